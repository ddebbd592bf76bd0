// HDF5 files as groups of arrays and attributes. The library itself is used in hdf5_file.cpp alone.
//
// The library builds and parses files in memory; what touches the disk is plain reading and writing. Files
// are sealed: the 512 bytes before the HDF5 content, a user block that HDF5 programs skip, hold the SHA-256
// of the rest. A damaged file is found by it before the library, which may crash on one, sees a byte.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "results/files/error.hpp"

namespace cpt::results {

/// A group of an open file. All functions throw Error; equal contents make equal bytes (no time stamps).
class Hdf5Group {
 public:
  explicit Hdf5Group(std::int64_t id) : id_(id) {}  // closed with the object
  ~Hdf5Group();
  Hdf5Group(const Hdf5Group&) = delete;
  Hdf5Group& operator=(const Hdf5Group&) = delete;

  [[nodiscard]] Hdf5Group add_group(const std::string& name) const;
  [[nodiscard]] Hdf5Group group(const std::string& name) const;
  /// Names of the groups and arrays in this group, in alphabetical order.
  [[nodiscard]] std::vector<std::string> names() const;

  // Attributes of the group.
  void put_text(const std::string& name, const std::string& value) const;
  void put_number(const std::string& name, double value) const;
  [[nodiscard]] std::string text(const std::string& name) const;
  [[nodiscard]] std::optional<double> number(const std::string& name) const;  ///< nullopt if there is none

  // Arrays of 64-bit floats, little-endian. A unit becomes the array's attribute `unit`.
  void put_array(const std::string& name, const std::vector<double>& values,
                 const std::string& unit = "") const;
  [[nodiscard]] std::vector<double> array(const std::string& name) const;
  [[nodiscard]] std::string unit(const std::string& array) const;

 private:
  std::int64_t id_;
};

/// Writes a file whole: to FILE.tmp, down to the disk, then renamed into place, so that it is always
/// complete. Throws Error, naming the file and why.
void write_hdf5(const std::filesystem::path& file, const std::function<void(const Hdf5Group&)>& fill);

/// Opens a file to read from its root. Throws Error if the file has no seal or a broken one.
void read_hdf5(const std::filesystem::path& file, const std::function<void(const Hdf5Group&)>& read);

}  // namespace cpt::results
