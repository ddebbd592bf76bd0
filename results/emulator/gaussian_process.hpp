// Gaussian process regression with a polynomial trend (universal kriging): one number of a run, between the
// runs that were made.
//
//   y(x) = h(x)^T beta + Z(x) + noise,   cov Z(x, x') = variance * matern_5_2(x - x'),
//   noise of variance nugget * variance
//
// (Rasmussen & Williams 2006, Gaussian Processes for Machine Learning, eq. 4.17 and section 2.7, with a
// length for each input and a flat prior on beta.) Leave-one-out errors and their variances come from the
// inverse of the bordered matrix (Dubrule 1983, Mathematical Geology 15, 687-699), here from the Cholesky
// factor.
#pragma once

#include <Eigen/Dense>

namespace cpt::results {

/// h(x): 1; 1 and x; 1, x and all products of two. An input that takes two values only has no square.
enum class Trend { constant, linear, quadratic };

struct Kernel {
  Eigen::VectorXd lengths;  ///< [-] of the unit cube, one for each input, > 0
  double nugget = 0.0;      ///< [-] variance of the noise over that of Z, >= 0
};

/// How a fit looks for lengths and nugget: over a coarse grid of each in turn, then around the best of it.
struct KernelSearch {
  int sweeps = 2;       ///< over the coarse grid
  int refinements = 3;  ///< each with half the step of the one before
};

class GaussianProcess {
 public:
  /// `design`: runs x inputs, in the unit cube. `values`: one a run. The last `exact` runs have no noise.
  /// Throws std::invalid_argument for sizes that do not agree, numbers that are not finite, lengths that are
  /// not positive, and a design too poor for its trend.
  GaussianProcess(Eigen::MatrixXd design, Eigen::VectorXd values, Trend trend, Kernel kernel,
                  Eigen::Index exact = 0);

  /// With the lengths and the nugget that maximize the restricted likelihood (Patterson & Thompson 1971,
  /// Biometrika 58, 545-554: of the values less their trend). The same input gives the same bits.
  [[nodiscard]] static GaussianProcess fit(const Eigen::MatrixXd& design, const Eigen::VectorXd& values,
                                           Trend trend, const KernelSearch& search = {},
                                           Eigen::Index exact = 0);

  [[nodiscard]] Eigen::Index inputs() const { return design_.cols(); }
  [[nodiscard]] Eigen::Index runs() const { return design_.rows() - exact_; }  ///< without the exact ones
  [[nodiscard]] Trend trend() const { return trend_; }
  [[nodiscard]] const Kernel& kernel() const { return kernel_; }
  [[nodiscard]] const Eigen::MatrixXd& design() const { return design_; }
  [[nodiscard]] const Eigen::VectorXd& values() const { return values_; }
  [[nodiscard]] double variance() const { return variance_; }  ///< of Z; the restricted likelihood's
  [[nodiscard]] double noise() const {
    return kernel_.nugget * variance_;
  }  ///< variance of a run's own noise

  // `points`: points x inputs.
  [[nodiscard]] Eigen::VectorXd mean(const Eigen::MatrixXd& points) const;
  /// Of the mean, without the noise of a run.
  [[nodiscard]] Eigen::VectorXd mean_variance(const Eigen::MatrixXd& points) const;
  /// Of the means at `a` (rows) and at `b` (columns) with each other.
  [[nodiscard]] Eigen::MatrixXd mean_covariance(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) const;

  /// Mean and its variance at one point, inputs in a row; the fast way where points come one by one.
  struct AtPoint {
    double mean, variance;
  };
  [[nodiscard]] AtPoint at(const Eigen::RowVectorXd& point) const;

  // Of the runs that have noise, predicted from all others with the same kernel and variance.
  [[nodiscard]] const Eigen::VectorXd& left_out_errors() const {
    return left_out_errors_;
  }  ///< y - predicted
  [[nodiscard]] const Eigen::VectorXd& left_out_variances() const { return left_out_variances_; }

 private:
  // What a point is to the runs: points' covariances with them and trend, solved through the factor.
  struct Border {
    Eigen::MatrixXd runs;   // L^-1 k, runs x points
    Eigen::MatrixXd trend;  // R^-T (h - (L^-1 H)^T L^-1 k), terms x points
  };
  [[nodiscard]] Border border(const Eigen::MatrixXd& points) const;

  Eigen::MatrixXd design_;
  Eigen::VectorXd values_;
  Trend trend_;
  Kernel kernel_;
  Eigen::Index exact_;
  Eigen::Array<bool, Eigen::Dynamic, 1> squared_;  // inputs that have a square in the trend
  Eigen::MatrixXd factor_;                         // L of K = L L^T
  Eigen::MatrixXd trend_q_, trend_r_;              // L^-1 H = Q R
  Eigen::VectorXd weights_;                        // K^-1 (y - H beta)
  Eigen::VectorXd coefficients_;                   // beta
  double variance_ = 0.0;
  Eigen::VectorXd left_out_errors_, left_out_variances_;
};

/// Terms of a trend over `inputs`, all with squares.
[[nodiscard]] Eigen::Index trend_terms(Eigen::Index inputs, Trend trend);

/// The richest trend with at least two runs a term.
[[nodiscard]] Trend trend_for(Eigen::Index runs, Eigen::Index inputs);

/// Matern's covariance of smoothness 5/2, (1 + r + r^2 / 3) exp(-r) with r = sqrt(5) |(a - b) / lengths|:
/// points of `a` x points of `b`.
[[nodiscard]] Eigen::MatrixXd matern_5_2(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b,
                                         const Eigen::VectorXd& lengths);

}  // namespace cpt::results
