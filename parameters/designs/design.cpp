#include "parameters/designs/design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

#include "parameters/all_realizations.hpp"
#include "parameters/designs/latin_hypercube.hpp"
#include "parameters/designs/morris.hpp"
#include "parameters/designs/pairs.hpp"
#include "parameters/designs/propagation.hpp"
#include "parameters/designs/sobol.hpp"
#include "parameters/distributions/copula.hpp"

namespace cpt::parameters {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

DesignKind one_at_a_time_design() {
  return {.name = "one_at_a_time", .run_count = [](const Design&) { return 0L; }};
}

bool is_drawn(const DesignKind& kind, const Row& row) { return kind.samples && row.marginal != nullptr; }

DesignPoint point_of(const Study& study, const MatrixXd& places, Index run) {
  const DesignKind& kind = design_named(study.design.kind);
  DesignPoint point{kind.run_name(study.design, run), {}};
  for (Index j = 0; j < places.cols(); ++j) {
    const Row& row = study.rows[study.design.rows[static_cast<std::size_t>(j)]];
    const double place = places(run, j);
    if (std::isnan(place)) continue;
    point.changes.push_back(
        {row.quantity, is_drawn(kind, row) ? value_of_probability(row, place) : value_at(row, place)});
  }
  return point;
}

std::string settings_of(const Study& study, const DesignPoint& point) {
  solver::Setup setup = study.baseline;
  for (const Change& change : point.changes) change.quantity->set_value(setup, change.value);
  return solver::canonical_text(setup);
}

// Index of the first realization with these settings.
std::map<std::string, std::size_t> by_settings(const Study& study,
                                               std::span<const Realization> realizations) {
  std::map<std::string, std::size_t> found;
  for (std::size_t i = 0; i < realizations.size(); ++i)
    found.try_emplace(settings_text(study, realizations[i]), i);
  return found;
}

}  // namespace

std::span<const DesignKind> all_designs() {
  static const std::vector<DesignKind> list = {
      one_at_a_time_design(),   pairs_design(), morris_design(),
      latin_hypercube_design(), sobol_design(), propagation_design(),
  };
  return list;
}

std::vector<std::string_view> design_kinds() {
  std::vector<std::string_view> names;
  for (const DesignKind& kind : all_designs()) names.push_back(kind.name);
  return names;
}

const DesignKind& design_named(std::string_view name) {
  for (const DesignKind& kind : all_designs())
    if (kind.name == name) return kind;
  throw std::out_of_range("no design " + std::string(name));
}

std::string name_in_group(std::string_view kind, Index run, Index size) {
  return fmt::format("{} {}.{}", kind, run / size + 1, run % size + 1);
}

long run_count(const Design& design) { return design_named(design.kind).run_count(design); }

MatrixXd design_places(const Study& study) {
  const DesignKind& kind = design_named(study.design.kind);
  if (kind.places == nullptr) return MatrixXd(0, width_of(study.design));
  MatrixXd places = kind.places(study.design);
  if (!study.correlations.empty())
    places = dependent_places(places, score_correlations(study.correlations, study.design));
  for (Index j = 0; j < places.cols(); ++j) {
    const Row& row = study.rows[study.design.rows[static_cast<std::size_t>(j)]];
    for (double& place : places.col(j))
      if (values_of(row) > 0 && !std::isnan(place) && !is_drawn(kind, row))
        place = (value_at(row, place) - row.lower) / (row.upper - row.lower);
  }
  return places;
}

MatrixXd score_correlations(const std::vector<RankCorrelation>& pairs, const Design& design) {
  const Index width = width_of(design);
  MatrixXd scores = MatrixXd::Identity(width, width);
  const auto place = [&](std::size_t row) {
    return std::ranges::find(design.rows, row) - design.rows.begin();
  };
  for (const RankCorrelation& pair : pairs) {
    const Index a = place(pair.first), b = place(pair.second);
    scores(a, b) = scores(b, a) = score_correlation(pair.rho);
  }
  return scores;
}

int values_of(const Row& row) {
  if (!row.quantity->choices.empty()) return 2;
  return row.quantity->integer ? static_cast<int>(std::lround(row.upper - row.lower)) + 1 : 0;
}

// Not the diagnosis's row_value: that has other bits where the bounds are of opposite sign, and runs that are
// stored keep those they were made with.
double value_at(const Row& row, double place) {
  if (!row.quantity->choices.empty()) return place < 0.5 ? row.lower : row.upper;
  const double value = std::lerp(row.lower, row.upper, place);
  return row.quantity->integer ? std::round(value) : value;
}

double value_of_probability(const Row& row, double probability) {
  if (row.marginal == nullptr) return value_at(row, probability);
  // Where the normal score of a probability would be infinite, as little inside.
  constexpr double edge = 1e-12;
  const double value = row.marginal->quantile(std::clamp(probability, edge, 1.0 - edge));
  return row.quantity->integer ? std::round(value) : value;
}

std::vector<DesignPoint> design_points(const Study& study) {
  const MatrixXd places = design_places(study);
  std::vector<DesignPoint> points;
  if (places.rows() == 0) return points;
  auto known = by_settings(study, all_realizations(study));
  for (Index run = 0; run < places.rows(); ++run) {
    DesignPoint point = point_of(study, places, run);
    if (known.try_emplace(settings_of(study, point), 0).second) points.push_back(std::move(point));
  }
  return points;
}

std::vector<std::size_t> design_realizations(const Study& study, std::span<const Realization> realizations) {
  const MatrixXd places = design_places(study);
  const auto known = by_settings(study, realizations);
  std::vector<std::size_t> found;
  for (Index run = 0; run < places.rows(); ++run)
    found.push_back(known.at(settings_of(study, point_of(study, places, run))));
  return found;
}

}  // namespace cpt::parameters
