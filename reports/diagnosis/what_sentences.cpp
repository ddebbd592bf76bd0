// What is missing, how well it is proved, and what the answer depends on.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/prior_range.hpp"
#include "drawing/text.hpp"
#include "reports/diagnosis/errors.hpp"
#include "reports/diagnosis/sentences.hpp"
#include "reports/diagnosis/words.hpp"

namespace cpt::reports::diagnosed {
namespace {

using diagnosis::prior_deviation, diagnosis::prior_value;

constexpr double vague = 0.22;  // standard deviation of phi; that of the prior is 0.29

}  // namespace

std::string fitted_parameters(const DiagnosisInput& input, std::size_t mechanism) {
  const diagnosis::MechanismEvidence& fit = input.diagnosis.mechanisms[mechanism].evidence;
  std::vector<std::string> parts;
  const auto& parameters = input.mechanisms[mechanism].parameters;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const auto i = static_cast<Index>(k);
    const solver::Quantity& quantity = parameters[k].quantity;
    parts.push_back(fmt::format(
        "{} = {}{}", quantity.symbol,
        with_deviation(prior_value(parameters[k], fit.mean(i)),
                       prior_deviation(parameters[k], fit.mean(i), fit.deviation(i)), quantity.unit),
        quantity.meaning.empty() ? "" : fmt::format(" ({})", quantity.meaning)));
  }
  return listed(parts);
}

std::string weak_parameters(const DiagnosisInput& input, std::size_t mechanism) {
  const diagnosis::MechanismEvidence& fit = input.diagnosis.mechanisms[mechanism].evidence;
  std::vector<std::string> untold;
  const auto& parameters = input.mechanisms[mechanism].parameters;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const auto i = static_cast<Index>(k);
    if (fit.deviation(i) > vague) untold.push_back(parameters[k].quantity.symbol);
  }
  return untold.empty() ? "" : fmt::format("The recording says little about {}.", listed(untold));
}

std::string at_ends(const DiagnosisInput& input, std::size_t mechanism) {
  const diagnosis::MechanismEvidence& fit = input.diagnosis.mechanisms[mechanism].evidence;
  std::vector<std::string> ends;
  const auto& parameters = input.mechanisms[mechanism].parameters;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const auto i = static_cast<Index>(k);
    if (fit.deviation(i) <= vague && (fit.mode(i) < 0.02 || fit.mode(i) > 0.98))
      ends.push_back(parameters[k].quantity.symbol);
  }
  return ends.empty()
             ? ""
             : fmt::format("The best value of {} lies at the end of the range looked at.", listed(ends));
}

std::string check_passed(const DiagnosisInput& input) {
  const diagnosis::Verdict& verdict = input.diagnosis.verdict;
  if (!verdict.gate) return "";
  const double p = verdict.gate->p;
  const std::string from = verdict.winner.is_mechanism()
                               ? title_of(input, verdict.winner) + " in the simulation"
                               : "the study's parameters and the noise alone";
  return fmt::format("Curves drawn with {} {} like the recording (predictive check, {}, limit {}).", from,
                     p >= input.options.gate ? "look" : "do not look", p_value(p), brief(input.options.gate));
}

std::string held_out(const DiagnosisInput& input) {
  const auto& best = input.diagnosis.best;
  if (!best || !best->held_out) return "";
  const diagnosis::HeldOutGain& gain = *best->held_out;
  const std::string before = percent(percent_of(gain.rmse_null)), after = percent(percent_of(gain.rmse));
  const std::string change =
      before == after
          ? fmt::format("stays at {}", after)
          : fmt::format("{} from {} to {}", gain.rmse < gain.rmse_null ? "falls" : "rises", before, after);
  const char* meaning = gain.lower > 0.0   ? ""
                        : gain.upper < 0.0 ? "; the effect predicts worse than nothing"
                                           : "; the interval holds zero, so this is no proof";
  return fmt::format(
      "With {}, the error on depths held out of the fit {} (gain in log score {} per cell, 90 % interval {} "
      "to {}{}).",
      title_of(input, best->mechanism), change, drawing::decimals(gain.per_cell, 2),
      drawing::decimals(gain.lower, 2), drawing::decimals(gain.upper, 2), meaning);
}

std::string solver_confirms(const DiagnosisInput& input) {
  const auto solver = solver_in_cells(input);
  if (!solver || !input.diagnosis.best) return "";
  VectorXd emulated = input.diagnosis.with_best().curve;
  for (Index i = 0; i < emulated.size(); ++i)
    if (!std::isfinite((*solver)(i))) emulated(i) = (*solver)(i);  // the same cells for both
  return fmt::format(
      "Run in the full solver, the fitted effect leaves an error of {}; the emulator had said {}.",
      percent(percent_of(rmse(input.recorded, *solver))),
      percent(percent_of(rmse(input.recorded, emulated))));
}

std::string best_pair(const DiagnosisInput& input) {
  const diagnosis::Diagnosis& d = input.diagnosis;
  if (d.pairs.empty() || !d.best) return "";
  const diagnosis::PairEvidence& pair = d.pairs.front();
  const double gain = pair.log_evidence - d.mechanisms[d.best->mechanism].evidence.log_evidence;
  const std::string both =
      fmt::format("{} together with {}", title_of(input, pair.first), title_of(input, pair.second));
  if (gain <= 0.0)
    return fmt::format("No pair of effects does better than one alone; the best pair is {}.", both);
  return fmt::format(
      "The best pair to look into is {} (log evidence {} above the best effect alone); that is a hint, not "
      "an "
      "answer.",
      both, brief(gain));
}

std::string next_measurement(const DiagnosisInput& input) {
  if (input.diagnosis.next.empty()) return "";
  const diagnosis::NextMeasurement& next = input.diagnosis.next.front();
  const double limit = input.options.indistinguishable;
  if (next.least_distance < limit)
    return fmt::format(
        "Of the candidate measurements none would tell them apart; {} comes nearest ({} standard deviations, "
        "{} wanted).",
        next.name, brief(next.least_distance), brief(limit));
  return fmt::format(
      "The next measurement that would tell them apart best: {} (at least {} standard deviations between any "
      "two, {} wanted).",
      next.name, brief(next.least_distance), brief(limit));
}

std::string prior_widths(const DiagnosisInput& input) {
  const auto& variations = input.diagnosis.variations;
  if (variations.empty()) return "";
  std::string changes;
  std::vector<std::string> all;
  for (const diagnosis::PriorVariation& v : variations) {
    all.push_back(v.what);
    if (v.changed)
      changes += fmt::format("{}with {} “{}” would come first", changes.empty() ? "" : "; ", v.what,
                             title_of(input, v.answer));
  }
  if (changes.empty())
    return fmt::format("Other prior widths ({}) leave the same explanation in front.", listed(all));
  return "The answer depends on the width of the priors: " + changes + ".";
}

}  // namespace cpt::reports::diagnosed
