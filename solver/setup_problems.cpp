// What is wrong with a setup as a whole. Messages name every quantity involved by its dotted name.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/actual_setup.hpp"
#include "solver/constitutive/critical_state_line.hpp"
#include "solver/constitutive/norsand.hpp"
#include "solver/initial_state.hpp"
#include "solver/lengths.hpp"
#include "solver/made_layers.hpp"
#include "solver/quantities.hpp"
#include "solver/refinement.hpp"

namespace cpt::solver {
namespace {

constexpr double touching = 1.0e-9;        // [m] interfaces closer than this are the same
constexpr int max_zone_columns = 5000;     // [-]
constexpr double max_zone_rows = 20000.0;  // [1/m]

// "; initial.sigma_h0_kPa may be 13.2 to 211", rounded inwards to tenths.
std::string range_of_sigma_h(double least, double most) {
  least = std::ceil(least * 1e-2 - 1e-6) / 10.0;
  most = std::floor(most * 1e-2 + 1e-6) / 10.0;
  return least <= most ? fmt::format("; initial.sigma_h0_kPa may be {:g} to {:g}", least, most) : "";
}

class Check {
 public:
  explicit Check(const Setup& setup) : setup_(setup) {}

  std::vector<Problem> run() {
    values();
    if (!problems_.empty()) return problems_;  // the rest is meaningless with values out of range
    layers();
    const bool sound_layers = problems_.empty();
    if (contains(setup_, Soil::sand)) sand();
    if (contains(setup_, Soil::clay) && sound_layers) clay();
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

  // "sand.e_min = 0.552"
  [[nodiscard]] std::string given(std::string_view name) const {
    const Quantity* quantity = find_quantity(name);
    return fmt::format("{} = {}", name, quantity->format(quantity->value(setup_)));
  }

  void values();
  void layers();
  void sand();
  [[nodiscard]] bool bears(double sigma_h) const;
  [[nodiscard]] std::string range_of_sand() const;
  void clay();
  [[nodiscard]] std::string range_of_clay() const;
  bool wall_shear(const Layer& layer, double K_0);
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
  for (const Quantity& quantity : all_quantities()) {
    const double value = quantity.value(setup_);
    if (value >= quantity.min && value <= quantity.max) continue;
    add(quantity.name, fmt::format("{} is outside {} to {} {}", given(quantity.name), quantity.min,
                                   quantity.max, quantity.unit));
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

void Check::sand() {
  const Sand& sand = setup_.sand;
  if (sand.e_min >= sand.e_max)
    return add("sand.e_min", fmt::format("{} must be below {}", given("sand.e_min"), given("sand.e_max")));
  const double e = bulk(setup_, Soil::sand).e;
  if (e <= sand.e_min_star)
    return add("sand.e_min_star", fmt::format("{} must be below the initial void ratio {:.4f} at {}",
                                              given("sand.e_min_star"), e, given("sand.D_r_percent")));

  const double sigma_v = setup_.initial.sigma_v0, sigma_h = setup_.initial.sigma_h0;
  const double p = (sigma_v + 2.0 * sigma_h) / 3.0;
  if (p <= sand.p_min)
    return add("sand.p_min_kPa",
               fmt::format("{} must be below the initial mean stress {:.4g} kPa of {} and {}",
                           given("sand.p_min_kPa"), p / 1e3, given("initial.sigma_v0_kPa"),
                           given("initial.sigma_h0_kPa")));
  const double e_c = CriticalStateLine(sand).void_ratio(p);
  if (e_c <= sand.e_min_star)
    return add("sand.e_cs0",
               fmt::format("the critical state void ratio at the initial stress is {:.4f} with {}, {} and "
                           "{}: it must exceed {}",
                           e_c, given("sand.e_cs0"), given("sand.lambda"), given("sand.m"),
                           given("sand.e_min_star")));

  // NorSand's largest image pressure at this density bounds the stress ratio, Jefferies & Been (2015).
  const NorSand law(sand);
  const double p_i = law.initial_image_pressure(-sigma_h, -sigma_v, -sigma_h, 0.0, e) / sand.OCR;
  const NorSandState state = law.evaluate({-sigma_h, -sigma_v, -sigma_h, 0.0}, e, p_i);
  if (!(p_i < state.p_mx))
    add("initial.sigma_h0_kPa",
        fmt::format(
            "{} and {} (K_0 = {:.3g}) make a stress ratio q/p' of {:.3g}, but this sand bears at most {:.3g} "
            "(state parameter {:+.3f} at {}, {}, {}){}",
            given("initial.sigma_h0_kPa"), given("initial.sigma_v0_kPa"), sigma_h / sigma_v,
            state.q / state.p, std::max(0.0, state.M_i * (1.0 + std::log(state.p_mx / state.p))), state.psi,
            given("sand.D_r_percent"), given("sand.phi_cs_deg"), given("sand.chi_tc"), range_of_sand()));
}

// Whether NorSand can start from the vertical stress and this horizontal one.
bool Check::bears(double sigma_h) const {
  const double sigma_v = setup_.initial.sigma_v0, e = bulk(setup_, Soil::sand).e;
  if ((sigma_v + 2.0 * sigma_h) / 3.0 <= setup_.sand.p_min) return false;
  const NorSand law(setup_.sand);
  const double p_i = law.initial_image_pressure(-sigma_h, -sigma_v, -sigma_h, 0.0, e) / setup_.sand.OCR;
  return p_i < law.evaluate({-sigma_h, -sigma_v, -sigma_h, 0.0}, e, p_i).p_mx;
}

// "; initial.sigma_h0_kPa may be 13 to 210", sought on both sides of equal stresses, which any sand bears.
std::string Check::range_of_sand() const {
  const auto limit = [&](double beyond) {
    double borne = setup_.initial.sigma_v0;
    if (bears(beyond)) return beyond;
    for (int i = 0; i < 40; ++i) (bears(0.5 * (borne + beyond)) ? borne : beyond) = 0.5 * (borne + beyond);
    return borne;
  };
  const Quantity& sigma_h = *find_quantity("initial.sigma_h0_kPa");
  return bears(setup_.initial.sigma_v0) ? range_of_sigma_h(limit(sigma_h.min * 1e3), limit(sigma_h.max * 1e3))
                                        : "";
}

void Check::clay() {
  const double K_0 = setup_.initial.sigma_h0 / setup_.initial.sigma_v0;
  for (const Layer& layer : setup_.layers) {
    if (layer.soil != Soil::clay) continue;
    const double q = std::abs(1.0 - K_0) * vertical_stress(setup_, -layer.bottom);
    if (q <= 2.0 * setup_.clay.s_u) {
      if (!wall_shear(layer, K_0)) return;
      continue;
    }
    add("initial.sigma_h0_kPa", fmt::format("{} and {} (K_0 = {:.3g}) make a stress difference of {:.3g} kPa "
                                            "at {} m, but Tresca bears at most "
                                            "2 s_u, and {}{}",
                                            given("initial.sigma_h0_kPa"), given("initial.sigma_v0_kPa"), K_0,
                                            q / 1e3, layer.bottom, given("clay.s_u_kPa"), range_of_clay()));
    return;
  }
}

// Of all clay layers. None is told where the wall's friction narrows it.
std::string Check::range_of_clay() const {
  if (setup_.mechanisms.wall_friction.coefficient > 0.0) return "";
  double largest = 0.0;
  for (const Layer& layer : setup_.layers)
    if (layer.soil == Soil::clay) largest = std::max(largest, vertical_stress(setup_, -layer.bottom));
  const double away = 2.0 * setup_.clay.s_u / largest, sigma_v = setup_.initial.sigma_v0;
  const Quantity& sigma_h = *find_quantity("initial.sigma_h0_kPa");
  return range_of_sigma_h(std::max(sigma_h.min * 1e3, sigma_v * (1.0 - away)),
                          std::min(sigma_h.max * 1e3, sigma_v * (1.0 + away)));
}

// At the wall its friction comes on top of the stress difference.
bool Check::wall_shear(const Layer& layer, double K_0) {
  const double coefficient = setup_.mechanisms.wall_friction.coefficient;
  for (const double depth : {layer.top, layer.bottom}) {
    const double sigma_v = vertical_stress(setup_, -depth);
    const double shear = coefficient * K_0 * sigma_v;
    const double largest = std::hypot(0.5 * (1.0 - K_0) * sigma_v, shear);
    if (largest <= setup_.clay.s_u) continue;
    add("wall_friction.coefficient",
        fmt::format("{} makes a shear stress of {:.3g} kPa at the wall at {} m, with that of K_0 = {:.3g} "
                    "{:.3g} kPa, but Tresca bears at most s_u, and {}",
                    given("wall_friction.coefficient"), shear / 1e3, depth, K_0, largest / 1e3,
                    given("clay.s_u_kPa")));
    return false;
  }
  return true;
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
  if (numerics.near_width_radius >= setup_.chamber.radius)
    add("numerics.near_width_radius_m",
        fmt::format("{} must be below {}", given("numerics.near_width_radius_m"), given("chamber.radius_m")));
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
  if (exceeds(penetrometer.final_depth + numerics.zone_below + 2.0 * numerics.near_height,
              setup_.chamber.soil_height))
    add("penetrometer.final_depth_m",
        fmt::format("{} and {} leave no room for the compressing mesh above the bottom, {}",
                    given("penetrometer.final_depth_m"), given("numerics.zone_below_m"),
                    given("chamber.soil_height_m")));
}

bool Check::zones() {
  const std::size_t before = problems_.size();
  double inner = setup_.penetrometer.diameter / 2.0;
  if (setup_.numerics.zones.empty()) add("numerics.zones", "there is no zone of material points");
  for (const PointZone& zone : setup_.numerics.zones) {
    if (!(zone.outer_radius > inner) || !std::isfinite(zone.outer_radius))
      add("numerics.zones",
          fmt::format("the outer radius {} m must exceed {} m, that of the zone inside it or of the "
                      "penetrometer",
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

// Layers and lenses are made of whole rows of points; the first that is not made tells.
void Check::made() {
  const std::vector<Layer> layers = actual_setup(setup_).layers;
  const bool shifted = setup_.mechanisms.layer_shift.shift != 0.0;
  for (const Layer& layer : layers)
    if (!(layer.bottom > layer.top + touching))
      return add("layer_shift.shift_mm", fmt::format("{} leaves nothing of the layer down to {:.4g} m",
                                                     given("layer_shift.shift_mm"), layer.bottom));
  const std::vector<MadeInterval> all = made_layers(setup_);
  const std::size_t zones = all.size() / layers.size();
  for (std::size_t k = 0; k < layers.size() && zones > 0; ++k) {
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(k * zones);
    const std::string why = not_made(setup_, {first, first + static_cast<std::ptrdiff_t>(zones)},
                                     layers[k].soil == Soil::sand ? "the sand" : "the clay");
    if (why.empty()) continue;
    add(shifted ? "layer_shift.shift_mm" : "layers",
        shifted ? fmt::format("with {}, {}", given("layer_shift.shift_mm"), why) : why);
    break;
  }
  if (const std::string why = not_made(setup_, made_lens(setup_), "the density lens"); !why.empty())
    add("density_lens.thickness_mm", fmt::format("with {}, {}", given("density_lens.thickness_mm"), why));
}

// A cell lower or narrower than the spacing of the material points is sure to be empty at some time, and
// empty cells ruin a run. A margin of 1.2 is advisable; only the impossible is refused.
void Check::cells() {
  const Numerics numerics = refined(setup_.numerics);
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

std::vector<Problem> problems(const Setup& setup) { return Check(setup).run(); }

}  // namespace cpt::solver
