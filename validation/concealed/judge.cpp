#include "validation/concealed/judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnosis/prior_range.hpp"

namespace cpt::validation::concealed {
namespace {

using diagnosis::Assembled, diagnosis::Cell, diagnosis::CurveEmulator, diagnosis::FittedParameter,
    diagnosis::Index, diagnosis::none_of_these, diagnosis::nothing_is_missing, diagnosis::prepare,
    diagnosis::Prepared, diagnosis::prior_value, diagnosis::Problem, diagnosis::StoredAnswer,
    diagnosis::varied_parameters, diagnosis::VectorXd, diagnosis::Whitener;

// What the truth does to ln q_c: by the emulators, or by the effect's own formula on the baseline.
VectorXd true_effect(const Truth& truth, const Prepared& prepared) {
  const Problem& problem = prepared.problem;
  VectorXd effect = VectorXd::Zero(problem.recorded.size());
  for (const Part& part : truth.parts)
    for (const CurveEmulator& emulator : prepared.emulators)
      if (emulator.name() == part.mechanism.name) effect += emulator.mean(part.place);
  if (!truth.outside) return effect;
  const auto n = static_cast<Index>(problem.cells.size());
  for (Index first = 0; first < n;) {
    std::vector<double> depth, q_c;
    Index end = first;
    for (; end < n && problem.cells[static_cast<std::size_t>(end)].sounding ==
                          problem.cells[static_cast<std::size_t>(first)].sounding;
         ++end) {
      depth.push_back(problem.cells[static_cast<std::size_t>(end)].depth);
      q_c.push_back(std::exp(problem.baseline(end)));
    }
    const std::vector<double> changed = with_outside(*truth.outside, depth, q_c);
    for (Index i = first; i < end; ++i)
      effect(i) +=
          std::log(changed[static_cast<std::size_t>(i - first)] / q_c[static_cast<std::size_t>(i - first)]);
    first = end;
  }
  return effect;
}

// Depth intervals of a sounding where the effect is at least half its greatest.
Intervals strong_depths(const VectorXd& effect, const std::vector<Cell>& cells, int sounding) {
  const double half = 0.5 * effect.cwiseAbs().maxCoeff();
  Intervals intervals;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i].sounding != sounding || std::abs(effect(static_cast<Index>(i))) < half) continue;
    const double from = cells[i].depth - 0.5 * cells[i].height, to = from + cells[i].height;
    if (!intervals.empty() && from - intervals.back().second < 1e-6)
      intervals.back().second = to;
    else
      intervals.emplace_back(from, to);
  }
  return intervals;
}

std::string label_of(const Truth& truth) {
  if (truth.outside) {
    const solver::Mechanism* mechanism = catalogued(*truth.outside);
    return mechanism != nullptr ? std::string(mechanism->name) : none_of_these;
  }
  if (truth.parts.empty()) return nothing_is_missing;
  std::string label(truth.parts.front().mechanism.name);
  for (std::size_t i = 1; i < truth.parts.size(); ++i)
    label += " + " + std::string(truth.parts[i].mechanism.name);
  return label;
}

std::vector<ParameterCheck> check_parameters(const Truth& truth, const StoredAnswer& answer) {
  std::vector<ParameterCheck> checks;
  if (truth.parts.size() != 1 || answer.answer != truth.parts.front().mechanism.name) return checks;
  const Part& part = truth.parts.front();
  const std::vector<std::size_t> varied = varied_parameters(part.mechanism);
  for (std::size_t d = 0; d < varied.size(); ++d) {
    const solver::MechanismParameter& parameter = part.mechanism.parameters[varied[d]];
    const double value = prior_value(parameter, part.place(static_cast<Index>(d)));
    for (const FittedParameter& fitted : answer.fitted)
      if (fitted.mechanism == part.mechanism.name && fitted.quantity == parameter.quantity.name)
        checks.push_back({fitted, value});
  }
  return checks;
}

}  // namespace

double Judged::probability_of(const std::string& name) const {
  for (const StoredAnswer::Weighed& hypothesis : answer.hypotheses)
    if (hypothesis.name == name) return hypothesis.probability;
  return 0.0;
}

bool Judged::right() const {
  if (truth.parts.size() < 2) return answer.answer == label;
  return std::ranges::any_of(truth.parts,
                             [&](const Part& part) { return answer.answer == part.mechanism.name; });
}

bool Judged::pair_right() const {
  const auto& [first, second] = answer.best_pair;
  return truth.parts.size() == 2 && (first + " + " + second == label || second + " + " + first == label);
}

Judged judge(const std::string& benchmark, const Truth& truth, const StoredAnswer& answer,
             const Assembled& assembled) {
  const Prepared prepared = prepare(assembled.problem);
  const std::vector<Cell>& cells = prepared.problem.cells;
  Judged judged{benchmark,
                truth,
                answer,
                label_of(truth),
                0.0,
                std::numeric_limits<double>::quiet_NaN(),
                check_parameters(truth, answer),
                "",
                "",
                0.0,
                0.0};
  const VectorXd effect = true_effect(truth, prepared);
  judged.strength = Whitener(prepared.null.covariance).whiten(effect).norm();

  if (effect.cwiseAbs().maxCoeff() > 0.0) {
    double sum = 0.0;
    for (int s = 0; s <= cells.back().sounding; ++s) {
      Intervals found;
      for (const StoredAnswer::Place& interval : answer.mismatches)
        if (interval.sounding == s || interval.sounding == -1) found.emplace_back(interval.from, interval.to);
      sum += overlap(found, strong_depths(effect, cells, s));
    }
    judged.overlap = sum / (1.0 + cells.back().sounding);
  }

  const LeastSquares simple = least_squares(prepared);
  judged.bic = simple.greatest_weight().name;
  judged.best_rmse = simple.least_rmse().name;
  judged.bic_nothing = simple.of_nothing().bic_weight;
  double of_nothing = 0.0, of_unknown = 0.0;
  for (const StoredAnswer::Weighed& hypothesis : answer.hypotheses) {
    if (hypothesis.name == nothing_is_missing) of_nothing = hypothesis.log_evidence;
    if (hypothesis.name == none_of_these) of_unknown = hypothesis.log_evidence;
  }
  judged.discrepancy = 1.0 / (1.0 + std::exp(of_nothing - of_unknown));
  return judged;
}

}  // namespace cpt::validation::concealed
