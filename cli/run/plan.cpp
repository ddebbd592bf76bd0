#include "cli/run/plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "campaign/external/run_program.hpp"
#include "cli/exit_codes.hpp"
#include "cli/run/sample_growth.hpp"
#include "parameters/all_realizations.hpp"
#include "results/ledger/matching.hpp"
#include "results/tables/table_format.hpp"
#include "solver/simulate.hpp"

namespace cpt::cli {
namespace {

// Of a realization, as its database has it.
std::string status_of(const results::MatchedRun& run, bool under_way) {
  if (!run.held) return "new";
  if (run.held->damaged) return "damaged";
  if (run.held->status == "running" && !under_way) return "interrupted";
  return run.held->status + (run.held->unused ? ", unused until now" : "");
}

// Stops a run at its first report: by then the model is built and has made its first steps.
class StopAtOnce final : public solver::Observer {
 public:
  bool stop_requested(std::string& reason) override {
    reason = "first steps made";
    return true;
  }
};

}  // namespace

void print_plan(const parameters::Study& study) {
  const std::optional<results::Prospect> found = results::prospect(study);
  results::Table table{{"id", "parameter", "side", "value", "baseline", "unit", "status"}, {}};
  std::size_t k = 0;
  for (const parameters::Realization& realization : parameters::all_realizations(study)) {
    std::string baseline;
    std::string unit;
    if (realization.row >= 0) {
      const parameters::Row& row = study.rows.at(static_cast<std::size_t>(realization.row));
      baseline = row.quantity->format(row.baseline);
      if (row.quantity->choices.empty()) unit = row.quantity->unit;
    }
    table.rows.push_back({std::int64_t{realization.id}, std::string(parameter_name(study, realization)),
                          std::string(to_string(realization.side)), value_text(study, realization), baseline,
                          unit,
                          found ? status_of(found->matching.realizations.at(k++), found->under_way) : "new"});
  }
  fmt::print("{}", results::format(table, results::Format::table));
  if (const auto& program = study.baseline.program)
    fmt::print(
        "each runs {}{}\n",
        fmt::join(campaign::resolved_command(program->command, program->folder, program->template_name), " "),
        program->version.empty() ? "" : fmt::format(", version {}", program->version));
  if (const std::string note = growth_note(study); !note.empty()) fmt::print("{}\n", note);
  if (!found) return;
  for (const std::string& message : found->opened.messages) fmt::print("{}\n", message);
  if (const std::string advice = growth_advice(study, *found); !advice.empty()) fmt::print("{}\n", advice);
}

void print_points(const parameters::Study& study, results::Format format) {
  const std::vector<const solver::Quantity*> varied = parameters::varied_quantities(study);
  results::Table table{{"realization", "name"}, {}};
  for (const solver::Quantity* quantity : varied) table.columns.push_back(quantity->name);
  for (const parameters::Realization& realization : parameters::all_realizations(study)) {
    const solver::Setup setup = make_setup(study, realization);
    std::string name(parameter_name(study, realization));
    if (realization.point < 0)
      name += fmt::format("{}{}", name.empty() ? "" : " ", to_string(realization.side));
    std::vector<results::Cell>& row = table.rows.emplace_back();
    row = {std::int64_t{realization.id}, name};
    for (const solver::Quantity* quantity : varied) {
      const double value = quantity->value(setup);
      row.push_back(quantity->choices.empty() ? results::Cell(value)
                                              : results::Cell(quantity->format(value)));
    }
  }
  fmt::print("{}", results::format(table, format));
}

namespace {

// Nothing of it is run: that the program is there is all that can be said.
int validate_program(const parameters::Study& study) {
  const solver::ExternalProgram& program = *study.baseline.program;
  const std::vector<std::string> words =
      campaign::resolved_command(program.command, program.folder, program.template_name);
  if (!campaign::is_there(words.front())) {
    fmt::print("{}: there is no such program\n", words.front());
    return bad_input;
  }
  fmt::print("{} is valid: program {}, {} realizations, {} window{}\n", study.file.filename().string(),
             fmt::join(words, " "), parameters::all_realizations(study).size(), study.windows.size(),
             study.windows.size() == 1 ? "" : "s");
  return all_well;
}

}  // namespace

int validate(const parameters::Study& study) {
  if (study.baseline.program) return validate_program(study);
  int bad = 0;
  std::int64_t material_points = 0;
  const auto realizations = parameters::all_realizations(study);
  for (const parameters::Realization& realization : realizations) {
    StopAtOnce observer;
    const solver::Outcome outcome = solver::simulate(parameters::make_setup(study, realization), observer);
    material_points = std::max(material_points, outcome.material_points);
    if (outcome.status == solver::Status::time_limit || outcome.status == solver::Status::completed) continue;
    ++bad;
    fmt::print("realization {} ({} {}): {}: {}\n", realization.id, parameter_name(study, realization),
               value_text(study, realization), solver::to_string(outcome.status), outcome.reason);
  }
  if (bad > 0) {
    fmt::print("{} of {} realizations cannot be run\n", bad, realizations.size());
    return bad_input;
  }
  fmt::print("{} is valid: {}, preset {}, {} realizations of up to {} material points, {} window{}\n",
             study.file.filename().string(), solver::to_string(study.profile),
             solver::to_string(study.preset), realizations.size(), material_points, study.windows.size(),
             study.windows.size() == 1 ? "" : "s");
  return all_well;
}

}  // namespace cpt::cli
