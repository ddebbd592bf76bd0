#include "cli/diagnose/diagnosis_input.hpp"

#include "diagnosis/fitted.hpp"
#include "results/ledger/provenance.hpp"

namespace cpt::cli {
namespace {

using namespace diagnosis;
namespace page = reports::diagnosed;

page::Curve curve_of(const results::Snapshot& campaign, int id) {
  for (const results::CurveRow& curve : campaign.curves)
    if (curve.realization == id) return {curve.profile.depth, curve.profile.q_c};
  return {};
}

std::optional<page::Curve> fitted_curve(const results::Snapshot& campaign, const std::string& mechanism) {
  for (const results::RealizationRow& row : campaign.realizations)
    if (row.parameter == fitted_point(mechanism) && row.completed()) return curve_of(campaign, row.id);
  return std::nullopt;
}

// With those parameters alone that are varied.
solver::Mechanism varied(const MechanismDesign& design) {
  solver::Mechanism mechanism = design.mechanism;
  mechanism.parameters.clear();
  for (const std::size_t parameter : design.varied)
    mechanism.parameters.push_back(design.mechanism.parameters[parameter]);
  return mechanism;
}

}  // namespace

page::DiagnosisInput diagnosis_input(const Request& request, const std::vector<SoundingData>& soundings,
                                     const Assembled& assembled, const Options& options,
                                     const Diagnosis& diagnosis,
                                     const std::vector<results::Snapshot>& fitted) {
  page::DiagnosisInput input;
  input.name = request.name;
  input.title = request.title;
  input.options = options;
  input.diagnosis = diagnosis;
  input.recorded = assembled.problem.recorded(diagnosis.compared.rows);
  input.baseline = assembled.problem.baseline(diagnosis.compared.rows);
  input.noise = {request.measurement > 0.0, static_cast<int>(assembled.problem.repeats.cols()),
                 assembled.problem.numerical_shares, static_cast<int>(assembled.problem.joint.curves.cols())};
  for (const MechanismDesign& design : assembled.mechanisms) input.mechanisms.push_back(varied(design));
  for (const ParameterEffect& effect : assembled.problem.parameters)
    for (const parameters::Row& row : soundings.front().study.study.rows)
      if (row.quantity->name == effect.name)
        input.parameters.push_back({row.quantity, row.baseline, row.lower, row.upper});

  page::Provenance& provenance = input.provenance;
  provenance.program_version = results::program_version();
  provenance.solver_version = std::string(solver::solver_version());
  provenance.seeds = {request.seed};
  provenance.files = {{"request", request.file.filename().string(), ""},
                      {"study", request.study.filename().string(), ""}};
  for (std::size_t s = 0; s < soundings.size(); ++s) {
    const SoundingData& data = soundings[s];
    page::Sounding sounding;
    sounding.name = data.request.name;
    for (const recordings::Reading& reading : data.recording.readings) {
      sounding.recorded.depth.push_back(reading.depth);
      sounding.recorded.q_c.push_back(reading.q_c);
    }
    sounding.baseline = curve_of(data.campaign, 1);
    if (diagnosis.best)
      sounding.solver =
          fitted_curve(fitted[s], diagnosis.mechanisms[diagnosis.best->mechanism].evidence.name);
    input.soundings.push_back(std::move(sounding));
    provenance.files.push_back({"recording", data.request.recording.filename().string(), ""});
    for (const results::RealizationRow& row : data.campaign.realizations) {
      ++provenance.solver_runs;
      provenance.wall_s += row.wall_s;
    }
  }
  return input;
}

}  // namespace cpt::cli
