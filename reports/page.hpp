// The report's page: one self-contained HTML file.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/answer_store.hpp"
#include "results/ledger/snapshot.hpp"
#include "results/statistics/effects.hpp"

namespace cpt::reports {

/// What stands on the page beside the campaign itself.
struct PageContext {
  std::vector<diagnosis::StoredAnswer> diagnoses;  ///< of the study
  std::vector<std::string> files;                  ///< names of the files beside the page, to link to
  int reload_seconds = 0;                          ///< how often the page loads itself anew; 0: never
  results::Effects effects = {};                   ///< of the study's design
  std::vector<std::string> notes = {};             ///< what a reader must know first; sentences
};

/// The page: reports/html/report.html with style, scripts, libraries, the figures of windows and diagnoses as
/// SVG (window_figures), and all numbers as one JSON block, of which reports/html/*.js make sentences, tables
/// and curves in the browser. It loads nothing from anywhere. The same input gives the same bytes.
[[nodiscard]] std::string page(const results::Snapshot& campaign, const PageContext& context = {});

}  // namespace cpt::reports
