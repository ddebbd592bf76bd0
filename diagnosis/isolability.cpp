#include "diagnosis/isolability.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnosis/quadrature.hpp"

namespace cpt::diagnosis {
namespace {

// The whitened curves of mechanism j over several observations, end to end: components times scores.
class Imitator {
 public:
  Imitator(const std::vector<const Observation*>& observations, std::size_t j, const std::size_t i,
           const VectorXd& phi_i) {
    for (const Observation* observation : observations) {
      const Whitener whitener(observation->covariance);
      const CurveEmulator& emulator = observation->mechanisms[j];
      emulators_.push_back(&emulator);
      components_.push_back(whitener.whiten(emulator.components()));
      targets_.push_back(whitener.whiten(observation->mechanisms[i].mean(phi_i)));
    }
  }

  [[nodiscard]] VectorXd squares(const MatrixXd& points) const {
    VectorXd sum = VectorXd::Zero(points.rows());
    for (std::size_t o = 0; o < emulators_.size(); ++o)
      sum += ((components_[o] * emulators_[o]->scores(points)).colwise() - targets_[o])
                 .colwise()
                 .squaredNorm()
                 .transpose();
    return sum;
  }

 private:
  std::vector<const CurveEmulator*> emulators_;
  std::vector<MatrixXd> components_;
  std::vector<VectorXd> targets_;
};

}  // namespace

Imitation imitate(const std::vector<const Observation*>& observations, std::size_t i, const VectorXd& phi_i,
                  std::size_t j) {
  const Index d = observations.front()->mechanisms[j].dimensions();
  const Imitator imitator(observations, j, i, phi_i);
  constexpr int points[] = {60, 20, 10};
  const Quadrature grid = box_rule(VectorXd::Zero(d), VectorXd::Ones(d), points[d - 1]);
  VectorXd squares = imitator.squares(grid.nodes);

  Imitation best{std::numeric_limits<double>::infinity(), {}};
  for (int start = 0; start < 3; ++start) {  // several hollows may hold the least
    Index node = 0;
    double here = squares.minCoeff(&node);
    VectorXd phi = grid.nodes.row(node).transpose();
    for (Index k = 0; k < squares.size(); ++k)
      if ((grid.nodes.row(k).transpose() - phi).cwiseAbs().maxCoeff() < 0.2)
        squares(k) = std::numeric_limits<double>::infinity();
    for (double step = 0.5 / points[d - 1]; step > 1e-4;) {
      MatrixXd trials = phi.transpose().replicate(2 * d, 1);
      for (Index k = 0; k < d; ++k) {
        trials(2 * k, k) = std::min(1.0, phi(k) + step);
        trials(2 * k + 1, k) = std::max(0.0, phi(k) - step);
      }
      Index trial = 0;
      const double least = imitator.squares(trials).minCoeff(&trial);
      if (least < here) {
        here = least;
        phi = trials.row(trial).transpose();
      } else {
        step *= 0.5;
      }
    }
    if (std::sqrt(here) < best.distance) best = {std::sqrt(here), phi};
    if (!std::isfinite(squares.minCoeff())) break;
  }
  return best;
}

double strength(const std::vector<const Observation*>& observations, std::size_t i, const VectorXd& phi_i) {
  double squares = 0.0;
  for (const Observation* observation : observations)
    squares += Whitener(observation->covariance).whiten(observation->mechanisms[i].mean(phi_i)).squaredNorm();
  return std::sqrt(squares);
}

Isolability isolability(const Observation& observation, const std::vector<VectorXd>& phi) {
  const std::size_t k = observation.mechanisms.size();
  const auto n = static_cast<Index>(k);
  Isolability all{MatrixXd::Zero(n, n), VectorXd(n)};
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; j < k; ++j)
      if (i != j)
        all.between(static_cast<Index>(i), static_cast<Index>(j)) =
            imitate({&observation}, i, phi[i], j).distance;
    all.strength(static_cast<Index>(i)) = strength({&observation}, i, phi[i]);
  }
  return all;
}

std::vector<NextMeasurement> next_measurements(const Observation& present,
                                               const std::vector<Observation>& candidates,
                                               const std::vector<std::size_t>& set,
                                               const std::vector<VectorXd>& phi) {
  std::vector<NextMeasurement> ranked;
  for (const Observation& candidate : candidates) {
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t i : set)
      for (const std::size_t j : set)
        if (i != j) least = std::min(least, imitate({&present, &candidate}, i, phi[i], j).distance);
    ranked.push_back({candidate.name, least});
  }
  std::stable_sort(ranked.begin(), ranked.end(), [](const NextMeasurement& a, const NextMeasurement& b) {
    return a.least_distance > b.least_distance;
  });
  return ranked;
}

}  // namespace cpt::diagnosis
