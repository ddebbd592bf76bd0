// campaign diagnose REQUEST
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <iterator>
#include <memory>

#include "campaign/mpi_transport.hpp"
#include "campaign/run_campaign.hpp"
#include "campaign/stop_signals.hpp"
#include "campaign/worker.hpp"
#include "cli/command.hpp"
#include "cli/diagnosis_input.hpp"
#include "cli/exit_codes.hpp"
#include "cli/realization_command.hpp"
#include "cli/study_argument.hpp"
#include "diagnosis/answer_store.hpp"
#include "diagnosis/assemble.hpp"
#include "diagnosis/fitted.hpp"
#include "diagnosis/read_request.hpp"
#include "parameters/designs/one_at_a_time.hpp"
#include "reports/diagnosis/answer.hpp"
#include "reports/diagnosis/write_diagnosis_report.hpp"
#include "results/ledger.hpp"

namespace cpt::cli {
namespace {

using namespace diagnosis;

struct Arguments {
  std::filesystem::path request;
  bool plan = false, quiet = false;
  std::string executor;
  campaign::RunOptions options;
};

struct Asked {
  parameters::Study study;
  std::string study_text;
  Request request;
};

Asked read(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream.is_open()) throw BadInput(fmt::format("cannot read the request {}", file.string()));
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  const std::filesystem::path study_file = study_of_request(text, file);
  Asked asked;
  if (!study_file.empty()) {
    StudyFile study = read_study_file(study_file);
    asked.study = std::move(study.study);
    asked.study_text = std::move(study.text);
  }
  auto parsed = parse_request(text, file, asked.study);
  if (const auto* errors = std::get_if<std::vector<parameters::StudyError>>(&parsed))
    throw BadInput(parameters::format(*errors));
  asked.request = std::get<Request>(std::move(parsed));
  return asked;
}

recordings::Recording read_recording(const SoundingRequest& sounding) {
  auto read = recordings::read_recording(sounding.recording, sounding.options);
  if (const auto* errors = std::get_if<std::vector<recordings::RecordingError>>(&read))
    throw BadInput(recordings::format(*errors));
  return std::get<recordings::Recording>(std::move(read));
}

std::vector<SoundingData> soundings_of(const Asked& asked) {
  std::vector<SoundingData> soundings;
  for (const SoundingRequest& sounding : asked.request.soundings) {
    soundings.push_back({sounding,
                         sounding_study(asked.study, sounding, asked.request.mechanisms,
                                        asked.request.repeats, asked.request.joint),
                         read_recording(sounding),
                         {}});
    try {
      check_recording(sounding, soundings.back().recording, asked.request.cell_height);
    } catch (const std::invalid_argument& problem) {
      throw BadInput(problem.what());
    }
  }
  return soundings;
}

// Runs studies one after the other on the same ranks.
class Runner {
 public:
  struct Stopped {
    int signal;
  };

  Runner(const Arguments& arguments, const std::string& study_text, campaign::Transport& transport)
      : arguments_(arguments), study_text_(study_text), transport_(transport) {}

  /// What `study` holds when all has run; what another campaign's database has finished is taken from there.
  /// Throws Stopped.
  results::Snapshot run(const parameters::Study& study, const std::filesystem::path& finished) {
    const int adopted =
        results::Ledger::open_for_run(study, parameters::one_at_a_time(study), {study_text_, false})
            .adopt(finished);
    if (!arguments_.quiet && adopted > 0)
      fmt::print("{} realizations taken from {}\n", adopted, finished.string());
    campaign::ProgressDisplay display(stderr, arguments_.quiet ? campaign::ProgressDisplay::Style::silent
                                                               : campaign::ProgressDisplay::style_of(stderr));
    const campaign::Summary summary =
        campaign::run_campaign(study, study_text_, transport_, arguments_.options, display);
    ranks_lost_ = ranks_lost_ || summary.ranks_lost;
    if (summary.signal != 0) throw Stopped{summary.signal};
    return results::read_snapshot(study.database);
  }
  [[nodiscard]] bool ranks_lost() const { return ranks_lost_; }

