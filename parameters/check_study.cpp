#include "parameters/check_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parameters/all_realizations.hpp"
#include "solver/lengths.hpp"

namespace cpt::parameters {
namespace {

bool involves_doubtful(const solver::Problem& problem, const QuantitySections& sections,
                       const SoilDoubts& doubts) {
  if (problem.quantity == "layers" && doubts.depths) return true;
  return std::any_of(sections.doubtful.begin(), sections.doubtful.end(), [&](const std::string& name) {
    return problem.quantity == name || problem.message.find(name) != std::string::npos;
  });
}

// The setting of the file that a problem of the baseline is about, as its message names all that are
// involved.
const Setting* culprit(const solver::Problem& problem, const QuantitySections& sections) {
  const Setting* involved = nullptr;
  for (const Setting& setting : sections.settings) {
    if (setting.quantity->name == problem.quantity) return &setting;
    if (involved == nullptr && problem.message.find(setting.quantity->name) != std::string::npos)
      involved = &setting;
  }
  return involved;
}

void report_baseline(const solver::Problem& problem, const QuantitySections& sections,
                     const StudyPlaces& places, ErrorList& errors) {
  if (problem.quantity == "layers" && !places.layers.empty())
    return errors.add(places.layers[problem.layer.value_or(0)], "layers", problem.message);
  if (problem.quantity == "soils" && places.soils.line > 0)
    return errors.add(places.soils, "soils", problem.message);
  if (problem.quantity == "numerics.zones" && places.zones.line > 0)
    return errors.add(places.zones, "zones", problem.message);
  if (const Setting* setting = culprit(problem, sections))
    return errors.add(setting->place, setting->key, problem.message);
  errors.add(places.profile, problem.quantity, problem.message);
}

void check_physics(const Study& study, const QuantitySections& sections, const StudyPlaces& places,
                   const SoilDoubts& doubts, ErrorList& errors) {
  const std::vector<solver::Problem> of_baseline = solver::problems(study.baseline);
  for (const solver::Problem& problem : of_baseline)
    if (!involves_doubtful(problem, sections, doubts)) report_baseline(problem, sections, places, errors);

  const auto in_baseline = [&](const solver::Problem& problem) {
    return std::any_of(of_baseline.begin(), of_baseline.end(),
                       [&](const solver::Problem& other) { return other.quantity == problem.quantity; });
  };
  bool design_told = false, repeats_seen = false;
  for (const Realization& realization : all_realizations(study)) {
    if (realization.side == Side::baseline) continue;
    repeats_seen = repeats_seen || realization.side == Side::repeat;
    // The pairs of repeats come last; what is wrong with them is so with their bound.
    if (repeats_seen && realization.side == Side::point) break;
    if (realization.point >= 0) {
      const auto point = static_cast<std::size_t>(realization.point);
      const bool of_design = point - study.design.first_point < study.design.points;
      for (const solver::Problem& problem : solver::problems(make_setup(study, realization))) {
        if (in_baseline(problem) || involves_doubtful(problem, sections, doubts) ||
            (of_design && design_told))
          continue;
        errors.add(places.points[point],
                   fmt::format("{}.{}", of_design ? "design" : "points", parameter_name(study, realization)),
                   problem.message,
                   of_design
                       ? fmt::format("narrow the bounds: this run has {}", value_text(study, realization))
                       : "");
        design_told = design_told || of_design;
      }
      continue;
    }
    const PlacedRow& placed = sections.rows[static_cast<std::size_t>(realization.row)];
    for (const solver::Problem& problem : solver::problems(make_setup(study, realization))) {
      if (in_baseline(problem) || involves_doubtful(problem, sections, doubts)) continue;
      errors.add(realization.side == Side::lower ? placed.lower : placed.upper,
                 fmt::format("parameters.{}.{}", placed.row.quantity->name, to_string(realization.side)),
                 problem.message);
    }
  }
}

// A final depth that reaches the window, if the chamber is high enough for one.
std::string deeper_hint(const Study& study, double depth) {
  solver::Setup setup = study.baseline;
  setup.penetrometer.final_depth = std::ceil(depth * 100.0 + 0.2) / 100.0;
  return solver::problems(setup).empty()
             ? fmt::format("penetrometer.final_depth_m = {:.2f} reaches it", setup.penetrometer.final_depth)
             : "";
}

// Where the depths of a window may lie that the push has from `start` to `end`; an end that is itself in
// doubt is infinite. Nothing where there is no room.
std::string range_hint(const Window& window, double start, double end) {
  const bool fixed = window.kind == Window::Kind::fixed;
  const double margin = fixed ? 0.0 : window.width / 2.0;
  const double from = std::ceil((start + margin) * 1e4 - 1e-6) / 1e4, to = end - margin;
  if (!(from < to)) return "";
  const std::string_view which = fixed ? "from_m and to_m" : "between_m, with half of width_m to spare,";
  return std::isinf(to) ? fmt::format("{} may lie from {:.6g} m on", which, from)
                        : fmt::format("{} may lie from {:.6g} to {:.6g} m", which, from, to);
}

void check_windows(const Study& study, const QuantitySections& sections, const StudyPlaces& places,
                   ErrorList& errors) {
  double start = 0.0, end = INFINITY, bin = 0.0;  // [m] what every realization covers
  for (const Realization& realization : all_realizations(study)) {
    const solver::Setup setup = make_setup(study, realization);
    start = std::max(start, setup.penetrometer.diameter / 2.0 / std::tan(setup.penetrometer.apex / 2.0));
    end = std::min(end, setup.penetrometer.final_depth);
    bin = std::max(bin, setup.numerics.bin_height);
  }
  for (std::size_t i = 0; i < study.windows.size(); ++i) {
    const Window& window = study.windows[i];
    const bool fixed = window.kind == Window::Kind::fixed;
    const double margin = fixed ? 0.0 : window.width / 2.0;
    const double width = fixed ? window.to - window.from : window.width;
    const std::string key = fmt::format("windows.{}", window.name);
    const Place place = places.windows[i];
    const bool sound_end = !sections.doubtful.contains("penetrometer.final_depth_m");
    const std::string range = range_hint(window, start, sound_end ? end : INFINITY);
    if (solver::exceeds(window.to + margin, end) && sound_end) {
      const std::string deeper = deeper_hint(study, window.to + margin);
      errors.add(place, key,
                 fmt::format("reaches {:.6g} m, but the push ends at penetrometer.final_depth_m = {}",
                             window.to + margin, end),
                 deeper.empty() ? range : deeper);
    }
    if (solver::falls_short(window.from - margin, start))
      errors.add(place, key,
                 fmt::format("starts at {:.6g} m, above the depth of the tip at the start, {:.4f} m",
                             window.from - margin, start),
                 range);
    if (solver::falls_short(width, bin) && !sections.doubtful.contains("numerics.bin_height_m"))
      errors.add(place, key,
                 fmt::format("is {} m wide, less than one bin of the recording, numerics.bin_height_m = {}",
                             width, bin));
  }
}

}  // namespace

void check_study(const Study& study, const QuantitySections& sections, const StudyPlaces& places,
                 const SoilDoubts& doubts, ErrorList& errors) {
  check_physics(study, sections, places, doubts, errors);
  if (study.baseline.program == nullptr) check_windows(study, sections, places, errors);
}

}  // namespace cpt::parameters
