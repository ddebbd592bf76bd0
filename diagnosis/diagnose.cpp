#include "diagnosis/diagnose.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace cpt::diagnosis {
namespace {

constexpr double not_yet = std::numeric_limits<double>::quiet_NaN();

VectorXd kept(const VectorXd& curve, const std::vector<Index>& rows) {
  return curve.size() > 0 ? VectorXd(curve(rows)) : curve;
}

MatrixXd kept_rows(const MatrixXd& curves, const std::vector<Index>& rows) {
  return curves.cols() > 0 ? MatrixXd(curves(rows, Eigen::all))
                           : MatrixXd(static_cast<Index>(rows.size()), 0);
}

NoiseModel measurement_noise(const Problem& problem, const Options& options) {
  return problem.measurement ? *problem.measurement
                             : noise_of_high_pass(problem.cells, problem.recorded, options.high_pass);
}

// Noise, and the error of the response surface.
MatrixXd noise(const Problem& problem, const Compared& compared, const ResponseSurface& surface) {
  MatrixXd sigma = noise_covariance(compared.cells, compared.measurement);
  if (compared.numerical) sigma += problem.numerical_shares * compared.numerical->covariance;
  return sigma + low_rank_plus_diagonal(surface.left_out());
}

VectorXd column(const std::vector<Hypothesis>& hypotheses, double Hypothesis::*number) {
  VectorXd values(static_cast<Index>(hypotheses.size()));
  std::ranges::transform(hypotheses, values.begin(), number);
  return values;
}

// What is to be weighed, with its prior.
std::vector<Hypothesis> hypotheses_of(const std::vector<CurveEmulator>& emulators, const Options& options) {
  const double rest = 1.0 - options.prior_nothing - options.prior_unknown;
  std::vector<Hypothesis> hypotheses;
  for (std::size_t k = 0; k < emulators.size(); ++k)
    hypotheses.push_back(
        {k, emulators[k].name(), rest / static_cast<double>(emulators.size()), not_yet, not_yet});
  hypotheses.push_back({Explanation::nothing(), nothing_is_missing, options.prior_nothing, not_yet, not_yet});
  hypotheses.push_back({Explanation::unknown(), none_of_these, options.prior_unknown, not_yet, not_yet});
  const double sum = column(hypotheses, &Hypothesis::prior).sum();
  for (Hypothesis& hypothesis : hypotheses) hypothesis.prior /= sum;
  return hypotheses;
}

void set_probabilities(std::vector<Hypothesis>& hypotheses) {
  const VectorXd probability =
      probabilities(column(hypotheses, &Hypothesis::log_evidence), column(hypotheses, &Hypothesis::prior));
  for (std::size_t k = 0; k < hypotheses.size(); ++k)
    hypotheses[k].probability = probability(static_cast<Index>(k));
}

// Fills in log evidence and probability of the hypotheses; what there is to say of the mechanisms.
std::vector<MechanismEvidence> weigh(const Problem& problem, const NullModel& null,
                                     const std::vector<CurveEmulator>& emulators, const Options& options,
                                     std::vector<Hypothesis>& hypotheses) {
  const VectorXd residual = problem.recorded - null.mean;
  const Whitener M(null.covariance);
  std::vector<MechanismEvidence> mechanisms;
  for (Hypothesis& hypothesis : hypotheses) {
    if (hypothesis.explanation.is_nothing()) {
      hypothesis.log_evidence = M.log_density(residual);
    } else if (hypothesis.explanation.is_unknown()) {
      hypothesis.log_evidence = unknown_evidence(problem.cells, null, residual, options.unknown);
    } else {
      const MechanismLikelihood likelihood(emulators[hypothesis.explanation.mechanism()], M);
      mechanisms.push_back(mechanism_evidence(likelihood, residual, options.grid));
      hypothesis.log_evidence = mechanisms.back().log_evidence;
    }
  }
  set_probabilities(hypotheses);
  return mechanisms;
}

// The most probable, where "nothing is missing" gives way only below the alarm's level.
Explanation winner_of(const std::vector<Hypothesis>& hypotheses, const Options& options) {
  for (const Hypothesis& hypothesis : hypotheses)
    if (hypothesis.explanation.is_nothing() && hypothesis.probability >= options.alarm)
      return hypothesis.explanation;
  return std::ranges::max_element(hypotheses, {}, &Hypothesis::probability)->explanation;
}

std::vector<PairEvidence> best_pairs(const Problem& problem, const std::vector<CurveEmulator>& emulators,
                                     const NullModel& null, const std::vector<MechanismEvidence>& mechanisms,
                                     const Options& options) {
  const VectorXd residual = problem.recorded - null.mean;
  std::vector<std::size_t> order(emulators.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return mechanisms[a].log_evidence > mechanisms[b].log_evidence;
  });
  order.resize(std::min(order.size(), static_cast<std::size_t>(options.pairs_of)));
  std::vector<PairEvidence> pairs;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size(); ++j)
      pairs.push_back(
          pair_evidence(emulators[order[i]], emulators[order[j]], null.covariance, residual, options.grid));
  std::stable_sort(pairs.begin(), pairs.end(), [](const PairEvidence& a, const PairEvidence& b) {
    return a.log_evidence > b.log_evidence;
  });
  return pairs;
}

