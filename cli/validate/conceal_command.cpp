// campaign conceal PLAN
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/command.hpp"
#include "cli/exit_codes.hpp"
#include "cli/run/realization_command.hpp"
#include "cli/run/study_runner.hpp"
#include "cli/validate/plan_file.hpp"
#include "validation/concealed/sealed_files.hpp"

namespace cpt::cli {
namespace {

using namespace validation::concealed;

struct ConcealArguments {
  std::filesystem::path plan;
  bool quiet = false;
  std::string executor;
  campaign::RunOptions options;
};

const solver::DepthProfile* profile_of(const results::Snapshot& campaign, const std::string& point) {
  for (const results::RealizationRow& row : campaign.realizations)
    for (const results::CurveRow& curve : campaign.curves)
      if (row.parameter == point && row.completed() && curve.realization == row.id) return &curve.profile;
  return nullptr;
}

// Requests and recordings of the cases whose runs all completed.
std::vector<int> publish(const PlanFile& file, const std::vector<Truth>& truths,
                         const std::vector<results::Snapshot>& runs) {
  const Plan& plan = file.plan;
  std::vector<int> made;
  for (const Truth& truth : truths) {
    std::vector<std::string> recordings;
    for (std::size_t s = 0; s < truth.soundings.size(); ++s)
      if (const auto* profile = profile_of(runs[s], case_name(truth.id)))
        recordings.push_back(recording_text(plan, truth, s, *profile));
    if (recordings.size() < truth.soundings.size()) continue;
    for (std::size_t s = 0; s < recordings.size(); ++s)
      write_whole(plan.cases_folder / recording_file(truth.id, s), recordings[s]);
    write_whole(plan.cases_folder / request_file(truth.id), request_text(plan, file.study, truth));
    made.push_back(truth.id);
  }
  publish_seals(plan, made);
  return made;
}

int conceal(const ConcealArguments& arguments, campaign::Transport& transport, bool& ranks_lost) {
  const PlanFile file = read_plan_file(arguments.plan);
  const Plan& plan = file.plan;
  const std::vector<Truth> truths = sealed_truths(plan, file.study);
  StudyRunner runner(arguments.options, arguments.quiet, file.study_text, transport);
  std::vector<results::Snapshot> runs;
  const std::size_t soundings = plan.cases.two_soundings > 0 ? 2 : 1;
  for (std::size_t s = 0; s < soundings; ++s) {
    const parameters::Study study = truth_study(plan, file.study, truths, s);
    runs.push_back(runner.run(study, study.database));
  }
  ranks_lost = runner.ranks_lost();
  const std::vector<int> made = publish(file, truths, runs);
  fmt::print("{} of {} cases in {}\n", made.size(), truths.size(), plan.cases_folder.string());
  fmt::print("the truth is sealed in {}\n", plan.sealed_folder.string());
  fmt::print("next: campaign diagnose --no-report {}\n", (plan.cases_folder / "case-*.toml").string());
  return made.size() == truths.size() ? all_well : realizations_failed;
}

}  // namespace

void add_conceal(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<ConcealArguments>();
  CLI::App* command = program.add_subcommand(
      "conceal", "Draw recordings with an effect that nobody knows, to try the diagnosis on");
  command->add_option("PLAN", arguments->plan, "NAME.toml: study, soundings, noise and how many cases")
      ->type_name("")
      ->required();
  command
      ->add_option("--slots", arguments->options.slots, "Cores each rank uses [its share of the machine's]")
      ->type_name("N")
      ->check(CLI::Range(1, 4096).description(""));
  command->add_flag("--quiet", arguments->quiet, "No progress");
  add_executor_option(*command, arguments->executor);
  command->footer(std::string(R"(A plan is a request for a diagnosis without recordings, and [cases]:

  title = "Concealed cases, sand"
  study = "sand.toml"
  [[soundings]]
  name = "50 kPa"
  from_m = 0.03
  to_m = 0.19
  [noise]
  measurement_percent = 1
  correlation_mm = 10
  [cases]
  nothing = 10        the study's parameters only
  single = 20         one mechanism of the catalogue
  pair = 4            two
  outside = 6         an effect that no mechanism has
  two_soundings = 0   how many have the second [[soundings]] too

Every case gets other soil parameters, material points, mesh, Courant number and noise, drawn with the
machine's entropy. NAME-cases/ has the recordings, a request for each and seals.json, the salted SHA-256 of
each truth; NAME-sealed/ has the truths, which only `campaign reveal` opens. May be stopped and started again.

)") + exit_code_help);
  command->callback([arguments, &action] {
    arguments->options.realization_command = realization_command(arguments->executor);
    action = [arguments] {
      return run_as_master(arguments->options, [&](campaign::Transport& transport, bool& ranks_lost) {
        return conceal(*arguments, transport, ranks_lost);
      });
    };
  });
}

}  // namespace cpt::cli
