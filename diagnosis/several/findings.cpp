#include "diagnosis/several/findings.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "diagnosis/random.hpp"
#include "diagnosis/several/soil.hpp"
#include "diagnosis/several/soil_scaling.hpp"

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

// Known channels' noise; what is estimated has its floor alone yet.
MatrixXd known_noise(const std::vector<Cell>& cells, const VectorXd& simulated,
                     const std::vector<ChannelFacts>& channels) {
  std::vector<ChannelNoise> noises;
  for (const ChannelFacts& channel : channels)
    noises.push_back(channel.noise.value_or(ChannelNoise{0.0, channel.floor, 0.01}));
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

// One look at the recording from where the soil is thought to be.
struct Look {
  LocalSoil soil;
  MatrixXd parameters;  // of the scatter: the soil's slopes first
  std::unique_ptr<SubsetWeigher> weigher;
  VectorXd residual;
  Explained explained;
  Summary summary;
};

class Search {
 public:
  Search(const Problem& given, const std::vector<ChannelFacts>& channels, const SeveralOptions& options)
      : options_(options),
        channels_(channels),
        problem_(complete_cells(given, found_.rows)),
        surface_(problem_.baseline, problem_.parameters, problem_.joint),
        prior_(soil_prior(problem_.parameters, problem_.correlation)),
        factors_(factor_columns(problem_.cells, channels)) {
    for (const MechanismEffect& effect : problem_.mechanisms) emulators_.emplace_back(effect);
    for (std::size_t k = 0; k < emulators_.size(); ++k)
      scalings_.emplace_back(problem_.cells, problem_.mechanisms[k], emulators_[k]);
  }

  Findings find() {
    found_.cells = problem_.cells;
    found_.recorded = problem_.recorded;
    found_.baseline = problem_.baseline;
    learn_scatter();
    SoilBelief belief = before_recording(prior_);
    Look look = look_from(belief);
    alarm(look);
    for (int pass = 0; pass < options_.most_passes; ++pass) {
      const SoilBelief next = after(look.summary);
      const double moved = belief.mean.size() > 0 ? (next.mean - belief.mean).cwiseAbs().maxCoeff() : 0.0;
      if (moved < options_.settled) break;
      belief = next;
      look = look_from(belief);
    }
    answer(look);
    hold_out(look);
    return std::move(found_);
  }

 private:
  void learn_scatter() {
    const auto n = static_cast<Index>(problem_.cells.size());
    scatter_.numerics = 1e-8 * MatrixXd::Identity(n, n);
    if (problem_.repeats.cols() > 2)
      scatter_.numerics += problem_.numerical_shares * scatter_of_repeats(problem_.cells, problem_.repeats);
    const MatrixXd known = known_noise(problem_.cells, problem_.baseline, channels_);
    if (std::ranges::all_of(channels_, [](const ChannelFacts& channel) { return channel.noise.has_value(); }))
      scatter_.noises = {{known, 0.0}};
    else
      estimate(known);
    likely_ = scatter_.noises[scatter_.noises.size() / 2].covariance + scatter_.numerics;
    found_.deviation = likely_.diagonal().cwiseSqrt();
    // The surface's error belongs to the parameters: curves that it may be off by.
    off_ = beyond_scatter(surface_.left_out(), likely_, 3);
  }

  void estimate(const MatrixXd& known) {
    std::vector<std::vector<Index>> stretches;
    for (std::vector<Index>& stretch : stretches_of(problem_.cells, options_)) {
      const Cell& first = problem_.cells[static_cast<std::size_t>(stretch.front())];
      if (!channels_[static_cast<std::size_t>(first.channel)].noise) stretches.push_back(std::move(stretch));
    }
    found_.noise = estimate_noise(problem_.cells, problem_.recorded - problem_.baseline, scatter_.numerics,
                                  stretches, options_.high_pass);
    for (const Scatter::Noise& noise : found_.noise->noises)
      scatter_.noises.push_back(
          {known + on_channels(noise.covariance, problem_.cells, channels_), noise.log_prior});
  }

  Look look_from(const SoilBelief& belief) {
    Look look{local_soil(surface_, prior_, belief), {}, {}, {}, {}, {}};
    const LocalSoil& soil = look.soil;
    look.parameters.resize(off_.rows(),
                           soil.slopes.cols() + soil.remainder.cols() + off_.cols() + factors_.cols());
    look.parameters << soil.slopes, soil.remainder, off_, factors_;
    scatter_.parameters = look.parameters;
    std::vector<CurveEmulator> effects;
    for (const SoilScaling& scaling : scalings_)
      effects.push_back(scaling.at(soil.places - surface_.baseline_place()));
    look.weigher = std::make_unique<SubsetWeigher>(
        effects, likely_, metrics_of(problem_.cells, scatter_, options_.metrics), options_.subsets);
    look.residual = problem_.recorded - soil.mean;
    look.explained = look.weigher->explain(look.residual);
    look.summary =
        summarize(*look.weigher, look.explained, look.residual, look.parameters, soil.slopes.cols());
    return look;
  }

  // Scores z = L u from the normals u that are told.
  [[nodiscard]] SoilBelief after(const Summary& summary) const {
    const MatrixXd covariance = prior_.lower * summary.covariance * prior_.lower.transpose();
    return {prior_.lower * summary.normals, covariance.diagonal().cwiseMax(1e-4).cwiseSqrt()};
  }

  // By the first look, which is the same for curves with nothing missing.
  void alarm(const Look& first) {
    MatrixXd draws =
        draw_soil(surface_, prior_, likely_ + off_ * off_.transpose(), options_.null_draws, options_.seed)
            .colwise() -
        first.soil.mean;
    if (factors_.cols() > 0) {
      Random random(options_.seed, 1000003);
      for (Index k = 0; k < draws.cols(); ++k) draws.col(k) += factors_ * random.normals(factors_.cols());
    }
    found_.nothing = first.weigher->probability_of_nothing(first.residual);
    found_.alarm_level = alarm_level(*first.weigher, draws, options_.false_alarms);
  }

  void answer(const Look& look) {
    const WeighedSubset& best = look.explained.subsets.front();
    found_.null_mean = look.soil.mean;
    found_.check = check_subset(*look.weigher, best, look.residual);
    found_.naming =
        name_effects(look.explained, found_.nothing < found_.alarm_level, found_.check.p, options_.rules);
    found_.summary = look.summary;
    found_.best = summarize(*look.weigher, best, look.residual, look.parameters, look.soil.slopes.cols());
    found_.explained = look.explained;
  }

  void hold_out(const Look& look) {
    found_.blocks = held_out_blocks(problem_.cells, options_.held_out);
    const WeighedSubset& best = look.explained.subsets.front();
    if (found_.blocks.size() < 2 || best.subset.is_nothing()) return;
    const auto score = [&](const Subset& subset) {
      return held_out_scores(*look.weigher, subset, look.residual, found_.blocks);
    };
    const VectorXd own = score(best.subset);
    found_.over_nothing = score_gain(own, score({}));
    if (const WeighedSubset* wrong = best_without(look.explained, best.subset.effects); wrong != nullptr) {
      found_.wrong = wrong->subset;
      found_.over_wrong = score_gain(own, score(wrong->subset));
    }
  }

  const SeveralOptions& options_;
  const std::vector<ChannelFacts>& channels_;
  Findings found_;  // before the problem, which tells its rows
  Problem problem_;
  ResponseSurface surface_;
  SoilPrior prior_;
  MatrixXd factors_;
  std::vector<CurveEmulator> emulators_;
  std::vector<SoilScaling> scalings_;  // of the emulators
  Scatter scatter_;
  MatrixXd likely_, off_;
};

}  // namespace

Findings find_several(const Problem& problem, const std::vector<ChannelFacts>& channels,
                      const SeveralOptions& options) {
  return Search(problem, channels, options).find();
}

}  // namespace cpt::diagnosis