// The credible set, and what the answer cannot be told from.
std::vector<Explanation> answers(const Verdict& verdict, const Isolability& isolability,
                                 const Options& options) {
  const auto like_the_answer = [&](Explanation other) {
    if (!verdict.answer.is_mechanism() || other.is_unknown()) return false;
    const auto i = static_cast<Index>(verdict.answer.mechanism());
    const double distance = other.is_nothing()
                                ? isolability.strength(i)
                                : isolability.between(i, static_cast<Index>(other.mechanism()));
    return distance < options.indistinguishable;
  };
  std::vector<Explanation> set;
  double sum = 0.0;
  for (const Explanation explanation : verdict.by_probability()) {
    if (sum < options.credible || explanation == verdict.answer || like_the_answer(explanation))
      set.push_back(explanation);
    sum += verdict.of(explanation).probability;
  }
  return set;
}

// Depth [m] that the sounding with the fewest cells covers.
double shortest_sounding(const std::vector<Cell>& cells) {
  std::vector<int> count(static_cast<std::size_t>(cells.back().sounding) + 1, 0);
  for (const Cell& cell : cells) ++count[static_cast<std::size_t>(cell.sounding)];
  std::erase(count, 0);
  return *std::min_element(count.begin(), count.end()) * cells.front().height;
}

std::optional<HeldOutGain> hold_out(const Problem& problem, const Compared& compared, const NullModel& null,
                                    const CurveEmulator& emulator, const Options& options) {
  const double correlation =
      std::max(compared.measurement.length, compared.numerical ? compared.numerical->target.length : 0.0);
  const double length = std::max(std::min(options.held_out_length, 0.25 * shortest_sounding(compared.cells)),
                                 3.0 * correlation);
  const auto blocks = depth_blocks(compared.cells, length);
  if (blocks.size() < 2) return std::nullopt;
  const Prediction with = predict_mechanism(null, emulator, problem.recorded, blocks, options.grid);
  return held_out_gain(problem.recorded, predict_null(null, problem.recorded, blocks), with,
                       static_cast<int>(std::ceil(length / compared.cells.front().height)), options.seed + 2);
}

std::vector<PriorVariation> vary(const Problem& problem, const NullModel& null,
                                 const std::vector<CurveEmulator>& emulators, const Verdict& verdict,
                                 const Options& options) {
  std::vector<PriorVariation> variations;
  const auto add = [&](const char* what, const std::vector<Hypothesis>& hypotheses) {
    const Explanation winner = winner_of(hypotheses, options);
    variations.push_back({what, verdict.of(winner).name, winner != verdict.winner});
  };
  const auto weighed = [&](const NullModel& other_null, const Options& other_options) {
    std::vector<Hypothesis> hypotheses = verdict.hypotheses;
    weigh(problem, other_null, emulators, other_options, hypotheses);
    return hypotheses;
  };
  for (const double width : {0.5, 2.0})
    add(width < 1.0 ? "parameter ranges x 1/2" : "parameter ranges x 2",
        weighed(null_model(null.parameters.widened(width), null.sigma), options));
  Options half = options;
  half.grid.strength_limit = 0.5 * options.grid.strength_limit;
  add("strength ranges x 1/2", weighed(null, half));
  // Beyond the runs the likelihood is taken as nil: the wider prior only costs.
  std::vector<Hypothesis> diluted = verdict.hypotheses;
  for (Hypothesis& hypothesis : diluted)
    if (hypothesis.explanation.is_mechanism() &&
        emulators[hypothesis.explanation.mechanism()].vanishes_at_zero())
      hypothesis.log_evidence -= std::log(2.0);
  set_probabilities(diluted);
  add("strength ranges x 2", diluted);
  return variations;
}

}  // namespace

Problem complete_cells(const Problem& problem, std::vector<Index>& rows) {
  std::vector<MatrixXd> curves{problem.recorded, problem.baseline, problem.repeats, problem.joint.curves};
  for (const ParameterEffect& p : problem.parameters)
    for (const VectorXd* y : {&p.lower, &p.upper})
      if (y->size() > 0) curves.emplace_back(*y);
  for (const MechanismEffect& m : problem.mechanisms) {
    curves.push_back(m.delta);
    curves.push_back(m.joint_delta);
  }
  if (problem.recorded.size() != static_cast<Index>(problem.cells.size()))
    throw std::invalid_argument("the recording has another number of cells than the grid");
  rows = complete_rows(curves);
  if (rows.size() < 10) throw std::invalid_argument("fewer than 10 complete cells");

  Problem result = problem;
  result.cells = select(problem.cells, rows);
  result.recorded = kept(problem.recorded, rows);
  result.baseline = kept(problem.baseline, rows);
  result.repeats = kept_rows(problem.repeats, rows);
  result.joint.curves = kept_rows(problem.joint.curves, rows);
  for (ParameterEffect& p : result.parameters) {
    p.lower = kept(p.lower, rows);
    p.upper = kept(p.upper, rows);
  }
  for (MechanismEffect& m : result.mechanisms) {
    m.delta = kept_rows(m.delta, rows);
    m.joint_delta = kept_rows(m.joint_delta, rows);
  }
  return result;
}

