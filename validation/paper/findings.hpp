// Every result of the paper held against what was run. Rows are named as the report names them: S sand, C
// clay, L layered, B boundaries, W wall, M second push, D densification, F the measured profile.
#pragma once

#include "validation/paper/finding.hpp"
#include "validation/paper/pushes.hpp"
#include "validation/paper/studies.hpp"

namespace cpt::validation::paper {

[[nodiscard]] std::vector<Finding> sand_findings(const Studies& studies);     // S1 to S5
[[nodiscard]] std::vector<Finding> clay_findings(const Studies& studies);     // C1, C2
[[nodiscard]] std::vector<Finding> layered_findings(const Studies& studies);  // L1 to L3
[[nodiscard]] std::vector<Finding> chamber_findings(const Runs& runs);        // B1, W1, M1, M2, D1, F9

// The parts of the last that need recorded pushes.
[[nodiscard]] std::vector<Finding> path_findings(const Pushes& pushes);        // B1
[[nodiscard]] std::vector<Finding> wall_findings(const Pushes& pushes);        // W1
[[nodiscard]] std::vector<Finding> void_ratio_findings(const Pushes& pushes);  // D1

/// Findings under one heading.
struct FindingGroup {
  std::string title;
  std::vector<Finding> findings;
};

/// All of them, in this order.
[[nodiscard]] std::vector<FindingGroup> all_findings(const Runs& runs);

}  // namespace cpt::validation::paper
