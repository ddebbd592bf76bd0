#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>

#include "parameters/designs/propagation.hpp"
#include "parameters/designs/shapley.hpp"
#include "results/emulator/placed_inputs.hpp"
#include "results/statistics/window_effects.hpp"

namespace cpt::results {
namespace {

using Eigen::VectorXd;

constexpr double kPa = 1e3;  // [Pa]

struct Number {
  std::string_view name;
  int least;  ///< entries of a section that it takes
  double (*of)(const VectorXd&, double error);
};

template <int Percent>
double percentile(const VectorXd& sample, double error) {
  return parameters::sample_quantile(sample, Percent / 100.0, error);
}

constexpr std::array numbers = {
    Number{"mean", 1, [](const VectorXd& y, double) { return y.mean(); }},
    Number{"standard_deviation", 2, parameters::sample_deviation},
    Number{"quantile_05", 2, percentile<5>},
    Number{"quantile_25", 2, percentile<25>},
    Number{"quantile_50", 2, percentile<50>},
    Number{"quantile_75", 2, percentile<75>},
    Number{"quantile_95", 2, percentile<95>},
};

// Which input the scatter comes from.
void add_shapley_effects(WindowEffects& w) {
  const PlacedInputs inputs(w.study);
  if (inputs.count() < 2) return;
  const auto found = parameters::shapley_indices(inputs.places(w.y.size()), w.y, inputs.scored(),
                                                 inputs.correlation(), w.study.design.seed);
  if (w.window.problem.empty() && !found.problem.empty() && !w.constant) w.prepend(found.problem);
  w.method = "Shapley effects of a sparse polynomial, jackknife over ten folds";
  w.put_all("shapley", found.shapley, found.used, found.dropped, found.used);
  w.method = "Kucherenko's indices of a sparse polynomial, jackknife over ten folds";
  w.put_all("total_order", found.total, found.used, found.dropped, found.used);
  w.put_all("first_order", found.first, found.used, found.dropped, found.used);
  w.put_fit(found.q2, found.degree, found.terms, found.used, found.dropped);
}

}  // namespace

void add_propagation_effects(WindowEffects& w) {
  const auto used = static_cast<int>((w.y.array() == w.y.array()).count());
  const auto dropped = static_cast<int>(w.y.size()) - used;
  const double error = w.study.design.numerical_error.front();
  const std::string method =
      std::string(w.study.design.latin ? "Latin hypercubes" : "randomized Sobol' points") + ", ten sections" +
      (error > 0.0 ? fmt::format(", with a numerical error of {:g} %", 100.0 * error) : "");
  for (const Number& number : numbers) {
    const auto estimate = parameters::by_sections(
        w.y, number.least, [&](const VectorXd& y) { return number.of(y, error); }, w.study.design.latin);
    w.rows.push_back({w.window.name, "", "", std::string(number.name), w.window.unit(), estimate.value,
                      estimate.lower, estimate.upper, used, dropped, w.remarks, method, used});
  }
  for (const parameters::Window& window : w.study.windows)
    if (window.name == w.window.name)
      for (const double threshold : window.thresholds) {
        const auto share = parameters::exceedance(w.y * kPa, w.study.design.latin, threshold, error);
        w.rows.push_back({w.window.name, "", "", "exceedance", "-", share.value, share.lower, share.upper,
                          used, dropped, w.remarks, method, used, threshold / kPa});
      }
  add_shapley_effects(w);
}

}  // namespace cpt::results
