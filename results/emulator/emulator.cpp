#include "results/emulator/emulator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cpt::results {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A process among those whose variances are added up, given the candidates taken so far.
struct Watched {
  const GaussianProcess* process;
  double weight;               // one over the variance of the output over the runs
  MatrixXd covariances;        // of the references with each candidate
  VectorXd variances;          // at each candidate
  std::vector<VectorXd> cuts;  // of each candidate taken: covariances of all with it over its deviation
};

constexpr Index reference_step = 8;  // every eighth candidate

MatrixXd references(const MatrixXd& candidates) {
  return candidates(Eigen::seq(0, candidates.rows() - 1, reference_step), Eigen::all);
}

std::vector<Watched> watched(const Emulator& emulator, const MatrixXd& candidates) {
  const MatrixXd reference = references(candidates);
  std::vector<Watched> all;
  for (const EmulatedOutput& output : emulator.outputs) {
    const std::vector<GaussianProcess>& processes = output.emulator.processes();
    double power = 0.0;
    for (const GaussianProcess& process : processes)
      power += (process.values().array() - process.values().mean()).square().mean();
    for (const GaussianProcess& process : processes)
      all.push_back({&process,
                     1.0 / power,
                     process.mean_covariance(candidates, reference).transpose(),
                     process.mean_variance(candidates),
                     {}});
  }
  return all;
}

// What a run at each candidate would take off the references' variances, added.
VectorXd gains(const Watched& of) {
  const double floor = 1e-12 * of.process->variance() + of.process->noise();
  return of.weight *
         (of.covariances.colwise().squaredNorm().transpose().array() / (of.variances.array() + floor))
             .matrix();
}

void take(Watched& of, const MatrixXd& candidates, Index taken) {
  VectorXd cut = of.process->mean_covariance(candidates, candidates.row(taken));
  for (const VectorXd& before : of.cuts) cut -= before * before(taken);
  const double own = cut(taken) + of.process->noise();
  if (!(own > 0.0)) return;
  cut /= std::sqrt(own);
  of.covariances -= cut(Eigen::seq(0, candidates.rows() - 1, reference_step)) * cut.transpose();
  of.variances = (of.variances - cut.cwiseAbs2()).cwiseMax(0.0);
  of.cuts.push_back(std::move(cut));
}

}  // namespace

double EmulatorInput::place(double value) const {
  if (logarithmic) return std::log(value / lower) / std::log(upper / lower);
  return (value - lower) / (upper - lower);
}

std::string EmulatorInput::text(double value) const {
  if (!choices.empty()) return choices[value == lower ? 0 : 1];
  return fmt::format("{}", value);
}

std::string EmulatorInput::range() const {
  if (!choices.empty()) return fmt::format("{} or {}", choices[0], choices[1]);
  return fmt::format("{}{:.6g} to {:.6g}{}", integer ? "whole, " : "", lower, upper,
                     unit == "-" ? "" : " " + unit);
}

std::string out_of_range(const EmulatorInput& input, double value) {
  const bool within = input.choices.empty() ? value >= input.lower && value <= input.upper
                                            : value == input.lower || value == input.upper;
  if (within && (!input.integer || value == std::floor(value))) return "";
  return fmt::format("must be {}", input.range());
}

const EmulatorInput* Emulator::input(std::string_view name) const {
  const auto found = std::ranges::find(inputs, name, &EmulatorInput::name);
  return found == inputs.end() ? nullptr : &*found;
}

const EmulatedOutput* Emulator::output(std::string_view name) const {
  const auto found = std::ranges::find(outputs, name, &EmulatedOutput::name);
  return found == outputs.end() ? nullptr : &*found;
}

MatrixXd Emulator::places(const MatrixXd& values) const {
  MatrixXd at(values.rows(), values.cols());
  for (Index i = 0; i < at.rows(); ++i)
    for (Index j = 0; j < at.cols(); ++j) at(i, j) = inputs[static_cast<std::size_t>(j)].place(values(i, j));
  return at;
}

std::string refusal_of(const EmulatedOutput& output) {
  if (!output.validation.refused()) return "";
  return fmt::format("Q2 = {:.3g} on held-out runs, below {}", output.validation.q2, least_emulator_q2);
}

std::vector<Index> worst_places(const Emulator& emulator, const MatrixXd& candidates, Index count) {
  std::vector<Watched> all = watched(emulator, candidates);
  std::vector<Index> taken;
  while (static_cast<Index>(taken.size()) < std::min(count, candidates.rows())) {
    VectorXd total = VectorXd::Zero(candidates.rows());
    for (const Watched& of : all) total += gains(of);
    for (const Index before : taken) total(before) = -1.0;
    Index worst = 0;
    total.maxCoeff(&worst);
    taken.push_back(worst);
    for (Watched& of : all) take(of, candidates, worst);
  }
  return taken;
}

}  // namespace cpt::results
