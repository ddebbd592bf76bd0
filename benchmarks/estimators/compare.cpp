// The designs' estimators beside OpenTURNS' on the same runs, as a table in Markdown (docs/designs.md): on
// functions whose indices are known and on runs of the solver (tests/reference/clay_saltelli.csv).
#include "benchmarks/estimators/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <openturns/ComposedDistribution.hxx>
#include <openturns/CorrectedLeaveOneOut.hxx>
#include <openturns/FixedStrategy.hxx>
#include <openturns/FunctionalChaosAlgorithm.hxx>
#include <openturns/HyperbolicAnisotropicEnumerateFunction.hxx>
#include <openturns/JansenSensitivityAlgorithm.hxx>
#include <openturns/LARS.hxx>
#include <openturns/LeastSquaresMetaModelSelectionFactory.hxx>
#include <openturns/LeastSquaresStrategy.hxx>
#include <openturns/LegendreFactory.hxx>
#include <openturns/MartinezSensitivityAlgorithm.hxx>
#include <openturns/OrthogonalProductPolynomialFactory.hxx>
#include <openturns/ResourceMap.hxx>
#include <openturns/SaltelliSensitivityAlgorithm.hxx>
#include <openturns/Uniform.hxx>
#include <sstream>
#include <string>
#include <vector>

#include "parameters/designs/latin_hypercube.hpp"
#include "parameters/designs/polynomial_chaos.hpp"
#include "parameters/designs/sobol.hpp"
#include "tests/parameters/designs/functions.hpp"

namespace cpt::benchmarks {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using parameters::Estimate;

struct Numbers {
  VectorXd first, total;
};

Numbers values_of(const std::vector<Estimate>& first, const std::vector<Estimate>& total) {
  Numbers numbers{VectorXd(static_cast<Index>(first.size())), VectorXd(static_cast<Index>(first.size()))};
  for (std::size_t i = 0; i < first.size(); ++i) {
    numbers.first(static_cast<Index>(i)) = first[i].value;
    numbers.total(static_cast<Index>(i)) = total[i].value;
  }
  return numbers;
}

VectorXd vector_of(const OT::Point& point) {
  VectorXd numbers(static_cast<Index>(point.getSize()));
  for (Index i = 0; i < numbers.size(); ++i) numbers(i) = point[static_cast<OT::UnsignedInteger>(i)];
  return numbers;
}

OT::Sample sample_of(const MatrixXd& numbers) {
  OT::Sample sample(static_cast<OT::UnsignedInteger>(numbers.rows()),
                    static_cast<OT::UnsignedInteger>(numbers.cols()));
  for (Index i = 0; i < numbers.rows(); ++i)
    for (Index j = 0; j < numbers.cols(); ++j)
      sample(static_cast<OT::UnsignedInteger>(i), static_cast<OT::UnsignedInteger>(j)) = numbers(i, j);
  return sample;
}

// Runs of sobol_places in the order of OpenTURNS: all of A, all of B, all of A with the first column of B,
// ...
MatrixXd by_matrices(const MatrixXd& runs, Index width) {
  const Index rows = runs.rows() / width;
  MatrixXd ordered(runs.rows(), runs.cols());
  for (Index row = 0; row < rows; ++row)
    for (Index k = 0; k < width; ++k) ordered.row(k * rows + row) = runs.row(row * width + k);
  return ordered;
}

template <class Algorithm>
Numbers openturns_indices(const MatrixXd& places, const VectorXd& y) {
  const Index width = places.cols() + 2;
  const Algorithm algorithm(sample_of(by_matrices(places, width)), sample_of(by_matrices(y, width)),
                            static_cast<OT::UnsignedInteger>(y.size() / width));
  return {vector_of(algorithm.getFirstOrderIndices()), vector_of(algorithm.getTotalOrderIndices())};
}

// Legendre polynomials, hyperbolic truncation with norm 0.75, ten candidate terms a run (400 at most), chosen
// by least-angle regression and the corrected leave-one-out error.
Numbers openturns_chaos(const MatrixXd& places, const VectorXd& y) {
  const auto inputs = static_cast<OT::UnsignedInteger>(places.cols());
  const OT::HyperbolicAnisotropicEnumerateFunction order(inputs, 0.75);
  OT::Collection<OT::OrthogonalUniVariatePolynomialFamily> families(
      inputs, OT::OrthogonalUniVariatePolynomialFamily(OT::LegendreFactory()));
  const OT::OrthogonalProductPolynomialFactory basis(families, order);
  const OT::ComposedDistribution uniform(
      OT::ComposedDistribution::DistributionCollection(inputs, OT::Uniform(0.0, 1.0)));
  const OT::LeastSquaresMetaModelSelectionFactory selection{OT::LARS(), OT::CorrectedLeaveOneOut()};
  const auto candidates = static_cast<OT::UnsignedInteger>(std::min<Index>(400, 10 * y.size()));
  OT::FunctionalChaosAlgorithm algorithm(sample_of(places), sample_of(y), uniform,
                                         OT::FixedStrategy(basis, candidates),
                                         OT::LeastSquaresStrategy{selection});
  algorithm.run();
  const OT::FunctionalChaosResult result = algorithm.getResult();
  Numbers shares{VectorXd::Zero(places.cols()), VectorXd::Zero(places.cols())};
  double variance = 0.0;
  for (OT::UnsignedInteger k = 0; k < result.getIndices().getSize(); ++k) {
    const OT::Indices degrees = order(result.getIndices()[k]);
    const double share = std::pow(result.getCoefficients()(k, 0), 2);
    Index involved = 0, last = 0;
    for (OT::UnsignedInteger j = 0; j < inputs; ++j)
      if (degrees[j] > 0) {
        ++involved;
        last = static_cast<Index>(j);
        shares.total(last) += share;
      }
    if (involved == 1) shares.first(last) += share;
    if (involved > 0) variance += share;
  }
  return {shares.first / variance, shares.total / variance};
}

double apart(const VectorXd& a, const VectorXd& b) { return (a - b).cwiseAbs().maxCoeff(); }

struct Shown {
  std::string function, estimator;
  Index runs;
  Numbers own, theirs;
};

// Differences are the largest over the inputs. `exact`: nothing where no truth is known.
void show(const Shown& of, const Numbers* exact) {
  const auto from_truth = [&](const Numbers& numbers) {
    return exact == nullptr ? "–"
                            : fmt::format("{:.4f}, {:.4f}", apart(numbers.first, exact->first),
                                          apart(numbers.total, exact->total));
  };
  fmt::print("| {} | {} | {} | {:.1e}, {:.1e} | {} | {} |\n", of.function, of.estimator, of.runs,
             apart(of.own.first, of.theirs.first), apart(of.own.total, of.theirs.total), from_truth(of.own),
             from_truth(of.theirs));
}

/// Largest difference of what is the same formula in both.
struct Agreement {
  double of_formulas = 0.0;
};

void compare_saltelli(const std::string& name, const MatrixXd& places, const VectorXd& y,
                      const Numbers* exact, Agreement& agreement) {
  const auto inputs = static_cast<int>(places.cols());
  const auto own = [&](parameters::SobolEstimator estimator) {
    const auto indices = parameters::sobol_indices(inputs, y, 1, estimator);
    return values_of(indices.first, indices.total);
  };
  const Numbers saltelli = own(parameters::SobolEstimator::saltelli),
                martinez = own(parameters::SobolEstimator::martinez);
  const Numbers theirs_saltelli = openturns_indices<OT::SaltelliSensitivityAlgorithm>(places, y),
                theirs_jansen = openturns_indices<OT::JansenSensitivityAlgorithm>(places, y),
                theirs_martinez = openturns_indices<OT::MartinezSensitivityAlgorithm>(places, y);
  show({name,
        "`saltelli`; Saltelli, Jansen",
        y.size(),
        saltelli,
        {theirs_saltelli.first, theirs_jansen.total}},
       exact);
  show({name, "`martinez`; Martinez", y.size(), martinez, theirs_martinez}, exact);
  agreement.of_formulas = std::max({agreement.of_formulas, apart(martinez.first, theirs_martinez.first),
                                    apart(martinez.total, theirs_martinez.total)});
}

void compare_chaos(const std::string& name, const MatrixXd& places, const VectorXd& y, const Numbers* exact) {
  const auto fit =
      parameters::polynomial_chaos(places, std::vector<int>(static_cast<std::size_t>(places.cols())), y);
  show({name, "`latin_hypercube`; sparse chaos", y.size(), values_of(fit.first, fit.total),
        openturns_chaos(places, y)},
       exact);
}

// A header, then places in the unit cube and the average q_c of each run.
MatrixXd read_sample(const std::string& file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  const Index columns = std::ranges::count(line, ',') + 1;
  std::vector<double> numbers;
  while (std::getline(in, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream fields(line);
    for (double number = 0.0; fields >> number;) numbers.push_back(number);
  }
  return Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
      numbers.data(), static_cast<Index>(numbers.size()) / columns, columns);
}

}  // namespace

