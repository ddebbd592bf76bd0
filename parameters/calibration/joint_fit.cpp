#include "parameters/calibration/joint_fit.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <unsupported/Eigen/NonLinearOptimization>

namespace cpt::calibration {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

constexpr std::array<double, channel_count> assumed_scatter = {0.01, 1e-3, 2e-3, 0.05};
constexpr std::array<double, channel_count> least_scatter = {1e-4, 1e-5, 1e-5, 1e-3};
constexpr double fewest_free = 2.0;       // degrees of freedom that estimate a scatter
constexpr double scatter_settled = 0.02;  // relative change that ends the turns
constexpr int most_turns = 10;
constexpr double step_share = 1e-4;            // of the range: step of a derivative
constexpr double edge_share = 1e-3;            // of the range: a fit starts no nearer to its ends
constexpr double told_share = 0.5;             // of the range: the widest interval that tells
constexpr double at_edge_share = 0.005;        // of the range: a value so near to an end is at it
constexpr double least_length = 1e-9;          // of J's columns over the longest
constexpr double smallest_eigenvalue = 1e-13;  // of J^T J with columns of length one
constexpr double no_run = 1e3;                 // [standard deviations] residual of a test that does not run
constexpr double confidence = 0.95;
constexpr int most_evaluations = 60;  // of one minimization

struct Weighted {
  const std::vector<Observation>& observations;
  const std::array<double, channel_count>& scatter;
  [[nodiscard]] double of(std::size_t i) const {
    return 1.0 / scatter[static_cast<std::size_t>(observations[i].channel)];
  }
};

// The tests as a function of free parameters on their scales.
class Residuals {
 public:
  Residuals(const SimulatedTests& simulated, const solver::NorSandParameters& sand,
            std::vector<const FitParameter*> free, const std::array<double, channel_count>& scatter,
            int& runs)
      : simulated_(simulated), sand_(sand), free_(std::move(free)), scatter_(scatter), runs_(runs) {}

  [[nodiscard]] Index inputs() const { return static_cast<Index>(free_.size()); }
  [[nodiscard]] Index values() const { return static_cast<Index>(simulated_.observations().size()); }
  [[nodiscard]] const std::vector<const FitParameter*>& free() const { return free_; }

  [[nodiscard]] solver::NorSandParameters sand(const VectorXd& s) const {
    solver::NorSandParameters changed = sand_;
    for (Index j = 0; j < inputs(); ++j) {
      const FitParameter& parameter = *free_[static_cast<std::size_t>(j)];
      parameter.set(
          changed, std::clamp(parameter.study_value(s(j)), parameter.quantity->min, parameter.quantity->max));
    }
    return changed;
  }

  /// Over the scatter; nothing where a test does not run.
  [[nodiscard]] std::optional<VectorXd> at(const VectorXd& s) const {
    ++runs_;
    std::vector<double> simulated;
    if (!simulated_.run(sand(s), simulated).empty()) return std::nullopt;
    const std::vector<Observation>& observations = simulated_.observations();
    const Weighted weight{observations, scatter_};
    VectorXd r(values());
    for (std::size_t i = 0; i < observations.size(); ++i)
      r(static_cast<Index>(i)) = (simulated[i] - observations[i].measured) * weight.of(i);
    return r;
  }

  /// Derivatives by s: central where `central`, else forward from the residuals `r` at s; one-sided where the
  /// other side does not run.
  [[nodiscard]] MatrixXd jacobian(const VectorXd& s, const VectorXd& r, bool central) const {
    MatrixXd J = MatrixXd::Zero(values(), inputs());
    for (Index j = 0; j < inputs(); ++j) {
      const FitParameter& parameter = *free_[static_cast<std::size_t>(j)];
      const double step = step_share * parameter.range();
      VectorXd up = s, down = s;
      up(j) = std::min(s(j) + step, parameter.upper());
      down(j) = std::max(s(j) - step, parameter.lower());
      const auto above = up(j) > s(j) ? at(up) : std::nullopt;
      const auto below = (central || !above) && down(j) < s(j) ? at(down) : std::nullopt;
      if (above && below)
        J.col(j) = (*above - *below) / (up(j) - down(j));
      else if (above)
        J.col(j) = (*above - r) / (up(j) - s(j));
      else if (below)
        J.col(j) = (r - *below) / (s(j) - down(j));
    }
    return J;
  }

