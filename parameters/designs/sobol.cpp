#include "parameters/designs/sobol.hpp"

#include <fmt/format.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/sobol.hpp>

#include "parameters/designs/variation.hpp"

namespace cpt::parameters {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// First-order indices, then total ones, over a sample of the rows of `y`: f(A), f(B), f(A_B^1), ...
VectorXd sobol_indices_of(const MatrixXd& y, const Resample& sample) {
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

}  // namespace

MatrixXd sobol_places(int parameters, int rows, std::uint64_t seed) {
  boost::random::sobol sequence(static_cast<std::size_t>(2 * parameters));
  boost::random::mt19937_64 bits(seed);
  std::vector<std::uint64_t> shift(static_cast<std::size_t>(2 * parameters));
  for (std::uint64_t& word : shift) word = bits();

  MatrixXd places(Index{rows} * (parameters + 2), parameters);
  for (Index row = 0; row < rows; ++row) {
    Eigen::RowVectorXd u(2 * parameters);
    for (std::size_t j = 0; j < shift.size(); ++j) {
      const std::uint64_t digits = row == 0 ? 0 : sequence();  // Boost leaves the zero point out
      u(static_cast<Index>(j)) = static_cast<double>((digits ^ shift[j]) >> 11) * 0x1p-53;
    }
    auto block = places.middleRows(row * (parameters + 2), parameters + 2);
    block.rowwise() = u.head(parameters);
    block.row(1) = u.tail(parameters);
    for (Index i = 0; i < parameters; ++i) block(2 + i, i) = u(parameters + i);
  }
  return places;
}

SobolIndices sobol_indices(int parameters, const VectorXd& y, std::uint64_t seed) {
  const Index width = parameters + 2, rows = y.size() / width;
  MatrixXd complete(rows, width);
  Index used = 0;
  for (Index row = 0; row < rows; ++row) {
    const auto runs = y.segment(row * width, width);
    if (runs.allFinite()) complete.row(used++) = runs.transpose();
  }
  complete.conservativeResize(used, width);
  const auto estimates = bootstrap(used, bootstrap_draws, seed, [&](const Resample& sample) {
    return sobol_indices_of(complete, sample);
  });
  return {{estimates.begin(), estimates.begin() + parameters},
          {estimates.begin() + parameters, estimates.end()},
          static_cast<int>(used),
          static_cast<int>(rows - used)};
}

DesignKind sobol_design() {
  return {
      .name = "sobol",
      .keys = {{"runs", 64.0}, {"seed", 1.0}},
      .samples = true,
      .draws_fields = true,
      .run_count = [](const Design& design) { return long{design.runs} * (width_of(design) + 2); },
      .places = [](const Design& design) { return sobol_places(width_of(design), design.runs, design.seed); },
      .run_name =
          [](const Design& design, Index run) {
            const Index columns = width_of(design) + 2, column = run % columns + 1;
            const std::string matrix = column == 1 ? "A" : column == 2 ? "B" : fmt::format("{}", column - 2);
            return fmt::format("sobol {}.{}", run / columns + 1, matrix);
          }};
}

}  // namespace cpt::parameters
