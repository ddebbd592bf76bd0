#include "cli/diagnose/calibration_check.hpp"

#include <fmt/format.h>

#include "cli/emulator/emulator_argument.hpp"
#include "cli/exit_codes.hpp"
#include "diagnosis/calibration/assemble_calibration.hpp"
#include "diagnosis/calibration/rank_check.hpp"
#include "parameters/all_realizations.hpp"
#include "reports/calibration/sentences.hpp"
#include "reports/calibration/tables.hpp"
#include "reports/calibration/write_calibration.hpp"

namespace cpt::cli {

using namespace diagnosis;

namespace {

// The inputs of a run, in study units.
VectorXd inputs_of(const parameters::Study& study, const CalibrationModel& model, int id) {
  const solver::Setup setup = parameters::make_setup(study, find_realization(study, id));
  const auto& inputs = model.problem().inputs;
  VectorXd values(static_cast<Index>(inputs.size()));
  for (std::size_t j = 0; j < inputs.size(); ++j)
    for (const parameters::Row& row : study.rows)
      if (row.quantity->name == inputs[j].name) values(static_cast<Index>(j)) = row.quantity->value(setup);
  return values;
}

const results::TrainingOutput& output_of(const results::TrainingRuns& runs, const std::string& channel) {
  const std::string name = solver::in_unit(solver::channel(channel), "kPa");
  for (const results::TrainingOutput& output : runs.outputs)
    if (output.name == name) return output;
  throw results::Error("no curve " + name);
}

std::vector<RankCase> cases_of(const CalibrationFile& asked, const results::TrainingRuns& runs,
                               const CalibrationModel& model, const std::vector<Index>& held_out) {
  std::vector<RankCase> cases;
  for (const Index run : held_out) {
    const int id = runs.runs[static_cast<std::size_t>(run)].id;
    RankCase made{fmt::format("run {}", id), inputs_of(asked.study.study, model, id), {}};
    for (const CalibrationChannel& channel : model.problem().channels) {
      const results::TrainingOutput& output = output_of(runs, channel.name);
      made.curves.push_back(curve_at_cells(channel, output.abscissa, output.values.col(run)));
    }
    cases.push_back(std::move(made));
  }
  return cases;
}

}  // namespace

int check_calibration(const CalibrationFile& asked, int count, int threads) {
  const results::TrainingRuns runs = training_runs(asked.request.study, asked.study);
  std::vector<std::string> notes;
  try {
    const std::vector<Index> held_out = held_out_runs(asked.study.study, runs, count, asked.request.seed);
    const results::Emulator emulator = results::make_emulator(without_runs(runs, held_out), notes);
    if (refuse_all_channels(asked.request, emulator)) return emulator_refused;
    const CalibrationModel model(assemble_unrecorded(asked.request, asked.study.study, emulator, notes));
    for (const std::string& note : notes) fmt::print(stderr, "note: {}\n", note);

    reports::calibrated::RankReport report{asked.request.title,
                                           asked.study.study.name,
                                           static_cast<int>(emulator.runs.size()),
                                           {},
                                           asked.request.seed};
    report.check = rank_check(model, cases_of(asked, runs, model, held_out), options_of(asked.request),
                              asked.request.seed, threads, [&](Index done) {
                                if (done % 10 == 0) fmt::print(stderr, "{} of {} recordings\n", done, count);
                              });
    const auto files = write_rank_check(report, asked.request.folder);
    fmt::print("{}: {} recordings made of runs held out, an emulator of {} others\n\n", report.title, count,
               report.training_runs);
    fmt::print("{}\n", results::format(uniformity_table(report), results::Format::table));
    for (const std::string& sentence : rank_sentences(report)) fmt::print("{}\n", sentence);
    fmt::print("\nranks in {}\n", files[1].string());
  } catch (const std::invalid_argument& problem) {
    throw BadInput(problem.what());
  }
  return all_well;
}

}  // namespace cpt::cli
