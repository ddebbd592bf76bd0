#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reports/view/frame.hpp"

namespace cpt::reports::view {

DrawnPoints drawn_points(const View& view, const results::VtkPoints& points) {
  const auto array = [&](std::string_view name, std::size_t components) -> const std::vector<double>& {
    const results::VtkArray* found = results::find_array(points, name);
    if (found == nullptr || found->components < components)
      throw results::Error(fmt::format("the fields have no array {}; run campaign push again", name));
    return found->values;
  };
  const std::vector<double>& volume = array("volume_m3", 1);
  const std::vector<double>& material = array("material", 1);
  const std::vector<double>& displacement = array("displacement_m", 3);
  const std::size_t count = points.ids.size();

  DrawnPoints drawn;
  drawn.soils = view.geometry.soils;
  drawn.fields.resize(view.panels.size() + 2);
  for (std::size_t k = 0; k < count; ++k) {
    const double r = points.positions[3 * k];
    drawn.r.push_back(r);
    drawn.depth.push_back(-points.positions[3 * k + 1]);
    drawn.size.push_back(std::sqrt(volume[k] / (2.0 * std::numbers::pi * std::max(r, 1e-9))));
    drawn.material.push_back(
        static_cast<std::size_t>(std::clamp(material[k], 0.0, static_cast<double>(view.geometry.soils))));
    drawn.fields[view.panels.size()].push_back(displacement[3 * k]);
    drawn.fields[view.panels.size() + 1].push_back(-displacement[3 * k + 1]);
  }
  for (std::size_t i = 0; i < view.panels.size(); ++i) {
    const ViewQuantity& quantity = *view.panels[i].quantity;
    const std::vector<double>& values = array(quantity.array, 1);
    const std::size_t components = count == 0 ? 1 : values.size() / count;
    if (quantity.name == "displacement" || quantity.array == "stress_Pa") (void)array(quantity.array, 2);
    for (std::size_t k = 0; k < count; ++k)
      drawn.fields[i].push_back(quantity.value({&values[k * components], components}) / quantity.scale);
  }
  return drawn;
}

}  // namespace cpt::reports::view
