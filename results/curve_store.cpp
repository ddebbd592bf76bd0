#include "results/curve_store.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <hdf5.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace cpt::results {
namespace {

/// What is in a curve file.
struct CurveFile {
  std::map<std::string, std::string> provenance;  // attributes of the file's root
  std::vector<StoredCurve> curves;
  bool operator==(const CurveFile&) const = default;
};

/// An HDF5 identifier, closed by the function that fits its kind.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t), const char* what) : id_(id), close_(close) {
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

void put_text(hid_t at, const char* name, const std::string& value) {
  const Handle type = utf8_type();
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "a scalar");
  const Handle attribute(H5Acreate2(at, name, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         name);
  const char* bytes = value.c_str();
  check(H5Awrite(attribute.id(), type.id(), static_cast<const void*>(&bytes)), "write an attribute");
}

std::string get_text(hid_t at, const char* name) {
  const Handle attribute(H5Aopen(at, name, H5P_DEFAULT), H5Aclose, name);
  const Handle type = utf8_type();
  char* bytes = nullptr;
  check(H5Aread(attribute.id(), type.id(), static_cast<void*>(&bytes)), "read an attribute");
  std::string value = bytes == nullptr ? "" : bytes;
  H5free_memory(bytes);
  return value;
}

void put_number(hid_t at, const char* name, double value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "a scalar");
  const Handle attribute(H5Acreate2(at, name, H5T_IEEE_F64LE, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         name);
  check(H5Awrite(attribute.id(), H5T_NATIVE_DOUBLE, &value), "write an attribute");
}

std::optional<double> get_number(hid_t at, const char* name) {
  if (H5Aexists(at, name) <= 0) return std::nullopt;
  const Handle attribute(H5Aopen(at, name, H5P_DEFAULT), H5Aclose, name);
  double value = 0.0;
  check(H5Aread(attribute.id(), H5T_NATIVE_DOUBLE, &value), "read an attribute");
  return value;
}

void put_array(hid_t at, const char* name, const std::vector<double>& values) {
  const hsize_t size = values.size();
  const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose, "an array");
  const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "a property list");
  check(H5Pset_obj_track_times(creation.id(), false),
        "switch off time stamps");  // equal campaigns, equal files
  const Handle set(H5Dcreate2(at, name, H5T_IEEE_F64LE, space.id(), H5P_DEFAULT, creation.id(), H5P_DEFAULT),
                   H5Dclose, name);
  check(H5Dwrite(set.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
        "write an array");
}

