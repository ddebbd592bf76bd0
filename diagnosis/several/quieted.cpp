#include "diagnosis/several/quieted.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/median.hpp"

namespace cpt::diagnosis {

Quieted::Quieted(const std::vector<Cell>& cells, const VectorXd& baseline, const MatrixXd& repeats)
    : mean_(baseline), control_(VectorXd::Zero(baseline.size())) {
  const auto n = static_cast<Index>(cells.size());
  for (Index top = 0, bottom = 0; top < n; top = bottom) {
    const auto cell = [&](Index i) { return cells[static_cast<std::size_t>(i)]; };
    while (bottom < n && cell(bottom).same_curve(cell(top))) ++bottom;
    curves_.emplace_back(top, bottom);
  }
  if (repeats.cols() < 3) return;
  const auto runs = static_cast<double>(repeats.cols() + 1);
  mean_ = (baseline + repeats.rowwise().sum()) / runs;
  control_ = baseline - mean_;
  share_ = 1.0 / runs;
}

// Over two cells to either side: neighbours scatter together.
VectorXd Quieted::differences(const VectorXd& curve, Index top, Index bottom) const {
  constexpr Index reach = 2;
  const Index count = std::max<Index>(bottom - top - 2 * reach, 0);
  return curve.segment(top + reach, count) -
         0.5 * (curve.segment(top, count) + curve.segment(top + 2 * reach, count));
}

VectorXd Quieted::operator()(const VectorXd& run) const {
  constexpr double most = 5.0;  // times the usual difference: a lens, a layer, not scatter
  VectorXd quiet = run;
  if (share_ == 1.0) return quiet;
  for (const auto& [top, bottom] : curves_) {
    if (bottom - top < 5) continue;
    const VectorXd own = differences(run - mean_, top, bottom), scatter = differences(control_, top, bottom);
    std::vector<double> sizes;
    for (const double difference : own)
      if (std::isfinite(difference)) sizes.push_back(std::abs(difference));
    if (sizes.empty()) continue;
    const double usual = median(sizes);
    double product = 0.0, square = 0.0;
    for (Index i = 0; i < own.size(); ++i) {
      if (!std::isfinite(own(i)) || !std::isfinite(scatter(i)) || std::abs(own(i)) > most * usual) continue;
      product += own(i) * scatter(i);
      square += scatter(i) * scatter(i);
    }
    if (square > 0.0)
      quiet.segment(top, bottom - top) -=
          std::clamp(product / square, 0.0, 1.0) * control_.segment(top, bottom - top);
  }
  return quiet;
}

}  // namespace cpt::diagnosis
