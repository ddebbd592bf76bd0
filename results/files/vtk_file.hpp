// Points with data as VTK XML files, for ParaView and VisIt: .vtu, and .pvd for a series of them.
//
// The format is that of "The VTK User's Guide", chapter "VTK File Formats": an unstructured grid of vertices,
// its arrays appended as raw bytes. What is read is what is written here, not all that VTK allows.
#pragma once

#include <bit>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "results/files/error.hpp"

namespace cpt::results {

/// An array with `components` values a point, point after point.
struct VtkArray {
  std::string name;
  std::vector<std::string> component_names;  ///< empty, or one a component
  std::size_t components = 1;
  std::vector<double> values;
};

/// This machine's byte order, as VTK calls it.
inline constexpr const char* vtk_byte_order =
    std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";

struct VtkPoints {
  std::string comment;            ///< where the data come from; written as an XML comment
  std::vector<double> positions;  // [m] x, y, z of each point
  std::vector<std::int64_t> ids;  ///< one a point
  std::vector<VtkArray> arrays;
};

/// The array of that name; nullptr if there is none.
[[nodiscard]] const VtkArray* find_array(const VtkPoints& points, std::string_view name);

/// Throws Error if the file cannot be written.
void write_vtu(const std::filesystem::path& file, const VtkPoints& points);
/// Reads what write_vtu wrote, to the same bits. Throws Error if the file is missing, damaged or of another
/// program.
[[nodiscard]] VtkPoints read_vtu(const std::filesystem::path& file);

/// One file of a series and its place on ParaView's time axis.
struct VtkFrame {
  double time;
  std::string file;  ///< relative to the .pvd
};

/// Throws Error if the file cannot be written.
void write_pvd(const std::filesystem::path& file, const std::vector<VtkFrame>& frames);
/// Reads what write_pvd wrote. Throws Error as read_vtu.
[[nodiscard]] std::vector<VtkFrame> read_pvd(const std::filesystem::path& file);

}  // namespace cpt::results
