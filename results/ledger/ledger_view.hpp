// A ledger as readers are to see it. Of a study whose file has been edited since its campaign last ran, that
// is what the file says now, with windows averaged from the stored curves; the ledger itself is not written.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "parameters/study.hpp"
#include "results/files/database.hpp"
#include "results/ledger/snapshot.hpp"

namespace cpt::results {

struct LedgerView {
  Database database;  ///< the ledger, read only, or a copy in memory that says what the study says
  std::vector<std::string> notes = {};  ///< how the study differs from what is stored, in sentences
  bool under_way = true;                ///< a campaign held it when it was opened; else nothing of it runs
};

/// As it is stored. Throws as read_snapshot.
[[nodiscard]] LedgerView view_ledger(const std::filesystem::path& database);

/// As the study, whose file has this text, says now: rows that have not been run are pending, results that it
/// does not ask for are left out. As stored where the results are imported or another solver version's.
[[nodiscard]] LedgerView view_ledger(const parameters::Study& study, const std::string& study_text);

[[nodiscard]] Snapshot read_snapshot(const LedgerView& view);

}  // namespace cpt::results
