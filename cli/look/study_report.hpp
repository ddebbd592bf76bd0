// The report of a study's database, as `campaign STUDY` and `campaign report` write it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "drawing/column.hpp"
#include "results/ledger/snapshot.hpp"

namespace cpt::cli {

/// The report (see reports/report.hpp) with the answers of the study's diagnoses, which lie beside the
/// database. A page with `reload_seconds` loads itself anew so often; `notes` stand in its head. Returns the
/// files, the page first.
std::vector<std::filesystem::path> write_study_report(const results::Snapshot& campaign,
                                                      const std::filesystem::path& database,
                                                      const std::filesystem::path& directory,
                                                      int reload_seconds = 0,
                                                      drawing::Column column = drawing::Column::one_and_half,
                                                      const std::vector<std::string>& notes = {});

/// The page of that report alone, without figures and tables, for a campaign that gets further. Returns its
/// file.
std::filesystem::path write_study_page(const results::Snapshot& campaign,
                                       const std::filesystem::path& database,
                                       const std::filesystem::path& directory, int reload_seconds);

}  // namespace cpt::cli