 private:
  const SimulatedTests& simulated_;
  solver::NorSandParameters sand_;
  std::vector<const FitParameter*> free_;
  std::array<double, channel_count> scatter_;
  int& runs_;
};

// For Eigen's Levenberg-Marquardt: the same of the logits of the places in the ranges.
class OfLogits {
 public:
  using Scalar = double;
  using InputType = VectorXd;
  using ValueType = VectorXd;
  using JacobianType = MatrixXd;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

  explicit OfLogits(const Residuals& residuals) : residuals_(residuals) {}
  [[nodiscard]] int inputs() const { return static_cast<int>(residuals_.inputs()); }
  [[nodiscard]] int values() const { return static_cast<int>(residuals_.values()); }

  [[nodiscard]] VectorXd scaled(const VectorXd& logits) const {
    VectorXd s(logits.size());
    for (Index j = 0; j < logits.size(); ++j) {
      const FitParameter& parameter = *residuals_.free()[static_cast<std::size_t>(j)];
      s(j) = parameter.lower() + parameter.range() / (1.0 + std::exp(-logits(j)));
    }
    return s;
  }
  [[nodiscard]] VectorXd logits(const VectorXd& s) const {
    VectorXd u(s.size());
    for (Index j = 0; j < s.size(); ++j) {
      const FitParameter& parameter = *residuals_.free()[static_cast<std::size_t>(j)];
      const double place =
          std::clamp((s(j) - parameter.lower()) / parameter.range(), edge_share, 1.0 - edge_share);
      u(j) = std::log(place / (1.0 - place));
    }
    return u;
  }

  int operator()(const VectorXd& u, VectorXd& r) const {
    r = residuals_.at(scaled(u)).value_or(VectorXd::Constant(residuals_.values(), no_run));
    return 0;
  }
  int df(const VectorXd& u, MatrixXd& J) const {
    const VectorXd s = scaled(u);
    const auto r = residuals_.at(s);
    J = r ? residuals_.jacobian(s, *r, false) : MatrixXd::Zero(residuals_.values(), residuals_.inputs());
    for (Index j = 0; j < u.size(); ++j) {
      const double place = 1.0 / (1.0 + std::exp(-u(j)));
      J.col(j) *= residuals_.free()[static_cast<std::size_t>(j)]->range() * place * (1.0 - place);
    }
    return 0;
  }

 private:
  const Residuals& residuals_;
};

VectorXd minimized(const Residuals& residuals, const VectorXd& start) {
  OfLogits function(residuals);
  VectorXd u = function.logits(start);
  Eigen::LevenbergMarquardt<OfLogits> method(function);
  method.parameters.ftol = method.parameters.xtol = 1e-5;
  method.parameters.factor = 1.0;
  method.parameters.maxfev = most_evaluations;
  method.minimize(u);
  return function.scaled(u);
}

// At a minimum: what the residuals and their derivatives tell.
struct AtMinimum {
  VectorXd s, r;
  MatrixXd J;
  MatrixXd inverse;  // (J^T J)^-1, nearly singular directions made finite and large
};

// (J^T J)^-1, directions of which J tells nothing finite and large.
MatrixXd inverse_normal(const MatrixXd& J) {
  const VectorXd lengths = J.colwise().norm();
  // What acts on nothing that was measured has no length.
  const double least = std::max(least_length * lengths.maxCoeff(), std::numeric_limits<double>::min());
  const VectorXd scale = lengths.cwiseMax(least).cwiseInverse();
  const MatrixXd scaled = J * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(scaled.transpose() * scaled);
  const VectorXd values = solver.eigenvalues().cwiseMax(smallest_eigenvalue);
  const MatrixXd vectors = scale.asDiagonal() * solver.eigenvectors();
  return vectors * values.cwiseInverse().asDiagonal() * vectors.transpose();
}

class Fitter {
 public:
  Fitter(const LaboratoryTests& tests, const solver::NorSandParameters& sand,
         std::span<const FitParameter* const> free)
      : given_(sand), simulated_(tests), tests_(tests) {
    fit_.sand = sand;
    for (const FitParameter& parameter : fit_parameters())
      if (std::ranges::find(free, &parameter) != free.end()) {
        free_.push_back(&parameter);
        fit_.parameters.push_back(
            {.parameter = &parameter, .given = parameter.of(sand), .value = parameter.of(sand)});
      }
    for (const Observation& observation : simulated_.observations())
      ++fit_.channels[static_cast<std::size_t>(observation.channel)].readings;
  }