int print_comparison(const std::string& sample_file) {
  fmt::print(
      "| function | estimator here; OpenTURNS' | runs | between the two | from the truth, here | "
      "from the truth, OpenTURNS |\n|---|---|---|---|---|---|\n");
  struct Known {
    std::string name;
    parameters::Function of;
    Numbers exact;
  };
  const auto ishigami = parameters::ishigami_indices(), borehole = parameters::borehole_indices();
  Agreement agreement;
  for (const Known& known :
       {Known{"Ishigami", parameters::ishigami, {ishigami.first, ishigami.total}},
        Known{"g-function", parameters::g_function, {parameters::g_first(), parameters::g_total()}},
        Known{"borehole", parameters::borehole, {borehole.first, borehole.total}}}) {
    const auto inputs = static_cast<int>(known.exact.first.size());
    const MatrixXd rows = parameters::sobol_places(inputs, 256, 1);
    compare_saltelli(known.name, rows, parameters::results_of(known.of, rows), &known.exact, agreement);
    for (const int runs : {60, 120, 240}) {
      const MatrixXd places = parameters::latin_hypercube_places(inputs, runs, 1);
      compare_chaos(known.name, places, parameters::results_of(known.of, places), &known.exact);
    }
  }
  const MatrixXd sample = read_sample(sample_file);
  const Index inputs = sample.cols() - 1, rows = sample.rows() / (inputs + 2);
  if (rows < 8) {
    fmt::print(stderr, "{} holds no sample of Saltelli's scheme\n", sample_file);
    return 1;
  }
  const MatrixXd places = sample.leftCols(inputs);
  const VectorXd y = sample.rightCols(1);
  compare_saltelli("cone in clay", places, y, nullptr, agreement);
  // A and B alone are spread over the cube.
  std::vector<Index> spread;
  for (Index row = 0; row < rows; ++row)
    for (const Index k : {0, 1}) spread.push_back(row * (inputs + 2) + k);
  compare_chaos("cone in clay", places(spread, Eigen::all), y(spread), nullptr);
  constexpr double rounding = 1e-10;
  return agreement.of_formulas <= rounding ? 0 : 1;
}

}  // namespace cpt::benchmarks
