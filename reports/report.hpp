// The report of a campaign: figures, numbers and one page to read, from the database alone.
#pragma once

#include <filesystem>
#include <vector>

#include "drawing/column.hpp"
#include "reports/page.hpp"

namespace cpt::reports {

/// Writes into `directory` (made if missing; files of an earlier report are replaced):
///   index.html             the page, see page.hpp
///   tornado_WINDOW         range of q_c between each parameter's bounds (Yost et al. 2023, Fig. 11)
///   sensitivity_WINDOW     sensitivity indices with the noise floor (Fig. 12)
///   effects_WINDOW         what the study's design says of its parameters, where it has one
///   profiles               q_c over depth of every realization (Fig. 10)
///   baseline               the baseline with its windows enlarged (Fig. 9); all figures as .svg and .png,
///                          as wide as a journal's `column`
///   sensitivity.csv, realizations.csv, window_means.csv, curves.csv, effects.csv   the numbers
///   report.json            all of the numbers in one file
///   report.pdf             tables and figures on A4, see supplement.hpp
/// Works for a campaign that is still running or has failures, and says so everywhere. Figures that need
/// results not there yet are left out. `context` is the page's; its files are found here. Returns the files
/// written, in the order above. Throws results::Error if a file cannot be written.
std::vector<std::filesystem::path> write_report(const results::Snapshot& campaign,
                                                const std::filesystem::path& directory,
                                                PageContext context = {},
                                                drawing::Column column = drawing::Column::one_and_half);

/// index.html alone, for a campaign that gets further. Throws as write_report.
std::filesystem::path write_page(const results::Snapshot& campaign, const std::filesystem::path& directory,
                                 PageContext context);

}  // namespace cpt::reports
