// campaign reveal PLAN...
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <memory>

#include "cli/command.hpp"
#include "cli/common/study_argument.hpp"
#include "cli/diagnose/request_file.hpp"
#include "cli/exit_codes.hpp"
#include "cli/validate/plan_file.hpp"
#include "results/files/file_bytes.hpp"
#include "results/ledger/provenance.hpp"
#include "validation/concealed/judge.hpp"
#include "validation/concealed/page.hpp"
#include "validation/concealed/sealed_files.hpp"

namespace cpt::cli {
namespace {

using namespace diagnosis;
using namespace validation::concealed;

struct RevealArguments {
  std::vector<std::filesystem::path> plans;
  std::filesystem::path out, note;
};

std::string file_text(const std::filesystem::path& file) {
  std::error_code why;
  std::optional<std::string> text = results::bytes_of(file, why);
  if (!text) throw BadInput(fmt::format("cannot read {} ({})", file.string(), results::cause_of(file, why)));
  return *std::move(text);
}

std::filesystem::path answer_file(const Plan& plan, int id) {
  return plan.cases_folder / (case_name(id) + ".sqlite");
}

// All answers, before any truth is opened. What they were goes on record the first time.
std::map<int, StoredAnswer> answers_of(const Plan& plan) {
  std::map<int, StoredAnswer> answers;
  std::vector<std::string> missing;
  std::map<int, std::string> hashes;
  for (const auto& [id, seal] : published_seals(plan)) {
    if (!std::filesystem::exists(answer_file(plan, id))) {
      missing.push_back(case_name(id));
      continue;
    }
    StoredAnswer answer = load_answer(answer_file(plan, id));
    std::string said = answer.answer;
    for (const StoredAnswer::Weighed& h : answer.hypotheses)
      said += fmt::format("|{}={:.17g}", h.name, h.probability);
    hashes[id] = results::sha256(said);
    answers.emplace(id, std::move(answer));
  }
  if (!missing.empty())
    throw BadInput(
        fmt::format("{} of {} cases have no answer yet, {} the first; nothing was opened\n"
                    "hint: campaign diagnose --no-report {}",
                    missing.size(), missing.size() + answers.size(), missing.front(),
                    (plan.cases_folder / "case-*.toml").string()));
  if (!are_first_answers(plan, hashes))
    fmt::print(stderr, "note: answers of {} are not those of its first opening: no longer blind\n",
               plan.request.name);
  return answers;
}

// The finished campaigns that diagnoses used, each read once.
class Campaigns {
 public:
  const results::Snapshot& of(const std::filesystem::path& database) {
    auto found = read_.find(database);
    if (found == read_.end()) found = read_.emplace(database, results::read_snapshot(database)).first;
    return found->second;
  }
  [[nodiscard]] int runs() const {
    int sum = 0;
    for (const auto& [file, campaign] : read_) sum += static_cast<int>(campaign.realizations.size());
    return sum;
  }

 private:
  std::map<std::filesystem::path, results::Snapshot> read_;
};

validation::concealed::Benchmark opened(const std::filesystem::path& plan_file) {
  const PlanFile file = read_plan_file(plan_file);
  const Plan& plan = file.plan;
  const std::map<int, StoredAnswer> answers = answers_of(plan);
  const std::map<int, Truth> truths = opened_truths(plan);
  Campaigns campaigns;
  validation::concealed::Benchmark benchmark;
  benchmark.name = plan.request.name;
  benchmark.title = plan.request.title;
  benchmark.profile = std::string(to_string(file.study.profile));
  benchmark.preset = std::string(to_string(file.study.preset));
  benchmark.drawn = drawn_at(plan);
  benchmark.withheld = plan.cases.total() - static_cast<int>(truths.size());
  for (const solver::Mechanism& mechanism : plan.request.mechanisms)
    benchmark.mechanisms.emplace_back(mechanism.name);
  for (const auto& [id, truth] : truths) {
    const RequestFile request = read_request_file(plan.cases_folder / request_file(id));
    std::vector<SoundingData> soundings = soundings_of(request);
    for (SoundingData& sounding : soundings) sounding.campaign = campaigns.of(sounding.study.study.database);
    benchmark.cases.push_back(
        judge(plan.request.name, truth, answers.at(id), assemble(request.request, soundings)));
  }
  benchmark.solver_runs = campaigns.runs();
  return benchmark;
}

int reveal(const RevealArguments& arguments) {
  std::vector<validation::concealed::Benchmark> benchmarks;
  try {
    for (const std::filesystem::path& plan : arguments.plans) benchmarks.push_back(opened(plan));
  } catch (const std::invalid_argument& problem) {
    throw BadInput(problem.what());
  }
  const std::string note = arguments.note.empty() ? "" : file_text(arguments.note);
  const auto files = validation::concealed::write_page(benchmarks, note, arguments.out);
  int cases = 0, right = 0;
  for (const auto& benchmark : benchmarks)
    for (const Judged& judged : benchmark.cases) {
      ++cases;
      right += judged.right() ? 1 : 0;
    }
  fmt::print("{} of {} answers are right; the scores are in {}\n", right, cases, files.front().string());
  return all_well;
}

}  // namespace

void add_reveal(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<RevealArguments>();
  CLI::App* command =
      program.add_subcommand("reveal", "Open concealed cases once they are diagnosed, and score the answers");
  command->add_option("PLAN", arguments->plans, "Plans that were concealed; several make one page")
      ->type_name("")
      ->required();
  command
      ->add_option("--out", arguments->out, "Page to write; figures go to the folder of its name beside it")
      ->type_name("FILE.md")
      ->required();
  command->add_option("--note", arguments->note, "Markdown to begin the page with")->type_name("FILE.md");
  command->footer(
      R"(Nothing is opened before every case has its answer. A truth that does not fit its seal is an error.

Example:
  mpirun -np 2 campaign conceal sand-cases.toml
  mpirun -np 2 campaign diagnose --no-report sand-cases-cases/case-*.toml
  campaign reveal sand-cases.toml --out concealed.md)");
  command->callback([arguments, &action] { action = [arguments] { return reveal(*arguments); }; });
}

}  // namespace cpt::cli
