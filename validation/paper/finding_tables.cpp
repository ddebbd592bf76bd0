#include "validation/paper/finding_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "drawing/markdown.hpp"
#include "validation/paper/findings.hpp"

namespace cpt::validation::paper {
namespace {

std::string tally(const std::vector<FindingGroup>& groups) {
  const auto count = [&](Verdict verdict) {
    std::ptrdiff_t sum = 0;
    for (const FindingGroup& group : groups)
      sum += std::count_if(group.findings.begin(), group.findings.end(),
                           [&](const Finding& f) { return f.verdict == verdict; });
    return sum;
  };
  return fmt::format("{} checks hold, {} differ, {} numbers are shown without a check, {} are not run.\n",
                     count(Verdict::holds), count(Verdict::differs), count(Verdict::shown),
                     count(Verdict::not_run));
}

// "4068 kPa (+1.3 %)"
std::string value_cell(const Finding& f) {
  if (f.ours.empty()) return "–";
  return f.difference.empty() ? f.ours : fmt::format("{} ({})", f.ours, f.difference);
}

// `beside` is empty or has the same findings in the same order.
std::string table(const Findings& findings, const std::string& ours, const Findings& beside,
                  const std::string& others) {
  std::vector<std::string> columns = {"#", "what", "paper", "§", ours};
  if (!beside.empty()) columns.push_back(others);
  columns.insert(columns.end(), {"check", "verdict"});
  std::string out = drawing::table_head(columns);
  for (std::size_t i = 0; i < findings.size(); ++i) {
    const Finding& f = findings[i];
    std::vector<std::string> cells = {std::string(f.row), f.quantity, f.published, std::string(f.section),
                                      value_cell(f)};
    if (!beside.empty())
      cells.push_back(value_cell(beside[i]) + (beside[i].verdict == Verdict::differs ? ", **differs**" : ""));
    cells.insert(cells.end(), {f.check, std::string(to_string(f.verdict))});
    out += drawing::table_line(cells);
  }
  return out;
}

// What is out of line in the findings that have been run, and by reason those that have not.
std::string details(const Findings& findings) {
  std::string out;
  std::vector<std::pair<std::string, std::string>> absent;  // reason, rows
  for (const Finding& f : findings) {
    if (f.detail.empty()) continue;
    if (f.verdict != Verdict::not_run) {
      out += fmt::format("- {}, {}: {}.\n", f.row, f.quantity, f.detail);
      continue;
    }
    const auto same = std::find_if(absent.begin(), absent.end(),
                                   [&](const auto& other) { return other.first == f.detail; });
    if (same == absent.end())
      absent.emplace_back(f.detail, f.row);
    else if (!same->second.ends_with(f.row))
      same->second += fmt::format(", {}", f.row);
  }
  for (const auto& [reason, rows] : absent) out += fmt::format("- {}: {}.\n", rows, reason);
  return out;
}

std::string cause_of(std::string_view row, const std::vector<Cause>& causes, const Studies& studies) {
  const auto found = std::find_if(causes.begin(), causes.end(), [&](const Cause& c) { return c.row == row; });
  if (found == causes.end()) return fmt::format("- **{} differs:** the cause is not known yet.\n", row);
  std::string text = found->text;
  std::replace(text.begin(), text.end(), '\n', ' ');
  std::string out = fmt::format("- **{} differs:** {}\n", row, text);
  for (const Evidence& evidence : found->evidence)
    out += fmt::format("  - {}.\n", in_numbers(evidence, studies));
  return out;
}

std::string all_causes(const Findings& findings, const std::vector<Cause>& causes, const Studies& studies) {
  std::string out;
  std::string_view told;
  for (const Finding& f : findings) {
    if (f.verdict != Verdict::differs || f.row == told) continue;
    told = f.row;
    out += cause_of(f.row, causes, studies);
  }
  return out;
}

}  // namespace

std::string finding_tables(const Runs& runs, const std::vector<Cause>& causes, const Runs* beside) {
  const std::vector<FindingGroup> groups = all_findings(runs);
  const std::vector<FindingGroup> others =
      beside != nullptr ? all_findings(*beside) : std::vector<FindingGroup>(groups.size());
  const std::string column = "ours, " + presets_of(runs.studies);
  const std::string other_column = beside != nullptr ? "beside, " + presets_of(beside->studies) : "";
  std::string out = tally(groups);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const Findings& findings = groups[g].findings;
    out += fmt::format("\n### {}\n\n", groups[g].title) +
           table(findings, column, others[g].findings, other_column);
    const std::string below = details(findings) + all_causes(findings, causes, runs.studies);
    if (!below.empty()) out += "\n" + below;
  }
  return out;
}

}  // namespace cpt::validation::paper
