#include "results/push/field_series.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "results/files/atomic_file.hpp"

namespace cpt::results {
namespace {

// ParaView wants three components of a vector and six of a symmetric tensor: xx, yy, zz, xy, yz, xz. With
// x = r, y = z and z = theta the components of an axisymmetric state come first, the rest is zero.
std::size_t vtk_components(std::size_t components) { return components == 0 ? 1 : components == 2 ? 3 : 6; }

// "velocity_m_per_s"
std::string array_name(const PointQuantity& quantity) {
  if (quantity.unit == "-") return std::string(quantity.name);
  std::string unit(quantity.unit);
  if (const auto slash = unit.find('/'); slash != std::string::npos) unit.replace(slash, 1, "_per_");
  return fmt::format("{}_{}", quantity.name, unit);
}

VtkArray point_array(const PointQuantity& quantity, const std::vector<solver::PointState>& now,
                     const std::vector<solver::PointState>& start) {
  constexpr const char* vector_names[] = {"r", "z", "theta"};
  constexpr const char* tensor_names[] = {"rr", "zz", "tt", "rz", "zt", "rt"};
  VtkArray array;
  array.name = array_name(quantity);
  array.components = vtk_components(quantity.components.size());
  if (array.components == 3) array.component_names.assign(std::begin(vector_names), std::end(vector_names));
  if (array.components == 6) array.component_names.assign(std::begin(tensor_names), std::end(tensor_names));
  array.values.reserve(now.size() * array.components);
  const std::size_t own = std::max<std::size_t>(1, quantity.components.size());
  for (std::size_t k = 0; k < now.size(); ++k)
    for (std::size_t c = 0; c < array.components; ++c)
      array.values.push_back(c < own ? quantity.value(now[k], start[k], c) : 0.0);
  return array;
}

}  // namespace

FieldSeries::FieldSeries(std::filesystem::path folder, std::string name, std::string origin,
                         std::vector<PointQuantity> quantities)
    : folder_(std::move(folder)),
      name_(std::move(name)),
      origin_(std::move(origin)),
      quantities_(std::move(quantities)) {
  make_folder(folder_);
}

std::filesystem::path FieldSeries::file() const { return folder_ / (name_ + ".pvd"); }

void FieldSeries::add(double wanted_depth, double depth, const std::vector<solver::PointState>& now,
                      const std::vector<solver::PointState>& start) {
  VtkPoints points;
  points.comment = fmt::format("{}, tip at {} m", origin_, depth);
  VtkArray material{"material", {}, 1, {}};
  for (const solver::PointState& state : now) {
    points.positions.insert(points.positions.end(), {state.r, state.z, 0.0});
    points.ids.push_back(state.id);
    material.values.push_back(static_cast<double>(state.material));
  }
  for (const PointQuantity& quantity : quantities_)
    if (quantity.name != "position") points.arrays.push_back(point_array(quantity, now, start));
  points.arrays.push_back(std::move(material));

  frames_.push_back({depth, fmt::format("{}-{}m.vtu", name_, wanted_depth)});
  write_vtu(folder_ / frames_.back().file, points);
  write_pvd(file(), frames_);
}

}  // namespace cpt::results
