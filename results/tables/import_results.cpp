#include "results/tables/import_results.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>

#include "parameters/all_realizations.hpp"
#include "results/files/atomic_file.hpp"
#include "results/files/database.hpp"
#include "results/ledger/ledger_rows.hpp"
#include "results/ledger/ledger_tables.hpp"
#include "results/ledger/provenance.hpp"
#include "results/ledger/schema.hpp"
#include "results/tables/count_of.hpp"
#include "solver/quantities.hpp"

namespace cpt::results {
namespace {

/// Fills a new database in one transaction under another name.
void make_database(const std::filesystem::path& file, const std::function<void(const Database&)>& fill) {
  std::error_code ignored;
  if (std::filesystem::exists(file, ignored))
    throw Error(fmt::format("{}: exists; an import makes a new database", file.string()));
  const std::filesystem::path temporary = file.string() + ".tmp";
  std::filesystem::remove(temporary, ignored);
  try {
    const Database database(temporary, Database::Mode::read_write);
    database.execute("PRAGMA journal_mode = MEMORY; PRAGMA synchronous = FULL");
    Transaction transaction(database, Transaction::Kind::write);
    create_schema(database);
    fill(database);
    transaction.commit();
  } catch (...) {
    std::filesystem::remove(temporary, ignored);
    throw;
  }
  move_into_place(temporary, file);
}

decltype(WindowMeanRow::other_means_kPa) not_recorded() {
  decltype(WindowMeanRow::other_means_kPa) means;
  means.fill(std::numeric_limits<double>::quiet_NaN());
  return means;
}

}  // namespace

Remarks import_samples(const parameters::Study& asked, const std::string& study_text,
                       std::span<const parameters::Sample> samples, const ImportedFile& file,
                       const std::filesystem::path& target) {
  parameters::Study study = asked;  // with the samples that are none of its realizations
  std::vector<parameters::Realization> realizations = parameters::all_realizations(study);
  std::map<std::string, int> free;  // realizations without a sample, by their settings
  for (const parameters::Realization& r : realizations) free.try_emplace(settings_text(study, r), r.id);
  std::map<int, const parameters::Sample*> sample_of;
  for (const parameters::Sample& sample : samples) {
    solver::Setup setup = study.baseline;
    parameters::DesignPoint point{sample.name, {}};
    for (const parameters::Change& change : sample.changes) {
      if (change.quantity->value(setup) != change.value) point.changes.push_back(change);
      change.quantity->set_value(setup, change.value);
    }
    const auto found = free.find(solver::canonical_text(setup));
    if (found != free.end()) {
      sample_of[found->second] = &sample;
      free.erase(found);
      continue;
    }
    const int id = static_cast<int>(realizations.size()) + 1;
    realizations.push_back({id, -1, parameters::Side::point, static_cast<int>(study.points.size())});
    study.points.push_back(std::move(point));
    sample_of[id] = &sample;
  }

  make_database(target, [&](const Database& database) {
    write_study(database, study, study_text);
    for (const parameters::Realization& r : realizations)
      insert_pending(database, r.id, describe_input(study, r));
    write_inputs(database, study, realizations);
    // Not runs of this program.
    database.execute(
        "UPDATE realization SET settings_hash = '', solver_version = ''; "
        "UPDATE campaign SET program_version = '', solver_version = ''");
    recompute_windows(database, study);
    for (const auto& [id, sample] : sample_of) {
      database.prepare("UPDATE realization SET status = ?, reason = ? WHERE id = ?")
          .bind(sample->status)
          .bind(sample->reason)
          .bind(id)
          .run();
      for (std::size_t w = 0; w < study.windows.size(); ++w)
        if (const parameters::WindowResponse& r = sample->responses[w]; !std::isnan(r.mean))
          insert_row(database, window_mean_table(),
                     {id, study.windows[w].name, study.windows[w].from, study.windows[w].to, r.mean, r.min,
                      r.max, 0, not_recorded()});
    }
    recompute_repeat_noise(database);
    insert_row(database, import_table(),
               {file.name, file.sha256, utc_now(), std::string(program_version()), 1});
  });
  Remarks remarks;
  const std::size_t points = study.points.size() - asked.points.size();
  if (points > 0)
    remarks.push_back(count_of(points, "row") + " with inputs that the study does not ask for: points");
  if (!free.empty())
    remarks.push_back(count_of(free.size(), "realization") + " of the study without a row: pending");
  return remarks;
}

}  // namespace cpt::results
