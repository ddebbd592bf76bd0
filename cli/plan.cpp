#include "cli/plan.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <map>

#include "cli/exit_codes.hpp"
#include "parameters/designs/one_at_a_time.hpp"
#include "results/provenance.hpp"
#include "results/snapshot.hpp"
#include "results/table_format.hpp"
#include "solver/simulate.hpp"

namespace cpt::cli {
namespace {

// Status of what the database holds, by settings hash.
std::map<std::string, std::string> known_status(const parameters::Study& study) {
  std::map<std::string, std::string> status;
  if (!std::filesystem::exists(study.database)) return status;
  for (const results::RealizationRow& row : results::read_snapshot(study.database).realizations)
    status[row.settings_hash] = row.status;
  return status;
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
  const auto status = known_status(study);
  results::Table table{{"id", "parameter", "side", "value", "baseline", "unit", "status"}, {}};
  for (const parameters::Realization& realization : parameters::one_at_a_time(study)) {
    const auto found = status.find(results::settings_hash(parameters::make_setup(study, realization)));
    std::string baseline;
    std::string unit;
    if (realization.row >= 0) {
      const parameters::Row& row = study.rows.at(static_cast<std::size_t>(realization.row));
      baseline = row.quantity->format(row.baseline);
      if (row.quantity->choices.empty()) unit = row.quantity->unit;
    }
    table.rows.push_back({std::int64_t{realization.id}, std::string(parameter_name(study, realization)),
                          std::string(to_string(realization.side)), value_text(study, realization), baseline,
                          unit, found == status.end() ? "new" : found->second});
  }
  fmt::print("{}", results::format(table, results::Format::table));
}

int validate(const parameters::Study& study) {
  int bad = 0;
  std::int64_t material_points = 0;
  const auto realizations = parameters::one_at_a_time(study);
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
