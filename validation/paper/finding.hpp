// One line of the comparison with the paper.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cpt::validation::paper {

enum class Verdict {
  holds,
  differs,
  shown,         ///< the paper gives nothing to hold it against
  not_run,       ///< the results it needs are not there
  not_published  ///< what it would be held against is not there
};
[[nodiscard]] std::string_view to_string(Verdict verdict);

/// Texts are Markdown.
struct Finding {
  std::string_view row;      ///< "S1", "C2", ...: the result of the paper it belongs to
  std::string quantity;      ///< what is compared
  std::string published;     ///< the paper's value or statement
  std::string_view section;  ///< of the paper
  std::string ours;          ///< empty if there is nothing to show
  std::string difference;    ///< ours against the paper's; empty where there is no number
  std::string check;         ///< what `verdict` speaks of: "level", "sign", "order", ...
  Verdict verdict = Verdict::not_run;
  std::string detail;  ///< what is missing, or what stands out of line; may be empty
};
using Findings = std::vector<Finding>;

}  // namespace cpt::validation::paper
