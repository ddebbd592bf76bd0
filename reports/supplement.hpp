// The report as pages of paper, for the supplement of a publication.
#pragma once

#include <vector>

#include "drawing/pdf.hpp"
#include "reports/figure_files.hpp"
#include "results/ledger/snapshot.hpp"

namespace cpt::reports {

/// A4 pages: what the campaign is, with `notes` on it; the inputs and their indices by window; what the
/// design says; each figure 190 mm wide, a journal's double column, with its caption; failures with their
/// reasons. No type is smaller than 7.5 pt, subscripts aside.
[[nodiscard]] std::vector<drawing::PdfPage> supplement(const results::Snapshot& campaign,
                                                       const std::vector<NamedFigure>& figures,
                                                       const results::Effects& effects = {},
                                                       const std::vector<std::string>& notes = {});

}  // namespace cpt::reports
