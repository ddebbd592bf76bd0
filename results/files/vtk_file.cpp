#include "results/files/vtk_file.hpp"

#include <fmt/format.h>

#include <numeric>

#include "results/files/atomic_file.hpp"

namespace cpt::results {
namespace {

// "<" and the like cannot stand in an attribute, nor "--" in a comment.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '&')
      out += "&amp;";
    else if (c == '"')
      out += "&quot;";
    else if (c == '-' && out.ends_with('-'))
      out += " -";
    else
      out += c;
  }
  return out;
}

// Arrays are announced in the XML with their place in the block of raw bytes at the end.
class Appended {
 public:
  template <typename Number>
  std::string announce(const char* type, const std::string& attributes, const std::vector<Number>& values) {
    const std::string line = fmt::format("<DataArray type=\"{}\" {} format=\"appended\" offset=\"{}\"/>\n",
                                         type, attributes, bytes_.size());
    const std::uint64_t size = values.size() * sizeof(Number);
    bytes_.append(reinterpret_cast<const char*>(&size), sizeof size);
    bytes_.append(reinterpret_cast<const char*>(values.data()), size);
    return line;
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

std::string attributes_of(const VtkArray& array) {
  std::string text =
      fmt::format("Name=\"{}\" NumberOfComponents=\"{}\"", escaped(array.name), array.components);
  for (std::size_t i = 0; i < array.component_names.size(); ++i)
    text += fmt::format(" ComponentName{}=\"{}\"", i, escaped(array.component_names[i]));
  return text;
}

}  // namespace

void write_vtu(const std::filesystem::path& file, const VtkPoints& points) {
  const std::size_t count = points.ids.size();
  std::vector<std::int64_t> connectivity(count), offsets(count);
  std::iota(connectivity.begin(), connectivity.end(), 0);
  std::iota(offsets.begin(), offsets.end(), 1);
  const std::vector<std::uint8_t> types(count, 1);  // VTK_VERTEX

  Appended appended;
  std::string xml = fmt::format(
      "<?xml version=\"1.0\"?>\n<!-- {} -->\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"{}\" header_type=\"UInt64\">\n"
      "<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n",
      escaped(points.comment), vtk_byte_order, count, count);
  xml += appended.announce("Float64", "NumberOfComponents=\"3\"", points.positions);
  xml += "</Points>\n<Cells>\n";
  xml += appended.announce("Int64", "Name=\"connectivity\"", connectivity);
  xml += appended.announce("Int64", "Name=\"offsets\"", offsets);
  xml += appended.announce("UInt8", "Name=\"types\"", types);
  xml += "</Cells>\n<PointData>\n";
  xml += appended.announce("Int64", "Name=\"id\"", points.ids);
  for (const VtkArray& array : points.arrays)
    xml += appended.announce("Float64", attributes_of(array), array.values);
  xml += "</PointData>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
  replace_file(file, xml + appended.bytes() + "\n</AppendedData>\n</VTKFile>\n");
}

void write_pvd(const std::filesystem::path& file, const std::vector<VtkFrame>& frames) {
  std::string xml = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n<Collection>\n";
  for (const VtkFrame& frame : frames)
    xml += fmt::format("<DataSet timestep=\"{}\" file=\"{}\"/>\n", frame.time, escaped(frame.file));
  replace_file(file, xml + "</Collection>\n</VTKFile>\n");
}

}  // namespace cpt::results
