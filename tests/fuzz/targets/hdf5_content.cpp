// HDF5 files that are whole and sealed but hold other things than the program writes. Each line of the input
// puts something else in the place of an object or an attribute of sound files, where they have it:
//
//   /realizations/0001/depth_m matrix
//   /realizations/0001@status numbers
#include <hdf5.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "results/ledger/provenance.hpp"
#include "tests/fuzz/targets/hdf5.hpp"

namespace cpt::fuzz {
namespace {

constexpr std::size_t seal_size = 512;

// What may stand there instead.
struct Kind {
  std::string_view name;
  hid_t type;                  // -1: nothing is put there
  std::vector<hsize_t> shape;  // empty: one value
};

hid_t texts(std::size_t size) {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, size);
  return type;
}

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all = [] {
    const hid_t pair = H5Tcreate(H5T_COMPOUND, 16);
    H5Tinsert(pair, "a", 0, H5T_NATIVE_DOUBLE);
    H5Tinsert(pair, "b", 8, H5T_NATIVE_DOUBLE);
    return std::vector<Kind>{{"gone", -1, {}},
                             {"number", H5T_NATIVE_DOUBLE, {}},
                             {"numbers", H5T_NATIVE_DOUBLE, {64}},
                             {"nothing", H5T_NATIVE_DOUBLE, {0}},
                             {"matrix", H5T_NATIVE_DOUBLE, {3, 4}},
                             {"bytes", H5T_NATIVE_SCHAR, {7}},
                             {"integer", H5T_NATIVE_LLONG, {}},
                             {"text", texts(H5T_VARIABLE), {}},
                             {"texts", texts(H5T_VARIABLE), {64}},
                             {"fixed", texts(5), {}},
                             {"pairs", pair, {9}},
                             {"huge", H5T_NATIVE_DOUBLE, {hsize_t{1} << 40}}};
  }();
  return all;
}

// Zeros, which are empty texts too.
void put_attribute(hid_t object, const std::string& name, const Kind& kind) {
  H5Adelete(object, name.c_str());
  if (kind.type < 0 || kind.name == "huge") return;
  const hid_t space = kind.shape.empty()
                          ? H5Screate(H5S_SCALAR)
                          : H5Screate_simple(static_cast<int>(kind.shape.size()), kind.shape.data(), nullptr);
  const hid_t attribute = H5Acreate2(object, name.c_str(), kind.type, space, H5P_DEFAULT, H5P_DEFAULT);
  const std::array<char, 2048> zeros{};
  H5Awrite(attribute, kind.type, zeros.data());
  H5Aclose(attribute);
  H5Sclose(space);
}

bool put_array(hid_t file, const std::string& path, const Kind& kind) {
  if (H5Ldelete(file, path.c_str(), H5P_DEFAULT) < 0) return false;
  if (kind.type < 0) return true;
  const hid_t space = kind.shape.empty()
                          ? H5Screate(H5S_SCALAR)
                          : H5Screate_simple(static_cast<int>(kind.shape.size()), kind.shape.data(), nullptr);
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  const hsize_t chunk = 1024;
  if (kind.name == "huge") H5Pset_chunk(creation, 1, &chunk);  // takes no room
  H5Dclose(H5Dcreate2(file, path.c_str(), kind.type, space, H5P_DEFAULT, creation, H5P_DEFAULT));
  H5Pclose(creation);
  H5Sclose(space);
  return true;
}

// False where there is no such place in the file, or nothing that is called so.
bool put(hid_t file, const std::string& place, const std::string& what) {
  const std::size_t at = place.find('@');
  if (what == "group" || what == "loop" || what == "astray") {
    if (H5Ldelete(file, place.c_str(), H5P_DEFAULT) < 0) return false;
    if (what == "group")
      H5Gclose(H5Gcreate2(file, place.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    else
      H5Lcreate_soft(what == "loop" ? "/" : "/nowhere", file, place.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    return true;
  }
  const auto kind =
      std::find_if(kinds().begin(), kinds().end(), [&](const Kind& k) { return k.name == what; });
  if (kind == kinds().end()) return false;
  if (at == std::string::npos) return put_array(file, place, *kind);
  const hid_t object = H5Oopen(file, place.substr(0, at).c_str(), H5P_DEFAULT);
  if (object < 0) return false;
  put_attribute(object, place.substr(at + 1), *kind);
  H5Oclose(object);
  return true;
}

// The file's bytes with what the lines say, sealed; empty if they change nothing.
std::string changed(std::string bytes, std::string_view layout) {
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_fapl_core(access, 1 << 16, false);
  H5Pset_file_image(access, bytes.data(), bytes.size());
  const hid_t file = H5Fopen("/dev/null/fuzzed", H5F_ACC_RDWR, access);
  promise(file >= 0, "the sound file can be opened");
  std::istringstream lines{std::string(layout)};
  bool any = false;
  for (std::string place, what; lines >> place >> what;)
    if (place.size() > 1 && place[0] == '/') any = put(file, place, what) || any;
  H5Fflush(file, H5F_SCOPE_GLOBAL);
  std::string content(static_cast<std::size_t>(H5Fget_file_image(file, nullptr, 0)), '\0');
  H5Fget_file_image(file, content.data(), content.size());
  H5Fclose(file);
  H5Pclose(access);
  if (!any) return {};
  std::string seal = "SHA-256 of the bytes after the first 512: " + results::sha256(content) + "\n";
  seal.resize(seal_size, '\0');
  return seal + content;
}

}  // namespace

Fate hdf5_content(std::string_view layout) {
  const std::vector<std::string>& files = sound_hdf5_files();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  Fate fate = Fate::refused;
  for (const std::string& bytes : files)
    if (const std::string other = changed(bytes, layout); !other.empty() && use_hdf5(other) == Fate::sound)
      fate = Fate::sound;
  return fate;
}

}  // namespace cpt::fuzz
