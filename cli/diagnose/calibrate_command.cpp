// campaign calibrate REQUEST
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "cli/command.hpp"
#include "cli/common/study_argument.hpp"
#include "cli/diagnose/calibration_check.hpp"
#include "cli/diagnose/calibration_file.hpp"
#include "cli/diagnose/request_file.hpp"
#include "cli/emulator/emulator_argument.hpp"
#include "cli/exit_codes.hpp"
#include "diagnosis/assemble.hpp"
#include "diagnosis/calibration/assemble_calibration.hpp"
#include "recordings/spikes.hpp"
#include "reports/calibration/sentences.hpp"
#include "reports/calibration/tables.hpp"
#include "reports/calibration/write_calibration.hpp"

namespace cpt::cli {
namespace {

using namespace diagnosis;
using reports::calibrated::CalibrationReport;

struct CalibrationArguments {
  std::filesystem::path request, recordings;
  int check = 0, threads = 0;
};

std::vector<recordings::Recording> recordings_of(const CalibrationRequest& request) {
  std::vector<recordings::Recording> found;
  for (const SoundingRequest& sounding : request.soundings) {
    found.push_back(recording_of(sounding));
    for (const recordings::Spike& spike : recordings::spikes(found.back()))
      if (const double depth = found.back().readings[spike.reading].depth;
          depth >= sounding.from && depth <= sounding.to)
        fmt::print(stderr, "note: {}: {} has a spike of a single reading at {:.3f} m; it is taken as it is\n",
                   sounding.name, spike.quantity, depth);
    if (request.channels.front()->name != "q_c") continue;
    try {
      check_recording(sounding, found.back(), request.cell_height);
    } catch (const std::invalid_argument& problem) {
      throw BadInput(problem.what());
    }
  }
  return found;
}

CalibrationReport report_of(const CalibrationFile& asked, const results::Emulator& emulator,
                            const CalibrationModel& model, const SamplerOptions& limits,
                            Posterior posterior) {
  CalibrationReport report{asked.request.title,
                           asked.study.study.name,
                           static_cast<int>(emulator.runs.size()),
                           model.problem().soundings,
                           {},
                           {},
                           std::move(posterior),
                           limits};
  report.shifts_points = std::ranges::any_of(asked.study.study.rows, [](const parameters::Row& row) {
    return row.only_drawn() && row.quantity->name == "numerics.point_shift";
  });
  for (const CalibrationChannel& channel : model.problem().channels)
    report.channels.push_back({channel.name, std::string(solver::channel(channel.name).symbol)});
  for (const results::EmulatorInput& input : emulator.inputs)
    for (const parameters::Row& row : asked.study.study.rows)
      if (row.quantity->name == input.name)
        report.inputs.push_back({input.name, std::string(row.quantity->symbol), input.unit, input.lower,
                                 input.upper, input.integer || !input.choices.empty(), input.choices});
  return report;
}

int calibrate_request(const CalibrationArguments& arguments) {
  const CalibrationFile asked = read_calibration_file(arguments.request, arguments.recordings);
  if (arguments.check > 0) return check_calibration(asked, arguments.check, arguments.threads);
  const std::vector<recordings::Recording> recordings = recordings_of(asked.request);
  const results::Emulator emulator = emulator_of(asked.request.study, asked.study, true);
  if (refuse_all_channels(asked.request, emulator)) return emulator_refused;
  std::vector<std::string> notes;
  CalibrateOptions options = options_of(asked.request);
  options.sampler.threads = arguments.threads;
  try {
    const CalibrationModel model(
        assemble_calibration(asked.request, asked.study.study, emulator, recordings, notes));
    for (const std::string& note : notes) fmt::print(stderr, "note: {}\n", note);
    const CalibrationReport report =
        report_of(asked, emulator, model, options.sampler, calibrate(model, options));
    const auto files = write_calibration(report, asked.request.folder);
    fmt::print("{}: {} of {}, an emulator of {} runs\n\n", report.title, fmt::join(report.soundings, ", "),
               report.study, report.training_runs);
    fmt::print("{}\n", results::format(short_posterior_table(report), results::Format::table));
    for (const std::string& sentence : calibration_sentences(report)) fmt::print("{}\n", sentence);
    fmt::print("\nanswer in {}, rows for a new study in {}\n", asked.request.folder.string(),
               files[4].string());
  } catch (const std::invalid_argument& problem) {
    throw BadInput(problem.what());
  }
  return all_well;
}

}  // namespace

void add_calibration(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<CalibrationArguments>();
  CLI::App* command = program.add_subcommand(
      "calibrate", "Posterior of a study's parameters from recordings, by an emulator of its runs");
  command
      ->add_option("REQUEST", arguments->request,
                   "NAME.toml: the study and the recordings; the answer goes to NAME-calibration/")
      ->type_name("")
      ->required();
  command
      ->add_option(
          "--recordings", arguments->recordings,
          "Where recordings lie that are not beside the request [the folder that CPT_RECORDINGS names]")
      ->type_name("FOLDER")
      ->envname("CPT_RECORDINGS");
  command
      ->add_option(
          "--check", arguments->check,
          "Hold N of the study's drawn runs out, take each for a recording, and look at the truths' ranks")
      ->type_name("N")
      ->check(CLI::Range(10, 10000).description("10 to 10000"));
  command
      ->add_option("--threads", arguments->threads,
                   "Threads [one a core]; the answer is the same with any number")
      ->type_name("N")
      ->check(CLI::Range(1, 1024).description("1 to 1024"));
  command->footer(R"(A request is a TOML file:

  title = "Clay, first push"
  study = "clay.toml"          run before: its rows and their distributions are the prior
  [[soundings]]
  recording = "first.csv"
  columns = { depth_m = "z_m", q_c_MPa = "qc" }
  from_m = 0.04
  to_m = 0.14
  [noise]
  measurement_percent = 1
  [discrepancy]
  deviation_percent = 5        how far a simulation with the true parameters may be off

The study's emulator is taken as campaign emulate stored it, or made. Channels whose emulator is refused (Q2 < 0.9)
are left out; where all are, the exit code is 7. In NAME-calibration/: posterior.csv, draws.csv, correlation.csv,
bands.csv, figures, and posterior.toml, rows for a new study. --check writes ranks.csv and a figure, which show whether
intervals hold the truth as often as they say. docs/calibration.md says how. `campaign list calibration-keys` prints all
keys.

Examples:
  campaign calibrate first.toml
  campaign calibrate first.toml --check 100)");
  command->callback([arguments, &action] { action = [arguments] { return calibrate_request(*arguments); }; });
}

}  // namespace cpt::cli
