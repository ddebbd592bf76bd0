// What is wrong with a setup as a whole. Messages name every quantity involved by its dotted name.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "solver/actual_setup.hpp"
#include "solver/lengths.hpp"
#include "solver/material_points.hpp"
#include "solver/quantities.hpp"
#include "solver/refinement.hpp"
#include "solver/soils/law.hpp"
#include "solver/thin_layers.hpp"

namespace cpt::solver {
namespace {

constexpr double touching = 1.0e-9;  // [m] interfaces closer than this are the same
constexpr std::string_view sigma_h0 = "initial.sigma_h0_kPa";
constexpr int max_zone_columns = 5000;     // [-]
constexpr double max_zone_rows = 20000.0;  // [1/m]

class Check {
 public:
  explicit Check(const Setup& setup) : setup_(setup) {}

  std::vector<Problem> run() {
    soils();
    if (!problems_.empty()) return problems_;
    values();
    if (!problems_.empty()) return problems_;  // the rest is meaningless with values out of range
    layers();
    const bool sound_layers = problems_.empty();
    laws(sound_layers);
    stress_ratio(sound_layers);
    geometry();
    if (!zones()) return problems_;
    const std::size_t before = problems_.size();
    cells();
    if (sound_layers && problems_.size() == before) made();
    return problems_;
  }

 private:
  void add(std::string_view quantity, std::string message) {
    problems_.push_back({std::string(quantity), std::move(message)});
  }

  [[nodiscard]] std::string given(std::string_view name) const { return solver::given(setup_, name); }

  [[nodiscard]] double scale() const { return setup_.penetrometer.diameter / setup_.numerics.for_diameter; }
  /// A length that grows with the cone, as given and as it is.
  [[nodiscard]] std::string at_this_cone(std::string_view name) const {
    if (scale() == 1.0) return given(name);
    return fmt::format("{} ({:.3g} m at this cone)", given(name), scale() * find_quantity(name)->get(setup_));
  }

  void values();
  void layers();
  void soils();
  void laws(bool sound_layers);
  void stress_ratio(bool sound_layers);
  [[nodiscard]] bool bears(double sigma_h, bool sound_layers) const;
  [[nodiscard]] std::string range_of_sigma_h(bool sound_layers) const;
  void geometry();
  bool zones();
  void cells();
  void made();

  [[nodiscard]] double face_height() const {
    return setup_.penetrometer.diameter / 2.0 / std::tan(setup_.penetrometer.apex / 2.0);
  }

