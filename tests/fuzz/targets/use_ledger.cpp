#include "tests/fuzz/targets/use_ledger.hpp"

#include <unistd.h>

#include <cmath>

#include "diagnosis/answer_store.hpp"
#include "parameters/all_realizations.hpp"
#include "reports/figure_files.hpp"
#include "reports/page.hpp"
#include "results/ledger/curve_store.hpp"
#include "results/ledger/ledger.hpp"
#include "results/ledger/ledger_view.hpp"
#include "results/ledger/pruning.hpp"
#include "results/ledger/salvage.hpp"
#include "results/ledger/snapshot.hpp"
#include "results/statistics/effects.hpp"
#include "results/tables/query.hpp"
#include "tests/fuzz/targets/quick_study.hpp"

namespace cpt::fuzz {
namespace {

namespace fs = std::filesystem;

// Few bins of a centimetre each: a small file.
solver::Outcome completed(double level) {
  solver::Outcome outcome;
  outcome.status = solver::Status::completed;
  for (int i = 0; i < 35; ++i) {
    const double depth = (i + 0.5) * 0.01;
    outcome.profile.depth.push_back(depth);
    outcome.profile.q_c.push_back(level * std::sqrt(depth));
    outcome.profile.f_s.push_back(level / 137.0);
  }
  outcome.audit = {1e-16, 2e-4, 3e-3, 0.01, 2, 1e-5, 2e-5};
  outcome.steps = 12345;
  outcome.material_points = 11999;
  outcome.wall_seconds = 1.5;
  return outcome;
}

results::Ledger open(const parameters::Study& study) {
  return results::Ledger::open_for_run(study, parameters::all_realizations(study), {quick_study_text});
}

parameters::Study study_at(const fs::path& database) {
  parameters::Study study = quick_study();
  study.database = database;
  study.curves = database.parent_path() / "fuzzed.h5";
  return study;
}

void remove_all_of(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder)) fs::remove_all(entry.path());
}

}  // namespace

fs::path scratch(const std::string& name) {
  static const fs::path folder = [] {
    const fs::path memory = "/dev/shm";
    const fs::path root = fs::is_directory(memory) ? memory : fs::temp_directory_path();
    const fs::path own = root / ("cpt-fuzz-" + std::to_string(getpid()));
    fs::create_directory(own);
    static const struct Remove {
      fs::path folder;
      ~Remove() {
        std::error_code ignored;
        fs::remove_all(folder, ignored);
      }
    } remove{own};
    return own;
  }();
  remove_all_of(folder);
  return folder / name;
}

const std::string& sound_ledger() {
  static const std::string bytes = [] {
    const fs::path file = scratch("fuzzed.sqlite");
    {
      results::Ledger ledger = open(study_at(file));
      const std::vector<int> ids = ledger.pending();
      for (std::size_t k = 0; k + 1 < ids.size(); ++k)
        ledger.record(ids[k], completed(1e6 * static_cast<double>(ids[k])));
    }
    // One result that an edit left unused.
    parameters::Study edited = study_at(file);
    edited.baseline.contact.friction_ratio = 0.625;
    { open(edited).record(1, completed(3e6)); }
    { (void)open(study_at(file)); }
    return bytes_of(file);
  }();
  return bytes;
}

Fate use_ledger(const fs::path& database) {
  bool sound = true;
  const auto attempt = [&](auto use) {
    try {
      use();
    } catch (const results::Error& error) {
      promise(*error.what() != '\0', "an error says what is wrong");
      sound = false;
    }
  };
  attempt([&] {
    const results::Snapshot campaign = results::read_snapshot(database);
    const results::Effects effects = results::design_effects(campaign);
    promise(!reports::page(campaign, {{}, {}, 0, effects}).empty(), "there is a page");
    (void)reports::campaign_figures(campaign, effects);
  });
  for (const results::NamedQuery& named : results::named_queries())
    attempt([&] { (void)format(results::query(database, named.name), results::Format::json); });
  attempt([&] { (void)format(results::query_sql(database, "SELECT * FROM curve"), results::Format::csv); });
  attempt([&] { (void)results::read_run(database, 1); });
  for (const results::StoredRun& run : results::salvage(database, 10).runs)
    promise(!run.row.waiting() && (run.profile.has_value() || !run.row.completed()),
            "what is salvaged is whole");
  attempt([&] {
    parameters::Study edited = study_at(database);
    edited.baseline.contact.friction_ratio = 0.625;
    (void)results::read_snapshot(results::view_ledger(edited, "another text"));
  });
  attempt([&] {
    const results::Database ledger(database, results::Database::Mode::read_only);
    for (const results::UnusedRun& run : results::unused_runs(ledger))
      (void)results::former_settings(ledger, run.study);
  });
  (void)diagnosis::read_answers(database.parent_path(), "quick");
  attempt([&] {
    const parameters::Study study = study_at(database);
    results::Ledger ledger = open(study);
    for (const int id : ledger.pending()) ledger.record(id, completed(2e6));
    promise(ledger.counts().pending == 0, "a campaign can be completed");
    (void)results::sync_curves(study.curves, study.database);
  });
  return sound ? Fate::sound : Fate::refused;
}

}  // namespace cpt::fuzz
