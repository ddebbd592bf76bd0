#include "diagnosis/fitted.hpp"

#include <fmt/format.h>

#include <cmath>

namespace cpt::diagnosis {
namespace {

using parameters::Change;

// The study's parameters at their places between the bounds, those that are uncertain in this sounding.
std::vector<Change> changes_at(const VectorXd& place, const Problem& problem,
                               const parameters::Study& study) {
  std::vector<Change> changes;
  for (Index j = 0; j < place.size(); ++j)
    for (const parameters::Row& row : study.rows) {
      if (row.quantity->name != problem.parameters[static_cast<std::size_t>(j)].name) continue;
      double value = row.lower + place(j) * (row.upper - row.lower);
      if (!row.quantity->choices.empty() || row.quantity->integer) value = std::round(value);
      changes.push_back({row.quantity, value});
    }
  return changes;
}

}  // namespace

parameters::Study fitted_study(const Request& request, const SoundingStudy& sounding, std::size_t index,
                               const std::vector<MechanismDesign>& mechanisms, const Problem& problem,
                               const Diagnosis& diagnosis) {
  parameters::Study study = sounding.study;
  const std::string suffix = index == 0 ? "" : fmt::format("-{}", index + 1);
  const std::filesystem::path folder = request.database.parent_path();
  study.name = request.name + suffix;
  study.title = request.title;
  study.database = folder / (study.name + ".sqlite");
  study.curves = folder / (study.name + ".h5");
  study.report_dir = request.report_dir;
  study.points = {{recalibrated_point, changes_at(diagnosis.recalibrated.place, problem, study)}};
  if (diagnosis.best) {
    parameters::DesignPoint fitted{fitted_point, changes_at(diagnosis.with_best.place, problem, study)};
    const MechanismDesign& design = mechanisms[*diagnosis.best];
    const VectorXd& mode = diagnosis.mechanisms[*diagnosis.best].mode;
    for (std::size_t j = 0; j < design.mechanism->parameters.size(); ++j) {
      const solver::MechanismParameter& parameter = design.mechanism->parameters[j];
      double value = parameter.prior_lower;
      for (std::size_t v = 0; v < design.varied.size(); ++v)
        if (design.varied[v] == j) value = prior_value(parameter, mode(static_cast<Index>(v)));
      fitted.changes.push_back({&parameter.quantity, value});
    }
    study.points.push_back(std::move(fitted));
  }
  if (study.points.front().changes.empty()) study.points.erase(study.points.begin());
  study.rows.clear();
  return study;
}

}  // namespace cpt::diagnosis
