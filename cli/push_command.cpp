// campaign push STUDY [ID]
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "campaign/cores.hpp"
#include "campaign/progress_display.hpp"
#include "campaign/stop_signals.hpp"
#include "cli/command.hpp"
#include "cli/exit_codes.hpp"
#include "cli/number_list.hpp"
#include "cli/set_quantity.hpp"
#include "cli/study_argument.hpp"
#include "results/provenance.hpp"
#include "results/push_recorder.hpp"
#include "results/radial_profile.hpp"
#include "solver/quantities.hpp"

namespace cpt::cli {
namespace {

struct Arguments {
  std::filesystem::path study;
  int id = 1;
  std::vector<std::string> settings;  // name=value
  std::vector<std::string> fields_at, track, wall_between;
  std::string radial_between;
  std::filesystem::path folder;
  int threads = 0;
};

/// One push: its input, what to record, and where that goes.
struct Push {
  parameters::Study study;
  parameters::Realization realization;
  solver::Setup setup;
  results::PushRequest request;
  results::DepthInterval radial_between{};
  std::filesystem::path folder;
  std::string name;  // of the files
};

// Shows progress, and ends the push when a signal asks for it.
class Watch final : public results::PushRecorder {
 public:
  using PushRecorder::PushRecorder;

  void progress(const solver::Progress& now) override {
    const double rate = static_cast<double>(now.steps * now.material_points) / now.wall_seconds;
    display_.update(
        fmt::format("tip at {:.3f} of {:.3f} m, {}, {:.1f} million material-point steps/s", now.depth,
                    now.final_depth, campaign::format_duration(now.wall_seconds), rate * 1e-6),
        now.wall_seconds);
  }

  bool stop_requested(std::string& reason) override {
    if (campaign::StopSignals::received() == 0) return PushRecorder::stop_requested(reason);
    reason = "stopped by a signal";
    return true;
  }

  void finish() { display_.finish(); }