 private:
  const Arguments& arguments_;
  const std::string& study_text_;
  campaign::Transport& transport_;
  bool ranks_lost_ = false;
};

void diagnose_with(Runner& runner, const Asked& asked) {
  const Request& request = asked.request;
  std::vector<SoundingData> soundings = soundings_of(asked);
  for (SoundingData& sounding : soundings)
    sounding.campaign = runner.run(sounding.study.study, asked.study.database);

  const Assembled assembled = assemble(request, soundings);
  Options options;
  options.seed = request.seed;
  const Diagnosis diagnosis = diagnose(assembled.problem, options);

  std::vector<results::Snapshot> fitted;
  for (std::size_t s = 0; s < soundings.size(); ++s)
    fitted.push_back(runner.run(
        fitted_study(request, soundings[s].study, s, assembled.mechanisms, assembled.problem, diagnosis),
        soundings[s].study.study.database));
  const auto input = diagnosis_input(request, soundings, assembled, options, diagnosis, fitted);
  const reports::diagnosed::Answer answer = reports::diagnosed::answer_of(input);
  store_answer(request.database, {request.title, asked.study.name, answer.headline}, diagnosis,
               assembled.problem);
  const auto files = reports::diagnosed::write_diagnosis_report(input, request.report_dir);

  for (const std::string& remark : assembled.remarks) fmt::print("note: {}\n", remark);
  fmt::print("{}\n", answer.headline);
  for (const std::string& paragraph : answer.paragraphs) fmt::print("\n{}\n", paragraph);
  fmt::print("\nanswer in {}\nreport: {}\n", request.database.string(), files.front().string());
}

int diagnose_as_master(const Arguments& arguments, campaign::Transport& transport, bool& ranks_lost) {
  const campaign::Dismissal dismissal(transport);
  const Asked asked = read(arguments.request);
  Runner runner(arguments, asked.study_text, transport);
  int code = all_well;
  try {
    diagnose_with(runner, asked);
  } catch (const Runner::Stopped& stopped) {
    fmt::print(stderr, "stopped by signal {}; the same command goes on where this one stopped\n",
               stopped.signal);
    code = stopped_by_signal + stopped.signal;
  } catch (const std::invalid_argument& problem) {
    throw BadInput(problem.what());
  }
  ranks_lost = runner.ranks_lost();
  return code;
}

void print_plan(const Asked& asked) {
  for (const SoundingData& sounding : soundings_of(asked))
    fmt::print("{}: {} realizations, kept in {}\n", sounding.request.name,
               parameters::one_at_a_time(sounding.study.study).size(),
               sounding.study.study.database.string());
}

int run(const Arguments& arguments) {
  if (arguments.plan) {
    if (campaign::rank_from_environment() == 0) print_plan(read(arguments.request));
    return all_well;
  }
  const campaign::StopSignals signals;
  bool ranks_lost = false;
  if (!campaign::started_by_mpi()) {
    campaign::InProcessTransport transport;
    return diagnose_as_master(arguments, transport, ranks_lost);
  }
  campaign::MpiTransport transport;
  if (transport.rank() != 0) {
    campaign::serve_master(transport, arguments.options);
    return all_well;
  }
  const int code = diagnose_as_master(arguments, transport, ranks_lost);
  if (ranks_lost) transport.abandon(code);
  return code;
}

}  // namespace

void add_diagnose(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand(
      "diagnose", "Find out where recordings and simulation part, and which physics would close the gap");
  command
      ->add_option("REQUEST", arguments->request,
                   "NAME.toml: the study, the recordings, the mechanisms; the answer goes to NAME.sqlite")
      ->type_name("")
      ->required();
  command->add_flag("--plan", arguments->plan, "Print how many realizations it takes, and quit");
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

The solver runs are kept beside the study and used again by the next diagnosis. `campaign list mechanisms` prints
what is looked for; docs/diagnosis-method.md says how.

)") + exit_code_help);
  command->callback([arguments, &action] {
    arguments->options.realization_command = realization_command(arguments->executor);
    action = [arguments] { return run(*arguments); };
  });
}

}  // namespace cpt::cli
