#include "diagnosis/several/combination.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace cpt::diagnosis {
namespace {

constexpr int most_columns = 32;
using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_columns, most_columns>;
using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_columns, 1>;

}  // namespace

Combinations::Combinations(const Metric& metric, const std::vector<EffectNodes>& effects)
    : nodes_(&effects), whitening_(metric.whitening) {
  for (const EffectNodes& effect : effects) {
    Effect& own = own_.emplace_back();
    Index columns = 0;
    for (const MatrixXd& spread : effect.spreads) {
      own.blocks.push_back({columns, spread.cols()});
      columns += 1 + spread.cols();
    }
    own.log_weights = effect.weights.array().log();
    own.products.resize(own_.size());
  }
  constant_ = -0.5 * (static_cast<double>(whitening_.rows()) * std::log(2.0 * std::numbers::pi) +
                      metric.log_determinant);
}

void Combinations::prepare(std::span<const std::size_t> effects) {
  for (const std::size_t k : effects) {
    Effect& own = own_[k];
    if (own.whitened.size() > 0) continue;
    const EffectNodes& nodes = (*nodes_)[k];
    MatrixXd all(whitening_.rows(), own.blocks.back().first + 1 + own.blocks.back().columns);
    for (Index g = 0; g < nodes.count(); ++g) {
      const Block& block = own.blocks[static_cast<std::size_t>(g)];
      all.col(block.first) = nodes.curves.col(g);
      all.middleCols(block.first + 1, block.columns) = nodes.spreads[static_cast<std::size_t>(g)];
    }
    own.whitened = whitening_ * all;
  }
  for (const std::size_t k : effects)
    for (const std::size_t l : effects)
      if (l <= k && own_[k].products[l].size() == 0)
        own_[k].products[l] = own_[k].whitened.transpose() * own_[l].whitened;
}

Target Combinations::target(const VectorXd& residual) const {
  const VectorXd whitened = whitening_ * residual;
  Target target{{}, whitened.squaredNorm()};
  for (const Effect& own : own_)
    target.onto.push_back(own.whitened.size() > 0 ? VectorXd(own.whitened.transpose() * whitened)
                                                  : VectorXd());
  return target;
}

// With e = r - sum of curves and U all spreads: e'(1 + U U')^-1 e = |e|^2 - v'A^-1 v, A = 1 + U'U, v = U'e.
Combinations::Weighed Combinations::weigh(const Target& target, std::span<const std::size_t> effects,
                                          const Combination& at) const {
  std::array<Block, most_effects> block{};
  Index columns = 0;
  for (std::size_t k = 0; k < effects.size(); ++k) {
    block[k] = own_[effects[k]].blocks[static_cast<std::size_t>(at.node[k])];
    columns += block[k].columns;
  }
  double square = target.square;
  SmallVector v = SmallVector::Zero(columns);
  Small A(columns, columns);
  Index row = 0;
  for (std::size_t k = 0; k < effects.size(); ++k) {
    const Block& a = block[k];
    const VectorXd& onto = target.onto[effects[k]];
    square -= 2.0 * onto(a.first);
    v.segment(row, a.columns) += onto.segment(a.first + 1, a.columns);
    Index column = 0;
    for (std::size_t l = 0; l <= k; ++l) {
      const Block& b = block[l];
      const MatrixXd& product = products(effects[k], effects[l]);
      square += (l < k ? 2.0 : 1.0) * product(a.first, b.first);
      v.segment(row, a.columns) -= product.col(b.first).segment(a.first + 1, a.columns);
      if (l < k)
        v.segment(column, b.columns) -= product.row(a.first).segment(b.first + 1, b.columns).transpose();
      A.block(row, column, a.columns, b.columns) =
          product.block(a.first + 1, b.first + 1, a.columns, b.columns);
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
  // Summed as they come, relative to the greatest so far.
  double greatest = -std::numeric_limits<double>::infinity(), sum = 0.0;
  if (kept != nullptr) kept->clear();
  for (bool more = true; more;) {
    at.log_weight = log_density(target, effects, at);
    for (std::size_t k = 0; k < effects.size(); ++k)
      at.log_weight += own_[effects[k]].log_weights(at.node[k]);
    if (at.log_weight > greatest) {
      sum *= std::exp(greatest - at.log_weight);
      greatest = at.log_weight;
    }
    sum += std::exp(at.log_weight - greatest);
    if (kept != nullptr && at.log_weight > greatest - within) kept->push_back(at);
    more = false;
    for (std::size_t k = 0; k < effects.size() && !more; ++k) {  // the next combination, as an odometer
      more = ++at.node[k] < own_[effects[k]].log_weights.size();
      if (!more) at.node[k] = 0;
    }
  }
  if (kept != nullptr)
    std::erase_if(*kept, [&](const Combination& one) { return one.log_weight < greatest - within; });
  return greatest + std::log(sum);
}

}  // namespace cpt::diagnosis
