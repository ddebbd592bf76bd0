// campaign diagnose REQUEST...
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <stdexcept>

#include "campaign/mpi_transport.hpp"
#include "cli/command.hpp"
#include "cli/common/study_argument.hpp"
#include "cli/diagnose/diagnosis_input.hpp"
#include "cli/diagnose/next_measurement.hpp"
#include "cli/diagnose/request_file.hpp"
#include "cli/diagnose/several_effects.hpp"
#include "cli/exit_codes.hpp"
#include "cli/run/realization_command.hpp"
#include "cli/run/study_remarks.hpp"
#include "cli/run/study_runner.hpp"
#include "diagnosis/answer_store.hpp"
#include "diagnosis/assemble.hpp"
#include "diagnosis/fitted.hpp"
#include "diagnosis/several/findings_store.hpp"
#include "parameters/all_realizations.hpp"
#include "reports/diagnosis/answer.hpp"
#include "reports/diagnosis/write_diagnosis_report.hpp"

namespace cpt::cli {
namespace {

using namespace diagnosis;

struct DiagnoseArguments {
  std::vector<std::filesystem::path> requests;
  std::filesystem::path recordings;
  bool plan = false, quiet = false, no_report = false;
  std::string executor;
  campaign::RunOptions options;
};

void diagnose_one(StudyRunner& runner, const RequestFile& asked, bool report) {
  const Request& request = asked.request;
  std::vector<SoundingData> soundings = soundings_of(asked);
  for (SoundingData& sounding : soundings)
    sounding.campaign = runner.run(sounding.study.study, asked.study.database);

  Assembled assembled = assemble(request, soundings);
  Options options;
  options.seed = request.seed;
  Diagnosis diagnosis = diagnose(assembled.problem, options);

  std::vector<results::Snapshot> fitted;
  for (std::size_t s = 0; s < soundings.size(); ++s)
    fitted.push_back(runner.run(fitted_study(request, soundings[s].study, s, assembled, diagnosis),
                                soundings[s].study.study.database));
  if (report)
    diagnosis.next = next_measurements_of(runner, asked, soundings, assembled, diagnosis, assembled.remarks);
  const auto input = diagnosis_input(request, soundings, assembled, options, diagnosis, fitted);
  const reports::diagnosed::Answer answer = reports::diagnosed::answer_of(input);
  store_answer(request.database, {request.title, asked.study.name, answer.headline, answer.reservations},
               diagnosis, assembled);
  std::string together;
  try {
    const SeveralEffects several = several_effects(request, soundings);
    store_findings(request.database, several.findings, several.assembled);
    together = several_text(several);
  } catch (const std::invalid_argument& problem) {  // the answer above stands without them
    together = fmt::format("Several effects at once are not weighed: {}", problem.what());
  }
  for (const std::string& remark : assembled.remarks) fmt::print("note: {}\n", remark);
  fmt::print("{}\n", answer.headline);
  for (const std::string& reservation : answer.reservations) fmt::print("  {}\n", reservation);
  for (const std::string& paragraph : answer.paragraphs) fmt::print("\n{}\n", paragraph);
  fmt::print("\n{}\n", together);
  fmt::print("\nanswer in {}\n", request.database.string());
  if (!report) return;
  const auto files = reports::diagnosed::write_diagnosis_report(input, request.report_dir);
  fmt::print("report: {}\n", files.front().string());
}

void print_request_plan(const RequestFile& asked) {
  print_remarks(asked.study);
  for (const SoundingData& sounding : soundings_of(asked))
    fmt::print("{}: {} realizations, kept in {}\n", sounding.request.name,
               parameters::all_realizations(sounding.study.study).size(),
               sounding.study.study.database.string());
}

int diagnose_all(const DiagnoseArguments& arguments) {
  if (arguments.plan) {
    if (campaign::rank_from_environment() == 0)
      for (const auto& request : arguments.requests)
        print_request_plan(read_request_file(request, arguments.recordings));
    return all_well;
  }
  return run_as_master(arguments.options, [&](campaign::Transport& transport, bool& ranks_lost) {
    // All are read first: nothing runs before all are sound.
    std::vector<RequestFile> asked;
    for (const auto& request : arguments.requests)
      asked.push_back(read_request_file(request, arguments.recordings));
    for (const RequestFile& one : asked) {
      StudyRunner runner(arguments.options, arguments.quiet, one.study_text, transport);
      if (asked.size() > 1) fmt::print("== {}\n", one.request.title);
      if (!arguments.quiet) print_remarks(one.study);
      diagnose_one(runner, one, !arguments.no_report);
      ranks_lost = ranks_lost || runner.ranks_lost();
    }
    return static_cast<int>(all_well);
  });
}

}  // namespace

void add_diagnose(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<DiagnoseArguments>();
  CLI::App* command = program.add_subcommand(
      "diagnose", "Find out where recordings and simulation part, and which physics would close the gap");
  command
      ->add_option("REQUEST", arguments->requests,
                   "NAME.toml: the study, the recordings, the mechanisms; the answer goes to NAME.sqlite")
      ->type_name("")
      ->required();
  command
      ->add_option(
          "--recordings", arguments->recordings,
          "Where recordings lie that are not beside the request [the folder that CPT_RECORDINGS names]")
      ->type_name("FOLDER")
      ->envname("CPT_RECORDINGS");
  command->add_flag("--plan", arguments->plan, "Print how many realizations it takes, and quit");
  command->add_flag("--no-report", arguments->no_report, "The answer only, no page and figures");
  command
      ->add_option("--slots", arguments->options.slots, "Cores each rank uses [its share of the machine's]")
      ->type_name("N")
      ->check(CLI::Range(1, 4096).description(""));
  command->add_flag("--quiet", arguments->quiet, "No progress");
  add_executor_option(*command, arguments->executor);
  command->footer(std::string(R"(A request is a TOML file:

  title = "Sand, first push"
  study = "sens.toml"          its parameters within their bounds are no missing physics
  [[soundings]]
  recording = "first.csv"
  columns = { depth_m = "z_m", q_c_MPa = "qc" }
  from_m = 0.04
  to_m = 0.32

  [[candidates]]               pushes that could be made next, ranked where the answer is a set of effects
  name = "at 100 kPa"
  from_m = 0.04
  to_m = 0.32
  fixed = { "initial.sigma_v0_kPa" = 100, "initial.sigma_h0_kPa" = 50 }

The solver runs are kept beside the study and used again by the next diagnosis. `campaign list mechanisms` prints
what is looked for; docs/diagnosis-method.md says how.

)") + exit_code_help);
  command->callback([arguments, &action] {
    arguments->options.realization_command = realization_command(arguments->executor);
    action = [arguments] { return diagnose_all(*arguments); };
  });
}

}  // namespace cpt::cli