  JointFit fit() {
    fit_.first = first_estimates(tests_, given_, free_);
    for (const FirstEstimate& estimate : fit_.first.estimates) of(estimate.parameter).first = estimate.value;
    std::string why;
    if (auto start = better_start(why); start.size() > 0 || free_.empty())
      search(std::move(start));
    else
      fit_.problem = why;
    return std::move(fit_);
  }

 private:
  [[nodiscard]] ParameterFit& of(const FitParameter* parameter) {
    return *std::ranges::find(fit_.parameters, parameter, &ParameterFit::parameter);
  }
  [[nodiscard]] Residuals residuals() { return {simulated_, given_, free_, scatter_, fit_.simulations}; }
  [[nodiscard]] VectorXd scaled(const solver::NorSandParameters& sand) const {
    VectorXd s(static_cast<Index>(free_.size()));
    for (std::size_t j = 0; j < free_.size(); ++j)
      s(static_cast<Index>(j)) = free_[j]->scaled(free_[j]->of(sand));
    return s;
  }

  // Nothing where the tests run from neither.
  VectorXd better_start(std::string& why) {
    VectorXd best;
    double least = 0.0;
    for (const solver::NorSandParameters& sand : {fit_.first.sand, given_}) {
      const VectorXd s = scaled(sand);
      if (const auto r = residuals().at(s); r && (best.size() == 0 || r->squaredNorm() < least)) {
        best = s;
        least = r->squaredNorm();
      }
    }
    std::vector<double> values;
    if (best.size() == 0) why = simulated_.run(given_, values);
    return best;
  }

  // Parameters that are not told leave one by one.
  void search(VectorXd start) {
    while (!free_.empty()) {
      if (simulated_.observations().size() <= free_.size()) {
        fit_.problem = fmt::format("{} readings cannot tell {} parameters", simulated_.observations().size(),
                                   free_.size());
        return;
      }
      const AtMinimum minimum = settled(start);
      const MatrixXd covariance = covariance_of(minimum);
      const double t = quantile();
      Index widest = 0;
      VectorXd share(covariance.rows());
      for (Index j = 0; j < share.size(); ++j)
        share(j) = 2.0 * t * std::sqrt(covariance(j, j)) / free_[static_cast<std::size_t>(j)]->range();
      if (share.maxCoeff(&widest) <= told_share) return store(minimum, covariance, t);
      const FitParameter* leaves = free_[static_cast<std::size_t>(widest)];
      of(leaves).remark = fmt::format(
          "not told by these tests: kept as given, since its 95 % interval would be {} of its valid "
          "range",
          share(widest) >= 1.0 ? std::string("wider than all")
                               : fmt::format("{:.0f} %", 100.0 * share(widest)));
      free_.erase(free_.begin() + widest);
      start.resize(static_cast<Index>(free_.size()));
      for (Index j = 0; j < start.size(); ++j) start(j) = minimum.s(j < widest ? j : j + 1);
    }
    fit_.problem = "the tests tell none of these parameters";
  }

  // The minimum, with the scatter that its residuals have.
  AtMinimum settled(VectorXd s) {
    for (int turn = 0;; ++turn) {
      const Residuals function = residuals();
      s = minimized(function, s);
      AtMinimum minimum{s, function.at(s).value(), {}, {}};
      minimum.J = function.jacobian(s, minimum.r, true);
      minimum.inverse = inverse_normal(minimum.J);
      if (!change_scatter(minimum) || turn + 1 == most_turns) return minimum;
    }
  }

  // False where it has settled; the minimum's numbers are then on the scatter that stays.
  bool change_scatter(const AtMinimum& minimum) {
    std::array<double, channel_count> squares{}, left{};
    const std::vector<Observation>& observations = simulated_.observations();
    for (std::size_t i = 0; i < observations.size(); ++i) {
      const auto k = static_cast<std::size_t>(observations[i].channel);
      const auto row = minimum.J.row(static_cast<Index>(i));
      const double leverage = (row * minimum.inverse).dot(row);
      squares[k] += std::pow(minimum.r(static_cast<Index>(i)), 2);
      left[k] += 1.0 - std::clamp(leverage, 0.0, 1.0);
    }
    std::array<double, channel_count> next = scatter_;
    double change = 0.0;
    for (std::size_t k = 0; k < channel_count; ++k) {
      ChannelScatter& channel = fit_.channels[k];
      channel.estimated = left[k] >= fewest_free;
      if (channel.readings == 0) continue;
      next[k] = channel.estimated ? std::max(least_scatter[k], scatter_[k] * std::sqrt(squares[k] / left[k]))
                                  : assumed_scatter[k];
      change = std::max(change, std::abs(next[k] / scatter_[k] - 1.0));
    }
    if (change <= scatter_settled) return false;
    scatter_ = next;
    return true;
  }

