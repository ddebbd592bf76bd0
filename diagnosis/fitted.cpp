#include "diagnosis/fitted.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>

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

// In all soundings end to end, on the problem's cells; nothing if a run is missing.
std::optional<VectorXd> run_of(const std::string& point, const Request& request,
                               const std::vector<SoundingData>& soundings,
                               const std::vector<results::Snapshot>& fitted) {
  std::vector<VectorXd> parts;
  for (std::size_t s = 0; s < soundings.size(); ++s) {
    const results::CurveRow* curve = nullptr;
    for (const results::RealizationRow& row : fitted[s].realizations)
      for (const results::CurveRow& candidate : fitted[s].curves)
        if (row.parameter == point && row.completed() && candidate.realization == row.id) curve = &candidate;
    if (curve == nullptr) return std::nullopt;
    parts.push_back(log_cell_means(grid_of(soundings[s].request, request.cell_height), curve->profile.depth,
                                   curve->profile.q_c));
  }
  return concatenate(parts);
}

}  // namespace

std::string fitted_point(const std::string& mechanism) { return "fitted " + mechanism; }

std::vector<std::size_t> finalists(const Diagnosis& diagnosis, int most) {
  std::vector<std::size_t> chosen;
  const std::size_t nothing = diagnosis.mechanisms.size();
  if (diagnosis.answer == nothing) return chosen;
  for (const std::size_t k : diagnosis.set)
    if (k < nothing && static_cast<int>(chosen.size()) < most) chosen.push_back(k);
  if (chosen.empty() && diagnosis.best && most > 0) chosen.push_back(*diagnosis.best);
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
  if (request.confirm > 0 && !soil_at(diagnosis.recalibrated.place).empty())
    study.points.push_back({recalibrated_point, soil_at(diagnosis.recalibrated.place)});
  for (const std::size_t k : finalists(diagnosis, request.confirm)) {
    const MechanismDesign& design = assembled.mechanisms[k];
    parameters::DesignPoint fitted{fitted_point(std::string(design.mechanism->name)),
                                   soil_at(diagnosis.with[k].place)};
    for (const Change& change : mechanism_changes(design, diagnosis.mechanisms[k].mode))
      fitted.changes.push_back(change);
    study.points.push_back(std::move(fitted));
  }
  study.rows.clear();
  return study;
}

VectorXd expected_error(const VectorXd& off, const MatrixXd& error, const MatrixXd& noise) {
  return error * Eigen::LDLT<MatrixXd>(error + noise).solve(off);
}

bool correct(Problem& problem, const Request& request, const std::vector<SoundingData>& soundings,
             const std::vector<results::Snapshot>& fitted, const Diagnosis& diagnosis) {
  bool any = false;
  const Prepared prepared = prepare(problem);
  const auto n = static_cast<Index>(diagnosis.rows.size());
  const MatrixXd noise =
      prepared.numerical ? prepared.numerical->covariance : MatrixXd(1e-12 * MatrixXd::Identity(n, n));
  const MatrixXd adding_up = low_rank_plus_diagonal(prepared.problem.joint_residuals);
  for (const std::size_t k : finalists(diagnosis, request.confirm)) {
    MechanismEffect& effect = problem.mechanisms[k];
    const auto run = run_of(fitted_point(effect.name), request, soundings, fitted);
    if (!run) continue;
    effect.correction = VectorXd::Constant(problem.recorded.size(), std::numeric_limits<double>::quiet_NaN());
    const VectorXd off = VectorXd((*run)(diagnosis.rows)) - diagnosis.with[k].curve;
    effect.correction(diagnosis.rows) = expected_error(
        off, adding_up + prepared.emulators[k].covariance(diagnosis.mechanisms[k].mode), noise);
    any = true;
  }
  return any;
}

}  // namespace cpt::diagnosis
