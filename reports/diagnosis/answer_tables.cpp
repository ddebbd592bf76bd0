// Tables of what was found.
#include <fmt/format.h>

#include "diagnosis/prior_range.hpp"
#include "drawing/markdown.hpp"
#include "drawing/text.hpp"
#include "reports/diagnosis/errors.hpp"
#include "reports/diagnosis/tables.hpp"
#include "reports/diagnosis/words.hpp"

namespace cpt::reports::diagnosed {

using diagnosis::prior_deviation, diagnosis::prior_value;
using drawing::decimals, drawing::number, drawing::table_head, drawing::table_line;

std::string hypotheses_table(const DiagnosisInput& input) {
  const diagnosis::Verdict& verdict = input.diagnosis.verdict;
  std::string text = "### Hypotheses\n\n" + table_head({"hypothesis", "prior probability (-)",
                                                        "log evidence (-)", "probability (-)", ""});
  for (const Explanation explanation : verdict.by_probability()) {
    const diagnosis::Hypothesis& h = verdict.of(explanation);
    text += table_line({markdown(title_of(input, explanation)), number(h.prior, 2),
                        decimals(h.log_evidence, 2), probability(h.probability),
                        explanation == verdict.answer ? "the answer"
                        : verdict.in_set(explanation) ? "in the set of answers"
                                                      : ""});
  }
  return text + "\n";
}

std::string intervals_table(const DiagnosisInput& input) {
  const diagnosis::Location& location = input.diagnosis.location;
  std::string text = fmt::format(
      "### Mismatch intervals\n\nGreatest step statistic {}, threshold {} (family-wise level {}).\n\n",
      decimals(location.greatest, 1), decimals(location.threshold, 1), brief(input.options.locate.alpha));
  if (location.mismatches.empty()) return text + "None.\n\n";
  text += table_head({"sounding", "from (m)", "to (m)", "recorded over refitted (%)", "cell by cell (%)",
                      "recorded less refitted (kPa)", "step of the scan (%)", "statistic (-)", "p (-)"});
  for (const diagnosis::Mismatch& m : location.mismatches) {
    const diagnosis::Departure above = departure(input, m);
    text += table_line(
        {m.sounding < 0 ? "all" : markdown(input.soundings[static_cast<std::size_t>(m.sounding)].name),
         decimals(m.from, 3), decimals(m.to, 3), decimals(above.percent, 1),
         fmt::format("{} to {}", decimals(above.least, 0), decimals(above.greatest, 0)),
         brief(above.difference / 1e3), decimals(percent_of(m.size), 1), decimals(m.statistic, 1),
         m.p < 0.001 ? "< 0.001" : decimals(m.p, 3)});
  }
  return text +
         "\nRecorded over refitted: mean over the interval of what the figures show there, above (+) or "
         "below "
         "(−) the simulation with the study's parameters refitted. Step of the scan: what the statistic "
         "tests, "
         "a step that is missing beside whatever the parameters do with it; its sign may be another.\n\n";
}

std::string fitted_parameters_table(const DiagnosisInput& input) {
  if (input.mechanisms.empty()) return "";
  std::string text = "### Effects of the catalogue and their fitted parameters\n\n" +
                     table_head({"effect", "what to expect", "parameter", "range looked at",
                                 "mean ± standard deviation", "90 % interval", "best"});
  for (const std::size_t k : input.diagnosis.verdict.mechanisms_by_probability()) {
    const solver::Mechanism& mechanism = input.mechanisms[k];
    const diagnosis::MechanismEvidence& fit = input.diagnosis.mechanisms[k].evidence;
    for (std::size_t j = 0; j < mechanism.parameters.size(); ++j) {
      const solver::MechanismParameter& p = mechanism.parameters[j];
      const solver::Quantity& quantity = p.quantity;
      const auto i = static_cast<Index>(j);
      const auto value = [&](double phi) { return brief(prior_value(p, phi)); };
      const std::string unit = markdown(unit_after(quantity.unit));
      text += table_line(
          {j == 0 ? markdown(mechanism.title) : "", j == 0 ? markdown(mechanism.signature) : "",
           fmt::format("{} ({})", markdown_symbol(quantity.symbol), markdown(quantity.name)),
           fmt::format("{} to {}{}", brief(p.prior_lower), brief(p.prior_upper), unit),
           markdown(with_deviation(prior_value(p, fit.mean(i)),
                                   prior_deviation(p, fit.mean(i), fit.deviation(i)), quantity.unit)),
           fmt::format("{} to {}{}", value(fit.lower(i)), value(fit.upper(i)), unit),
           value(fit.mode(i)) + unit});
    }
  }
  return text + "\n";
}

std::string before_and_after_table(const DiagnosisInput& input) {
  const diagnosis::Diagnosis& d = input.diagnosis;
  const auto error = [](double ln) { return percent(percent_of(ln)); };
  std::string text = "### Before and after\n\n" + table_head({"curve", "RMSE of q<sub>c</sub>"});
  text += table_line({"simulation, baseline", error(rmse(input.recorded, input.baseline))});
  text += table_line({"study's parameters refitted", error(d.null.recalibrated.rmse)});
  if (d.best) {
    const std::string with = "with " + markdown(title_of(input, d.best->mechanism));
    text += table_line({with + " (emulator)", error(d.with_best().rmse)});
    if (const auto solver = solver_in_cells(input))
      text += table_line({with + " (full solver)", error(rmse(input.recorded, *solver))});
  }
  if (d.best && d.best->held_out) {
    const diagnosis::HeldOutGain& gain = *d.best->held_out;
    text += "\nOn depths held out of the fit:\n\n" +
            table_head({"", "study's parameters alone", "with the best effect"}) +
            table_line({"RMSE of q<sub>c</sub>", error(gain.rmse_null), error(gain.rmse)}) +
            table_line({"log score of all blocks (-)", "0 (reference)", decimals(gain.log_score, 2)}) +
            table_line({"gain in log score per cell (-)", "0 (reference)",
                        fmt::format("{} (90 % interval {} to {})", decimals(gain.per_cell, 3),
                                    decimals(gain.lower, 3), decimals(gain.upper, 3))});
  }
  return text + "\n";
}

std::string checks_table(const DiagnosisInput& input) {
  const diagnosis::Verdict& verdict = input.diagnosis.verdict;
  std::string text =
      fmt::format("### Predictive checks\n\nA hypothesis whose p is below {} is not the answer.\n\n",
                  brief(input.options.gate)) +
      table_head(
          {"hypothesis", "chi-square (-)", "its p (-)", "greatest step left (-)", "its p (-)", "p (-)"});
  const auto line = [&](const std::string& name, const diagnosis::PredictiveCheck& c) {
    text += table_line({markdown(name), decimals(c.chi_square, 1), decimals(c.chi_square_p, 3),
                        decimals(c.scan, 1), decimals(c.scan_p, 3), decimals(c.p, 3)});
  };
  line(diagnosis::nothing_is_missing, input.diagnosis.null.check);
  if (verdict.gate && verdict.winner.is_mechanism()) line(title_of(input, verdict.winner), *verdict.gate);
  return text + "\n";
}

std::string pairs_table(const DiagnosisInput& input) {
  if (input.diagnosis.pairs.empty()) return "";
  std::string text =
      "### Pairs of the best effects\n\n" + table_head({"first", "second", "log evidence (-)"});
  for (const diagnosis::PairEvidence& pair : input.diagnosis.pairs)
    text += table_line({markdown(title_of(input, pair.first)), markdown(title_of(input, pair.second)),
                        decimals(pair.log_evidence, 2)});
  return text + "\n";
}

std::string next_measurements_table(const DiagnosisInput& input) {
  if (input.diagnosis.next.empty()) return "";
  std::string text =
      fmt::format(
          "### Next measurement\n\nLeast distance between any two effects of the set, together with "
          "this recording; {} is wanted.\n\n",
          brief(input.options.indistinguishable)) +
      table_head({"measurement", "distance (standard deviations)"});
  for (const diagnosis::NextMeasurement& next : input.diagnosis.next)
    text += table_line({markdown(next.name), decimals(next.least_distance, 1)});
  return text + "\n";
}

}  // namespace cpt::reports::diagnosed
