#include "diagnosis/fitted.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "diagnosis/prior_range.hpp"

namespace cpt::diagnosis {
namespace {

using parameters::Change;

// The study's parameters at their places between the bounds, those that are uncertain in this sounding.
std::vector<Change> changes_at(const VectorXd& place, const Problem& problem,
                               const parameters::Study& study) {
  std::vector<Change> changes;
  for (Index j = 0; j < place.size(); ++j)
    for (const parameters::Row& row : study.rows)
      if (row.quantity->name == problem.parameters[static_cast<std::size_t>(j)].name)
        changes.push_back({row.quantity, row_value(row, place(j))});
  return changes;
}

}  // namespace

std::string fitted_point(const std::string& mechanism) { return "fitted " + mechanism; }

std::vector<std::size_t> finalists(const Diagnosis& diagnosis, int most) {
  if (diagnosis.verdict.answer.is_nothing()) return {};
  std::vector<std::size_t> chosen = diagnosis.verdict.mechanisms_in_set();
  if (chosen.empty() && diagnosis.best) chosen.push_back(diagnosis.best->mechanism);
  chosen.resize(std::min(chosen.size(), static_cast<std::size_t>(most)));
  return chosen;
}

parameters::Study fitted_study(const Request& request, const SoundingStudy& sounding, std::size_t index,
                               const Assembled& assembled, const Diagnosis& diagnosis) {
  parameters::Study study = sounding.study;
  const std::string suffix = index == 0 ? "" : fmt::format("-{}", index + 1);
  const std::filesystem::path folder = request.database.parent_path();
  study.name = request.name + suffix;
  study.title = request.title;
  study.database = folder / (study.name + ".sqlite");
  study.curves = folder / (study.name + ".h5");
  study.report_dir = request.report_dir;
  study.points.clear();
  study.design = {};
  const auto soil_at = [&](const VectorXd& place) { return changes_at(place, assembled.problem, study); };
  const VectorXd& refitted = diagnosis.null.recalibrated.place;
  if (request.confirm > 0 && !soil_at(refitted).empty())
    study.points.push_back({recalibrated_point, soil_at(refitted)});
  for (const std::size_t k : finalists(diagnosis, request.confirm)) {
    const MechanismDesign& design = assembled.mechanisms[k];
    const MechanismFit& fit = diagnosis.mechanisms[k];
    parameters::DesignPoint fitted{fitted_point(std::string(design.mechanism.name)),
                                   soil_at(fit.recalibrated.place)};
    for (const Change& change : mechanism_changes(design.mechanism, fit.evidence.mode))
      if (std::ranges::none_of(request.soundings[index].changes, [&](const Change& known) {
            return known.quantity->name == change.quantity->name;
          }))
        fitted.changes.push_back(change);
    study.points.push_back(std::move(fitted));
  }
  study.rows.clear();
  return study;
}

}  // namespace cpt::diagnosis
