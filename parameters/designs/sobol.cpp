#include "parameters/designs/sobol.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <stdexcept>

#include "parameters/designs/sectioning.hpp"
#include "parameters/designs/variation.hpp"

namespace cpt::parameters {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index fewest_rows = 3;  // of a section that counts

// First-order indices, then total ones, over a sample of the rows of `y`: f(A), f(B), f(A_B^1), ...
VectorXd saltelli_jansen_of(const MatrixXd& y, const Resample& sample) {
  const Index parameters = y.cols() - 2;
  const auto n = static_cast<double>(sample.size());
  double mean = 0.0, variance = 0.0;  // of A and B together
  for (const Index row : sample) mean += (y(row, 0) + y(row, 1)) / (2.0 * n);
  for (const Index row : sample) variance += (y.row(row).head(2).array() - mean).square().sum() / (2.0 * n);
  VectorXd first = VectorXd::Zero(parameters), total = VectorXd::Zero(parameters);
  for (const Index row : sample)
    for (Index i = 0; i < parameters; ++i) {
      const double change = y(row, 2 + i) - y(row, 0);
      first(i) += (y(row, 1) - mean) * change / n;  // less the mean: the same, with less scatter
      total(i) += change * change / (2.0 * n);
    }
  VectorXd both(2 * parameters);
  both << first, total;
  if (varies(y(sample, Eigen::seqN(0, 2)).reshaped())) return both / variance;
  return VectorXd::Constant(2 * parameters, undefined);
}

// Pearson's correlation; NaN where one does not vary.
double correlation(const VectorXd& a, const VectorXd& b) {
  if (!varies(a) || !varies(b)) return undefined;
  const VectorXd x = a.array() - a.mean(), y = b.array() - b.mean();
  return x.dot(y) / std::sqrt(x.squaredNorm() * y.squaredNorm());
}

VectorXd martinez_of(const MatrixXd& all, const Resample& sample) {
  const MatrixXd y = all(sample, Eigen::all);
  const Index parameters = y.cols() - 2;
  if (!varies(y.leftCols(2).reshaped())) return VectorXd::Constant(2 * parameters, undefined);
  VectorXd both(2 * parameters);
  for (Index i = 0; i < parameters; ++i) {
    both(i) = correlation(y.col(1), y.col(2 + i));
    both(parameters + i) = 1.0 - correlation(y.col(0), y.col(2 + i));
  }
  return both;
}

using IndicesOf = VectorXd (*)(const MatrixXd& y, const Resample& sample);
IndicesOf indices_by(SobolEstimator estimator) {
  return estimator == SobolEstimator::martinez ? martinez_of : saltelli_jansen_of;
}

// `rows_of` has the rows of each section.
std::vector<Estimate> by_their_sections(const MatrixXd& y, const std::vector<Resample>& rows_of,
                                        IndicesOf indices) {
  Resample all;
  std::vector<VectorXd> own;
  for (const Resample& rows : rows_of) {
    all.insert(all.end(), rows.begin(), rows.end());
    if (static_cast<Index>(rows.size()) >= fewest_rows) own.push_back(indices(y, rows));
  }
  std::sort(all.begin(), all.end());
  const VectorXd values = indices(y, all);
  std::vector<Estimate> estimates;
  for (Index q = 0; q < values.size(); ++q) {
    std::vector<double> numbers;
    for (const VectorXd& section : own) numbers.push_back(section(q));
    estimates.push_back(sectioned(values(q), numbers));
  }
  return estimates;
}

}  // namespace

MatrixXd sobol_places(int parameters, int rows, std::uint64_t seed, int sections) {
  const auto width = static_cast<std::size_t>(2 * parameters);
  boost::random::sobol sequence(width);
  boost::random::mt19937_64 bits(seed);
  std::vector<std::vector<std::uint64_t>> shifts(static_cast<std::size_t>(sections));
  for (auto& shift : shifts)
    for (std::size_t j = 0; j < width; ++j) shift.push_back(bits());

  std::vector<std::uint64_t> digits(width, 0);  // Boost leaves the zero point out
  MatrixXd places(Index{rows} * (parameters + 2), parameters);
  for (Index row = 0; row < rows; ++row) {
    const auto section = static_cast<std::size_t>(row % sections);
    if (section == 0 && row > 0)
      for (std::uint64_t& word : digits) word = sequence();
    Eigen::RowVectorXd u(2 * parameters);
    for (std::size_t j = 0; j < width; ++j)
      u(static_cast<Index>(j)) = static_cast<double>((digits[j] ^ shifts[section][j]) >> 11) * 0x1p-53;
    auto block = places.middleRows(row * (parameters + 2), parameters + 2);
    block.rowwise() = u.head(parameters);
    block.row(1) = u.tail(parameters);
    for (Index i = 0; i < parameters; ++i) block(2 + i, i) = u(parameters + i);
  }
  return places;
}

SobolEstimator sobol_estimator(std::string_view name) {
  if (name.empty() || name == "saltelli") return SobolEstimator::saltelli;
  if (name == "martinez") return SobolEstimator::martinez;
  throw std::out_of_range("no estimator " + std::string(name));
}

SobolIndices sobol_indices(int parameters, const VectorXd& y, std::uint64_t seed, SobolEstimator estimator,
                           int sections) {
  const Index width = parameters + 2, rows = y.size() / width;
  MatrixXd complete(rows, width);
  std::vector<Resample> rows_of(static_cast<std::size_t>(sections));
  Index used = 0;
  for (Index row = 0; row < rows; ++row) {
    const auto runs = y.segment(row * width, width);
    if (!runs.allFinite()) continue;
    rows_of[static_cast<std::size_t>(row % sections)].push_back(used);
    complete.row(used++) = runs.transpose();
  }
  complete.conservativeResize(used, width);
  const IndicesOf indices = indices_by(estimator);
  const auto estimates = sections > 1 ? by_their_sections(complete, rows_of, indices)
                                      : bootstrap(used, bootstrap_draws, seed, [&](const Resample& sample) {
                                          return indices(complete, sample);
                                        });
  return {{estimates.begin(), estimates.begin() + parameters},
          {estimates.begin() + parameters, estimates.end()},
          static_cast<int>(used),
          static_cast<int>(rows - used)};
}

DesignKind sobol_design() {
  return {
      .name = "sobol",
      .keys = {{"runs", 64.0}, {"sections", 1.0}, {"seed", 1.0}},
      .estimators = {"saltelli", "martinez"},
      .samples = true,
      .draws_fields = true,
      .run_count = [](const Design& design) { return long{design.runs} * (width_of(design) + 2); },
      .places =
          [](const Design& design) {
            return sobol_places(width_of(design), design.runs, design.seed, design.sections);
          },
      .run_name =
          [](const Design& design, Index run) {
            const Index columns = width_of(design) + 2, column = run % columns + 1;
            const std::string matrix = column == 1 ? "A" : column == 2 ? "B" : fmt::format("{}", column - 2);
            return fmt::format("sobol {}.{}", run / columns + 1, matrix);
          }};
}

}  // namespace cpt::parameters
