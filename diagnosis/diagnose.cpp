#include "diagnosis/diagnose.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace cpt::diagnosis {
namespace {

VectorXd kept(const VectorXd& curve, const std::vector<Index>& rows) {
  return curve.size() > 0 ? VectorXd(curve(rows)) : curve;
}

MatrixXd kept_rows(const MatrixXd& curves, const std::vector<Index>& rows) {
  return curves.cols() > 0 ? MatrixXd(curves(rows, Eigen::all))
                           : MatrixXd(static_cast<Index>(rows.size()), 0);
}

// The problem on the cells where every curve has a value.
Problem complete(const Problem& problem, std::vector<Index>& rows) {
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

NoiseModel measurement_noise(const Problem& problem, const Options& options) {
  return problem.measurement ? *problem.measurement
                             : noise_of_high_pass(problem.cells, problem.recorded, options.high_pass);
}

// Noise, and the error of the response surface.
MatrixXd noise(const Problem& problem, const NoiseModel& measurement,
               const std::optional<ShrunkCovariance>& numerical, const ResponseSurface& surface) {
  MatrixXd sigma = noise_covariance(problem.cells, measurement);
  if (numerical) sigma += problem.numerical_shares * numerical->covariance;
  return sigma + low_rank_plus_diagonal(surface.left_out());
}

VectorXd prior_of(std::size_t mechanisms, const Options& options) {
  const auto k = static_cast<Index>(mechanisms);
  const double rest = 1.0 - options.prior_nothing - options.prior_unknown;
  VectorXd prior(k + 2);
  prior.head(k).setConstant(k > 0 ? rest / static_cast<double>(k) : 0.0);
  prior(k) = options.prior_nothing;
  prior(k + 1) = options.prior_unknown;
  return prior / prior.sum();
}

struct Weighing {
  std::vector<MechanismEvidence> mechanisms;
  VectorXd log_evidence;  // mechanisms, nothing, none of these
};

Weighing weigh(const Problem& problem, const NullModel& null, const std::vector<CurveEmulator>& emulators,
               const Options& options) {
  const VectorXd residual = problem.recorded - null.mean;
  const Whitener M(null.covariance);
  const auto k = static_cast<Index>(emulators.size());
  Weighing weighing;
  weighing.log_evidence.resize(k + 2);
  for (Index i = 0; i < k; ++i) {
    const MechanismLikelihood likelihood(emulators[static_cast<std::size_t>(i)], M);
    weighing.mechanisms.push_back(mechanism_evidence(likelihood, residual, options.grid));
    weighing.log_evidence(i) = weighing.mechanisms.back().log_evidence;
  }
  weighing.log_evidence(k) = M.log_density(residual);
  weighing.log_evidence(k + 1) = unknown_evidence(problem.cells, null, residual, options.unknown);
  return weighing;
}

// The most probable, where "nothing is missing" gives way only below the alarm's level.
std::size_t winner_of(const VectorXd& probability, const Options& options) {
  const Index nothing = probability.size() - 2;
  if (probability(nothing) >= options.alarm) return static_cast<std::size_t>(nothing);
  Index best = 0;
  probability.maxCoeff(&best);
  return static_cast<std::size_t>(best);
}

std::vector<PairEvidence> best_pairs(const Problem& problem, const std::vector<CurveEmulator>& emulators,
                                     const NullModel& null, const VectorXd& log_evidence,
                                     const Options& options) {
  const VectorXd residual = problem.recorded - null.mean;
  std::vector<std::size_t> order(emulators.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return log_evidence(static_cast<Index>(a)) > log_evidence(static_cast<Index>(b));
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
std::vector<std::size_t> answers(const Diagnosis& diagnosis, const Options& options) {
  const std::size_t mechanisms = diagnosis.mechanisms.size();
  std::vector<std::size_t> order(diagnosis.hypotheses.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return diagnosis.hypotheses[a].probability > diagnosis.hypotheses[b].probability;
  });
  std::vector<bool> in(order.size(), false);
  in[diagnosis.answer] = true;
  double sum = 0.0;
  for (const std::size_t k : order) {
    if (sum < options.credible) in[k] = true;
    sum += diagnosis.hypotheses[k].probability;
  }
  if (diagnosis.answer < mechanisms) {
    const auto i = static_cast<Index>(diagnosis.answer);
    // The last column, against the null, stands where "nothing is missing" does among the hypotheses.
    for (Index j = 0; j < diagnosis.isolability.cols(); ++j)
      if (j != i && diagnosis.isolability(i, j) < options.indistinguishable)
        in[static_cast<std::size_t>(j)] = true;
  }
  std::vector<std::size_t> set;
  for (const std::size_t k : order)
    if (in[k]) set.push_back(k);
  return set;
}

// Depth [m] that the sounding with the fewest cells covers.
double shortest_sounding(const std::vector<Cell>& cells) {
  std::vector<int> count(static_cast<std::size_t>(cells.back().sounding) + 1, 0);
  for (const Cell& cell : cells) ++count[static_cast<std::size_t>(cell.sounding)];
  std::erase(count, 0);
  return *std::min_element(count.begin(), count.end()) * cells.front().height;
}

std::vector<PriorVariation> vary(const Problem& problem, const NullModel& null,
                                 const std::vector<CurveEmulator>& emulators, const VectorXd& log_evidence,
                                 const VectorXd& prior, const Options& options, const Diagnosis& diagnosis) {
  std::vector<PriorVariation> variations;
  const auto add = [&](const char* what, const VectorXd& evidence) {
    const std::size_t winner = winner_of(probabilities(evidence, prior), options);
    variations.push_back({what, diagnosis.hypotheses[winner].name, winner != diagnosis.winner});
  };
  for (const double width : {0.5, 2.0})
    add(width < 1.0 ? "parameter ranges x 1/2" : "parameter ranges x 2",
        weigh(problem, null_model(null.parameters.widened(width), null.sigma), emulators, options)
            .log_evidence);
  Options half = options;
  half.grid.strength_limit = 0.5 * options.grid.strength_limit;
  add("strength ranges x 1/2", weigh(problem, null, emulators, half).log_evidence);
  // Beyond the runs the likelihood is taken as nil: the wider prior only costs.
  VectorXd diluted = log_evidence;
  for (std::size_t k = 0; k < emulators.size(); ++k)
    if (emulators[k].vanishes_at_zero()) diluted(static_cast<Index>(k)) -= std::log(2.0);
  add("strength ranges x 2", diluted);
  return variations;
}

}  // namespace

Prepared prepare(const Problem& given, const Options& options) {
  std::vector<Index> rows;
  Problem problem = complete(given, rows);
  const NoiseModel measurement = measurement_noise(problem, options);
  std::optional<ShrunkCovariance> numerical;
  if (problem.repeats.cols() > 0) numerical = covariance_of_repeats(problem.cells, problem.repeats);
  ResponseSurface surface(problem.baseline, problem.parameters, problem.joint);
  MatrixXd sigma = noise(problem, measurement, numerical, surface);
  NullModel null = null_model(std::move(surface), std::move(sigma));
  std::vector<CurveEmulator> emulators;
  for (const MechanismEffect& effect : problem.mechanisms) emulators.emplace_back(effect);
  return {std::move(problem),   std::move(rows), measurement,
          std::move(numerical), std::move(null), std::move(emulators)};
}

Diagnosis diagnose(const Problem& given, const Options& options) {
  const Prepared prepared = prepare(given, options);
  const Problem& problem = prepared.problem;
  const NullModel& null = prepared.null;
  const std::vector<CurveEmulator>& emulators = prepared.emulators;
  Diagnosis d;
  d.rows = prepared.rows;
  d.cells = problem.cells;
  d.measurement = prepared.measurement;
  d.numerical = prepared.numerical;

  // Null: what scatter and the soil's parameters can do.
  const Whitener M(null.covariance), noise_alone(null.sigma);
  const VectorXd residual = problem.recorded - null.mean;
  const MatrixXd draws = draw_null(null, options.bootstraps, options.seed);
  d.recalibrated = recalibrate(null.parameters, problem.recorded, noise_alone);

  // Locate.
  d.location = locate(d.cells, residual, M, draws, d.recalibrated.curve, options.locate);

  // Name.
  Weighing weighing = weigh(problem, null, emulators, options);
  const VectorXd prior = prior_of(emulators.size(), options);
  const VectorXd probability = probabilities(weighing.log_evidence, prior);
  for (Index k = 0; k < prior.size(); ++k) {
    const auto mechanisms = static_cast<Index>(emulators.size());
    const std::string name = k < mechanisms    ? emulators[static_cast<std::size_t>(k)].name()
                             : k == mechanisms ? nothing_is_missing
                                               : none_of_these;
    d.hypotheses.push_back({name, prior(k), weighing.log_evidence(k), probability(k)});
  }
  d.mechanisms = std::move(weighing.mechanisms);
  d.pairs = best_pairs(problem, emulators, null, weighing.log_evidence, options);
  d.winner = winner_of(probability, options);

  // Gate.
  const std::size_t nothing = emulators.size(), unknown = nothing + 1;
  d.null_check = check_null(d.cells, M, residual, draws, options.locate.least_cells);
  if (d.winner == nothing) d.gate = d.null_check;
  if (d.winner < nothing)
    d.gate = check_mechanism(d.cells, null.covariance, emulators[d.winner], d.mechanisms[d.winner], residual,
                             draws, options.seed + 1, options.locate.least_cells);
  d.answer = d.gate && d.gate->p < options.gate ? unknown : d.winner;

  // Isolate.
  std::vector<VectorXd> phi;
  for (const MechanismEvidence& m : d.mechanisms) phi.push_back(m.mode);
  const Observation present{"this recording", null.covariance, emulators};
  d.isolability = isolability(present, phi);
  d.set = answers(d, options);

  // Show it on what was held out.
  if (nothing > 0) {
    Index best = 0;
    probability.head(static_cast<Index>(nothing)).maxCoeff(&best);
    d.best = static_cast<std::size_t>(best);
    const CurveEmulator& emulator = emulators[*d.best];
    for (std::size_t k = 0; k < nothing; ++k) {
      const VectorXd rest = problem.recorded - emulators[k].mean(phi[k]);
      d.with.push_back(recalibrate(null.parameters, rest, noise_alone));
      d.with.back().curve += problem.recorded - rest;
    }
    d.with_best = d.with[*d.best];
    const double correlation = std::max(d.measurement.length, d.numerical ? d.numerical->target.length : 0.0);
    const double length =
        std::max(std::min(options.held_out_length, 0.25 * shortest_sounding(d.cells)), 3.0 * correlation);
    const auto blocks = depth_blocks(d.cells, length);
    if (blocks.size() > 1) {
      const Prediction with = predict_mechanism(null, emulator, problem.recorded, blocks, options.grid);
      d.held_out =
          held_out_gain(problem.recorded, predict_null(null, problem.recorded, blocks), with,
                        static_cast<int>(std::ceil(length / d.cells.front().height)), options.seed + 2);
    }
  }

  if (options.sensitivity)
    d.variations = vary(problem, null, emulators, weighing.log_evidence, prior, options, d);
  return d;
}

std::vector<std::size_t> mechanisms_in_set(const Diagnosis& diagnosis) {
  std::vector<std::size_t> mechanisms;
  for (const std::size_t k : diagnosis.set)
    if (k < diagnosis.mechanisms.size()) mechanisms.push_back(k);
  return mechanisms;
}

Observation observation_of(const std::string& name, const Problem& problem, const Options& options) {
  Prepared prepared = prepare(problem, options);
  return {name, std::move(prepared.null.covariance), std::move(prepared.emulators)};
}

std::vector<NextMeasurement> rank_next_measurements(const Observation& present, const Diagnosis& diagnosis,
                                                    const std::vector<Observation>& candidates) {
  const std::vector<std::size_t> set = mechanisms_in_set(diagnosis);
  if (set.size() < 2) return {};
  std::vector<VectorXd> phi;
  for (const MechanismEvidence& mechanism : diagnosis.mechanisms) phi.push_back(mechanism.mode);
  return next_measurements(present, candidates, set, phi);
}

}  // namespace cpt::diagnosis
