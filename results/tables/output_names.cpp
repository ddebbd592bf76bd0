#include "results/tables/output_names.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

#include "solver/channels.hpp"

namespace cpt::results {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 11> renamed_columns = {
    {{"q_c_mean_kPa", "mean"},
     {"q_c_min_kPa", "min"},
     {"q_c_max_kPa", "max"},
     {"q_c_deviation_kPa", "deviation"},
     {"q_lower_kPa", "at_lower"},
     {"q_upper_kPa", "at_upper"},
     {"q_baseline_kPa", "at_baseline"},
     {"swing_kPa", "swing"},
     {"from_m", "from"},
     {"to_m", "to"},
     {"width_m", "width"}}};

using Units = std::map<std::string, std::string>;  // of outputs, by window

// That a push alone has.
constexpr std::array of_a_push = {"steps",           "material_points", "mass_error",
                                  "momentum_error",  "energy_error",    "kinetic_fraction",
                                  "max_empty_cells", "limited_share",   "safeguarded_share",
                                  "min_time_step_s", "max_time_step_s", "out_of_line"};

void remove_column(Table& table, std::string_view name) {
  const auto found = std::ranges::find(table.columns, name);
  if (found == table.columns.end()) return;
  const auto place = found - table.columns.begin();
  table.columns.erase(found);
  for (auto& row : table.rows) row.erase(row.begin() + place);
}

Table named(Table table, Units& units) {
  if (units.empty()) return table;
  for (const char* column : of_a_push) remove_column(table, column);
  for (const solver::Channel& channel : solver::channels().subspan(1))
    remove_column(table, in_unit(channel, "mean_kPa"));
  for (std::string& column : table.columns)
    if (const auto known = std::ranges::find(renamed_columns, std::string_view(column),
                                             [](const auto& name) { return name.first; });
        known != renamed_columns.end())
      column = known->second;
  const auto window = std::ranges::find(table.columns, "window");
  if (window == table.columns.end()) return table;
  const auto place = window - table.columns.begin();
  table.columns.insert(window + 1, "output_unit");
  for (auto& row : table.rows) {
    const auto* name = std::get_if<std::string>(&row[static_cast<std::size_t>(place)]);
    row.insert(row.begin() + place + 1, name != nullptr ? Cell(units[*name]) : Cell());
  }
  return table;
}

}  // namespace

Table named_for_outputs(Table table, const Database& database) {
  Units units;
  Statement windows = database.prepare("SELECT name, output_unit FROM depth_window WHERE output IS NOT NULL");
  while (windows.step()) units[windows.text(0)] = windows.text(1);
  return named(std::move(table), units);
}

Table named_for_outputs(Table table, const Snapshot& campaign) {
  Units units;
  if (campaign.is_external())
    for (const WindowRow& window : campaign.windows) units[window.name] = window.unit();
  return named(std::move(table), units);
}

}  // namespace cpt::results