 private:
  campaign::ProgressDisplay display_{stderr, campaign::ProgressDisplay::style_of(stderr)};
};

void check_depth(std::string_view option, double depth, double deepest, std::string_view what) {
  if (depth >= 0.0 && depth <= deepest) return;
  throw BadInput(fmt::format("{}: depth {} m: must be 0 to {} m, {}", option, depth, deepest, what));
}

std::vector<double> field_depths(const Arguments& arguments, const solver::Setup& setup) {
  std::vector<double> depths;
  for (const std::string& text : arguments.fields_at)
    for (const double depth : parse_numbers("--fields-at", text)) {
      check_depth("--fields-at", depth, setup.penetrometer.final_depth, "where the push ends");
      depths.push_back(depth);
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

Push make_push(const Arguments& arguments) {
  Push push;
  push.study = read_study_file(arguments.study).study;
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

std::map<std::string, std::string> origin_of(const Push& push, const solver::Outcome& outcome) {
  const parameters::Realization& realization = push.realization;
  std::string value;
  if (realization.row >= 0)
    value = push.study.rows[static_cast<std::size_t>(realization.row)].quantity->format(
        parameter_value(push.study, realization));
  return {{"study", push.study.name},
          {"title", push.study.title},
          {"realization", fmt::format("{}", realization.id)},
          {"parameter", std::string(parameter_name(push.study, realization))},
          {"side", std::string(to_string(realization.side))},
          {"value_text", value},
          {"status", std::string(to_string(outcome.status))},
          {"setup", solver::canonical_text(push.setup)},
          {"program_version", std::string(results::program_version())},
          {"solver_version", std::string(solver::solver_version())},
          {"settings_hash", results::settings_hash(push.setup)}};
}

results::Table profile_table(const solver::DepthProfile& profile) {
  results::Table table{{"depth_m", "q_c_kPa", "f_s_kPa"}, {}};
  for (std::size_t i = 0; i < profile.depth.size(); ++i)
    table.rows.push_back({profile.depth[i], profile.q_c[i] * 1e-3, profile.f_s[i] * 1e-3});
  return table;
}

void write_results(const Push& push, const solver::Outcome& outcome, const Watch& watch,
                   const results::FieldSeries& fields) {
  const auto file = [&](const char* part) { return push.folder / (push.name + part); };
  if (fields.size() > 0) fmt::print("fields at {} depth(s): {}\n", fields.size(), fields.file().string());

  results::Histories histories = watch.histories();
  histories.origin = origin_of(push, outcome);
  histories.profile = outcome.profile;
  results::write_histories(file("-histories.h5"), histories);
  fmt::print("histories of {} material points and {} parts of the wall, {} rows: {}\n",
             histories.points.size(), histories.walls.size(), histories.tip_depth.size(),
             file("-histories.h5").string());
  for (const results::PointHistory& point : histories.points)
    fmt::print("  r {} m, depth {} m: nearest is {} at r {:.4f} m, depth {:.4f} m\n", point.wanted.r,
               point.wanted.depth, point.material, point.start.r, point.start.depth);
  for (const results::WallHistory& wall : histories.walls)
    fmt::print("  wall from {} to {} m: {} material points\n", wall.between.from, wall.between.to,
               wall.points);

  results::write_csv(file("-profile.csv"), profile_table(outcome.profile));
  fmt::print("q_c and f_s, {} depth bins: {}\n", outcome.profile.depth.size(), file("-profile.csv").string());

  if (watch.end().empty()) return;
  results::write_csv(file("-radial.csv"),
                     results::radial_profile(watch.start(), watch.end(), push.radial_between,
                                             push.setup.penetrometer.diameter / 10.0));
  fmt::print("void ratio by radius, {:.4g} to {:.4g} m deep: {}\n", push.radial_between.from,
             push.radial_between.to, file("-radial.csv").string());
}

int run_push(const Arguments& arguments) {
  const Push push = make_push(arguments);
  const campaign::StopSignals signals;
  results::FieldSeries fields(
      push.folder / (push.name + "-fields"), push.name,
      fmt::format("campaign {} (solver {}), study {}, realization {}, settings {}",
                  results::program_version(), solver::solver_version(), push.study.name, push.realization.id,
                  results::settings_hash(push.setup)));
  Watch watch(push.request, push.setup, fields);
  const int threads = arguments.threads > 0 ? arguments.threads : campaign::use_allowed_cores(false);
  const solver::Outcome outcome =
      solver::simulate(push.setup, watch, {threads, push.study.wall_limit_seconds});
  watch.finish();
  watch.rethrow();

  fmt::print("realization {} of {}: {}{}, {} material points, {} steps, {}\n", push.realization.id,
             push.study.name, to_string(outcome.status), outcome.reason.empty() ? "" : ": " + outcome.reason,
             outcome.material_points, outcome.steps, campaign::format_duration(outcome.wall_seconds));
  write_results(push, outcome, watch, fields);
  if (campaign::StopSignals::received() != 0) return stopped_by_signal + campaign::StopSignals::received();
  return outcome.status == solver::Status::completed ? all_well : realizations_failed;
}

}  // namespace

void add_push(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand(
      "push", "Run one realization and write its fields, histories and radial profile");
  command->add_option("STUDY", arguments->study, "Study file; its database is neither read nor changed")
      ->type_name("")
      ->required();
  command->add_option("ID", arguments->id, "Realization, as campaign STUDY --plan lists it [1, the baseline]")
      ->type_name("");
  command
      ->add_option("--set", arguments->settings, "Any quantity, in its study unit, in place of the study's")
      ->type_name("NAME=VALUE");
  command
      ->add_option("--fields-at", arguments->fields_at,
                   "Depths of the tip at which to write the fields; 0 is the start")
      ->type_name("M,M");
  command
      ->add_option("--track", arguments->track,
                   "Follow the material point that starts nearest to this radius and depth")
      ->type_name("R_M,DEPTH_M");
  command
      ->add_option("--wall-between", arguments->wall_between,
                   "Follow the stresses at the wall, averaged between two depths")
      ->type_name("FROM_M,TO_M");
  command
      ->add_option(
          "--radial-between", arguments->radial_between,
          "Depths between which the void ratio is averaged by radius, at the end [middle half of the "
          "push]")
      ->type_name("FROM_M,TO_M");
  command->add_option("--out", arguments->folder, "Folder for all files [NAME-push beside the study]")
      ->type_name("FOLDER");
  command->add_option("--threads", arguments->threads, "Threads [all cores]; no result depends on it")
      ->type_name("N")
      ->check(CLI::Range(1, 4096).description(""));
  command->footer(R"(Writes to FOLDER (docs/output.md describes the files)
  NAME-fields/NAME.pvd   stress, void ratio, displacement, ... at the chosen depths; opens in ParaView
  NAME-histories.h5      material points and wall stresses over the push
  NAME-profile.csv       q_c and f_s over depth
  NAME-radial.csv        void ratio and its change by radius, at the end
NAME is the study's, with -ID unless that is the baseline. Options with ... take several values.

Examples:
  campaign push sens.toml --fields-at 0,0.2,0.4,0.53 --out fields
  campaign push sens.toml 4 --track 0.01265,0.5 0.0253,0.5 0.03795,0.5 --wall-between 0.45,0.55
  campaign push sens.toml --set sand.D_r_percent=60 chamber.wall=flexible --radial-between 0.2,0.4)");
  command->callback([arguments, &action] { action = [arguments] { return run_push(*arguments); }; });
}

}  // namespace cpt::cli
