// Every result of the paper held against the campaigns. Rows are named as the report names them: S sand, C
// clay, L layered, B boundaries, W wall, M second push, D densification, F the measured profile.
#pragma once

#include "reports/paper/finding.hpp"
#include "reports/paper/studies.hpp"

namespace cpt::reports::paper {

[[nodiscard]] std::vector<Finding> sand_findings(const Studies& studies);     // S1 to S5
[[nodiscard]] std::vector<Finding> clay_findings(const Studies& studies);     // C1, C2
[[nodiscard]] std::vector<Finding> layered_findings(const Studies& studies);  // L1 to L3
[[nodiscard]] std::vector<Finding> chamber_findings(const Studies& studies);  // B1, W1, M1, M2, D1, F9

/// All of them, in this order.
[[nodiscard]] std::vector<Finding> all_findings(const Studies& studies);

}  // namespace cpt::reports::paper
