#include "cli/look/push_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/common/number_list.hpp"
#include "cli/common/set_quantity.hpp"
#include "cli/common/study_argument.hpp"
#include "results/ledger/provenance.hpp"
#include "solver/quantities.hpp"

namespace cpt::cli {
namespace {

void check_depth(std::string_view option, double depth, double deepest, std::string_view what) {
  if (depth >= 0.0 && depth <= deepest) return;
  throw BadInput(fmt::format("{}: depth {} m: must be 0 to {} m, {}", option, depth, deepest, what));
}

std::vector<double> field_depths(const PushArguments& arguments, const solver::Setup& setup) {
  std::vector<double> depths;
  for (const std::string& text : arguments.fields_at)
    for (const double depth : parse_numbers("--fields-at", text)) {
      check_depth("--fields-at", depth, setup.penetrometer.final_depth, "where the push ends");
      depths.push_back(depth);
    }
  if (const double step = arguments.fields_every; step != 0.0) {
    const double end = setup.penetrometer.final_depth;
    if (!(step >= 1e-4 && step <= end))
      throw BadInput(
          fmt::format("--fields-every {}: must be 0.0001 to {} m, where the push ends", step, end));
    const double start = setup.penetrometer.diameter / 2.0 / std::tan(setup.penetrometer.apex / 2.0);
    depths.push_back(0.0);
    for (int i = 1; i * step <= end * (1.0 + 1e-12); ++i)
      if (i * step > start)  // files are named by their depth: 0.15, not 0.15000000000000002
        depths.push_back(std::min(end, std::round(i * step * 1e10) / 1e10));
  }
  std::sort(depths.begin(), depths.end());
  depths.erase(std::unique(depths.begin(), depths.end()), depths.end());
  return depths;
}

results::Place parse_place(const std::string& text, const solver::Setup& setup) {
  const auto [r, depth] = parse_pair("--track", "R_M,DEPTH_M", text);
  check_depth("--track", depth, setup.chamber.soil_height, "the soil's bottom");
  if (r < 0.0 || r > setup.chamber.radius)
    throw BadInput(
        fmt::format("--track {}: radius {} m: must be 0 to {} m, the wall", text, r, setup.chamber.radius));
  return {r, depth};
}

results::DepthInterval parse_interval(std::string_view option, const std::string& text,
                                      const solver::Setup& setup) {
  const auto [from, to] = parse_pair(option, "FROM_M,TO_M", text);
  for (const double depth : {from, to})
    check_depth(option, depth, setup.chamber.soil_height, "the soil's bottom");
  if (from >= to) throw BadInput(fmt::format("{} {}: the first depth must be the smaller one", option, text));
  return {from, to};
}

// What is looked at, as text: equal texts, equal recordings.
std::string recorded(const Push& push) {
  std::string text = fmt::format("fields_at = {}\n", fmt::join(push.request.fields_at, ", "));
  for (const results::Place& place : push.request.track)
    text += fmt::format("track = {}, {}\n", place.r, place.depth);
  for (const results::DepthInterval& wall : push.request.wall_between)
    text += fmt::format("wall_between = {}, {}\n", wall.from, wall.to);
  return text + fmt::format("radial_between = {}, {}\n", push.radial_between.from, push.radial_between.to);
}

}  // namespace

Push plan_push(const PushArguments& arguments) {
  Push push;
  push.study = read_study_file(arguments.study).study;
  refuse_external(push.study, "push");
  push.realization = find_realization(push.study, arguments.id);
  push.setup = parameters::make_setup(push.study, push.realization);
  for (const std::string& setting : arguments.settings) set_quantity(push.setup, setting, "");
  std::string problems;
  for (const solver::Problem& problem : solver::problems(push.setup))
    problems += fmt::format("{}{}", problems.empty() ? "" : "\n", problem.message);
  if (!problems.empty()) throw BadInput(problems);

  push.request.fields_at = field_depths(arguments, push.setup);
  for (const std::string& text : arguments.track) push.request.track.push_back(parse_place(text, push.setup));
  for (const std::string& text : arguments.wall_between)
    push.request.wall_between.push_back(parse_interval("--wall-between", text, push.setup));
  // Unless told otherwise: clear of the soil's top and of the tip.
  const double final_depth = push.setup.penetrometer.final_depth;
  push.radial_between = arguments.radial_between.empty()
                            ? results::DepthInterval{0.25 * final_depth, 0.75 * final_depth}
                            : parse_interval("--radial-between", arguments.radial_between, push.setup);

  push.name = push.study.name;
  if (push.realization.id != 1) push.name += fmt::format("-{}", push.realization.id);
  push.folder =
      arguments.folder.empty() ? push.study.file.parent_path() / (push.name + "-push") : arguments.folder;
  return push;
}

std::map<std::string, std::string> origin_of(const Push& push, solver::Status status) {
  const parameters::Realization& realization = push.realization;
  const std::string value = value_text(push.study, realization);
  return {{"study", push.study.name},
          {"title", push.study.title},
          {"realization", fmt::format("{}", realization.id)},
          {"parameter", std::string(parameter_name(push.study, realization))},
          {"side", std::string(to_string(realization.side))},
          {"value_text", value},
          {"status", std::string(to_string(status))},
          {"setup", solver::canonical_text(push.setup)},
          {"recorded", recorded(push)},
          {"program_version", std::string(results::program_version())},
          {"solver_version", std::string(solver::solver_version())},
          {"settings_hash", results::settings_hash(push.setup)}};
}

bool is_recorded(const Push& push) {
  try {
    const auto there = results::read_histories(push.file("-histories.h5")).origin;
    const auto wanted = origin_of(push, solver::Status::completed);
    constexpr const char* what_counts[] = {"settings_hash", "status", "recorded"};
    return std::all_of(std::begin(what_counts), std::end(what_counts),
                       [&](const char* name) { return there.at(name) == wanted.at(name); });
  } catch (const results::Error&) {
    return false;  // missing, damaged or of another version
  }
}

}  // namespace cpt::cli
