#include "diagnosis/design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/prior_range.hpp"

namespace cpt::diagnosis {
namespace {

using parameters::DesignPoint;

constexpr int joint_runs_of_mechanism = 3;

// Point k of the additive recurrence with the generalized golden ratio (Roberts 2018): fills the unit cube
// evenly for any number of points.
VectorXd quasi_random(int k, Index dimensions) {
  double ratio = 1.5;
  for (int i = 0; i < 60; ++i) ratio = std::pow(1.0 + ratio, 1.0 / static_cast<double>(dimensions + 1));
  VectorXd u(dimensions);
  double step = 1.0;
  for (Index j = 0; j < dimensions; ++j) {
    step /= ratio;
    const double x = 0.5 + (k + 1) * step;
    u(j) = x - std::floor(x);
  }
  return u;
}

// The baseline with material points, mesh and time step slightly otherwise: nothing that a user would notice.
DesignPoint repeat(const solver::Setup& baseline, int k) {
  const VectorXd u = quasi_random(k, 3);
  const auto set = [&](std::string_view name, double si) {
    const solver::Quantity* quantity = solver::find_quantity(name);
    return parameters::Change{quantity, si / quantity->scale};
  };
  return {fmt::format("repeat {}", k + 1),
          {set("numerics.point_shift", 0.8 * u(0) - 0.4),
           set("numerics.courant", baseline.numerics.courant * (0.8 + 0.2 * u(1))),
           set("numerics.near_height_m", baseline.numerics.near_height * (1.0 + 0.06 * u(2)))}};
}

// Places of a mechanism of the reading, ends included: its curves cost no run.
MechanismDesign reading_design(const solver::Mechanism& mechanism, std::size_t joints) {
  constexpr Index places = 21;
  MechanismDesign design{mechanism, {0}, VectorXd::LinSpaced(places, 0.0, 1.0), 0, {}};
  design.joint_unit.resize(static_cast<Index>(joints), 1);
  for (std::size_t k = 0; k < joints; ++k)
    design.joint_unit.row(static_cast<Index>(k)) = quasi_random(static_cast<int>(k), 1).transpose();
  return design;
}

// The mechanism's parameters alone.
MechanismDesign design_of(const solver::Mechanism& mechanism, std::vector<DesignPoint>& points) {
  MechanismDesign design{mechanism, varied_parameters(mechanism), {}, points.size(), {}};
  const auto dimensions = static_cast<Index>(design.varied.size());
  const int runs = dimensions == 1 ? 5 : dimensions == 2 ? 9 : 14;
  design.unit.resize(runs, dimensions);
  // Along one axis in equal steps up to the strongest, or around no strength without a run there.
  constexpr double two_sided[] = {0.0, 0.22, 0.44, 0.72, 1.0};
  const bool one_sided = mechanism.parameters.front().prior_lower == 0.0;
  for (int k = 0; k < runs; ++k) {
    VectorXd u = quasi_random(k, dimensions);
    if (dimensions == 1) u(0) = one_sided ? (k + 1.0) / runs : two_sided[k];
    design.unit.row(k) = u.transpose();
    points.push_back({fmt::format("{} {}", mechanism.name, k + 1), mechanism_changes(mechanism, u)});
  }
  return design;
}

// The mechanism's parameters and the soil's together. The recurrence goes on from one mechanism to the next,
// so that each sees other soil.
void add_joint(MechanismDesign& design, int runs, const std::vector<parameters::Row>& rows,
               const std::vector<parameters::Change>& known, int first, std::vector<DesignPoint>& points) {
  const auto dimensions = static_cast<Index>(design.varied.size());
  design.first_joint = points.size();
  design.joint_unit.resize(runs, dimensions);
  const bool one_sided = design.mechanism.parameters.front().prior_lower == 0.0;
  for (int k = 0; k < runs; ++k) {
    VectorXd u = quasi_random(first + k, dimensions);
    if (one_sided) u(0) = 0.5 * (1.0 + u(0));  // at little strength there is little to see
    design.joint_unit.row(k) = u.transpose();
    DesignPoint point{fmt::format("{} joint {}", design.mechanism.name, k + 1),
                      mechanism_changes(design.mechanism, u)};
    const VectorXd place = quasi_random(first + k, static_cast<Index>(rows.size()));
    for (const parameters::Change& change : row_changes(rows, place, known)) point.changes.push_back(change);
    points.push_back(std::move(point));
  }
}

}  // namespace

std::vector<parameters::Change> mechanism_changes(const solver::Mechanism& mechanism, const VectorXd& phi) {
  std::vector<parameters::Change> changes;
  for (const std::size_t varied : varied_parameters(mechanism)) {
    const solver::MechanismParameter& parameter = mechanism.parameters[varied];
    // The list's own quantity, which outlives the mechanism.
    changes.push_back({solver::find_quantity(parameter.quantity.name),
                       prior_value(parameter, phi(static_cast<Index>(changes.size())))});
  }
  return changes;
}

// All rows have places, so that a sounding where one of them is known has the others alike.
std::vector<parameters::Change> row_changes(const std::vector<parameters::Row>& rows, const VectorXd& places,
                                            const std::vector<parameters::Change>& known) {
  std::vector<parameters::Change> changes;
  for (std::size_t j = 0; j < rows.size(); ++j)
    if (std::ranges::find(known, rows[j].quantity, &parameters::Change::quantity) == known.end())
      changes.push_back({rows[j].quantity, row_value(rows[j], places(static_cast<Index>(j)))});
  return changes;
}

SoundingStudy sounding_study(const parameters::Study& study, const SoundingRequest& sounding,
                             const std::vector<solver::Mechanism>& mechanisms, int repeats, int joints) {
  SoundingStudy made{study, {}};
  parameters::Study& own = made.study;
  std::string suffix = "-diagnosis";
  own.correlations.clear();
  for (const parameters::Change& change : sounding.changes) {
    change.quantity->set_value(own.baseline, change.value);
    // What is known is no longer uncertain.
    std::erase_if(own.rows, [&](const parameters::Row& row) { return row.quantity == change.quantity; });
    suffix += fmt::format("-{}-{}", change.quantity->name, change.quantity->format(change.value));
  }
  const auto place = [&](std::size_t row) {
    return static_cast<std::size_t>(
        std::ranges::find(own.rows, study.rows[row].quantity, &parameters::Row::quantity) - own.rows.begin());
  };
  for (const parameters::RankCorrelation& pair : study.correlations)
    if (std::max(place(pair.first), place(pair.second)) < own.rows.size())
      own.correlations.push_back({place(pair.first), place(pair.second), pair.rho});
  own.name = study.name + suffix;
  own.title = study.title + ", runs for a diagnosis";
  const std::filesystem::path folder = study.database.parent_path();
  own.database = folder / (own.name + ".sqlite");
  own.curves = folder / (own.name + ".h5");
  own.report_dir = folder / (own.name + "-report");
  own.points.clear();
  own.design = {};

  Design& design = made.design;
  design.first_repeat = 0;
  design.repeats = static_cast<std::size_t>(repeats);
  for (int k = 0; k < repeats; ++k) own.points.push_back(repeat(own.baseline, k));
  design.first_joint = own.points.size();
  design.joint = own.rows.empty() ? 0 : static_cast<std::size_t>(joints);
  for (std::size_t k = 0; k < design.joint; ++k)
    own.points.push_back(
        {fmt::format("joint {}", k + 1),
         row_changes(study.rows, quasi_random(static_cast<int>(k), static_cast<Index>(study.rows.size())),
                     sounding.changes)});
  int drawn = joints;
  for (const solver::Mechanism& mechanism : mechanisms) {
    if (mechanism.of_reading) {
      design.mechanisms.push_back(reading_design(mechanism, design.joint));
      continue;
    }
    design.mechanisms.push_back(design_of(mechanism, own.points));
    if (design.joint == 0) continue;
    add_joint(design.mechanisms.back(), joint_runs_of_mechanism, study.rows, sounding.changes, drawn,
              own.points);
    drawn += joint_runs_of_mechanism;
  }
  // What is known holds in every run: a first push has no previous one, whatever the mechanisms' runs say.
  for (DesignPoint& point : own.points)
    std::erase_if(point.changes, [&](const parameters::Change& change) {
      return std::ranges::any_of(
          sounding.changes, [&](const auto& known) { return known.quantity->name == change.quantity->name; });
    });
  return made;
}

}  // namespace cpt::diagnosis
