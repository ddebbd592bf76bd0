#include "diagnosis/several/findings.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/random.hpp"

namespace cpt::diagnosis {
namespace {

// Parts of one curve within one soil.
std::vector<std::vector<Index>> stretches_of(const std::vector<Cell>& cells, const SeveralOptions& options) {
  std::vector<std::vector<Index>> made;
  const auto near = [&](const Cell& cell) {
    return std::ranges::any_of(options.soil_boundaries,
                               [&](double z) { return std::abs(cell.depth - z) < options.away; });
  };
  bool open = false;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (near(cells[i])) {
      open = false;
      continue;
    }
    if (!open || !cells[i].same_curve(cells[i - 1])) made.emplace_back();
    open = true;
    made.back().push_back(static_cast<Index>(i));
  }
  return made;
}

// Depths of one sounding, all its channels together: what one channel tells of a depth, another knows.
std::vector<std::vector<Index>> held_out_blocks(const std::vector<Cell>& cells, double length) {
  std::vector<std::vector<Index>> blocks;
  for (const std::vector<Index>& sounding : sounding_blocks(cells)) {
    const auto depth = [&](Index i) { return cells[static_cast<std::size_t>(i)].depth; };
    const auto [first, last] = std::ranges::minmax(sounding, {}, depth);
    const double top = depth(first) - 0.5 * cells.front().height;
    const double extent = depth(last) - depth(first) + cells.front().height;
    const double count = std::max(1.0, std::floor(extent / length + 1e-9));
    std::vector<std::vector<Index>> own(static_cast<std::size_t>(count));
    for (const Index i : sounding)
      own[static_cast<std::size_t>(std::min(count - 1.0, std::floor((depth(i) - top) / extent * count)))]
          .push_back(i);
    std::erase_if(own, [](const auto& block) { return block.empty(); });
    blocks.insert(blocks.end(), own.begin(), own.end());
  }
  return blocks;
}

// A level of its own for each curve of a channel that has a factor.
MatrixXd factor_columns(const std::vector<Cell>& cells, const std::vector<ChannelFacts>& channels) {
  std::vector<VectorXd> columns;
  const auto n = static_cast<Index>(cells.size());
  for (Index top = 0, bottom = 0; top < n; top = bottom) {
    const auto cell = [&](Index i) { return cells[static_cast<std::size_t>(i)]; };
    while (bottom < n && cell(bottom).same_curve(cell(top))) ++bottom;
    const double factor = channels[static_cast<std::size_t>(cell(top).channel)].factor;
    if (!(factor > 0.0)) continue;
    VectorXd column = VectorXd::Zero(n);
    column.segment(top, bottom - top).setConstant(factor);
    columns.push_back(std::move(column));
  }
  MatrixXd made(n, static_cast<Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k) made.col(static_cast<Index>(k)) = columns[k];
  return made;
}

// Known channels' noise; what is estimated has none yet.
MatrixXd known_noise(const std::vector<Cell>& cells, const VectorXd& simulated,
                     const std::vector<ChannelFacts>& channels) {
  std::vector<ChannelNoise> noises;
  for (const ChannelFacts& channel : channels)
    noises.push_back(channel.noise.value_or(ChannelNoise{0.0, 0.0, 0.01}));
  return measurement_covariance(cells, simulated, noises);
}

MatrixXd on_channels(const MatrixXd& covariance, const std::vector<Cell>& cells,
                     const std::vector<ChannelFacts>& channels) {
  MatrixXd kept = covariance;
  for (Index i = 0; i < kept.rows(); ++i)
    if (channels[static_cast<std::size_t>(cells[static_cast<std::size_t>(i)].channel)].noise) {
      kept.row(i).setZero();
      kept.col(i).setZero();
    }
  return kept;
}

}  // namespace

