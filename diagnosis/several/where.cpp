#include "diagnosis/several/where.hpp"

#include <boost/math/distributions/normal.hpp>

namespace cpt::diagnosis {
namespace {

// 1 where the effect is above the noise, -1 where it is below its negative, 0 elsewhere.
int side_of(double mean, double deviation, double noise, double probability) {
  const boost::math::normal effect(std::abs(mean), std::max(deviation, 1e-12));
  if (boost::math::cdf(boost::math::complement(effect, noise)) <= probability) return 0;
  return mean > 0.0 ? 1 : -1;
}

EffectInterval interval_of(const std::vector<Cell>& cells, Index top, Index bottom, const Band& effects,
                           const VectorXd& difference) {
  const Cell &first = cells[static_cast<std::size_t>(top)],
             &last = cells[static_cast<std::size_t>(bottom - 1)];
  EffectInterval made{first.sounding,
                      first.channel,
                      first.depth - 0.5 * first.height,
                      last.depth + 0.5 * last.height,
                      effects.mean.segment(top, bottom - top).mean(),
                      difference.segment(top, bottom - top).mean(),
                      {}};
  for (Index i = top; i < bottom; ++i) made.rows.push_back(i);
  return made;
}

}  // namespace

std::vector<EffectInterval> where_effects_are(const std::vector<Cell>& cells, const Band& effects,
                                              const VectorXd& noise, const VectorXd& difference,
                                              const IntervalRules& rules) {
  const auto n = static_cast<Index>(cells.size());
  const auto side = [&](Index i) {
    return side_of(effects.mean(i), effects.deviation(i), noise(i), rules.probability);
  };
  const auto same_curve = [&](Index i, Index j) {
    return j < n && cells[static_cast<std::size_t>(i)].same_curve(cells[static_cast<std::size_t>(j)]);
  };
  std::vector<EffectInterval> found;
  for (Index top = 0; top < n;) {
    const int here = side(top);
    Index bottom = top + 1;
    if (here != 0) {
      while (same_curve(top, bottom) &&
             (side(bottom) == here || (same_curve(top, bottom + 1) && side(bottom + 1) == here)))
        ++bottom;
      if (bottom - top >= rules.least_cells)
        found.push_back(interval_of(cells, top, bottom, effects, difference));
    }
    top = bottom;
  }
  return found;
}

}  // namespace cpt::diagnosis
