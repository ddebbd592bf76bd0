#include "diagnosis/calibration/calibrate.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cpt::diagnosis {
namespace {

constexpr double in_percent = 100.0;

// Streams of random numbers beside those of the chains.
constexpr std::uint64_t start_stream = 1'000'001, prior_stream = 1'000'002, depth_stream = 1'000'003;

// Draws of scores as values, deviations in per cent.
MatrixXd told_values(const CalibrationModel& model, const MatrixXd& scores) {
  const auto inputs = static_cast<Index>(model.problem().inputs.size());
  MatrixXd values(scores.rows(), scores.cols());
  for (Index i = 0; i < scores.rows(); ++i)
    values.row(i) = model.values(scores.row(i).transpose()).transpose();
  values.rightCols(values.cols() - inputs) *= in_percent;
  return values;
}

VectorXd ranks_of(const VectorXd& values) {
  std::vector<Index> order(static_cast<std::size_t>(values.size()));
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::sort(order, {}, [&](Index i) { return values(i); });
  VectorXd ranks(values.size());
  for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
    while (last < order.size() && values(order[last]) == values(order[first])) ++last;
    for (std::size_t i = first; i < last; ++i) ranks(order[i]) = 0.5 * static_cast<double>(first + last - 1);
  }
  return ranks;
}

std::vector<CalibratedBand> bands_of(const CalibrationModel& model, std::size_t c, const MatrixXd& scores,
                                     Random& random) {
  const CalibrationChannel& channel = model.problem().channels[c];
  const auto n = static_cast<Index>(channel.cells.size());
  const auto told = [&](double value) { return channel.logarithmic ? std::exp(value) : value; };
  MatrixXd simulation(n, scores.rows()), predicted(n, scores.rows()), discrepancy(n, scores.rows());
  for (Index k = 0; k < scores.rows(); ++k) {
    const CalibratedCells at = model.cells(c, model.values(scores.row(k).transpose()));
    for (Index i = 0; i < n; ++i) {
      const double run = at.simulation(i) + std::sqrt(at.simulation_variance(i)) * random.normal();
      simulation(i, k) = told(run);
      predicted(i, k) = told(run + std::sqrt(at.other_variance(i)) * random.normal());
      const double apart = at.discrepancy(i) + std::sqrt(at.discrepancy_variance(i)) * random.normal();
      discrepancy(i, k) = in_percent * (channel.logarithmic ? std::expm1(apart) : apart / model.units(c)(i));
    }
  }
  std::vector<CalibratedBand> bands;
  for (Index i = 0; i < n; ++i)
    bands.push_back({channel.cells[static_cast<std::size_t>(i)], told(channel.recorded(i)),
                     spread_of(simulation.row(i).transpose()), spread_of(predicted.row(i).transpose()),
                     spread_of(discrepancy.row(i).transpose())});
  return bands;
}

}  // namespace

Spread spread_of(const VectorXd& values) {
  std::vector<double> sorted(values.begin(), values.end());
  std::ranges::sort(sorted);
  const auto quantile = [&](double probability) {
    const double place = probability * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    return std::lerp(sorted[below], sorted[std::min(below + 1, sorted.size() - 1)],
                     place - static_cast<double>(below));
  };
  const double mean = values.mean();
  const double free = std::max<double>(1.0, static_cast<double>(values.size() - 1));
  return {mean, std::sqrt((values.array() - mean).square().sum() / free), quantile(0.05), quantile(0.5),
          quantile(0.95)};
}

MatrixXd rank_correlation_of(const MatrixXd& draws) {
  MatrixXd ranks(draws.rows(), draws.cols());
  for (Index j = 0; j < draws.cols(); ++j) ranks.col(j) = ranks_of(draws.col(j));
  ranks.rowwise() -= ranks.colwise().mean().eval();
  MatrixXd correlation = MatrixXd::Identity(draws.cols(), draws.cols());
  for (Index a = 0; a < draws.cols(); ++a)
    for (Index b = 0; b < a; ++b) {
      const double both = ranks.col(a).norm() * ranks.col(b).norm();
      correlation(a, b) = correlation(b, a) = both > 0.0 ? ranks.col(a).dot(ranks.col(b)) / both : 0.0;
    }
  return correlation;
}

Sample sample_posterior(const CalibrationModel& model, const CalibrateOptions& options) {
  Random random(options.sampler.seed, start_stream);
  MatrixXd starts(options.chains, model.unknowns());
  for (Index c = 0; c < starts.rows(); ++c) starts.row(c) = model.draw_prior(random).transpose();
  return sample([&](const VectorXd& scores) { return model.log_posterior(scores); }, starts, options.sampler);
}

Posterior calibrate(const CalibrationModel& model, const CalibrateOptions& options) {
  Posterior found;
  found.sample = sample_posterior(model, options);
  Random before(options.sampler.seed, prior_stream);
  MatrixXd prior(options.prior_draws, model.unknowns());
  for (Index i = 0; i < prior.rows(); ++i) prior.row(i) = model.draw_prior(before).transpose();
  found.prior_draws = told_values(model, prior);

  const Index all = found.sample.chains.front().rows() * options.chains;
  const MatrixXd everything = told_values(model, found.sample.thinned(all));
  found.draws = told_values(model, found.sample.thinned(options.kept));
  const auto inputs = static_cast<Index>(model.problem().inputs.size());
  found.correlation = rank_correlation_of(everything.leftCols(inputs));
  const std::vector<std::string> names = model.names();
  for (Index j = 0; j < model.unknowns(); ++j) {
    const auto at = static_cast<std::size_t>(j);
    found.unknowns.push_back({names[at], j < inputs ? model.problem().inputs[at].unit : "%", j < inputs,
                              spread_of(found.prior_draws.col(j)), spread_of(everything.col(j)),
                              found.sample.convergence[at]});
  }
  Random random(options.sampler.seed, depth_stream);
  const MatrixXd looked_at = found.sample.thinned(options.over_depth);
  for (std::size_t c = 0; c < model.problem().channels.size(); ++c)
    found.bands.push_back(bands_of(model, c, looked_at, random));
  return found;
}

}  // namespace cpt::diagnosis
