#include "results/statistics/propagation_convergence.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "parameters/designs/propagation.hpp"

namespace cpt::results {
namespace {

using Eigen::VectorXd;

constexpr int most_numbers = 40;
constexpr std::array<std::pair<std::string_view, double>, 2> quantiles = {
    {{"quantile_05", 0.05}, {"quantile_95", 0.95}}};

}  // namespace

void add_convergence(const WindowEffects& w, std::vector<ConvergenceRow>& rows) {
  const auto waits = [](const RealizationRow* run) { return run == nullptr || !run->ended(); };
  const auto ended = static_cast<int>(std::ranges::find_if(w.runs, waits) - w.runs.begin());
  const int step = parameters::look_interval *
                   std::max(1, (ended / parameters::look_interval + most_numbers - 1) / most_numbers);
  const bool latin = w.study.design.latin;
  const double error = w.study.design.numerical_error.front();
  for (int runs = step; runs <= ended; runs += step) {
    const VectorXd y = w.y.head(runs);
    rows.push_back({w.window.name, "mean", runs,
                    parameters::by_sections(
                        y, 1, [](const VectorXd& of) { return of.mean(); }, latin)});
    for (const auto& [name, probability] : quantiles)
      rows.push_back(
          {w.window.name, std::string(name), runs,
           parameters::by_sections(
               y, 2,
               [=, p = probability](const VectorXd& of) { return parameters::sample_quantile(of, p, error); },
               latin)});
  }
}

}  // namespace cpt::results
