#include "results/ledger/study_changes.hpp"

#include <fmt/format.h>

#include <map>
#include <string_view>

#include "results/ledger/ledger_rows.hpp"
#include "results/ledger/setup_text.hpp"
#include "solver/quantities.hpp"

namespace cpt::results {
namespace {

/// What a study says, by what it says it of.
using Content = std::map<std::string, std::string>;

void add_setup(Content& content, const std::string& canonical_text) {
  content.merge(setup_by_name(canonical_text));
}

void add_bounds(Content& content, const std::string& name, const std::string& lower,
                const std::string& upper) {
  content[name + ", bounds"] = fmt::format("{} to {}", lower, upper);
}

void add_window(Content& content, const std::string& name, std::string_view kind, double from, double to) {
  content[fmt::format("window {}", name)] = fmt::format("{} {:g} to {:g} m", kind, from, to);
}

Content stored(const Database& database) {
  Content content;
  Statement campaign = database.prepare("SELECT baseline_setup FROM campaign");
  if (campaign.step()) add_setup(content, campaign.text(0));
  Statement rows = database.prepare("SELECT name, lower_text, upper_text FROM parameter");
  while (rows.step()) add_bounds(content, rows.text(0), rows.text(1), rows.text(2));
  Statement windows = database.prepare("SELECT name, kind, search_from_m, search_to_m FROM depth_window");
  while (windows.step())
    add_window(content, windows.text(0), windows.text(1), windows.number(2), windows.number(3));
  return content;
}

Content written(const parameters::Study& study) {
  Content content;
  add_setup(content, solver::canonical_text(study.baseline));
  for (const parameters::Row& row : study.rows)
    add_bounds(content, std::string(row.quantity->name), row.quantity->format(row.lower),
               row.quantity->format(row.upper));
  for (const parameters::Window& window : study.windows)
    add_window(content, window.name, kind_name(window.kind), window.from, window.to);
  return content;
}

}  // namespace

std::vector<std::string> study_changes(const Database& database, const parameters::Study& study) {
  const Content before = stored(database), now = written(study);
  std::vector<std::string> changes;
  if (before.empty()) return changes;
  std::map<std::string, bool> all;  // names of both, in order
  for (const auto& [name, value] : before) all[name];
  for (const auto& [name, value] : now) all[name];
  for (const auto& [name, unused] : all) {
    const auto old = before.find(name), current = now.find(name);
    if (old == before.end())
      changes.push_back(fmt::format("{}: {}, new", name, current->second));
    else if (current == now.end())
      changes.push_back(fmt::format("{}: gone, was {}", name, old->second));
    else if (old->second != current->second)
      changes.push_back(fmt::format("{}: {}, was {}", name, current->second, old->second));
  }
  return changes;
}

}  // namespace cpt::results