Prepared prepare(const Problem& given, const Options& options) {
  Compared compared;
  Problem problem = complete_cells(given, compared.rows);
  compared.cells = problem.cells;
  compared.measurement = measurement_noise(problem, options);
  if (problem.repeats.cols() > 0) compared.numerical = covariance_of_repeats(problem.cells, problem.repeats);
  ResponseSurface surface(problem.baseline, problem.parameters, problem.joint);
  MatrixXd sigma = noise(problem, compared, surface);
  NullModel null = null_model(std::move(surface), std::move(sigma));
  std::vector<CurveEmulator> emulators;
  for (const MechanismEffect& effect : problem.mechanisms) emulators.emplace_back(effect);
  return {std::move(problem), std::move(compared), std::move(null), std::move(emulators)};
}

Diagnosis diagnose(const Problem& given, const Options& options) {
  const Prepared prepared = prepare(given, options);
  const Problem& problem = prepared.problem;
  const NullModel& null = prepared.null;
  const std::vector<CurveEmulator>& emulators = prepared.emulators;
  const std::vector<Cell>& cells = problem.cells;
  Diagnosis d;
  d.compared = prepared.compared;

  // Null: what scatter and the soil's parameters can do.
  const Whitener M(null.covariance), noise_alone(null.sigma);
  const VectorXd residual = problem.recorded - null.mean;
  const MatrixXd draws = draw_null(null, options.bootstraps, options.seed);
  d.null.recalibrated = recalibrate(null.parameters, problem.recorded, noise_alone);
  d.null.check = check_null(cells, M, residual, draws, options.locate.least_cells);

  // Locate.
  d.location = locate(cells, residual, M, draws, d.null.recalibrated.curve, options.locate);

  // Name.
  Verdict& verdict = d.verdict;
  verdict.hypotheses = hypotheses_of(emulators, options);
  const std::vector<MechanismEvidence> evidence =
      weigh(problem, null, emulators, options, verdict.hypotheses);
  verdict.winner = winner_of(verdict.hypotheses, options);
  d.pairs = best_pairs(problem, emulators, null, evidence, options);

  // Gate.
  if (verdict.winner.is_nothing()) verdict.gate = d.null.check;
  if (verdict.winner.is_mechanism()) {
    const std::size_t k = verdict.winner.mechanism();
    verdict.gate = check_mechanism(cells, null.covariance, emulators[k], evidence[k], residual, draws,
                                   options.seed + 1, options.locate.least_cells);
  }
  const bool failed = verdict.gate && verdict.gate->p < options.gate;
  verdict.answer = failed ? Explanation::unknown() : verdict.winner;

  // Isolate.
  std::vector<VectorXd> phi;
  for (const MechanismEvidence& mechanism : evidence) phi.push_back(mechanism.mode);
  d.isolability = isolability({"this recording", null.covariance, emulators}, phi);
  verdict.set = answers(verdict, d.isolability, options);

  // Show it on what was held out.
  for (std::size_t k = 0; k < emulators.size(); ++k) {
    const VectorXd rest = problem.recorded - emulators[k].mean(phi[k]);
    d.mechanisms.push_back({evidence[k], recalibrate(null.parameters, rest, noise_alone)});
    d.mechanisms.back().recalibrated.curve += problem.recorded - rest;
  }
  if (!emulators.empty()) {
    const std::size_t best = verdict.mechanisms_by_probability().front();
    d.best = {best, hold_out(problem, d.compared, null, emulators[best], options)};
  }

  if (options.sensitivity) d.variations = vary(problem, null, emulators, verdict, options);
  return d;
}

Observation observation_of(const std::string& name, const Problem& problem, const Options& options) {
  Prepared prepared = prepare(problem, options);
  return {name, std::move(prepared.null.covariance), std::move(prepared.emulators)};
}

std::vector<NextMeasurement> rank_next_measurements(const Observation& present, const Diagnosis& diagnosis,
                                                    const std::vector<Observation>& candidates) {
  const std::vector<std::size_t> set = diagnosis.verdict.mechanisms_in_set();
  if (set.size() < 2) return {};
  std::vector<VectorXd> phi;
  for (const MechanismFit& mechanism : diagnosis.mechanisms) phi.push_back(mechanism.evidence.mode);
  return next_measurements(present, candidates, set, phi);
}

}  // namespace cpt::diagnosis
