#include "solver/quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <map>
#include <mutex>
#include <stdexcept>

#include "solver/mechanisms/catalogue.hpp"
#include "solver/quantity_builders.hpp"
#include "solver/step_levels.hpp"

namespace cpt::solver {
namespace {

// The last layer follows the height of the soil, so that a homogeneous profile stays one layer.
void set_soil_height(Setup& setup, double value) {
  setup.chamber.soil_height = value;
  if (!setup.layers.empty()) setup.layers.back().bottom = value;
}

// Of an input that came after results had been stored.
Quantity silent(Quantity quantity) {
  quantity.silent_default = quantity.get(Setup());
  return quantity;
}

bool with_friction(const Law& law) { return law.has_friction(); }
bool with_adhesion(const Law& law) { return law.has_adhesion(); }
bool treated_as_sand(const Law& law) { return law.treated_as() == TreatedAs::sand; }

constexpr std::string_view chamber_tests = "Yost et al. (2023), section 3; De Lange (2018)";
constexpr std::string_view paper_model = "Yost et al. (2023), section 4.1";
constexpr std::string_view numerical = "numerical setting";

// The law's parameters as inputs of a setup with a soil of that name.
std::vector<Quantity> soil_quantities(const std::string& soil, const Law& law) {
  std::vector<Quantity> list;
  for (const LawQuantity& parameter : law.quantities()) {
    const auto parameters_in = [soil](auto& setup) -> auto& {
      for (auto& candidate : setup.soils)
        if (candidate.name == soil) return candidate.parameters;
      throw std::logic_error("the setup has no soil " + soil);
    };
    list.push_back({soil + "." + std::string(parameter.name), std::string(parameter.symbol), parameter.unit,
                    parameter.scale, parameter.min, parameter.max, parameter.choices, parameter.integer, soil,
                    nullptr, parameter.meaning, parameter.source,
                    [=](const Setup& setup) { return parameter.get(parameters_in(setup)); },
                    [=](Setup& setup, double value) { parameter.set(parameters_in(setup), value); },
                    parameter.silent ? std::optional(parameter.get(law.defaults())) : std::nullopt});
  }
  return list;
}

std::vector<Quantity> boundary_quantities() {
  constexpr auto contact = &Setup::contact;
  constexpr auto chamber = &Setup::chamber;
  constexpr auto initial = &Setup::initial;
  auto soil_height =
      number<chamber, &Chamber::soil_height>("chamber.soil_height_m", "h_soil", metres, 0.2, 3.0, any_soil,
                                             "height of the soil; the last layer follows it", paper_model);
  soil_height.set = set_soil_height;
  return {
      number<contact, &Contact::friction_ratio>(
          "contact.friction_ratio", "φ_cont/φ_cs", none, 0.0, 1.0, with_friction,
          "contact friction angle of cone and sand over phi_cs",
          "Yost et al. (2023), section 4.4; Durgunoglu & Mitchell (1973)"),
      number<contact, &Contact::adhesion_ratio>("contact.adhesion_ratio", "a/sᵤ", none, 0.0, 1.0,
                                                with_adhesion, "contact adhesion of cone and clay over s_u",
                                                "Yost et al. (2023), section 4.4; Potyondy (1961)"),
      choice<contact, &Contact::shoulder_normal>(
          "contact.shoulder_normal", "shoulder normal", {"shaft", "bisector", "face"}, any_soil,
          "contact normal of the node on the cone's shoulder", numerical),
      number<chamber, &Chamber::radius>("chamber.radius_m", "R", metres, 0.1, 5.0, any_soil,
                                        "inner radius of the chamber", chamber_tests),
      std::move(soil_height),
      choice<chamber, &Chamber::wall>("chamber.wall", "wall", {"flexible", "rigid"}, any_soil,
                                      "radial boundary: constant radial stress, or no radial movement",
                                      paper_model),
      choice<chamber, &Chamber::surcharge>("chamber.surcharge", "surcharge", {"traction", "layer"}, any_soil,
                                           "how sigma_v0 is applied at the soil's top", paper_model),
      number<chamber, &Chamber::surcharge_height>("chamber.surcharge_height_m", "h_sur", metres, 0.1, 3.0,
                                                  any_soil, "height of the surcharge layer", paper_model),
      number<chamber, &Chamber::surcharge_E>("chamber.surcharge_E_kPa", "E_sur", kilopascals, 10.0, 1.0e5,
                                             any_soil, "Young's modulus of the surcharge layer", numerical),
      number<chamber, &Chamber::surcharge_nu>("chamber.surcharge_nu", "ν_sur", none, 0.0, 0.45, any_soil,
                                              "Poisson's ratio of the surcharge layer", numerical),
      number<initial, &InitialStress::sigma_v0>("initial.sigma_v0_kPa", "σ'ᵥ₀", kilopascals, 1.0, 2000.0,
                                                any_soil, "vertical effective stress at the soil's top",
                                                chamber_tests),
      number<initial, &InitialStress::sigma_h0>("initial.sigma_h0_kPa", "σ'ₕ₀", kilopascals, 0.5, 4000.0,
                                                any_soil, "horizontal effective stress at the soil's top",
                                                chamber_tests),
      choice<initial, &InitialStress::self_weight>(
          "initial.self_weight", "self-weight", {"none", "submerged", "saturated"}, any_soil,
          "unit weight that raises the stress with depth", paper_model),
  };
}

std::vector<Quantity> penetrometer_quantities() {
  constexpr auto group = &Setup::penetrometer;
  return {
      number<group, &Penetrometer::diameter>("penetrometer.diameter_m", "d", metres, 0.005, 0.1, any_soil,
                                             "diameter of the penetrometer", chamber_tests),
      number<group, &Penetrometer::apex>("penetrometer.apex_deg", "α", degrees, 30.0, 120.0, any_soil,
                                         "apex angle of the cone", chamber_tests),
      number<group, &Penetrometer::speed>("penetrometer.speed_m_per_s", "v", metres_per_second, 0.001, 0.5,
                                          any_soil, "speed of the push", paper_model),
      number<group, &Penetrometer::sleeve_length>(
          "penetrometer.sleeve_length_m", "l_sleeve", metres, 0.005, 0.5, any_soil,
          "length of the friction sleeve above the shoulder", "ISO 22476-1, scaled to the cone's diameter"),
      number<group, &Penetrometer::final_depth>("penetrometer.final_depth_m", "z_end", metres, 0.01, 3.0,
                                                any_soil, "depth of the tip at the end of the push",
                                                chamber_tests),
  };
}

std::vector<Quantity> numerics_quantities() {
  constexpr auto group = &Setup::numerics;
  return {
      number<group, &Numerics::face_elements>("numerics.face_elements", "n_face", none, 1.0, 16.0, any_soil,
                                              "elements over the cone's radius", paper_model),
      number<group, &Numerics::near_height>("numerics.near_height_m", "h_near", metres, 0.0005, 0.05,
                                            any_soil, "cell height around the tip, at a cone of 25.3 mm",
                                            paper_model),
      number<group, &Numerics::near_width_radius>(
          "numerics.near_width_radius_m", "r_near", metres, 0.005, 5.0, any_soil,
          "radius up to which columns keep the near width, at a cone of 25.3 mm", numerical),
      number<group, &Numerics::far_width>("numerics.far_width_m", "w_far", metres, 0.002, 0.5, any_soil,
                                          "column width at the wall, at a cone of 25.3 mm", numerical),
      silent(number<group, &Numerics::width_growth>(
          "numerics.width_growth", "g_w", none, 1.0, 2.0, any_soil,
          "width of a column over its inner neighbour's, from the near to the far width", numerical)),
      number<group, &Numerics::coarse_rows_radius>(
          "numerics.coarse_rows_radius_m", "r_coarse", metres, 0.01, 5.0, any_soil,
          "radius beyond which rows are joined two by two, at a cone of 25.3 mm", numerical),
      number<group, &Numerics::zone_below>("numerics.zone_below_m", "h_below", metres, 0.02, 1.0, any_soil,
                                           "extent of the moving zone below the tip, at a cone of 25.3 mm",
                                           numerical),
      number<group, &Numerics::zone_above>(
          "numerics.zone_above_m", "h_above", metres, 0.02, 1.0, any_soil,
          "extent of the moving zone above the shoulder, at a cone of 25.3 mm", numerical),
      number<group, &Numerics::below_height>(
          "numerics.below_height_m", "Δz_below", metres, 0.001, 0.2, any_soil,
          "row height of the compressing zone at the start, at a cone of 25.3 mm", numerical),
      number<group, &Numerics::above_height>(
          "numerics.above_height_m", "Δz_above", metres, 0.001, 0.2, any_soil,
          "row height of the stretching zone at the start, at a cone of 25.3 mm", numerical),
      silent(number<group, &Numerics::refinement>(
          "numerics.refinement", "r", none, 0.5, 8.0, any_soil,
          "divides all lengths of the mesh and the spacing of the material points", numerical)),
      silent(number<group, &Numerics::point_density>("numerics.point_density", "f_point", none, 0.25, 16.0,
                                                     any_soil, "factor on the material points in a cell",
                                                     numerical)),
      number<group, &Numerics::point_shift>(
          "numerics.point_shift", "shift", none, -0.5, 0.5, any_soil,
          "draws where the material points lie, up to a tenth of their spacing "
          "off their grid",
          numerical),
      number<group, &Numerics::courant>("numerics.courant", "Co", none, 0.05, 0.98, any_soil,
                                        "Courant number", "0.95 in Yost et al. (2023), section 4.1"),
      number<group, &Numerics::mass_scaling>("numerics.mass_scaling", "f_mass", none, 1.0, 1.0e6, any_soil,
                                             "factor on the inertia, not on the weight", paper_model),
      number<group, &Numerics::step_levels>("numerics.step_levels", "n_levels", none, 0.0, highest_level,
                                            any_soil,
                                            "local time steps: soft and large cells are updated every 2nd, "
                                            "4th, ... 2^n-th step; 0: all of them at "
                                            "every step",
                                            numerical),
      number<group, &Numerics::pic_fraction>("numerics.pic_fraction", "PIC", none, 0.0, 1.0, any_soil,
                                             "share of PIC of second order in the velocity update; 0 is FLIP",
                                             numerical),
      number<group, &Numerics::local_damping>("numerics.local_damping", "α_damp", none, 0.0, 0.9, any_soil,
                                              "local damping over the out-of-balance force", numerical),
      number<group, &Numerics::bulk_viscosity>("numerics.bulk_viscosity", "b_1", none, 0.0, 1.0, any_soil,
                                               "linear bulk viscosity; damps pressure waves", numerical),
      number<group, &Numerics::stress_smoothing_clay>(
          "numerics.stress_smoothing_clay", "β_clay", none, 0.0, 1.0, any_soil,
          "share of the quadrant's average stress given back to its points, clay and surcharge layer",
          numerical),
      number<group, &Numerics::stress_smoothing_sand>(
          "numerics.stress_smoothing_sand", "β_sand", none, 0.0, 1.0, treated_as_sand,
          "share of the quadrant's average stress given back to its points, sand", numerical),
      number<group, &Numerics::start_distance>(
          "numerics.start_distance_m", "s_start", metres, 0.0, 0.1, any_soil,
          "travel over which the push gets up to its speed, at a cone of 25.3 mm", numerical),
      number<group, &Numerics::bin_height>("numerics.bin_height_m", "Δz_bin", metres, 1.0e-5, 0.05, any_soil,
                                           "depth over which q_c and f_s are averaged in the recording",
                                           numerical),
  };
}

// All but the soils'.
std::vector<Quantity> other_quantities() {
  std::vector<Quantity> list;
  for (auto part : {boundary_quantities, penetrometer_quantities, numerics_quantities})
    for (Quantity& quantity : part()) list.push_back(std::move(quantity));
  // A mechanism that is off leaves no trace: results stay valid when the catalogue grows.
  for (const Mechanism& mechanism : all_mechanisms())
    for (const MechanismParameter& parameter : mechanism.parameters)
      list.push_back(silent(parameter.quantity));
  return list;
}

const Setup& default_setup() {
  static const Setup defaults;
  return defaults;
}

bool same_kind(const Soil& a, const Soil& b) { return a.name == b.name && &law_of(a) == &law_of(b); }

// The defaults' soils first, then the others.
struct Lists {
  std::vector<Quantity> defaults;
  std::size_t others;  // where these begin
};

const Lists& lists() {
  static const Lists made = [] {
    Lists lists;
    for (const Soil& soil : default_setup().soils)
      for (Quantity& quantity : soil_quantities(soil.name, law_of(soil)))
        lists.defaults.push_back(std::move(quantity));
    lists.others = lists.defaults.size();
    for (Quantity& quantity : other_quantities()) lists.defaults.push_back(std::move(quantity));
    return lists;
  }();
  return made;
}

// The quantities of one soil, made once for its name and law.
std::span<const Quantity> quantities_of(const Soil& soil) {
  const std::span<const Quantity> defaults = all_quantities();
  std::size_t first = 0;
  for (const Soil& known : default_setup().soils) {
    const std::size_t count = law_of(known).quantities().size();
    if (same_kind(known, soil)) return defaults.subspan(first, count);
    first += count;
  }
  static std::mutex guard;
  static std::map<std::pair<std::string, const Law*>, std::vector<Quantity>> made;
  const std::lock_guard lock(guard);
  const auto [place, is_new] = made.try_emplace({soil.name, &law_of(soil)});
  if (is_new) place->second = soil_quantities(soil.name, law_of(soil));
  return place->second;
}

// What the input of an external program is as a quantity, made once for each declaration.
const Quantity& program_quantity(const ProgramInput& input) {
  struct Made {
    ProgramInput declared;  // owns what the quantity's views show
    Quantity quantity;
  };
  static std::mutex guard;
  static std::deque<Made> made;
  const std::lock_guard lock(guard);
  const auto known = std::ranges::find(made, input, &Made::declared);
  if (known != made.end()) return known->quantity;
  Made& added = made.emplace_back(input);
  const auto place_in = [&name = added.declared.name](const Setup& setup) {
    const auto& inputs = setup.program->inputs;
    const auto found = std::ranges::find(inputs, name, &ProgramInput::name);
    if (found == inputs.end()) throw std::logic_error("the program has no input " + name);
    return static_cast<std::size_t>(found - inputs.begin());
  };
  const ProgramInput& d = added.declared;
  added.quantity = {d.name,
                    d.name,
                    d.unit,
                    1.0,
                    d.min,
                    d.max,
                    {},
                    d.integer,
                    "",
                    nullptr,
                    d.meaning,
                    "the study",
                    [=](const Setup& setup) { return setup.program_inputs[place_in(setup)]; },
                    [=](Setup& setup, double value) { setup.program_inputs[place_in(setup)] = value; }};
  return added.quantity;
}

// On one line.
std::string quoted(std::string_view text) {
  std::string line;
  for (const char c : text) {
    if (c == '\\' || c == '"') line.push_back('\\');
    if (c == '\n')
      line.append("\\n");
    else
      line.push_back(c);
  }
  return fmt::format("\"{}\"", line);
}

std::string canonical_program_text(const Setup& setup) {
  const ExternalProgram& program = *setup.program;
  std::string command;
  for (const std::string& word : program.command)
    command += fmt::format("{}{}", command.empty() ? "" : " ", quoted(word));
  std::string text =
      fmt::format("solver.command = {}\nsolver.version = {}\n", command, quoted(program.version));
  if (!program.template_name.empty())
    text += fmt::format("solver.template = {} {}\n", quoted(program.template_name),
                        quoted(program.template_text));
  if (!program.results.empty()) text += fmt::format("solver.results = {}\n", quoted(program.results));
  for (const Quantity* quantity : quantities_of(setup))
    text += fmt::format("{} = {}\n", quantity->name, quantity->format(quantity->value(setup)));
  for (const ProgramOutput& output : program.outputs)
    text += fmt::format(
        "solver.outputs = {} {}{}\n", output.name, quoted(output.unit),
        output.is_curve() ? fmt::format(" over {} {}", output.over, quoted(output.over_unit)) : "");
  return text;
}

bool default_soils(const Setup& setup) {
  return std::ranges::equal(setup.soils, default_setup().soils, same_kind);
}

}  // namespace

std::span<const Quantity> all_quantities() { return lists().defaults; }

std::vector<const Quantity*> quantities_of(const Setup& setup) {
  std::vector<const Quantity*> list;
  if (setup.program != nullptr) {
    for (const ProgramInput& input : setup.program->inputs) list.push_back(&program_quantity(input));
    return list;
  }
  for (const Soil& soil : setup.soils)
    for (const Quantity& quantity : quantities_of(soil)) list.push_back(&quantity);
  for (const Quantity& quantity : all_quantities().subspan(lists().others)) list.push_back(&quantity);
  return list;
}

const Quantity* find_quantity(std::string_view name) { return find_quantity(name, default_setup()); }

const Quantity* find_quantity(std::string_view name, const Setup& setup) {
  for (const Quantity* quantity : quantities_of(setup))
    if (quantity->name == name) return quantity;
  return nullptr;
}

bool matters(const Quantity& quantity, const Setup& setup) {
  if (quantity.soil.empty() && quantity.acts_on == nullptr) return true;
  return std::ranges::any_of(setup.layers, [&](const Layer& layer) {
    const Soil& soil = setup.soils[layer.soil];
    return quantity.acts_on != nullptr ? quantity.acts_on(law_of(soil)) : soil.name == quantity.soil;
  });
}

std::string acts_on_text(const Quantity& quantity) {
  if (!quantity.soil.empty() || quantity.acts_on == nullptr) return quantity.soil;
  std::string titles;
  for (const Law* law : all_laws())
    if (quantity.acts_on(*law)) titles += (titles.empty() ? "" : ", ") + std::string(law->title());
  return titles;
}

std::string given(const Setup& setup, std::string_view name) {
  const Quantity& quantity = *find_quantity(name, setup);
  return fmt::format("{} = {}", name, quantity.format(quantity.value(setup)));
}

double Quantity::value(const Setup& setup) const {
  // Dividing by the scale gives 28.999999999999996 % for 0.29: take the shortest number that comes back
  // exactly.
  const double si = get(setup);
  if (scale == 1.0) return si;
  const double quotient = si / scale;
  if (!std::isfinite(quotient)) return quotient;
  for (int digits = 1; digits <= 17; ++digits) {
    const double candidate = std::strtod(fmt::format("{:.{}g}", quotient, digits).c_str(), nullptr);
    if (candidate * scale == si) return candidate;
  }
  for (const double candidate : {std::nextafter(quotient, HUGE_VAL), std::nextafter(quotient, -HUGE_VAL)})
    if (candidate * scale == si) return candidate;
  return quotient;
}

std::string Quantity::format(double study_value) const {
  if (choices.empty()) return fmt::format("{}", study_value);
  const auto index = static_cast<std::size_t>(std::lround(study_value));
  return index < choices.size() ? std::string(choices[index]) : fmt::format("choice {}", study_value);
}

std::string canonical_text(const Setup& setup) {
  if (setup.program != nullptr) return canonical_program_text(setup);
  std::string text;
  if (!default_soils(setup))
    for (const Soil& soil : setup.soils)
      text += fmt::format("soils = {} {}\n", soil.name, law_of(soil).name());
  for (const Quantity* quantity : quantities_of(setup)) {
    if (quantity->silent_default == quantity->get(setup)) continue;
    const double value = quantity->value(setup);
    text += fmt::format("{} = {}", quantity->name, quantity->format(value));
    const double si = quantity->get(setup);
    if (value * quantity->scale != si)
      text += fmt::format(" (SI {})", si);  // no study value is exactly this one
    text += '\n';
  }
  for (const Layer& layer : setup.layers)
    text += fmt::format("layers = {} to {} {}\n", layer.top, layer.bottom, setup.soils[layer.soil].name);
  for (const PointZone& zone : setup.numerics.zones)
    text += fmt::format("numerics.zones = to {} columns {} rows_per_metre {}\n", zone.outer_radius,
                        zone.columns, zone.rows_per_metre);
  return text;
}

}  // namespace cpt::solver
