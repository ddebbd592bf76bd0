#include "results/files/hdf5_file.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <optional>
#include <string_view>

#include "results/files/atomic_file.hpp"
#include "results/files/file_bytes.hpp"
#include "results/ledger/provenance.hpp"

namespace cpt::results {
namespace {

/// An HDF5 identifier, closed by the function that fits its kind.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t), const std::string& what) : id_(id), close_(close) {
    if (id_ < 0) throw Error(fmt::format("HDF5 cannot make or open {}", what));
  }
  ~Handle() { close_(id_); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  [[nodiscard]] hid_t id() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

void check(herr_t code, const char* what) {
  if (code < 0) throw Error(fmt::format("HDF5 cannot {}", what));
}

hid_t checked(hid_t id, const std::string& what) {
  if (id < 0) throw Error(fmt::format("HDF5 cannot make or open {}", what));
  return id;
}

/// HDF5 prints every failed call to stderr unless told not to; failures here become an Error.
class QuietErrors {
 public:
  QuietErrors() {
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~QuietErrors() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;

 private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

Handle utf8_type() {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return Handle(type, H5Tclose, "a text type");
}

Handle scalar() { return Handle(H5Screate(H5S_SCALAR), H5Sclose, "a scalar"); }

void put_text_at(hid_t at, const std::string& name, const std::string& value) {
  const Handle type = utf8_type();
  const Handle space = scalar();
  const Handle attribute(H5Acreate2(at, name.c_str(), type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose, name);
  const char* bytes = value.c_str();
  check(H5Awrite(attribute.id(), type.id(), static_cast<const void*>(&bytes)), "write an attribute");
}

/// HDF5 reads as many values as the file has, whatever there is room for.
void require_one_value(const Handle& attribute, const std::string& name) {
  const Handle space(H5Aget_space(attribute.id()), H5Sclose, name);
  if (H5Sget_simple_extent_npoints(space.id()) != 1) throw Error(fmt::format("{} is not one value", name));
}

std::string text_at(hid_t at, const std::string& name) {
  const Handle attribute(H5Aopen(at, name.c_str(), H5P_DEFAULT), H5Aclose, name);
  require_one_value(attribute, name);
  const Handle type = utf8_type();
  char* bytes = nullptr;
  check(H5Aread(attribute.id(), type.id(), static_cast<void*>(&bytes)), "read an attribute");
  std::string value = bytes == nullptr ? "" : bytes;
  H5free_memory(bytes);
  return value;
}

constexpr std::size_t seal_size = 512;  // [bytes] the smallest user block
constexpr std::string_view seal_start = "SHA-256 of the bytes after the first 512: ";
constexpr std::size_t growth = std::size_t{1} << 20;  // [bytes] of a file in memory

constexpr const char* nowhere = "/dev/null/memory";  // a file in memory may not have the name of one on disk

std::string seal_of(std::string_view content) {
  std::string seal = fmt::format("{}{}\n", seal_start, sha256(content));
  seal.resize(seal_size, '\0');
  return seal;
}

void check_seal(std::string_view file) {
  if (!file.starts_with(seal_start))
    throw Error("not a file of this program: it does not start with a checksum");
  if (file.size() < seal_size || file.substr(0, seal_size) != seal_of(file.substr(seal_size)))
    throw Error("damaged: its bytes do not match their checksum");
}

Handle file_in_memory() {
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_fapl_core(access, growth, false);
  return Handle(access, H5Pclose, "a property list");
}

Hdf5Group root_of(const Handle& file) {
  return Hdf5Group(checked(H5Gopen2(file.id(), "/", H5P_DEFAULT), "the root"));
}

}  // namespace

Hdf5Group::~Hdf5Group() { H5Gclose(id_); }

Hdf5Group Hdf5Group::add_group(const std::string& name) const {
  return Hdf5Group(checked(H5Gcreate2(id_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), name));
}

Hdf5Group Hdf5Group::group(const std::string& name) const {
  return Hdf5Group(checked(H5Gopen2(id_, name.c_str(), H5P_DEFAULT), name));
}

std::vector<std::string> Hdf5Group::names() const {
  H5G_info_t info{};
  check(H5Gget_info(id_, &info), "list a group");
  std::vector<std::string> all;
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    const auto name_of = [&](char* text, std::size_t size) {
      return H5Lget_name_by_idx(id_, ".", H5_INDEX_NAME, H5_ITER_INC, i, text, size, H5P_DEFAULT);
    };
    const ssize_t length = name_of(nullptr, 0);
    if (length <= 0) throw Error("HDF5 cannot list a group");
    std::string& name = all.emplace_back(static_cast<std::size_t>(length), '\0');
    if (name_of(name.data(), name.size() + 1) < 0) throw Error("HDF5 cannot list a group");
  }
  return all;
}

void Hdf5Group::put_text(const std::string& name, const std::string& value) const {
  put_text_at(id_, name, value);
}

std::string Hdf5Group::text(const std::string& name) const { return text_at(id_, name); }

void Hdf5Group::put_number(const std::string& name, double value) const {
  const Handle space = scalar();
  const Handle attribute(H5Acreate2(id_, name.c_str(), H5T_IEEE_F64LE, space.id(), H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose, name);
  check(H5Awrite(attribute.id(), H5T_NATIVE_DOUBLE, &value), "write an attribute");
}

std::optional<double> Hdf5Group::number(const std::string& name) const {
  if (H5Aexists(id_, name.c_str()) <= 0) return std::nullopt;
  const Handle attribute(H5Aopen(id_, name.c_str(), H5P_DEFAULT), H5Aclose, name);
  require_one_value(attribute, name);
  double value = 0.0;
  check(H5Aread(attribute.id(), H5T_NATIVE_DOUBLE, &value), "read an attribute");
  return value;
}

void Hdf5Group::put_array(const std::string& name, const std::vector<double>& values,
                          const std::string& unit) const {
  const hsize_t size = values.size();
  const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose, "an array");
  const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "a property list");
  check(H5Pset_obj_track_times(creation.id(), false), "switch off time stamps");
  const Handle set(
      H5Dcreate2(id_, name.c_str(), H5T_IEEE_F64LE, space.id(), H5P_DEFAULT, creation.id(), H5P_DEFAULT),
      H5Dclose, name);
  check(H5Dwrite(set.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
        "write an array");
  if (!unit.empty()) put_text_at(set.id(), "unit", unit);
}

std::vector<double> Hdf5Group::array(const std::string& name) const {
  const Handle set(H5Dopen2(id_, name.c_str(), H5P_DEFAULT), H5Dclose, name);
  const Handle space(H5Dget_space(set.id()), H5Sclose, "an array");
  const hssize_t size = H5Sget_simple_extent_npoints(space.id());
  // A file may name any size; one that the program wrote holds every value.
  if (size < 0 || H5Dget_storage_size(set.id()) / sizeof(double) < static_cast<hsize_t>(size))
    throw Error(fmt::format("{} is not an array of 64-bit floats", name));
  std::vector<double> values(static_cast<std::size_t>(size));
  check(H5Dread(set.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "read an array");
  return values;
}

std::string Hdf5Group::unit(const std::string& array) const {
  const Handle set(H5Dopen2(id_, array.c_str(), H5P_DEFAULT), H5Dclose, array);
  return text_at(set.id(), "unit");
}

void write_hdf5(const std::filesystem::path& file, const std::function<void(const Hdf5Group&)>& fill) {
  const QuietErrors quiet;
  std::string content;
  try {
    const Handle access = file_in_memory();
    const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "a property list");
    check(H5Pset_userblock(creation.id(), seal_size), "leave room for the checksum");
    const Handle h5(H5Fcreate(nowhere, H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose, "a file");
    fill(root_of(h5));
    check(H5Fflush(h5.id(), H5F_SCOPE_GLOBAL), "write the file");
    const ssize_t size = H5Fget_file_image(h5.id(), nullptr, 0);
    if (size <= 0) throw Error("HDF5 cannot give the file's bytes");
    content.resize(static_cast<std::size_t>(size));
    if (H5Fget_file_image(h5.id(), content.data(), content.size()) != size)
      throw Error("HDF5 cannot give the file's bytes");
  } catch (const std::exception& error) {
    throw Error(fmt::format("{}: cannot be written ({})", file.string(), error.what()));
  }
  write_atomically(file, seal_of(content), content);
}

void read_hdf5(const std::filesystem::path& file, const std::function<void(const Hdf5Group&)>& read) {
  const QuietErrors quiet;
  if (const auto other = not_a_file(file); !other.empty()) throw Error(fmt::format("{}, not a file", other));
  std::error_code why;
  std::optional<std::string> read_bytes = bytes_of(file, why, SIZE_MAX);
  if (!read_bytes) throw Error(fmt::format("cannot be read: {}", why.message()));
  std::string& bytes = *read_bytes;
  check_seal(bytes);
  const Handle access = file_in_memory();
  check(H5Pset_file_image(access.id(), bytes.data(), bytes.size()), "take the file's bytes");
  const Handle h5(H5Fopen(nowhere, H5F_ACC_RDONLY, access.id()), H5Fclose, "it as an HDF5 file");
  read(root_of(h5));
}

}  // namespace cpt::results
