// The report of a campaign: figures, numbers and one page to read, from the database alone.
#pragma once

#include <filesystem>
#include <vector>

#include "results/snapshot.hpp"

namespace cpt::reports {

/// Writes into `directory` (made if missing; files of an earlier report are replaced):
///   index.html               one page: state of the campaign, figures, tables, failures with reasons,
///   provenance tornado_WINDOW.svg/.png  range of q_c between each parameter's bounds (Yost et al. 2023, Fig.
///   11) sensitivity_WINDOW.svg/.png  sensitivity indices with the noise floor (Fig. 12) profiles.svg/.png
///   q_c over depth of every realization (Fig. 10) baseline.svg/.png        the baseline with its windows
///   enlarged (Fig. 9) sensitivity.csv, realizations.csv, window_means.csv, curves.csv   the numbers
///   report.json              all of the numbers in one file
/// Works for a campaign that is still running or has failures, and says so on every page. Figures that need
/// results not there yet are left out. Returns the files written, in the order above. Throws results::Error
/// if a file cannot be written.
std::vector<std::filesystem::path> write_report(const results::Snapshot& campaign,
                                                const std::filesystem::path& directory);

}  // namespace cpt::reports
