// Reading of vtk_file.hpp. Boost.PropertyTree parses the XML; the raw bytes behind it are no XML.
#include <fmt/format.h>

#include <algorithm>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cstring>
#include <optional>
#include <sstream>

#include "results/files/file_bytes.hpp"
#include "results/files/vtk_file.hpp"

namespace cpt::results {
namespace {

using boost::property_tree::ptree;

constexpr std::string_view before_bytes = "<AppendedData encoding=\"raw\">\n_";

std::string text_of(const std::filesystem::path& file) {
  std::error_code why;
  std::optional<std::string> content;
  if (std::filesystem::is_regular_file(file, why)) content = bytes_of(file, why, SIZE_MAX);
  if (!content)
    throw Error(fmt::format("{}: missing or not readable{}", file.string(),
                            why ? fmt::format(" ({})", why.message()) : ""));
  return *std::move(content);
}

ptree parsed_xml(const std::string& xml) {
  std::istringstream stream(xml);
  ptree tree;
  boost::property_tree::read_xml(stream, tree, boost::property_tree::xml_parser::trim_whitespace);
  return tree;
}

// Runs `read` and says of which file it is that it fails.
template <typename Read>
auto of_file(const std::filesystem::path& file, Read read) {
  try {
    return read(text_of(file));
  } catch (const boost::property_tree::ptree_error& error) {
    throw Error(
        fmt::format("{}: damaged, or not of campaign push ({})", file.string(), std::string(error.what())));
  } catch (const std::out_of_range& error) {
    throw Error(fmt::format("{}: damaged, or not of campaign push ({})", file.string(), error.what()));
  }
}

// The numbers of an array, which its offset announces in the block of raw bytes.
template <typename Number>
std::vector<Number> numbers_of(const ptree& array, const char* type, std::size_t count,
                               std::string_view bytes) {
  if (const auto there = array.get<std::string>("<xmlattr>.type"); there != type)
    throw std::out_of_range(fmt::format("an array of type {} in place of {}", there, type));
  const auto offset = array.get<std::size_t>("<xmlattr>.offset");
  std::uint64_t size = 0;
  if (offset > bytes.size() || bytes.size() - offset < sizeof size)
    throw std::out_of_range("the file ends too early");
  std::memcpy(&size, bytes.data() + offset, sizeof size);
  if (size != count * sizeof(Number)) throw std::out_of_range(fmt::format("an array of {} bytes", size));
  if (bytes.size() - offset - sizeof size < size) throw std::out_of_range("the file ends too early");
  std::vector<Number> numbers(count);
  std::memcpy(numbers.data(), bytes.data() + offset + sizeof size, size);
  return numbers;
}

VtkArray read_array(const ptree& entry, std::size_t points, std::string_view bytes) {
  VtkArray array;
  array.name = entry.get<std::string>("<xmlattr>.Name");
  array.components = entry.get<std::size_t>("<xmlattr>.NumberOfComponents");
  if (array.components < 1 || array.components > 9)
    throw std::out_of_range(fmt::format("{} components", array.components));
  for (std::size_t i = 0; i < array.components; ++i)
    if (const auto name = entry.get_optional<std::string>(fmt::format("<xmlattr>.ComponentName{}", i)))
      array.component_names.push_back(*name);
  array.values = numbers_of<double>(entry, "Float64", points * array.components, bytes);
  return array;
}

}  // namespace

const VtkArray* find_array(const VtkPoints& points, std::string_view name) {
  const auto found = std::ranges::find(points.arrays, name, &VtkArray::name);
  return found == points.arrays.end() ? nullptr : &*found;
}

VtkPoints read_vtu(const std::filesystem::path& file) {
  return of_file(file, [](const std::string& content) {
    const auto end = content.find(before_bytes);
    if (end == std::string::npos) throw std::out_of_range("no appended data");
    const std::string_view bytes = std::string_view(content).substr(end + before_bytes.size());
    const ptree tree = parsed_xml(content.substr(0, end) + "</VTKFile>");
    if (tree.get<std::string>("VTKFile.<xmlattr>.byte_order") != vtk_byte_order)
      throw std::out_of_range("of a machine with another byte order");
    const ptree& piece = tree.get_child("VTKFile.UnstructuredGrid.Piece");
    const auto count = piece.get<std::size_t>("<xmlattr>.NumberOfPoints");
    if (count > content.size()) throw std::out_of_range("the file ends too early");

    VtkPoints points;
    points.comment = tree.get<std::string>("<xmlcomment>", "");
    points.positions = numbers_of<double>(piece.get_child("Points.DataArray"), "Float64", 3 * count, bytes);
    for (const auto& [name, entry] : piece.get_child("PointData")) {
      if (name != "DataArray") continue;
      if (entry.get<std::string>("<xmlattr>.Name") == "id")
        points.ids = numbers_of<std::int64_t>(entry, "Int64", count, bytes);
      else
        points.arrays.push_back(read_array(entry, count, bytes));
    }
    return points;
  });
}

std::vector<VtkFrame> read_pvd(const std::filesystem::path& file) {
  return of_file(file, [](const std::string& content) {
    std::vector<VtkFrame> frames;
    const ptree tree = parsed_xml(content);
    for (const auto& [name, entry] : tree.get_child("VTKFile.Collection"))
      if (name == "DataSet")
        frames.push_back({entry.get<double>("<xmlattr>.timestep"), entry.get<std::string>("<xmlattr>.file")});
    return frames;
  });
}

}  // namespace cpt::results
