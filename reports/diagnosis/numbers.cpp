#include "reports/diagnosis/numbers.hpp"

#include <nlohmann/json.hpp>

#include "diagnosis/prior_range.hpp"
#include "reports/diagnosis/answer.hpp"
#include "reports/diagnosis/errors.hpp"

namespace cpt::reports::diagnosed {
namespace {

using diagnosis::prior_deviation, diagnosis::prior_value;
using Json = nlohmann::ordered_json;

Json array(const VectorXd& v) { return std::vector<double>(v.data(), v.data() + v.size()); }

// A row for each mechanism: its distances from all, and last from the null.
Json of(const diagnosis::Isolability& isolability) {
  Json list = Json::array();
  for (Index i = 0; i < isolability.strength.size(); ++i) {
    list.push_back(array(isolability.between.row(i).transpose()));
    list.back().push_back(isolability.strength(i));
  }
  return list;
}

template <class Items, class ToJson>
Json list_of(const Items& items, const ToJson& to_json) {
  Json list = Json::array();
  for (const auto& item : items) list.push_back(to_json(item));
  return list;
}

Json of(const Curve& curve) { return {{"depth_m", curve.depth}, {"q_c_Pa", curve.q_c}}; }

Json of(const diagnosis::NoiseModel& n) {
  return {{"kernel", n.kernel == diagnosis::Kernel::ar1 ? "ar1" : "matern_32"},
          {"deviation_ln", n.deviation},
          {"length_m", n.length}};
}

Json of(const diagnosis::PredictiveCheck& c) {
  return {{"chi_square", c.chi_square},
          {"chi_square_p", c.chi_square_p},
          {"scan", c.scan},
          {"scan_p", c.scan_p},
          {"p", c.p}};
}

Json answer_part(const DiagnosisInput& input) {
  const Answer answer = answer_of(input);
  const diagnosis::Verdict& verdict = input.diagnosis.verdict;
  return {{"kind", name_of(answer.kind)},
          {"name", verdict.of(verdict.answer).name},
          {"winner_before_check", verdict.of(verdict.winner).name},
          {"set", list_of(verdict.set, [&](Explanation e) { return verdict.of(e).name; })},
          {"headline", answer.headline},
          {"reservations", answer.reservations},
          {"paragraphs", answer.paragraphs}};
}

Json mechanism_part(const DiagnosisInput& input, std::size_t k) {
  const solver::Mechanism& mechanism = input.mechanisms[k];
  const diagnosis::MechanismEvidence& fit = input.diagnosis.mechanisms[k].evidence;
  Json parameters = Json::array();
  for (std::size_t j = 0; j < mechanism.parameters.size(); ++j) {
    const solver::MechanismParameter& p = mechanism.parameters[j];
    const auto i = static_cast<Index>(j);
    parameters.push_back({{"name", p.quantity.name},
                          {"unit", p.quantity.unit},
                          {"range", {p.prior_lower, p.prior_upper}},
                          {"mean", prior_value(p, fit.mean(i))},
                          {"deviation", prior_deviation(p, fit.mean(i), fit.deviation(i))},
                          {"best", prior_value(p, fit.mode(i))},
                          {"interval_90", {prior_value(p, fit.lower(i)), prior_value(p, fit.upper(i))}},
                          {"phi_mean", fit.mean(i)},
                          {"phi_deviation", fit.deviation(i)},
                          {"phi_best", fit.mode(i)}});
  }
  return {{"name", mechanism.name},
          {"title", mechanism.title},
          {"signature", mechanism.signature},
          {"log_evidence", fit.log_evidence},
          {"parameters", std::move(parameters)}};
}

Json study_part(const DiagnosisInput& input, const diagnosis::Recalibration& fit) {
  Json list = Json::array();
  for (Index j = 0; j < fit.place.size(); ++j) {
    const StudyParameter& p = input.parameters[static_cast<std::size_t>(j)];
    list.push_back({{"name", p.quantity->name},
                    {"unit", p.quantity->unit},
                    {"bounds", {p.lower, p.upper}},
                    {"baseline", p.baseline},
                    {"place", fit.place(j)},
                    {"place_deviation", fit.deviation(j)},
                    {"value", study_value(p, fit.place(j))}});
  }
  return list;
}

Json cells_part(const DiagnosisInput& input) {
  const diagnosis::Diagnosis& d = input.diagnosis;
  const std::vector<diagnosis::Cell>& cells = d.compared.cells;
  Json all{{"sounding", list_of(cells, [](const auto& c) { return c.sounding; })},
           {"depth_m", list_of(cells, [](const auto& c) { return c.depth; })},
           {"height_m", list_of(cells, [](const auto& c) { return c.height; })},
           {"recorded_ln", array(input.recorded)},
           {"baseline_ln", array(input.baseline)},
           {"recalibrated_ln", array(d.null.recalibrated.curve)},
           {"with_best_ln", d.best ? array(d.with_best().curve) : Json::array()},
           {"noise_deviation_ln", array(noise_deviation(input))}};
  if (const auto solver = solver_in_cells(input)) all["solver_ln"] = array(*solver);
  return all;
}

Json errors_part(const DiagnosisInput& input) {
  const diagnosis::Diagnosis& d = input.diagnosis;
  Json all{{"baseline_ln", rmse(input.recorded, input.baseline)},
           {"recalibrated_ln", d.null.recalibrated.rmse}};
  if (d.best) all["with_best_ln"] = d.with_best().rmse;
  if (const auto solver = solver_in_cells(input)) all["solver_ln"] = rmse(input.recorded, *solver);
  return all;
}

Json held_out_part(const diagnosis::HeldOutGain& gain) {
  return {{"rmse_null_ln", gain.rmse_null},
          {"rmse_ln", gain.rmse},
          {"log_score_gain", gain.log_score},
          {"gain_per_cell", gain.per_cell},
          {"interval_90", {gain.lower, gain.upper}}};
}

Json mismatch(const DiagnosisInput& input, const diagnosis::Mismatch& m) {
  const diagnosis::Departure above = departure(input, m);
  return {{"sounding", m.sounding},
          {"from_m", m.from},
          {"to_m", m.to},
          {"above_refitted_percent", above.percent},
          {"above_refitted_least_percent", above.least},
          {"above_refitted_greatest_percent", above.greatest},
          {"above_refitted_Pa", above.difference},
          {"scan_step_ln", m.size},
          {"statistic", m.statistic},
          {"p", m.p}};
}

Json provenance_part(const Provenance& p) {
  return {{"program_version", p.program_version},
          {"solver_version", p.solver_version},
          {"seeds", p.seeds},
          {"files", list_of(p.files,
                            [](const SourceFile& f) {
                              return Json{{"what", f.what}, {"path", f.path}, {"sha256", f.sha256}};
                            })},
          {"solver_runs", p.solver_runs},
          {"wall_s", p.wall_s}};
}

}  // namespace

std::string diagnosis_json(const DiagnosisInput& input) {
  const diagnosis::Diagnosis& d = input.diagnosis;
  Json all;
  all["title"] = input.title;
  all["answer"] = answer_part(input);
  all["hypotheses"] = list_of(d.verdict.hypotheses, [](const diagnosis::Hypothesis& h) {
    return Json{{"name", h.name},
                {"prior", h.prior},
                {"log_evidence", h.log_evidence},
                {"probability", h.probability}};
  });
  all["location"] = {
      {"threshold", d.location.threshold},
      {"greatest", d.location.greatest},
      {"p", d.location.p},
      {"mismatches", list_of(d.location.mismatches, [&](const auto& m) { return mismatch(input, m); })}};
  all["mechanisms"] = Json::array();
  for (std::size_t k = 0; k < input.mechanisms.size(); ++k)
    all["mechanisms"].push_back(mechanism_part(input, k));
  all["best"] = d.best ? Json(d.verdict.of(d.best->mechanism).name) : Json();
  all["rmse"] = errors_part(input);
  all["held_out"] = d.best && d.best->held_out ? held_out_part(*d.best->held_out) : Json();
  all["null_check"] = of(d.null.check);
  all["gate"] = d.verdict.gate ? of(*d.verdict.gate) : Json();
  all["isolability"] = of(d.isolability);
  all["pairs"] = list_of(d.pairs, [](const diagnosis::PairEvidence& p) {
    return Json{{"first", p.first},
                {"second", p.second},
                {"log_evidence", p.log_evidence},
                {"first_phi_best", array(p.first_mode)},
                {"second_phi_best", array(p.second_mode)}};
  });
  all["next_measurements"] = list_of(d.next, [](const diagnosis::NextMeasurement& n) {
    return Json{{"name", n.name}, {"least_distance", n.least_distance}};
  });
  all["prior_widths"] = list_of(d.variations, [](const diagnosis::PriorVariation& v) {
    return Json{{"what", v.what}, {"answer", v.answer}, {"changed", v.changed}};
  });
  all["study_parameters"] = study_part(input, d.null.recalibrated);
  all["study_parameters_with_best"] = d.best ? study_part(input, d.with_best()) : Json::array();
  const auto& numerical = d.compared.numerical;
  all["noise"] = {{"measurement", of(d.compared.measurement)},
                  {"measurement_given", input.noise.measurement_given},
                  {"numerical", numerical ? of(numerical->target) : Json()},
                  {"numerical_weight", numerical ? Json(numerical->weight) : Json()},
                  {"numerical_shares", input.noise.numerical_shares},
                  {"repeats", input.noise.repeats},
                  {"joint_runs", input.noise.joint_runs}};
  all["options"] = {
      {"alpha", input.options.locate.alpha}, {"alarm", input.options.alarm},
      {"gate", input.options.gate},          {"indistinguishable", input.options.indistinguishable},
      {"credible", input.options.credible},  {"seed", input.options.seed}};
  all["cells"] = cells_part(input);
  all["soundings"] = list_of(input.soundings, [](const Sounding& s) {
    return Json{{"name", s.name},
                {"recorded", of(s.recorded)},
                {"baseline", of(s.baseline)},
                {"solver", s.solver ? of(*s.solver) : Json()}};
  });
  all["provenance"] = provenance_part(input.provenance);
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace cpt::reports::diagnosed
