#include "cli/soils/joint_fit_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "cli/common/cells.hpp"
#include "parameters/distributions/copula.hpp"
#include "solver/constitutive/critical_state_line.hpp"

namespace cpt::cli {
namespace {

using calibration::JointFit;
using calibration::ParameterFit;

constexpr double one_percent = 0.01;
constexpr double close_correlation = 0.95;   // that is worth a sentence
constexpr double least_correlation = 0.005;  // that a study is told

std::vector<const ParameterFit*> told(const JointFit& fit) {
  std::vector<const ParameterFit*> list;
  for (const ParameterFit& one : fit.parameters)
    if (one.told) list.push_back(&one);
  return list;
}

std::string name_of(const ParameterFit& one) { return std::string(one.parameter->quantity->name); }

// Nearest decimal that a study needs: six figures.
std::string number(double value) { return fmt::format("{:.6g}", value); }

}  // namespace

results::Table ends_table(const JointFit& fit) {
  results::Table table{{"test", "critical_state", "D_end", "q_change_percent", "p_end_kPa", "e_end",
                        "psi_end", "eta_end", "D_min", "eta_there"},
                       {}};
  const solver::CriticalStateLine line(fit.sand);
  for (const calibration::TestStates& s : fit.first.states)
    table.rows.push_back({s.name,
                          std::string(std::isnan(s.D_end) ? "not known"
                                      : s.critical        ? "reached"
                                                          : "not reached"),
                          cell(s.D_end), cell(s.q_change / one_percent), cell(s.p_end / kPa), cell(s.e_end),
                          cell(s.e_end - line.void_ratio(s.p_end)), cell(s.eta_end), cell(s.D_peak),
                          cell(s.eta_peak)});
  return table;
}

results::Table parameters_table(const JointFit& fit) {
  results::Table table{{"parameter", "unit", "given", "by_hand", "fitted", "low_95", "high_95",
                        "deviation_of", "standard_deviation", "note"},
                       {}};
  for (const ParameterFit& one : fit.parameters)
    table.rows.push_back({name_of(one), std::string(one.parameter->quantity->unit), cell(one.given),
                          cell(one.first), one.told ? cell(one.value) : results::Cell{}, cell(one.low),
                          cell(one.high),
                          one.told ? (one.parameter->logarithmic ? "ln " : "") + name_of(one) : std::string(),
                          cell(one.standard_deviation), one.remark});
  return table;
}

results::Table correlation_table(const JointFit& fit) {
  results::Table table{{"correlation"}, {}};
  const auto names = told(fit);
  for (const ParameterFit* one : names) table.columns.push_back(name_of(*one));
  for (std::size_t i = 0; i < names.size(); ++i) {
    auto& row = table.rows.emplace_back();
    row.emplace_back(name_of(*names[i]));
    for (std::size_t j = 0; j < names.size(); ++j)
      row.push_back(
          cell(std::round(1e3 * fit.correlation(static_cast<long>(i), static_cast<long>(j))) / 1e3));
  }
  return table;
}

results::Table channels_table(const JointFit& fit) {
  results::Table table{{"measured", "readings", "scatter", "scatter_is", "neighbours_r", "count_for"}, {}};
  for (std::size_t k = 0; k < fit.channels.size(); ++k) {
    const calibration::ChannelScatter& channel = fit.channels[k];
    if (channel.readings == 0) continue;
    table.rows.push_back(
        {std::string(to_string(static_cast<calibration::Channel>(k))), whole(channel.readings),
         cell(channel.scatter), std::string(channel.estimated ? "estimated" : "assumed"),
         cell(channel.autocorrelation), cell(std::round(channel.readings / channel.inflation))});
  }
  return table;
}

results::Table misfit_table(const calibration::LaboratoryTests& tests, const JointFit& fit) {
  results::Table table{
      {"test", "misfit_q_percent_of_q_max", "misfit_eps_v_percent", "misfit_e", "misfit_ln_G0"}, {}};
  const auto add = [&](const std::string& name) {
    const auto test = static_cast<long>(table.rows.size());
    table.rows.push_back({name, cell(fit.misfit(test, 0) / one_percent),
                          cell(fit.misfit(test, 1) / one_percent), cell(fit.misfit(test, 2)),
                          cell(fit.misfit(test, 3))});
  };
  for (const auto& test : tests.triaxial) add(test.name);
  for (const auto& test : tests.oedometer) add(test.name);
  return table;
}

std::string verdict(const JointFit& fit) {
  std::string text;
  std::vector<std::string> kept;
  for (const ParameterFit& one : fit.parameters)
    if (!one.told) kept.push_back(fmt::format("{} = {:.6g}", name_of(one), one.given));
  if (!kept.empty())
    text +=
        fmt::format("Not told by these tests and kept as given: {}. The intervals hold for these values.\n",
                    fmt::join(kept, ", "));
  const auto names = told(fit);
  for (std::size_t i = 0; i < names.size(); ++i)
    for (std::size_t j = i + 1; j < names.size(); ++j)
      if (const double r = fit.correlation(static_cast<long>(i), static_cast<long>(j));
          std::abs(r) >= close_correlation)
        text +=
            fmt::format("{} and {} are told together rather than each alone: their correlation is {:+.3f}.\n",
                        name_of(*names[i]), name_of(*names[j]), r);
  const bool inflated = std::ranges::any_of(
      fit.channels, [](const calibration::ChannelScatter& channel) { return channel.inflation > 1.0; });
  if (inflated)
    text +=
        "Neighbouring residuals go together: the law misses the form of the curves, or the readings share an "
        "error.\nThey count for fewer readings, which makes the intervals wider; what the law cannot do, "
        "they do "
        "not hold.\n";
  return text;
}

std::string study_lines(const JointFit& fit) {
  std::string text = "[parameters]\n";
  const auto names = told(fit);
  for (const ParameterFit* one : names) {
    // Of ln(value) where that is fitted: mean and coefficient of variation of a lognormal law.
    const double s = one->standard_deviation;
    if (one->parameter->logarithmic)
      text += fmt::format(
          "\"sand.{}\" = {{ distribution = {{ kind = \"lognormal\", mean = {}, cv = {} }} }}\n",
          name_of(*one), number(one->value * std::exp(0.5 * s * s)), number(std::sqrt(std::expm1(s * s))));
    else
      text += fmt::format(
          "\"sand.{}\" = {{ distribution = {{ kind = \"normal\", mean = {}, standard_deviation = {} }} }}\n",
          name_of(*one), number(one->value), number(s));
  }
  std::string correlations;
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::vector<std::string> others;
    for (std::size_t j = 0; j < i; ++j) {
      const double rank =
          parameters::rank_correlation(fit.correlation(static_cast<long>(i), static_cast<long>(j)));
      if (std::abs(rank) >= least_correlation)
        others.push_back(fmt::format("\"sand.{}\" = {}", name_of(*names[j]), number(rank)));
    }
    if (!others.empty())
      correlations += fmt::format("\"sand.{}\" = {{ {} }}\n", name_of(*names[i]), fmt::join(others, ", "));
  }
  if (!correlations.empty()) text += "\n[correlation]\n" + correlations;
  return text;
}

}  // namespace cpt::cli
