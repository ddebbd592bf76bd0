#include "parameters/designs/design.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>

#include "parameters/all_realizations.hpp"
#include "parameters/designs/latin_hypercube.hpp"
#include "parameters/designs/morris.hpp"
#include "parameters/designs/pairs.hpp"
#include "parameters/designs/sobol.hpp"

namespace cpt::parameters {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Kind = Design::Kind;

constexpr std::array<std::string_view, 5> kind_names = {"one_at_a_time", "pairs", "morris", "latin_hypercube",
                                                        "sobol"};

MatrixXd places_of(const Design& design) {
  const auto parameters = static_cast<int>(design.rows.size());
  switch (design.kind) {
    case Kind::one_at_a_time:
      break;
    case Kind::pairs:
      return pairs_places(parameters);
    case Kind::morris:
      return morris_places(parameters, design.trajectories, design.levels, design.seed);
    case Kind::latin_hypercube:
      if (design.first_runs == 0) return latin_hypercube_places(parameters, design.runs, design.seed);
      return grown_latin_hypercube_places(parameters, design.first_runs, design.runs, design.seed);
    case Kind::sobol:
      return sobol_places(parameters, design.runs, design.seed);
  }
  return MatrixXd(0, parameters);
}

std::string run_name(const Design& design, Index run) {
  const auto group = [&](Index size) { return run / size + 1; };
  const auto member = [&](Index size) { return run % size + 1; };
  const auto parameters = static_cast<Index>(design.rows.size());
  if (design.kind == Kind::pairs) return fmt::format("pairs {}.{}", group(4), member(4));
  if (design.kind == Kind::morris)
    return fmt::format("morris {}.{}", group(parameters + 1), member(parameters + 1));
  if (design.kind == Kind::latin_hypercube) return fmt::format("latin hypercube {}", run + 1);
  const Index column = member(parameters + 2);
  const std::string matrix = column == 1 ? "A" : column == 2 ? "B" : fmt::format("{}", column - 2);
  return fmt::format("sobol {}.{}", group(parameters + 2), matrix);
}

DesignPoint point_of(const Study& study, const MatrixXd& places, Index run) {
  DesignPoint point{run_name(study.design, run), {}};
  for (Index j = 0; j < places.cols(); ++j) {
    const Row& row = study.rows[study.design.rows[static_cast<std::size_t>(j)]];
    if (!std::isnan(places(run, j))) point.changes.push_back({row.quantity, value_at(row, places(run, j))});
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

std::span<const std::string_view> design_kinds() { return kind_names; }

std::string_view to_string(Kind kind) { return kind_names[static_cast<std::size_t>(kind)]; }

long run_count(const Design& design) {
  const auto parameters = static_cast<long>(design.rows.size());
  switch (design.kind) {
    case Kind::one_at_a_time:
      return 0;
    case Kind::pairs:
      return 2 * parameters * (parameters - 1);
    case Kind::morris:
      return design.trajectories * (parameters + 1);
    case Kind::latin_hypercube:
      return design.runs;
    case Kind::sobol:
      return design.runs * (parameters + 2);
  }
  return 0;
}

MatrixXd design_places(const Study& study) {
  MatrixXd places = places_of(study.design);
  for (Index j = 0; j < places.cols(); ++j) {
    const Row& row = study.rows[study.design.rows[static_cast<std::size_t>(j)]];
    for (double& place : places.col(j))
      if (values_of(row) > 0 && !std::isnan(place))
        place = (value_at(row, place) - row.lower) / (row.upper - row.lower);
  }
  return places;
}

int values_of(const Row& row) {
  if (!row.quantity->choices.empty()) return 2;
  return row.quantity->integer ? static_cast<int>(std::lround(row.upper - row.lower)) + 1 : 0;
}

double value_at(const Row& row, double place) {
  if (!row.quantity->choices.empty()) return place < 0.5 ? row.lower : row.upper;
  const double value = std::lerp(row.lower, row.upper, place);
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
