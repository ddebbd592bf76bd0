// Points with data as VTK XML files, for ParaView and VisIt: .vtu, and .pvd for a series of them.
//
// The format is that of "The VTK User's Guide", chapter "VTK File Formats": an unstructured grid of vertices,
// its arrays appended as raw bytes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "results/error.hpp"

namespace cpt::results {

/// An array with `components` values a point, point after point.
struct VtkArray {
  std::string name;
  std::vector<std::string> component_names;  ///< empty, or one a component
  std::size_t components = 1;
  std::vector<double> values;
};

struct VtkPoints {
  std::string comment;            ///< where the data come from; written as an XML comment
  std::vector<double> positions;  // [m] x, y, z of each point
  std::vector<std::int64_t> ids;  ///< one a point
  std::vector<VtkArray> arrays;
};

/// Throws Error if the file cannot be written.
void write_vtu(const std::filesystem::path& file, const VtkPoints& points);

/// One file of a series and its place on ParaView's time axis.
struct VtkFrame {
  double time;
  std::string file;  ///< relative to the .pvd
};

/// Throws Error if the file cannot be written.
void write_pvd(const std::filesystem::path& file, const std::vector<VtkFrame>& frames);

}  // namespace cpt::results