Findings find_several(const Problem& given, const std::vector<ChannelFacts>& channels,
                      const SeveralOptions& options) {
  Findings found;
  const Problem problem = complete_cells(given, found.rows);
  found.cells = problem.cells;
  found.recorded = problem.recorded;
  found.baseline = problem.baseline;
  const auto n = static_cast<Index>(found.cells.size());

  // Scatter.
  const ResponseSurface surface(problem.baseline, problem.parameters, problem.joint);
  Scatter scatter;
  scatter.numerics = 1e-8 * MatrixXd::Identity(n, n);
  if (problem.repeats.cols() > 2)
    scatter.numerics += problem.numerical_shares * scatter_of_repeats(found.cells, problem.repeats);
  const MatrixXd known = known_noise(found.cells, problem.baseline, channels);
  if (std::ranges::all_of(channels, [](const ChannelFacts& channel) { return channel.noise.has_value(); })) {
    scatter.noises = {{known, 0.0}};
  } else {
    std::vector<std::vector<Index>> stretches;
    for (std::vector<Index>& stretch : stretches_of(found.cells, options))
      if (!channels[static_cast<std::size_t>(found.cells[static_cast<std::size_t>(stretch.front())].channel)]
               .noise)
        stretches.push_back(std::move(stretch));
    found.noise = estimate_noise(found.cells, problem.recorded - problem.baseline, scatter.numerics,
                                 stretches, options.high_pass);
    for (const Scatter::Noise& noise : found.noise->noises)
      scatter.noises.push_back(
          {known + on_channels(noise.covariance, found.cells, channels), noise.log_prior});
  }
  const MatrixXd likely = scatter.noises[scatter.noises.size() / 2].covariance + scatter.numerics;
  // The surface's error belongs to the parameters: curves that it may be off by.
  const MatrixXd soil = surface.prior_factors(), off = beyond_scatter(surface.left_out(), likely, 3);
  const MatrixXd factors = factor_columns(found.cells, channels);
  scatter.parameters.resize(n, soil.cols() + off.cols() + factors.cols());
  scatter.parameters << soil, off, factors;
  found.deviation = likely.diagonal().cwiseSqrt();

  // Subsets.
  std::vector<CurveEmulator> emulators;
  for (const MechanismEffect& effect : problem.mechanisms) emulators.emplace_back(effect);
  const SubsetWeigher weigher(emulators, likely, metrics_of(found.cells, scatter, options.metrics),
                              options.subsets);
  found.null_mean = surface.prior_mean();
  const VectorXd residual = problem.recorded - found.null_mean;
  found.explained = weigher.explain(residual);
  const WeighedSubset& best = found.explained.subsets.front();

  // Alarm, gate, names.
  NullModel null = null_model(surface, likely + off * off.transpose());
  MatrixXd draws = draw_null(null, options.null_draws, options.seed);
  if (factors.cols() > 0) {
    Random random(options.seed, 1000003);
    for (Index k = 0; k < draws.cols(); ++k) draws.col(k) += factors * random.normals(factors.cols());
  }
  found.nothing = weigher.probability_of_nothing(residual);
  found.alarm_level = alarm_level(weigher, draws, options.false_alarms);
  found.check = check_subset(weigher, best, residual);
  found.naming =
      name_effects(found.explained, found.nothing < found.alarm_level, found.check.p, options.rules);

  // Curves.
  found.summary = summarize(weigher, found.explained, residual, scatter.parameters);
  found.best = summarize(weigher, best, residual, scatter.parameters);

  // Depths that were not seen.
  found.blocks = held_out_blocks(found.cells, options.held_out);
  if (found.blocks.size() > 1 && !best.subset.is_nothing()) {
    const VectorXd scores = held_out_scores(weigher, best.subset, residual, found.blocks);
    found.over_nothing = score_gain(scores, held_out_scores(weigher, {}, residual, found.blocks));
    if (const WeighedSubset* wrong = best_without(found.explained, best.subset.effects); wrong != nullptr) {
      found.wrong = wrong->subset;
      found.over_wrong = score_gain(scores, held_out_scores(weigher, wrong->subset, residual, found.blocks));
    }
  }
  return found;
}

}  // namespace cpt::diagnosis
