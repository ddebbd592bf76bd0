#include "diagnosis/calibration/rank_check.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "diagnosis/calibration/in_parallel.hpp"

namespace cpt::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Eigen::VectorXi;

double place_of_rank(int rank, int draws) { return (rank + 0.5) / (draws + 1.0); }

// Ranks at most at each place.
VectorXi counts(const VectorXi& ranks, int draws, const VectorXd& at) {
  VectorXi found = VectorXi::Zero(at.size());
  for (const int rank : ranks)
    for (Index k = 0; k < at.size(); ++k) found(k) += place_of_rank(rank, draws) <= at(k) ? 1 : 0;
  return found;
}

// P(X <= count) and P(X >= count) of every count, as two columns of each place.
struct Tails {
  Eigen::MatrixXd below, above;  // counts x places
};
Tails tails(int cases, const VectorXd& at) {
  Tails found{{cases + 1, at.size()}, {cases + 1, at.size()}};
  for (Index k = 0; k < at.size(); ++k) {
    const boost::math::binomial_distribution<double> ranks(cases, at(k));
    for (int count = 0; count <= cases; ++count) {
      found.below(count, k) = cdf(ranks, count);
      found.above(count, k) = count == 0 ? 1.0 : cdf(complement(ranks, count - 1));
    }
  }
  return found;
}

struct RankedCase {
  VectorXi ranks;  // of each unknown
  VectorXd truth;
  bool converged;
};

RankedCase ranked_case(const CalibrationModel& model, const RankCase& one, int draws,
                       CalibrateOptions options, std::uint64_t seed, std::uint64_t number) {
  Random random(seed, number);
  VectorXd truth = model.values(model.draw_prior(random));
  truth.head(one.inputs.size()) = one.inputs;
  std::vector<VectorXd> recorded;
  for (std::size_t c = 0; c < one.curves.size(); ++c)
    recorded.push_back(model.draw_recording(c, one.curves[c], truth, random));
  const CalibrationModel of_recording = model.with_recordings(recorded);
  options.sampler.seed = seed + number;
  const Sample found = sample_posterior(of_recording, options);
  const Eigen::MatrixXd scores = found.thinned(draws);
  Eigen::MatrixXd values(scores.rows(), scores.cols());
  for (Index k = 0; k < scores.rows(); ++k)
    values.row(k) = model.values(scores.row(k).transpose()).transpose();
  RankedCase ranked{VectorXi(truth.size()), truth, found.converged};
  for (Index j = 0; j < truth.size(); ++j) ranked.ranks(j) = rank_of(truth(j), values.col(j), random);
  return ranked;
}

}  // namespace

int rank_of(double truth, const VectorXd& draws, Random& random) {
  int below = 0;
  Index equal = 0;
  for (const double draw : draws) {
    below += draw < truth ? 1 : 0;
    equal += draw == truth ? 1 : 0;
  }
  return below + (equal > 0 ? static_cast<int>(random.below(equal + 1)) : 0);
}

RankCheck rank_check(const CalibrationModel& model, const std::vector<RankCase>& cases,
                     const CalibrateOptions& options, std::uint64_t seed, int threads,
                     const std::function<void(Index)>& told) {
  const auto count = static_cast<Index>(cases.size());
  RankCheck check;
  check.unknowns = model.names();
  check.ranks.resize(count, model.unknowns());
  check.truths.resize(count, model.unknowns());
  check.converged.assign(cases.size(), false);
  for (const RankCase& one : cases) check.cases.push_back(one.name);

  std::mutex mutex;  // of what the threads write
  Index done = 0;
  in_parallel(count, threads, [&](Index i) {
    const RankedCase ranked = ranked_case(model, cases[static_cast<std::size_t>(i)], check.draws, options,
                                          seed, static_cast<std::uint64_t>(i));
    const std::scoped_lock lock(mutex);
    check.ranks.row(i) = ranked.ranks.transpose();
    check.truths.row(i) = ranked.truth.transpose();
    check.converged[static_cast<std::size_t>(i)] = ranked.converged;
    ++done;
    if (told) told(done);
  });
  return check;
}

double uniformity(const VectorXi& ranks, int draws, int bins) {
  if ((draws + 1) % bins != 0) throw std::invalid_argument("bins of unequal width");
  VectorXd found = VectorXd::Zero(bins);
  for (const int rank : ranks) found(rank * bins / (draws + 1)) += 1.0;
  const double expected = static_cast<double>(ranks.size()) / bins;
  const double square = (found.array() - expected).square().sum() / expected;
  return cdf(complement(boost::math::chi_squared_distribution<double>(bins - 1.0), square));
}

EcdfDifference simultaneous_band(int cases, int draws, double probability, std::uint64_t seed) {
  constexpr int repetitions = 4000;
  const Index places = std::min(cases, draws);
  EcdfDifference band;
  band.at = VectorXd::LinSpaced(places, 1.0 / static_cast<double>(places + 1),
                                static_cast<double>(places) / static_cast<double>(places + 1));
  // Shares of a rank's possible values that are at most there: ranks are whole numbers.
  VectorXd share(places);
  for (Index k = 0; k < places; ++k) {
    int below = 0;
    for (int rank = 0; rank <= draws; ++rank) below += place_of_rank(rank, draws) <= band.at(k) ? 1 : 0;
    share(k) = below / (draws + 1.0);
  }
  const Tails tail = tails(cases, share);
  Random random(seed, 0);
  std::vector<double> levels;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    VectorXi ranks(cases);
    for (int& rank : ranks) rank = static_cast<int>(random.below(draws + 1));
    const VectorXi here = counts(ranks, draws, band.at);
    double least = 1.0;
    for (Index k = 0; k < places; ++k)
      least = std::min(least, 2.0 * std::min(tail.below(here(k), k), tail.above(here(k), k)));
    levels.push_back(least);
  }
  const auto cut = levels.begin() + static_cast<std::ptrdiff_t>((1.0 - probability) * repetitions);
  std::nth_element(levels.begin(), cut, levels.end());
  const double level = *cut;
  band.lower.resize(places);
  band.upper.resize(places);
  for (Index k = 0; k < places; ++k) {
    int least = 0, most = cases;
    while (least < cases && 2.0 * tail.below(least, k) < level) ++least;
    while (most > 0 && 2.0 * tail.above(most, k) < level) --most;
    band.lower(k) = static_cast<double>(least) / cases - band.at(k);
    band.upper(k) = static_cast<double>(most) / cases - band.at(k);
  }
  return band;
}

VectorXd ecdf_difference(const VectorXi& ranks, int draws, const VectorXd& at) {
  return counts(ranks, draws, at).cast<double>() / static_cast<double>(ranks.size()) - at;
}

bool stays_within(const VectorXd& difference, const EcdfDifference& band) {
  constexpr double rounding = 1e-12;
  return (difference.array() >= band.lower.array() - rounding).all() &&
         (difference.array() <= band.upper.array() + rounding).all();
}

}  // namespace cpt::diagnosis
