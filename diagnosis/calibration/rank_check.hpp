// Simulation-based calibration (Talts, Betancourt, Simpson, Vehtari & Gelman 2018, arXiv:1804.06788): truths
// are drawn from the prior, recordings from the truths; where posterior and sampler are right, the rank of a
// truth among draws of its posterior is uniform.
#pragma once

#include <Eigen/Dense>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "diagnosis/calibration/calibrate.hpp"
#include "diagnosis/random.hpp"

namespace cpt::diagnosis {

/// Draws below the truth; equal ones count by chance.
[[nodiscard]] int rank_of(double truth, const Eigen::VectorXd& draws, Random& random);

/// Pearson's chi-square of `ranks`, whole numbers from 0 to `draws`, over `bins` bins of equal width: the
/// probability of a value at least as large where they are uniform. `draws` + 1 is a multiple of `bins`.
[[nodiscard]] double uniformity(const Eigen::VectorXi& ranks, int draws, int bins);

/// Of the empirical distribution function of the ranks, (rank + 0.5) / (draws + 1), less the uniform one.
struct EcdfDifference {
  Eigen::VectorXd at;            ///< in (0, 1]
  Eigen::VectorXd lower, upper;  ///< band that holds all of it with the given probability
};
/// Simultaneous band for the ECDFs of `cases` uniform ranks (Saeilynoja, Buerkner & Vehtari 2022, Statistics
/// and Computing 32, 32, algorithm 2: pointwise binomial intervals, their level found by simulation).
[[nodiscard]] EcdfDifference simultaneous_band(int cases, int draws, double probability, std::uint64_t seed);
/// At the same places.
[[nodiscard]] Eigen::VectorXd ecdf_difference(const Eigen::VectorXi& ranks, int draws,
                                              const Eigen::VectorXd& at);

struct RankCheck {
  std::vector<std::string> unknowns;
  std::vector<std::string> cases;  ///< what each recording is
  int draws = 99;
  Eigen::MatrixXi ranks;        ///< cases x unknowns
  Eigen::MatrixXd truths;       ///< the same
  std::vector<bool> converged;  ///< of each case
};

/// A truth that is known, and what its simulation is.
struct RankCase {
  std::string name;
  Eigen::VectorXd inputs;               ///< in study units
  std::vector<Eigen::VectorXd> curves;  ///< of each channel of the model, on its scale at its cells
};

/// Each curve becomes a recording, with a discrepancy and noise of deviations drawn from their priors, and
/// the truth is ranked among 99 draws of the posterior. On so many threads (0: one a core); the answer is the
/// same with any number. `told` is called after each case, by one thread at a time, with how many are done.
[[nodiscard]] RankCheck rank_check(const CalibrationModel& model, const std::vector<RankCase>& cases,
                                   const CalibrateOptions& options, std::uint64_t seed, int threads = 1,
                                   const std::function<void(Eigen::Index)>& told = {});

inline constexpr int rank_bins = 10;

/// Whether the ECDF of an unknown stays within the band.
[[nodiscard]] bool stays_within(const Eigen::VectorXd& difference, const EcdfDifference& band);

}  // namespace cpt::diagnosis