std::vector<double> get_array(hid_t at, const char* name) {
  const Handle set(H5Dopen2(at, name, H5P_DEFAULT), H5Dclose, name);
  const Handle space(H5Dget_space(set.id()), H5Sclose, "an array");
  const hssize_t size = H5Sget_simple_extent_npoints(space.id());
  if (size < 0) throw Error("HDF5 cannot tell the size of an array");
  std::vector<double> values(static_cast<std::size_t>(size));
  check(H5Dread(set.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "read an array");
  return values;
}

constexpr const char* text_attributes[] = {"parameter", "side",   "value_text",
                                           "unit",      "status", "settings_hash"};
constexpr std::string StoredCurve::*text_members[] = {&StoredCurve::parameter,  &StoredCurve::side,
                                                      &StoredCurve::value_text, &StoredCurve::unit,
                                                      &StoredCurve::status,     &StoredCurve::settings_hash};
constexpr const char* provenance_names[] = {"study",           "title",         "profile",
                                            "preset",          "study_text",    "baseline_setup",
                                            "program_version", "solver_version"};

void write_file(const std::filesystem::path& file, const CurveFile& content) {
  const Handle h5(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose, file.c_str());
  const Handle root(H5Gopen2(h5.id(), "/", H5P_DEFAULT), H5Gclose, "the root");
  for (const auto& [name, value] : content.provenance) put_text(root.id(), name.c_str(), value);
  const Handle all(H5Gcreate2(h5.id(), "realizations", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose,
                   "/realizations");
  for (const StoredCurve& curve : content.curves) {
    const std::string name = fmt::format("{:04}", curve.realization);
    const Handle group(H5Gcreate2(all.id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose,
                       name.c_str());
    for (std::size_t i = 0; i < std::size(text_attributes); ++i)
      put_text(group.id(), text_attributes[i], curve.*text_members[i]);
    if (curve.value) put_number(group.id(), "value", *curve.value);
    put_array(group.id(), "depth_m", curve.depth_m);
    put_array(group.id(), "q_c_kPa", curve.q_c_kPa);
    put_array(group.id(), "f_s_kPa", curve.f_s_kPa);
  }
  check(H5Fflush(h5.id(), H5F_SCOPE_GLOBAL), "write the file");
}

CurveFile read_file(const std::filesystem::path& file) {
  const Handle h5(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, file.c_str());
  const Handle root(H5Gopen2(h5.id(), "/", H5P_DEFAULT), H5Gclose, "the root");
  CurveFile content;
  for (const char* name : provenance_names) content.provenance[name] = get_text(root.id(), name);
  const Handle all(H5Gopen2(h5.id(), "realizations", H5P_DEFAULT), H5Gclose, "/realizations");
  H5G_info_t info{};
  check(H5Gget_info(all.id(), &info), "list the realizations");
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    std::string name(16, '\0');
    const ssize_t length = H5Lget_name_by_idx(all.id(), ".", H5_INDEX_NAME, H5_ITER_INC, i, name.data(),
                                              name.size(), H5P_DEFAULT);
    if (length <= 0 || length >= static_cast<ssize_t>(name.size()))
      throw Error("HDF5 cannot name a realization");
    name.resize(static_cast<std::size_t>(length));
    const Handle group(H5Gopen2(all.id(), name.c_str(), H5P_DEFAULT), H5Gclose, name.c_str());
    StoredCurve curve;
    if (std::sscanf(name.c_str(), "%d", &curve.realization) != 1) throw Error("a group is not a realization");
    for (std::size_t k = 0; k < std::size(text_attributes); ++k)
      curve.*text_members[k] = get_text(group.id(), text_attributes[k]);
    curve.value = get_number(group.id(), "value");
    curve.depth_m = get_array(group.id(), "depth_m");
    curve.q_c_kPa = get_array(group.id(), "q_c_kPa");
    curve.f_s_kPa = get_array(group.id(), "f_s_kPa");
    content.curves.push_back(std::move(curve));
  }
  return content;
}

std::vector<double> in_kPa(std::vector<double> values) {
  std::transform(values.begin(), values.end(), values.begin(), [](double Pa) { return Pa / 1.0e3; });
  return values;
}

CurveFile content_of(const Snapshot& snapshot) {
  const CampaignRow& c = snapshot.campaign;
  CurveFile content;
  content.provenance = {{"study", c.name},
                        {"title", c.title},
                        {"profile", c.profile},
                        {"preset", c.preset},
                        {"study_text", c.study_text},
                        {"baseline_setup", c.baseline_setup},
                        {"program_version", c.program_version},
                        {"solver_version", c.solver_version}};
  for (const CurveRow& curve : snapshot.curves) {
    const auto row = std::find_if(snapshot.realizations.begin(), snapshot.realizations.end(),
                                  [&](const RealizationRow& r) { return r.id == curve.realization; });
    const auto parameter = std::find_if(snapshot.parameters.begin(), snapshot.parameters.end(),
                                        [&](const ParameterRow& p) { return p.name == row->parameter; });
    content.curves.push_back({row->id, row->parameter, row->side, row->value_text,
                              parameter == snapshot.parameters.end() ? "" : parameter->unit, row->status,
                              row->settings_hash,
                              std::isnan(row->value) ? std::nullopt : std::optional(row->value),
                              curve.profile.depth, in_kPa(curve.profile.q_c), in_kPa(curve.profile.f_s)});
  }
  return content;
}

bool is_current(const std::filesystem::path& file, const CurveFile& wanted) {
  if (!std::filesystem::exists(file)) return false;
  try {
    return read_file(file) == wanted;
  } catch (const Error&) {
    return false;  // damaged, or of another layout: rebuilt
  }
}

void flush_to_disk(const std::filesystem::path& file) {
  const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0 || fsync(descriptor) != 0) {
    if (descriptor >= 0) close(descriptor);
    throw Error(file.string() + ": cannot be written to disk");
  }
  close(descriptor);
}

}  // namespace

bool sync_curves(const std::filesystem::path& file, const std::filesystem::path& database) {
  const QuietErrors quiet;
  const CurveFile wanted = content_of(read_snapshot(database));
  if (is_current(file, wanted)) return false;
  const std::filesystem::path temporary = file.string() + ".tmp";
  try {
    write_file(temporary, wanted);
    flush_to_disk(temporary);
    std::filesystem::rename(temporary, file);
  } catch (const std::exception& error) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw Error(fmt::format("{}: the curves cannot be written ({}); they are safe in {}", file.string(),
                            error.what(), database.string()));
  }
  return true;
}

std::vector<StoredCurve> read_curves(const std::filesystem::path& file) {
  const QuietErrors quiet;
  try {
    return read_file(file).curves;
  } catch (const Error& error) {
    throw Error(fmt::format("{}: not a readable curve file ({})", file.string(), error.what()));
  }
}

}  // namespace cpt::results
