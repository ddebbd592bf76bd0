// campaign push STUDY [ID]
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "campaign/cores.hpp"
#include "campaign/progress_display.hpp"
#include "campaign/stop_signals.hpp"
#include "cli/command.hpp"
#include "cli/exit_codes.hpp"
#include "cli/look/push_plan.hpp"
#include "results/ledger/provenance.hpp"
#include "results/push/radial_profile.hpp"

namespace cpt::cli {
namespace {

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

results::Table profile_table(const solver::DepthProfile& profile) {
  results::Table table{{"depth_m"}, {}};
  for (const double depth : profile.depth) table.rows.push_back({depth});
  for (const solver::Channel& channel : solver::channels()) {
    table.columns.push_back(in_unit(channel, "kPa"));
    const std::vector<double>& values = profile.*channel.values;
    for (std::size_t i = 0; i < values.size(); ++i) table.rows[i].emplace_back(values[i] * 1e-3);
  }
  return table;
}

// "q_c, f_s, wall_stress"
std::string channel_names() {
  std::string names;
  for (const solver::Channel& channel : solver::channels())
    names += (names.empty() ? "" : ", ") + std::string(channel.name);
  return names;
}

void print_histories(const results::Histories& histories) {
  for (const results::PointHistory& point : histories.points)
    fmt::print("  r {} m, depth {} m: nearest is {} at r {:.4f} m, depth {:.4f} m\n", point.wanted.r,
               point.wanted.depth, point.material, point.start.r, point.start.depth);
  for (const results::WallHistory& wall : histories.walls)
    fmt::print("  wall from {} to {} m: {} material points\n", wall.between.from, wall.between.to,
               wall.points);
}

// The histories come last: where they are, all else is there.
void write_results(const Push& push, const solver::Outcome& outcome, const Watch& watch,
                   const results::FieldSeries& fields) {
  if (fields.size() > 0) fmt::print("fields at {} depth(s): {}\n", fields.size(), fields.file().string());

  results::Histories histories = watch.histories();
  histories.origin = origin_of(push, outcome.status);
  histories.profile = outcome.profile;

  const auto profile_file = push.file("-profile.csv"), radial_file = push.file("-radial.csv"),
             histories_file = push.file("-histories.h5");
  results::write_csv(profile_file, profile_table(outcome.profile));
  fmt::print("{}, {} depth bins: {}\n", channel_names(), outcome.profile.depth.size(), profile_file.string());
  if (!histories.end.r.empty()) {
    results::write_csv(radial_file, ring_table(radial_profile(histories.end, push.radial_between,
                                                              push.setup.penetrometer.diameter / 10.0)));
    fmt::print("void ratio by radius, {:.4g} to {:.4g} m deep: {}\n", push.radial_between.from,
               push.radial_between.to, radial_file.string());
  }
  results::write_histories(histories_file, histories);
  fmt::print("histories of {} material points and {} parts of the wall, {} rows: {}\n",
             histories.points.size(), histories.walls.size(), histories.tip_depth.size(),
             histories_file.string());
  print_histories(histories);
}

int run_push(const PushArguments& arguments) {
  const Push push = plan_push(arguments);
  if (arguments.keep && is_recorded(push)) {
    fmt::print("realization {} of {}: kept as it is, {}\n", push.realization.id, push.study.name,
               push.folder.string());
    return all_well;
  }
  const campaign::StopSignals signals;
  results::FieldSeries fields(
      push.folder / (push.name + "-fields"), push.name,
      fmt::format("campaign {} (solver {}), study {}, realization {}, settings {}",
                  results::program_version(), solver::solver_version(), push.study.name, push.realization.id,
                  results::settings_hash(push.setup)),
      results::point_quantities(push.setup));
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
  auto arguments = std::make_shared<PushArguments>();
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
      ->add_option("--fields-every", arguments->fields_every,
                   "Write the fields at the start and whenever the tip has gone so far; campaign view draws "
                   "them")
      ->type_name("M");
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
  command->add_flag("--keep", arguments->keep,
                    "Do nothing if FOLDER holds this push already: same inputs, solver and recording");
  command->footer(R"(Writes to FOLDER (docs/output.md describes the files)
  NAME-fields/NAME.pvd   stress, void ratio, displacement, ... at the chosen depths; opens in ParaView;
                         campaign view draws them
  NAME-histories.h5      material points and wall stresses over the push, all of the soil at its end
  NAME-profile.csv       q_c, f_s and the wall's stress over depth
  NAME-radial.csv        void ratio and its change by radius, at the end
NAME is the study's, with -ID unless that is the baseline. Options with ... take several values.

Examples:
  campaign push sens.toml --fields-at 0,0.2,0.4,0.53 --out fields
  campaign push sens.toml --fields-every 0.01
  campaign push sens.toml 4 --track 0.01265,0.5 0.0253,0.5 0.03795,0.5 --wall-between 0.45,0.55
  campaign push sens.toml --set sand.D_r_percent=60 chamber.wall=flexible --radial-between 0.2,0.4)");
  command->callback([arguments, &action] { action = [arguments] { return run_push(*arguments); }; });
}

}  // namespace cpt::cli
