#include "diagnosis/held_out.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "diagnosis/random.hpp"

namespace cpt::diagnosis {
namespace {

std::vector<Index> others(const std::vector<Index>& block, Index n) {
  std::vector<Index> rest;
  for (Index i = 0; i < n; ++i)
    if (!std::binary_search(block.begin(), block.end(), i)) rest.push_back(i);
  return rest;
}

double log_normal_density(double y, double mean, double variance) {
  return -0.5 * (std::log(2.0 * std::numbers::pi * variance) + (y - mean) * (y - mean) / variance);
}

// With no emulator, of the null.
Prediction predict(const NullModel& null, const CurveEmulator* emulator, const VectorXd& recorded,
                   const std::vector<std::vector<Index>>& blocks, const GridOptions& options) {
  if (blocks.size() < 2) throw std::invalid_argument("nothing is left beside the block held out");
  const Index n = recorded.size();
  const VectorXd residual = recorded - null.mean;
  const auto evidence = [&](const Whitener& M, const std::vector<Index>& rows) {
    return mechanism_evidence(MechanismLikelihood(emulator->rows(rows), M), residual(rows), options);
  };
  const Whitener whole(null.covariance);
  const double log_all = emulator ? evidence(whole, others({}, n)).log_evidence : whole.log_density(residual);

  Prediction prediction{VectorXd(n), VectorXd(n), VectorXd(static_cast<Index>(blocks.size())), 0.0};
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const std::vector<Index>& block = blocks[k];
    const std::vector<Index> rest = others(block, n);
    const Whitener seen(null.covariance(rest, rest));
    MatrixXd covariance = null.covariance;
    MatrixXd delta = MatrixXd::Zero(n, 1);
    VectorXd weight = VectorXd::Ones(1);
    double log_seen = 0.0;
    if (emulator) {
      const MechanismEvidence posterior = evidence(seen, rest);  // knows nothing of the block
      log_seen = posterior.log_evidence;
      covariance += emulator->covariance(posterior.mode);
      delta = emulator->components() * emulator->scores(posterior.nodes);
      weight = posterior.probability;
    } else {
      log_seen = seen.log_density(residual(rest));
    }
    prediction.log_score(static_cast<Index>(k)) = log_all - log_seen;

    // Conditional normal at each node, then their mixture's first two moments.
    const MatrixXd across = covariance(rest, block);
    const MatrixXd gain = Whitener(covariance(rest, rest)).solve(across).transpose();
    const MatrixXd left = MatrixXd((-delta).colwise() + residual)(rest, Eigen::all);
    const MatrixXd means = MatrixXd(delta(block, Eigen::all)) + gain * left;
    const VectorXd mean = means * weight;
    const VectorXd between = (means.colwise() - mean).cwiseAbs2() * weight;
    const VectorXd within =
        MatrixXd(covariance(block, block)).diagonal() - gain.cwiseProduct(across.transpose()).rowwise().sum();
    prediction.mean(block) = VectorXd(null.mean(block)) + mean;
    prediction.variance(block) = within + between;
  }
  prediction.rmse = std::sqrt((recorded - prediction.mean).squaredNorm() / static_cast<double>(n));
  return prediction;
}

}  // namespace

std::vector<std::vector<Index>> depth_blocks(const std::vector<Cell>& cells, double length) {
  std::vector<std::vector<Index>> blocks;
  for (const std::vector<Index>& sounding : sounding_blocks(cells)) {
    const auto cell = [&](std::size_t i) { return cells[static_cast<std::size_t>(sounding[i])]; };
    const double extent = cell(sounding.size() - 1).depth - cell(0).depth + cell(0).height;
    const auto count = static_cast<std::size_t>(std::max(1.0, std::floor(extent / length + 1e-9)));
    for (std::size_t b = 0; b < count; ++b)
      blocks.emplace_back(sounding.begin() + static_cast<std::ptrdiff_t>(b * sounding.size() / count),
                          sounding.begin() + static_cast<std::ptrdiff_t>((b + 1) * sounding.size() / count));
  }
  return blocks;
}

std::vector<std::vector<Index>> sounding_blocks(const std::vector<Cell>& cells) {
  std::vector<std::vector<Index>> blocks;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i == 0 || cells[i].sounding != cells[i - 1].sounding) blocks.emplace_back();
    blocks.back().push_back(static_cast<Index>(i));
  }
  return blocks;
}

Prediction predict_null(const NullModel& null, const VectorXd& recorded,
                        const std::vector<std::vector<Index>>& blocks) {
  return predict(null, nullptr, recorded, blocks, {});
}

Prediction predict_mechanism(const NullModel& null, const CurveEmulator& emulator, const VectorXd& recorded,
                             const std::vector<std::vector<Index>>& blocks, const GridOptions& options) {
  return predict(null, &emulator, recorded, blocks, options);
}

HeldOutGain held_out_gain(const VectorXd& recorded, const Prediction& null, const Prediction& mechanism,
                          int block_cells, std::uint64_t seed, int resamples) {
  const Index n = recorded.size();
  VectorXd gain(n);
  for (Index i = 0; i < n; ++i)
    gain(i) = log_normal_density(recorded(i), mechanism.mean(i), mechanism.variance(i)) -
              log_normal_density(recorded(i), null.mean(i), null.variance(i));
  const Index block = std::clamp<Index>(block_cells, 1, n);
  VectorXd means(resamples);
  for (int k = 0; k < resamples; ++k) {
    Random random(seed, static_cast<std::uint64_t>(k));
    double sum = 0.0;
    for (Index filled = 0; filled < n;) {
      // In a circle, so that the cells at both ends count as often as the others.
      const Index first = random.below(n), length = std::min(block, n - filled);
      for (Index i = 0; i < length; ++i) sum += gain((first + i) % n);
      filled += length;
    }
    means(k) = sum / static_cast<double>(n);
  }
  std::sort(means.begin(), means.end());
  const auto at = [&](double share) { return means(static_cast<Index>(share * (resamples - 1))); };
  return {null.rmse,   mechanism.rmse, mechanism.log_score.sum() - null.log_score.sum(),
          gain.mean(), at(0.05),       at(0.95)};
}

}  // namespace cpt::diagnosis
