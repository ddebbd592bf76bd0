// Functions on the unit cube whose sensitivity indices are known.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace cpt::parameters {

using Function = std::function<double(const Eigen::VectorXd&)>;

inline Eigen::VectorXd results_of(const Function& function, const Eigen::MatrixXd& places) {
  Eigen::VectorXd y(places.rows());
  for (Eigen::Index run = 0; run < places.rows(); ++run) y(run) = function(places.row(run).transpose());
  return y;
}

/// First-order and total indices.
struct Indices {
  Eigen::VectorXd first, total;
};

/// Ishigami & Homma (1990), a = 7, b = 0.1, on [-pi, pi]^3.
inline double ishigami(const Eigen::VectorXd& u) {
  const Eigen::VectorXd x = (2.0 * u.array() - 1.0) * std::numbers::pi;
  return std::sin(x(0)) + 7.0 * std::pow(std::sin(x(1)), 2) + 0.1 * std::pow(x(2), 4) * std::sin(x(0));
}
/// Its variance is a^2/8 + b pi^4/5 + b^2 pi^8/18 + 1/2, of which x1 alone has (1 + b pi^4/5)^2/2, x2 a^2/8
/// and x1 with x3 the rest (Sobol' & Levitan 1999).
inline Indices ishigami_indices() {
  const double a = 7.0, b = 0.1, pi4 = std::pow(std::numbers::pi, 4);
  const double v = a * a / 8.0 + b * pi4 / 5.0 + b * b * pi4 * pi4 / 18.0 + 0.5;
  const double v1 = 0.5 * std::pow(1.0 + b * pi4 / 5.0, 2), v2 = a * a / 8.0;
  return {Eigen::Vector3d(v1, v2, 0.0) / v, Eigen::Vector3d(v - v2, v2, v - v1 - v2) / v};
}

/// Sobol' g-function: the product of (|4 u_i - 2| + a_i) / (1 + a_i), a_i = 0, 1, 4.5, 9. Each factor has
/// mean 1 and variance 1 / (3 (1 + a_i)^2) (Saltelli & Sobol' 1995).
inline const Eigen::Vector4d g_weights{0.0, 1.0, 4.5, 9.0};
inline double g_function(const Eigen::VectorXd& u) {
  return (((4.0 * u.array() - 2.0).abs() + g_weights.array()) / (1.0 + g_weights.array())).prod();
}
inline Eigen::Vector4d g_variances() { return (1.0 + g_weights.array()).square().inverse() / 3.0; }
inline Eigen::Vector4d g_first() { return g_variances() / ((1.0 + g_variances().array()).prod() - 1.0); }
inline Eigen::Vector4d g_total() {
  const double product = (1.0 + g_variances().array()).prod();
  return g_variances().array() * product / (1.0 + g_variances().array()) / (product - 1.0);
}

/// Flow of water through a borehole [m3/a] (Harper & Gupta 1983), all eight inputs uniform between the bounds
/// of Morris, Mitchell & Ylvisaker (1993): r_w, r, T_u, H_u, T_l, H_l, L, K_w.
inline double borehole(const Eigen::VectorXd& u) {
  const Eigen::Matrix<double, 8, 1> low{0.05, 100.0, 63070.0, 990.0, 63.1, 700.0, 1120.0, 9855.0};
  const Eigen::Matrix<double, 8, 1> high{0.15, 50000.0, 115600.0, 1110.0, 116.0, 820.0, 1680.0, 12045.0};
  const Eigen::Matrix<double, 8, 1> x = low.array() + u.array() * (high - low).array();
  const double log_ratio = std::log(x(1) / x(0));
  return 2.0 * std::numbers::pi * x(2) * (x(3) - x(5)) /
         (log_ratio * (1.0 + 2.0 * x(6) * x(2) / (log_ratio * x(0) * x(0) * x(7)) + x(2) / x(4)));
}

/// Nodes and weights of the average over [0, 1]: Gauss-Legendre, Newton's method on the polynomial.
struct Rule {
  std::vector<double> nodes, weights;
};
inline Rule gauss_legendre(int count) {
  Rule rule;
  const auto n = static_cast<unsigned>(count);
  for (int k = 0; k < count; ++k) {
    double x = std::cos(std::numbers::pi * (k + 0.75) / (count + 0.5)), slope = 0.0;
    for (int i = 0; i < 20; ++i) {
      slope = n * (x * std::legendre(n, x) - std::legendre(n - 1, x)) / (x * x - 1.0);
      x -= std::legendre(n, x) / slope;
    }
    rule.nodes.push_back(0.5 * (1.0 + x));
    rule.weights.push_back(1.0 / ((1.0 - x * x) * slope * slope));
  }
  return rule;
}

