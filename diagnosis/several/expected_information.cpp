#include "diagnosis/several/expected_information.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "diagnosis/random.hpp"
#include "diagnosis/whitener.hpp"

namespace cpt::diagnosis {
namespace {

double entropy(const std::vector<WeighedSubset>& subsets) {
  double sum = 0.0;
  for (const WeighedSubset& one : subsets)
    if (one.probability > 0.0) sum -= one.probability * std::log(one.probability);
  return sum;
}

double members(const std::vector<WeighedSubset>& subsets, double credible) {
  double held = 0.0, count = 0.0;
  for (const WeighedSubset& one : subsets) {
    if (held >= credible) break;
    held += one.probability;
    count += 1.0;
  }
  return count;
}

// A subset and one of its places by their probabilities.
std::pair<const WeighedSubset*, const Place*> draw(const Explained& explained, Random& random) {
  double total = 0.0;
  for (const WeighedSubset& one : explained.subsets)
    for (const Place& place : one.places) total += one.probability * place.probability;
  double left = random.uniform() * total;
  std::pair<const WeighedSubset*, const Place*> last{};
  for (const WeighedSubset& one : explained.subsets)
    for (const Place& place : one.places) {
      last = {&one, &place};
      left -= one.probability * place.probability;
      if (left <= 0.0) return last;
    }
  return last;
}

// What the cells below may read, given those above.
VectorXd completed(const SubsetWeigher& both, const WeighedSubset& subset, const Place& place,
                   const VectorXd& above, Random& random) {
  MatrixXd C = both.metrics()[place.metric].covariance();
  VectorXd mean = VectorXd::Zero(C.rows());
  for (std::size_t k = 0; k < subset.subset.effects.size(); ++k) {
    const EffectNodes& nodes = both.fine()[subset.subset.effects[k]];
    const Index node = place.combination.node[k];
    const MatrixXd& spread = nodes.spreads[static_cast<std::size_t>(node)];
    mean += nodes.curves.col(node);
    C += spread * spread.transpose();
  }
  const Index m = above.size(), rest = C.rows() - m;
  const Whitener known(C.topLeftCorner(m, m));
  const MatrixXd gain = known.solve(C.topRightCorner(m, rest)).transpose();
  const Whitener unknown(C.bottomRightCorner(rest, rest) - gain * C.topRightCorner(m, rest));
  VectorXd all(C.rows());
  all << above,
      mean.tail(rest) + gain * (above - mean.head(m)) + VectorXd(unknown.colour(random.normals(rest)).col(0));
  return all;
}

}  // namespace

ExpectedInformation expected_information(const SubsetWeigher& both, const VectorXd& residual, int draws,
                                         std::uint64_t seed, double credible) {
  std::vector<Index> rows(static_cast<std::size_t>(residual.size()));
  std::iota(rows.begin(), rows.end(), Index{0});
  const SubsetWeigher present(both, rows);
  const Explained explained = present.explain(residual);
  const std::vector<WeighedSubset> now = present.glance(residual);
  ExpectedInformation told{entropy(now), 0.0, members(now, credible), 0.0, 0.0};
  for (int k = 0; k < draws; ++k) {
    Random random(seed, static_cast<std::uint64_t>(k));
    const auto [subset, place] = draw(explained, random);
    const std::vector<WeighedSubset> then = both.glance(completed(both, *subset, *place, residual, random));
    const double left = members(then, credible);
    told.after += entropy(then) / draws;
    told.members_after += left / draws;
    if (2.0 * left <= told.members_before) told.halved += 1.0 / draws;
  }
  return told;
}

}  // namespace cpt::diagnosis