  const Setup& setup_;
  std::vector<Problem> problems_;
};

void Check::values() {
  for (const Quantity* quantity : quantities_of(setup_)) {
    const double value = quantity->value(setup_);
    if (value >= quantity->min && value <= quantity->max) continue;
    add(quantity->name, fmt::format("{} is outside {} to {} {}", given(quantity->name), quantity->min,
                                    quantity->max, quantity->unit));
  }
}

void Check::layers() {
  const double bottom = setup_.chamber.soil_height;
  if (setup_.layers.empty()) return add("layers", "there is no layer");
  double reached = 0.0;
  for (const Layer& layer : setup_.layers) {
    if (!(std::abs(layer.top - reached) <= touching))
      return add("layers",
                 fmt::format("a layer starts at {} m, but the one above it (or the soil's top) ends at {} m: "
                             "layers touch without gaps or overlaps",
                             layer.top, reached));
    if (!(layer.bottom > layer.top + touching))
      return add("layers",
                 fmt::format("the layer from {} m to {} m has no thickness", layer.top, layer.bottom));
    reached = layer.bottom;
  }
  if (std::abs(reached - bottom) > touching)
    add("layers", fmt::format("the layers end at {} m, but {}", reached, given("chamber.soil_height_m")));
}

// Named once, of a known law, and few enough for a cell's sums.
void Check::soils() {
  constexpr std::size_t most = most_materials - 1;  // the surcharge is one too
  if (setup_.soils.size() > most)
    return add("soils", fmt::format("{} soils are more than the {} that a cell has room for",
                                    setup_.soils.size(), most));
  for (std::size_t k = 0; k < setup_.soils.size(); ++k)
    for (std::size_t j = 0; j < k; ++j)
      if (setup_.soils[j].name == setup_.soils[k].name)
        return add("soils", fmt::format("two soils are called {}", setup_.soils[k].name));
  for (const Layer& layer : setup_.layers)
    if (layer.soil >= setup_.soils.size()) return add("soils", "a layer has no soil");
}

// What each law says of those that the layers have.
void Check::laws(bool sound_layers) {
  for (std::size_t k = 0; k < setup_.soils.size(); ++k)
    if (contains(setup_, k))
      for (Problem& problem : law_of(setup_.soils[k]).problems(setup_, k, sound_layers)) {
        if (problem.quantity == sigma_h0) problem.message += range_of_sigma_h(sound_layers);
        problems_.push_back(std::move(problem));
      }
}

// The least and the greatest K_0 of a trend are those of its ends.
void Check::stress_ratio(bool sound_layers) {
  const StressRatioTrend& trend = setup_.mechanisms.stress_ratio_trend;
  if (!trend.on() || !bears(setup_.initial.sigma_h0, sound_layers)) return;
  for (const double part : {0.0, 1.0}) {
    const double factor = trend.at(part, 1.0);
    if (bears(setup_.initial.sigma_h0 * factor, sound_layers)) continue;
    return add("stress_ratio_trend.change",
               fmt::format("{} makes a K_0 of {:.3g} at one end, which some soil cannot bear with {} and {}",
                           given("stress_ratio_trend.change"),
                           factor * setup_.initial.sigma_h0 / setup_.initial.sigma_v0, given(sigma_h0),
                           given("initial.sigma_v0_kPa")));
  }
}

// Whether all soils can start from the vertical stress and this horizontal one.
bool Check::bears(double sigma_h, bool sound_layers) const {
  Setup other = setup_;
  other.initial.sigma_h0 = sigma_h;
  for (std::size_t k = 0; k < other.soils.size(); ++k)
    if (contains(other, k) && !law_of(other.soils[k]).problems(other, k, sound_layers).empty()) return false;
  return true;
}

// "; initial.sigma_h0_kPa may be 13.2 to 211", sought on both sides of equal stresses and rounded inwards to
// tenths.
std::string Check::range_of_sigma_h(bool sound_layers) const {
  const auto limit = [&](double beyond) {
    double borne = setup_.initial.sigma_v0;
    if (bears(beyond, sound_layers)) return beyond;
    for (int i = 0; i < 40; ++i)
      (bears(0.5 * (borne + beyond), sound_layers) ? borne : beyond) = 0.5 * (borne + beyond);
    return borne;
  };
  if (!bears(setup_.initial.sigma_v0, sound_layers)) return "";
  const Quantity& quantity = *find_quantity(sigma_h0);
  const double least = std::ceil(limit(quantity.min * 1e3) * 1e-2 - 1e-6) / 10.0;
  const double most = std::floor(limit(quantity.max * 1e3) * 1e-2 + 1e-6) / 10.0;
  return least <= most ? fmt::format("; {} may be {:g} to {:g}", sigma_h0, least, most) : "";
}

void Check::geometry() {
  const Penetrometer& penetrometer = setup_.penetrometer;
  const Numerics& numerics = setup_.numerics;
  if (setup_.chamber.radius <= 2.0 * penetrometer.diameter)
    add("chamber.radius_m",
        fmt::format("{} must exceed twice {}", given("chamber.radius_m"), given("penetrometer.diameter_m")));
  const PreviousPush& previous = setup_.mechanisms.previous_push;
  if (previous.on() && previous.depth > 0.0) {
    Setup first = setup_;
    first.mechanisms.previous_push = {};
    first.penetrometer.final_depth = previous.depth;
    for (const Problem& problem : Check(first).run())
      if (problem.quantity == "penetrometer.final_depth_m")
        add("previous_push.depth_m", fmt::format("of the first push: {}", problem.message));
  }
  if (previous.on() && previous.spacing >= setup_.chamber.radius)
    add("previous_push.spacing_m",
        fmt::format("{} must be below {}: the first push leaves nothing outside the chamber",
                    given("previous_push.spacing_m"), given("chamber.radius_m")));
  if (scale() * numerics.near_width_radius >= setup_.chamber.radius)
    add("numerics.near_width_radius_m",
        fmt::format("{} must be below {}", at_this_cone("numerics.near_width_radius_m"),
                    given("chamber.radius_m")));
  const double elements = numerics.face_elements * numerics.refinement;
  const Quantity& most = *find_quantity("numerics.face_elements");
  if (elements != std::round(elements) || elements < most.min || elements > most.max)
    add("numerics.refinement",
        fmt::format(
            "{} times {} is {:g}: the elements over the cone's radius must be a whole number, {} to {}",
            given("numerics.refinement"), given("numerics.face_elements"), elements, most.min, most.max));
  if (penetrometer.final_depth <= face_height())
    add("penetrometer.final_depth_m",
        fmt::format("{} must exceed {:.4f} m, the depth of the tip at the start (the cone's height)",
                    given("penetrometer.final_depth_m"), face_height()));
  if (exceeds(penetrometer.final_depth + scale() * (numerics.zone_below + 2.0 * numerics.near_height),
              setup_.chamber.soil_height))
    add("penetrometer.final_depth_m",
        fmt::format("{} and {} leave no room for the compressing mesh above the bottom, {}",
                    given("penetrometer.final_depth_m"), at_this_cone("numerics.zone_below_m"),
                    given("chamber.soil_height_m")));
}

bool Check::zones() {
  const std::size_t before = problems_.size();
  double inner = setup_.numerics.for_diameter / 2.0;
  if (setup_.numerics.zones.empty()) add("numerics.zones", "there is no zone of material points");
  for (const PointZone& zone : setup_.numerics.zones) {
    if (!(zone.outer_radius > inner) || !std::isfinite(zone.outer_radius))
      add("numerics.zones",
          fmt::format("the outer radius {} m must exceed {} m, that of the zone inside it or of the "
                      "cone for which lengths are given",
                      zone.outer_radius, inner));
    if (zone.columns < 1 || zone.columns > max_zone_columns)
      add("numerics.zones", fmt::format("{} columns are outside 1 to {}", zone.columns, max_zone_columns));
    if (!(zone.rows_per_metre >= 1.0 && zone.rows_per_metre <= max_zone_rows))
      add("numerics.zones",
          fmt::format("{} rows per metre are outside 1 to {}", zone.rows_per_metre, max_zone_rows));
    inner = zone.outer_radius;
  }
  return problems_.size() == before;
}

// The first layer that the model cannot make tells.
void Check::made() {
  const std::vector<Layer> layers = actual_setup(setup_).layers;
  const bool shifted = setup_.mechanisms.layer_shift.shift != 0.0,
             thickened = setup_.mechanisms.layer_thickness.on();
  const std::string_view mover = thickened ? "layer_thickness.change_mm" : "layer_shift.shift_mm";
  for (const Layer& layer : layers)
    if (!(layer.bottom > layer.top + touching))
      return add(mover,
                 fmt::format("{} leaves nothing of the layer down to {:.4g} m", given(mover), layer.bottom));
  for (std::size_t k = 0; k < layers.size() && layers.size() > 1; ++k) {
    const Layer& layer = layers[k];
    const std::string why = too_thin(setup_, layer.top, layer.bottom, "the " + setup_.soils[layer.soil].name);
    if (why.empty()) continue;
    if (shifted || thickened)
      add(mover, fmt::format("with {}, {}", given(mover), why));
    else
      problems_.push_back({"layers", why, k});
    break;
  }
  const DensityLens& lens = setup_.mechanisms.density_lens;
  const double top = std::max(0.0, lens.centre - 0.5 * lens.thickness);
  const double bottom = std::min(setup_.chamber.soil_height, lens.centre + 0.5 * lens.thickness);
  if (lens.change == 0.0 || !(bottom > top)) return;
  if (const std::string why = too_thin(setup_, top, bottom, "the density lens"); !why.empty())
    add("density_lens.thickness_mm", fmt::format("with {}, {}", given("density_lens.thickness_mm"), why));
}

// A cell lower or narrower than the spacing of the material points is sure to be empty at some time, and
// empty cells ruin a run. A margin of 1.2 is advisable; only the impossible is refused.
void Check::cells() {
  const Numerics numerics = refined(setup_);
  const auto cause = [&](std::string_view quantity) {
    return given(quantity) +
           (setup_.numerics.point_density < 1.0 ? " and " + given("numerics.point_density") : "");
  };
  const auto refuse_low_rows = [&](std::string_view quantity, double height, std::string_view where) {
    double inner = 0.0;
    for (const PointZone& zone : numerics.zones) {
      if (inner >= setup_.chamber.radius) return;
      const double cell = inner >= numerics.coarse_rows_radius ? 2.0 * height : height;
      const double spacing = 1.0 / zone.rows_per_metre;
      if (falls_short(cell, spacing))
        return add(quantity,
                   fmt::format("with {}, cells {} are {:.2f} mm high in the zone up to {} m, less than the "
                               "{:.2f} mm between its rows of material points: cells would be empty",
                               cause(quantity), where, cell * 1e3, zone.outer_radius, spacing * 1e3));
      inner = zone.outer_radius;
    }
  };
  const double start = setup_.chamber.soil_height - face_height() - numerics.zone_below;
  const double end = setup_.chamber.soil_height - setup_.penetrometer.final_depth - numerics.zone_below;
  refuse_low_rows("numerics.near_height_m", numerics.near_height, "around the tip");
  refuse_low_rows("numerics.above_height_m", numerics.above_height, "above the moving zone");
  if (start > 0.0 && end > 0.0)
    refuse_low_rows("numerics.below_height_m", numerics.below_height * end / start,
                    fmt::format("compressed at {}", given("penetrometer.final_depth_m")));

  const PointZone& first = numerics.zones.front();
  const double near_width = setup_.penetrometer.diameter / 2.0 / numerics.face_elements;
  const double spacing = first.outer_radius / first.columns;
  if (falls_short(near_width, spacing))
    add("numerics.face_elements",
        fmt::format("with {}, cells at the cone are {:.2f} mm wide, less than the {:.2f} mm between columns "
                    "of material "
                    "points: cells would be empty",
                    cause("numerics.face_elements"), near_width * 1e3, spacing * 1e3));
}

}  // namespace

std::vector<Problem> problems(const Setup& setup) {
  if (setup.program == nullptr) return Check(setup).run();
  std::vector<Problem> found;
  for (const Quantity* quantity : quantities_of(setup))
    if (const double value = quantity->get(setup); !(value >= quantity->min && value <= quantity->max))
      found.push_back(
          {quantity->name, fmt::format("{} is outside the valid range {} to {}", given(setup, quantity->name),
                                       quantity->min, quantity->max)});
  return found;
}

}  // namespace cpt::solver