  // Inflated where neighbouring residuals go together.
  MatrixXd covariance_of(const AtMinimum& minimum) {
    const std::vector<Observation>& observations = simulated_.observations();
    std::array<double, channel_count> squares{}, products{};
    for (std::size_t i = 0; i < observations.size(); ++i) {
      const auto k = static_cast<std::size_t>(observations[i].channel);
      const double r = minimum.r(static_cast<Index>(i));
      squares[k] += r * r;
      if (i == 0 || observations[i - 1].channel != observations[i].channel ||
          observations[i - 1].test != observations[i].test)
        continue;
      products[k] += r * minimum.r(static_cast<Index>(i) - 1);
    }
    double readings = 0.0;
    for (std::size_t k = 0; k < channel_count; ++k) {
      ChannelScatter& channel = fit_.channels[k];
      if (channel.readings == 0) continue;
      channel.scatter = scatter_[k];
      channel.autocorrelation = squares[k] > 0.0 ? products[k] / squares[k] : 0.0;
      const double by_chance = 2.0 / std::sqrt(channel.readings);
      const double r = std::min(channel.autocorrelation, 0.99);
      channel.inflation = r > by_chance ? (1.0 + r) / (1.0 - r) : 1.0;
      readings += channel.readings / channel.inflation;
    }
    fit_.degrees_of_freedom = std::max(1, static_cast<int>(readings) - static_cast<int>(free_.size()));
    MatrixXd J = minimum.J;
    for (std::size_t i = 0; i < observations.size(); ++i)
      J.row(static_cast<Index>(i)) *=
          std::sqrt(fit_.channels[static_cast<std::size_t>(observations[i].channel)].inflation);
    return minimum.inverse * (J.transpose() * J) * minimum.inverse;
  }

  [[nodiscard]] double quantile() const {
    const boost::math::students_t_distribution<double> student(fit_.degrees_of_freedom);
    return boost::math::quantile(student, 0.5 + 0.5 * confidence);
  }

  void store(const AtMinimum& minimum, const MatrixXd& covariance, double t) {
    fit_.sand = residuals().sand(minimum.s);
    const VectorXd deviation = covariance.diagonal().cwiseSqrt();
    for (Index j = 0; j < deviation.size(); ++j) {
      const FitParameter* parameter = free_[static_cast<std::size_t>(j)];
      ParameterFit& one = of(parameter);
      one.told = true;
      one.value = parameter->of(fit_.sand);
      one.standard_deviation = deviation(j);
      one.low = parameter->study_value(minimum.s(j) - t * deviation(j));
      one.high = parameter->study_value(minimum.s(j) + t * deviation(j));
      const double edge = at_edge_share * parameter->range();
      if (minimum.s(j) < parameter->lower() + edge || minimum.s(j) > parameter->upper() - edge)
        one.remark = fmt::format("at the end of its valid range, {} to {}: the interval does not hold",
                                 parameter->quantity->min, parameter->quantity->max);
    }
    fit_.correlation =
        deviation.cwiseInverse().asDiagonal() * covariance * deviation.cwiseInverse().asDiagonal();
    misfits(minimum.r);
  }

  void misfits(const VectorXd& r) {
    const auto tests = static_cast<Index>(tests_.triaxial.size() + tests_.oedometer.size());
    MatrixXd squares = MatrixXd::Zero(tests, channel_count), count = squares;
    const std::vector<Observation>& observations = simulated_.observations();
    for (std::size_t i = 0; i < observations.size(); ++i) {
      const auto k = static_cast<Index>(observations[i].channel);
      const auto test = static_cast<Index>(observations[i].test);
      squares(test, k) += std::pow(r(static_cast<Index>(i)) * scatter_[static_cast<std::size_t>(k)], 2);
      count(test, k) += 1.0;
    }
    fit_.misfit = (squares.array() / count.array()).sqrt();  // NaN where there is no reading
  }

  solver::NorSandParameters given_;
  SimulatedTests simulated_;
  const LaboratoryTests& tests_;
  std::vector<const FitParameter*> free_;  // and told so far
  std::array<double, channel_count> scatter_ = assumed_scatter;
  JointFit fit_;
};

}  // namespace

JointFit fit_jointly(const LaboratoryTests& tests, const solver::NorSandParameters& sand,
                     std::span<const FitParameter* const> free) {
  return Fitter(tests, sand, free).fit();
}

}  // namespace cpt::calibration