/// By a tensor product of Gauss-Legendre rules. With 10, 8, 3, 4, 3, 4, 4 and 3 nodes (138240) no index is
/// further away than 3e-5.
constexpr double borehole_accuracy = 3e-5;
inline Indices borehole_indices(const std::vector<int>& counts = {6, 6, 3, 3, 3, 3, 3, 3}) {
  std::vector<Rule> rules;
  Eigen::Index runs = 1;
  for (const int count : counts) {
    rules.push_back(gauss_legendre(count));
    runs *= count;
  }
  const Eigen::Index dimensions = 8;
  Eigen::VectorXd weight(runs), y(runs);
  Eigen::MatrixXi node(runs, dimensions);
  for (Eigen::Index k = 0; k < runs; ++k) {
    Eigen::VectorXd u(dimensions);
    weight(k) = 1.0;
    for (Eigen::Index j = 0, left = k; j < dimensions; ++j) {
      const Rule& rule = rules[static_cast<std::size_t>(j)];
      const auto nodes = static_cast<Eigen::Index>(rule.nodes.size());
      node(k, j) = static_cast<int>(left % nodes);
      u(j) = rule.nodes[static_cast<std::size_t>(left % nodes)];
      weight(k) *= rule.weights[static_cast<std::size_t>(left % nodes)];
      left /= nodes;
    }
    y(k) = borehole(u);
  }
  const double mean = weight.dot(y), variance = weight.dot((y.array() - mean).square().matrix());
  Indices indices{Eigen::VectorXd(dimensions), Eigen::VectorXd(dimensions)};
  Eigen::Index stride = 1;
  for (Eigen::Index j = 0; j < dimensions; ++j) {
    const Eigen::Index nodes = counts[static_cast<std::size_t>(j)];
    // Means where input j is kept, and where all others are.
    Eigen::VectorXd kept = Eigen::VectorXd::Zero(nodes), kept_weight = kept;
    Eigen::VectorXd others = Eigen::VectorXd::Zero(runs), others_weight = others;
    for (Eigen::Index k = 0; k < runs; ++k) {
      kept(node(k, j)) += weight(k) * y(k);
      kept_weight(node(k, j)) += weight(k);
      const Eigen::Index without = k - stride * node(k, j);
      others(without) += weight(k) * y(k);
      others_weight(without) += weight(k);
    }
    double of_kept = 0.0, of_others = 0.0;
    for (Eigen::Index k = 0; k < nodes; ++k)
      of_kept += kept_weight(k) * std::pow(kept(k) / kept_weight(k) - mean, 2);
    for (Eigen::Index k = 0; k < runs; ++k)
      if (others_weight(k) > 0.0)
        of_others += others_weight(k) * std::pow(others(k) / others_weight(k) - mean, 2);
    indices.first(j) = of_kept / variance;
    indices.total(j) = 1.0 - of_others / variance;
    stride *= nodes;
  }
  return indices;
}

/// b . z of three correlated standard normal inputs, and its exponential.
inline const Eigen::Vector3d correlated_slope{0.4, 0.4, 0.2};
inline Eigen::Matrix3d correlated_inputs() {
  return (Eigen::Matrix3d() << 1.0, 0.7, 0.0, 0.7, 1.0, -0.4, 0.0, -0.4, 1.0).finished();
}
/// The share of the variance that each subset of them accounts for (bit j: input j). Of the sum E(y | z_u) is
/// normal with variance s_u^2 = c_u . S_uu^-1 c_u, c = S b (Owen & Prieur 2017, SIAM/ASA J. Uncertainty
/// Quantification 5, 986-1002); of the exponential it is lognormal, of a variance that goes with exp(s_u^2)
/// - 1.
inline Eigen::VectorXd correlated_shares(bool exponential) {
  const Eigen::Matrix3d correlation = correlated_inputs();
  const Eigen::Vector3d with = correlation * correlated_slope;
  const auto size = [&](double square) { return exponential ? std::expm1(square) : square; };
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(8);
  for (unsigned subset = 1; subset < 8; ++subset) {
    std::vector<Eigen::Index> in;
    for (Eigen::Index j = 0; j < 3; ++j)
      if ((subset >> j & 1U) != 0U) in.push_back(j);
    const Eigen::VectorXd known = with(in);
    const Eigen::MatrixXd among = correlation(in, in);
    shares(subset) = size(known.dot(among.llt().solve(known)));
  }
  return shares / shares(7);
}

}  // namespace cpt::parameters
