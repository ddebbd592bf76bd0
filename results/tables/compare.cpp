#include "results/tables/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>

#include "results/ledger/interrupted.hpp"
#include "results/ledger/setup_text.hpp"

namespace cpt::results {
namespace {

using Pair = std::pair<std::string, std::string>;  // of a and of b

/// One run as it can be found in another campaign.
using Key = std::tuple<std::string, std::string, std::string, std::string>;  // window, parameter, side, value

std::map<Key, WindowMeanRow> means_of(const Snapshot& s) {
  std::map<Key, WindowMeanRow> means;
  for (const WindowMeanRow& mean : s.window_means)
    for (const RealizationRow& run : s.realizations)
      if (run.id == mean.realization) means[{mean.window, run.parameter, run.side, run.value_text}] = mean;
  return means;
}

/// Keys of both, those of a in its order, then what b has alone.
std::vector<Key> keys_of(const Snapshot& a, const Snapshot& b) {
  std::vector<Key> keys;
  std::set<Key> seen;
  for (const Snapshot* s : {&a, &b})
    for (const WindowRow& window : s->windows)
      for (const RealizationRow& run : s->realizations)
        if (Key key{window.name, run.parameter, run.side, run.value_text}; seen.insert(key).second)
          keys.push_back(std::move(key));
  return keys;
}

/// Who lacks the index, or what is to be known of either.
std::string note_of(const SensitivityRow* a, const SensitivityRow* b) {
  if (a == nullptr || b == nullptr) return a == nullptr ? "only in b" : "only in a";
  if (a->note == b->note) return a->note;
  std::string note = a->note.empty() ? "" : "a: " + a->note;
  if (!b->note.empty()) note += (note.empty() ? "b: " : "; b: ") + b->note;
  return note;
}

Cell above(const SensitivityRow* row) {
  if (row == nullptr || !row->above_noise) return std::monostate{};
  return std::int64_t{*row->above_noise};
}

/// Why a campaign has no value of a run: "" where it does not know the run at all.
std::string why_none(const Snapshot& s, const Key& key) {
  const std::string& window = std::get<0>(key);
  if (std::ranges::none_of(s.windows, [&](const WindowRow& w) { return w.name == window; })) return "";
  const auto run = std::ranges::find_if(s.realizations, [&](const RealizationRow& r) {
    return Key{window, r.parameter, r.side, r.value_text} == key;
  });
  if (run == s.realizations.end()) return "";
  return interrupted(*run)   ? "interrupted"
         : run->waiting()    ? "not run yet"
         : run->not_needed() ? "not needed"
         : run->failed()     ? fmt::format("failed ({})", run->status)
                             : "no value in the window";
}

/// "only in b"; "a failed (crashed)"; "a not run yet, b failed (crashed)".
std::string absence(const Snapshot& a, const Snapshot& b, const Key& key, bool in_a, bool in_b) {
  const std::string of_a = in_a ? "" : why_none(a, key), of_b = in_b ? "" : why_none(b, key);
  std::string note;
  if (!of_a.empty()) note = "a " + of_a;
  if (!of_b.empty()) note += (note.empty() ? "b " : ", b ") + of_b;
  if (!in_a && of_a.empty()) note += note.empty() ? "only in b" : ", only in b";
  if (!in_b && of_b.empty()) note += note.empty() ? "only in a" : ", only in a";
  return note;
}

const SensitivityRow* index_of(const Snapshot& s, const std::string& window, const std::string& parameter) {
  const auto row = std::ranges::find_if(
      s.sensitivity, [&](const SensitivityRow& r) { return r.window == window && r.parameter == parameter; });
  return row == s.sensitivity.end() ? nullptr : &*row;
}

}  // namespace

Table compare_settings(const Snapshot& a, const Snapshot& b) {
  std::map<std::string, Pair> all;
  for (const auto& [name, value] : setup_by_name(a.campaign.baseline_setup)) all[name].first = value;
  for (const auto& [name, value] : setup_by_name(b.campaign.baseline_setup)) all[name].second = value;
  for (const ParameterRow& p : a.parameters)
    all[p.name + ", bounds"].first = p.lower_text + " to " + p.upper_text;
  for (const ParameterRow& p : b.parameters)
    all[p.name + ", bounds"].second = p.lower_text + " to " + p.upper_text;
  all["solver version"] = {a.campaign.solver_version, b.campaign.solver_version};
  Table table{{"setting", "a", "b"}, {}};
  for (const auto& [name, values] : all)
    if (values.first != values.second) table.rows.push_back({name, values.first, values.second});
  return table;
}

Table compare_means(const Snapshot& a, const Snapshot& b) {
  const auto of_a = means_of(a), of_b = means_of(b);
  const bool external = a.is_external() || b.is_external();
  Table table{{"window", "parameter", "side", "value", external ? "a" : "a_kPa", external ? "b" : "b_kPa",
               "change", "note"},
              {}};
  for (const Key& key : keys_of(a, b)) {
    const auto in_a = of_a.find(key), in_b = of_b.find(key);
    std::string note = absence(a, b, key, in_a != of_a.end(), in_b != of_b.end());
    double q_a = NAN, q_b = NAN;
    if (in_a != of_a.end()) q_a = in_a->second.q_c_mean_kPa;
    if (in_b != of_b.end()) q_b = in_b->second.q_c_mean_kPa;
    if (note.empty() &&
        (in_a->second.from_m != in_b->second.from_m || in_a->second.to_m != in_b->second.to_m))
      note = fmt::format("windows differ: {:.4f} to {:.4f} m, {:.4f} to {:.4f} m", in_a->second.from_m,
                         in_a->second.to_m, in_b->second.from_m, in_b->second.to_m);
    const auto& [window, parameter, side, value] = key;
    table.rows.push_back({window, parameter, side, value, number_cell(q_a), number_cell(q_b),
                          number_cell(q_b / q_a - 1.0), note});
  }
  return table;
}

Table compare_sensitivity(const Snapshot& a, const Snapshot& b) {
  Table table{{"window", "parameter", "si_a", "si_b", "half_width_a", "half_width_b", "above_noise_a",
               "above_noise_b", "si_noise_a", "si_noise_b", "note"},
              {}};
  std::set<std::pair<std::string, std::string>> seen;
  for (const Snapshot* s : {&a, &b})
    for (const SensitivityRow& row : s->sensitivity) {
      if (!seen.insert({row.window, row.parameter}).second) continue;
      const SensitivityRow* in_a = index_of(a, row.window, row.parameter);
      const SensitivityRow* in_b = index_of(b, row.window, row.parameter);
      const auto value = [](const SensitivityRow* r, double SensitivityRow::*member) {
        return r == nullptr ? Cell(std::monostate{}) : number_cell(r->*member);
      };
      table.rows.push_back({row.window, row.parameter, value(in_a, &SensitivityRow::si),
                            value(in_b, &SensitivityRow::si), value(in_a, &SensitivityRow::si_half_width),
                            value(in_b, &SensitivityRow::si_half_width), above(in_a), above(in_b),
                            value(in_a, &SensitivityRow::si_noise), value(in_b, &SensitivityRow::si_noise),
                            note_of(in_a, in_b)});
    }
  return table;
}

std::string windows_apart(const Snapshot& a, const Snapshot& b) {
  if (a.windows.empty() || b.windows.empty()) return "";
  const auto shared = [&](const WindowRow& window) {
    return std::ranges::find(b.windows, window.name, &WindowRow::name) != b.windows.end();
  };
  if (std::ranges::any_of(a.windows, shared)) return "";
  const auto listed = [](const Snapshot& s) {
    std::string text;
    for (const WindowRow& window : s.windows)
      text += fmt::format("{}{}{}", text.empty() ? "" : ", ", window.name,
                          std::isfinite(window.from_m)
                              ? fmt::format(" ({:.6g} to {:.6g} m)", window.from_m, window.to_m)
                              : "");
    return text;
  };
  return fmt::format(
      "no window of a has the name of one of b, so no value stands beside another: a has {}; b has {}",
      listed(a), listed(b));
}

}  // namespace cpt::results
