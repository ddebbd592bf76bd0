#include "cli/soundings/recording_interpretation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cli/common/cells.hpp"

namespace cpt::cli {
namespace {

using recordings::Interpretation;
using recordings::Recording;
using results::Cell;
using results::Table;

constexpr double mm_per_s = 1.0e-3;    // [m/s]
constexpr std::size_t most_rows = 12;  // rows of a table to read

Table assumption_table(const Interpretation& it) {
  Table table{{"assumption", "value", "unit", "origin"}, {}};
  for (const recordings::Assumption& a : it.assumptions)
    table.rows.push_back({a.what, a.value, a.unit, std::string(name_of(a.origin))});
  return table;
}

Table behaviour_table(const Interpretation& it) {
  Table table{{"from_m", "to_m", "zone", "soil_behaviour", "readings", "share_percent", "q_t_kPa",
               "R_f_percent", "I_c"},
              {}};
  for (const recordings::BehaviourInterval& b : it.intervals)
    table.rows.push_back({b.from, b.to, whole(b.zone), std::string(recordings::name_of_zone(b.zone)),
                          whole(b.readings), std::round(100.0 * b.of_zone / std::max(1, b.readings)),
                          cell(b.q_t / kPa), cell(b.R_f), cell(b.I_c)});
  return table;
}

Table spike_table(const Recording& r, const std::vector<recordings::Spike>& spikes) {
  Table table{{"depth_m", "line", "quantity", "value_kPa", "neighbours_kPa"}, {}};
  for (const recordings::Spike& s : spikes)
    table.rows.push_back({r.readings[s.reading].depth, whole(r.readings[s.reading].line),
                          std::string(s.quantity), s.value / kPa, s.neighbours / kPa});
  return table;
}

Table speed_table(const std::vector<recordings::OddSpeed>& runs) {
  Table table{{"from_m", "to_m", "readings", "slowest_mm_per_s", "median_mm_per_s", "fastest_mm_per_s"}, {}};
  for (const recordings::OddSpeed& s : runs)
    table.rows.push_back(
        {s.from, s.to, whole(s.readings), s.min / mm_per_s, s.median / mm_per_s, s.max / mm_per_s});
  return table;
}

/// A table to read: depths to the millimetre, other numbers to as many decimals; set in by two blanks.
std::string table_to_read(Table table) {
  for (auto& row : table.rows)
    for (Cell& cell : row)
      if (double* value = std::get_if<double>(&cell)) {
        const double places = std::abs(*value) < 100.0 ? 1e3 : 10.0;
        *value = std::round(*value * places) / places;
      }
  const std::string text = results::format(table, results::Format::table);
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1);
    result += "  " + text.substr(at, end + 1 - at);
    at = end + 1;
  }
  return result;
}

std::string behaviour_text(const Interpretation& it) {
  std::string text = "\nSoil behaviour type (Robertson 1990, 2009: I_c with its exponent n)\n";
  text += it.corrected ? "  q_t = q_c + (1 - a) u_2\n"
                       : fmt::format("  q_t = q_c, not corrected: {}\n", it.why_not_corrected);
  for (const recordings::Assumption& a : it.assumptions)
    text += fmt::format("  {}: {:g}{}{} ({})\n", a.what, a.value, a.unit.empty() ? "" : " ", a.unit,
                        name_of(a.origin));
  if (!it.why_no_behaviour.empty()) text += fmt::format("  none: {}\n", it.why_no_behaviour);
  if (it.intervals.empty()) return text;
  return text + table_to_read(behaviour_table(it)) +
         fmt::format("  medians; intervals thinner than {:.2g} m have joined a neighbour\n",
                     it.least_interval);
}

std::string spike_text(const Recording& r, const Interpretation& it) {
  if (it.spikes.empty()) return "\nNo spikes of single readings\n";
  std::string counts;
  for (const char* quantity : {"q_c", "f_s", "u_2"}) {
    const auto n = std::count_if(it.spikes.begin(), it.spikes.end(),
                                 [&](const recordings::Spike& s) { return s.quantity == quantity; });
    if (n > 0) counts += fmt::format("{}{} of {}", counts.empty() ? "" : ", ", n, quantity);
  }
  std::vector<recordings::Spike> first(
      it.spikes.begin(),
      it.spikes.begin() + static_cast<std::ptrdiff_t>(std::min(most_rows, it.spikes.size())));
  std::string text = fmt::format("\nSpikes of single readings: {}; no value is changed\n", counts) +
                     table_to_read(spike_table(r, first));
  if (it.spikes.size() > most_rows)
    text += fmt::format("  and {} more (--format json)\n", it.spikes.size() - most_rows);
  return text;
}

std::string speed_text(const Interpretation& it) {
  if (it.speed.source == recordings::SpeedSource::none) return {};
  const recordings::Spread spread = recordings::spread(it.speed.speed);
  const int odd = std::accumulate(it.odd_speeds.begin(), it.odd_speeds.end(), 0,
                                  [](int sum, const recordings::OddSpeed& s) { return sum + s.readings; });
  if (spread.values == 0) return {};
  std::string text = fmt::format(
      "\nSpeed of penetration, {}: median {:.3g} mm/s; {} of {} readings outside of 20 +- 5 mm/s\n",
      it.speed.source == recordings::SpeedSource::recorded ? "as recorded" : "from depth and time",
      spread.median / mm_per_s, odd, spread.values);
  if (odd == 0) return text;
  std::vector<recordings::OddSpeed> longest = it.odd_speeds;
  std::stable_sort(longest.begin(), longest.end(),
                   [](const auto& a, const auto& b) { return a.readings > b.readings; });
  if (longest.size() > most_rows) longest.resize(most_rows);
  std::stable_sort(longest.begin(), longest.end(),
                   [](const auto& a, const auto& b) { return a.from < b.from; });
  text += table_to_read(speed_table(longest));
  if (it.odd_speeds.size() > most_rows)
    text += fmt::format("  and {} shorter runs (--format json)\n", it.odd_speeds.size() - most_rows);
  return text;
}

}  // namespace

std::vector<results::NamedTable> interpretation_tables(const Recording& r, const Interpretation& it) {
  return {{"assumptions", assumption_table(it)},
          {"soil_behaviour", behaviour_table(it)},
          {"spikes", spike_table(r, it.spikes)},
          {"odd_speeds", speed_table(it.odd_speeds)}};
}

std::string interpretation_text(const Recording& r, const Interpretation& it) {
  return behaviour_text(it) + spike_text(r, it) + speed_text(it);
}

std::vector<DerivedColumn> derived_columns(const Interpretation& it) {
  std::vector<DerivedColumn> columns = {{"q_t", "kPa", "q_t_kPa", it.q_t},
                                        {"R_f", "%", "R_f_percent", it.R_f},
                                        {"Q_tn", "-", "Q_tn", {}},
                                        {"F_r", "%", "F_r_percent", {}},
                                        {"n", "-", "n", {}},
                                        {"I_c", "-", "I_c", {}},
                                        {"zone", "-", "zone", {}}};
  for (double& q_t : columns[0].values) q_t /= kPa;
  for (const recordings::Behaviour& b : it.behaviour) {
    columns[2].values.push_back(b.Q_tn);
    columns[3].values.push_back(b.F_r);
    columns[4].values.push_back(b.n);
    columns[5].values.push_back(b.I_c);
    columns[6].values.push_back(b.zone == 0 ? recordings::not_given : b.zone);
  }
  return columns;
}

}  // namespace cpt::cli
