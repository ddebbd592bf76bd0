#include "results/ledger/old_inputs.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <system_error>
#include <utility>

#include "results/ledger/setup_text.hpp"
#include "solver/quantities.hpp"

namespace cpt::results {
namespace {

using Texts = std::map<std::string, std::string>;  // values by the names of inputs

/// "sand.H = 75, sand.N = 0.2"
std::vector<std::pair<std::string, std::string>> changes_of(const std::string& value_text) {
  std::vector<std::pair<std::string, std::string>> changes;
  for (std::size_t from = 0; from < value_text.size();) {
    const std::size_t to = std::min(value_text.find(", ", from), value_text.size());
    const std::string change = value_text.substr(from, to - from);
    if (const auto equals = change.find(" = "); equals != change.npos)
      changes.emplace_back(change.substr(0, equals), change.substr(equals + 3));
    from = to + 2;
  }
  return changes;
}

bool is_point(const RealizationRow& run) { return run.side == "point" || run.side == "repeat"; }

std::set<std::string> varied_of(const Snapshot& s) {
  std::set<std::string> varied;
  for (const ParameterRow& parameter : s.parameters) varied.insert(parameter.name);
  for (const RealizationRow& run : s.realizations)
    if (is_point(run))
      for (const auto& [name, value] : changes_of(run.value_text)) varied.insert(name);
  return varied;
}

Texts baseline_of(const Snapshot& s) {
  static const solver::Setup defaults;
  Texts baseline;
  for (const solver::Quantity& quantity : solver::all_quantities())  // those that a setup's text leaves out
    if (quantity.silent_default)
      baseline[std::string(quantity.name)] = quantity.format(quantity.value(defaults));
  for (auto& [name, value] : setup_by_name(s.campaign.baseline_setup))
    baseline[name] = value.substr(0, value.find(" (SI "));
  for (const ParameterRow& parameter : s.parameters) baseline[parameter.name] = parameter.baseline_text;
  return baseline;
}

Texts inputs_of(const RealizationRow& run, Texts baseline) {
  if (is_point(run))
    for (const auto& [name, value] : changes_of(run.value_text)) baseline[name] = value;
  else if (!run.parameter.empty())
    baseline[run.parameter] = run.value_text;
  return baseline;
}

/// NaN of a choice whose place among the alternatives is not told.
double number_of(const std::string& name, const std::string& text) {
  double number = std::numeric_limits<double>::quiet_NaN();
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc{} && end == text.data() + text.size()) return number;
  const solver::Quantity* quantity = solver::find_quantity(name);
  if (quantity != nullptr)
    for (std::size_t k = 0; k < quantity->choices.size(); ++k)
      if (quantity->choices[k] == text) return static_cast<double>(k);
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

std::vector<InputRow> inputs_of_texts(const Snapshot& s) {
  const std::set<std::string> varied = varied_of(s);
  const Texts baseline = baseline_of(s);
  std::vector<InputRow> inputs;
  for (const RealizationRow& run : s.realizations) {
    Texts values = inputs_of(run, baseline);
    for (const std::string& name : varied)
      inputs.push_back({run.id, name, number_of(name, values[name]), values[name]});
  }
  return inputs;
}

}  // namespace cpt::results
