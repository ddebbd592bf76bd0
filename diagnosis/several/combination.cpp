#include "diagnosis/several/combination.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "diagnosis/quadrature.hpp"

namespace cpt::diagnosis {
namespace {

constexpr int most_columns = 32;
using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_columns, most_columns>;
using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_columns, 1>;

}  // namespace

Combinations::Combinations(const Metric& metric, const std::vector<EffectNodes>& effects)
    : whitening_(metric.whitening) {
  const Index n = whitening_.rows();
  Index columns = 0;
  for (const EffectNodes& effect : effects) {
    std::vector<Block>& blocks = blocks_.emplace_back();
    for (const MatrixXd& spread : effect.spreads) {
      blocks.push_back({columns, spread.cols()});
      columns += 1 + spread.cols();
    }
    log_weights_.emplace_back(effect.weights.array().log());
  }
  MatrixXd all(n, columns);
  for (std::size_t k = 0; k < effects.size(); ++k)
    for (Index g = 0; g < effects[k].count(); ++g) {
      const Block& block = blocks_[k][static_cast<std::size_t>(g)];
      all.col(block.first) = effects[k].curves.col(g);
      all.middleCols(block.first + 1, block.columns) = effects[k].spreads[static_cast<std::size_t>(g)];
    }
  whitened_ = whitening_ * all;
  products_ = whitened_.transpose() * whitened_;
  constant_ = -0.5 * (static_cast<double>(n) * std::log(2.0 * std::numbers::pi) + metric.log_determinant);
}

Target Combinations::target(const VectorXd& residual) const {
  const VectorXd whitened = whitening_ * residual;
  return {whitened_.transpose() * whitened, whitened.squaredNorm()};
}

// With e = r - sum of curves and U all spreads: e'(1 + U U')^-1 e = |e|^2 - v'A^-1 v, A = 1 + U'U, v = U'e.
Combinations::Weighed Combinations::weigh(const Target& target, std::span<const std::size_t> effects,
                                          const Combination& at) const {
  std::array<Block, most_effects> block{};
  Index columns = 0;
  for (std::size_t k = 0; k < effects.size(); ++k) {
    block[k] = blocks_[effects[k]][static_cast<std::size_t>(at.node[k])];
    columns += block[k].columns;
  }
  double square = target.square;
  SmallVector v(columns);
  Small A(columns, columns);
  Index row = 0;
  for (std::size_t k = 0; k < effects.size(); ++k) {
    const Block& a = block[k];
    square -= 2.0 * target.onto(a.first);
    v.segment(row, a.columns) = target.onto.segment(a.first + 1, a.columns);
    Index column = 0;
    for (std::size_t l = 0; l < effects.size(); ++l) {
      const Block& b = block[l];
      square += products_(a.first, b.first);
      v.segment(row, a.columns) -= products_.col(b.first).segment(a.first + 1, a.columns);
      if (l <= k)
        A.block(row, column, a.columns, b.columns) =
            products_.block(a.first + 1, b.first + 1, a.columns, b.columns);
      column += b.columns;
    }
    row += a.columns;
  }
  A.diagonal().array() += 1.0;
  const Eigen::LLT<Small> factor(A);  // reads the lower triangle
  const SmallVector half = factor.matrixL().solve(v);
  double log_determinant = 0.0;
  for (Index i = 0; i < columns; ++i) log_determinant += 2.0 * std::log(factor.matrixLLT()(i, i));
  return {square - half.squaredNorm(), log_determinant};
}

double Combinations::log_evidence(const Target& target, std::span<const std::size_t> effects,
                                  std::vector<Combination>* kept, double within) const {
  Combination at;
  if (effects.empty()) {
    at.log_weight = constant_ - 0.5 * target.square;
    if (kept != nullptr) kept->assign(1, at);
    return at.log_weight;
  }
  std::vector<Combination> all;
  for (bool more = true; more;) {
    at.log_weight = log_density(target, effects, at);
    for (std::size_t k = 0; k < effects.size(); ++k) at.log_weight += log_weights_[effects[k]](at.node[k]);
    all.push_back(at);
    more = false;
    for (std::size_t k = 0; k < effects.size() && !more; ++k) {  // the next combination, as an odometer
      more = ++at.node[k] < log_weights_[effects[k]].size();
      if (!more) at.node[k] = 0;
    }
  }
  VectorXd logs(static_cast<Index>(all.size()));
  std::ranges::transform(all, logs.begin(), &Combination::log_weight);
  if (kept != nullptr) {
    const double floor = logs.maxCoeff() - within;
    std::erase_if(all, [floor](const Combination& one) { return one.log_weight < floor; });
    *kept = std::move(all);
  }
  return log_sum_exp(logs);
}

}  // namespace cpt::diagnosis
