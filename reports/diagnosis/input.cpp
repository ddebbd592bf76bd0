#include "reports/diagnosis/input.hpp"

#include <algorithm>
#include <stdexcept>

#include "reports/diagnosis/words.hpp"

namespace cpt::reports::diagnosed {
namespace {

void want(bool good, const std::string& problem) {
  if (!good) throw std::invalid_argument("diagnosis report: " + problem);
}

void check_mechanisms(const DiagnosisInput& input) {
  const diagnosis::Diagnosis& d = input.diagnosis;
  want(input.mechanisms.size() == d.mechanisms.size(), "another number of mechanisms than were diagnosed");
  for (std::size_t k = 0; k < d.mechanisms.size(); ++k) {
    const diagnosis::MechanismEvidence& fit = d.mechanisms[k].evidence;
    want(input.mechanisms[k].name == fit.name, "mechanism " + fit.name + " is in another order");
    const auto dimensions = static_cast<Index>(input.mechanisms[k].parameters.size());
    for (const VectorXd* v : {&fit.mean, &fit.deviation, &fit.mode, &fit.lower, &fit.upper})
      want(v->size() == dimensions, "mechanism " + fit.name + " has another number of parameters");
  }
  const auto k = static_cast<Index>(d.mechanisms.size());
  want(d.isolability.between.rows() == k && d.isolability.between.cols() == k &&
           d.isolability.strength.size() == k,
       "the isolability matrix has another size");
  want(!d.best || d.best->mechanism < d.mechanisms.size(), "the best mechanism is none of the catalogue");
}

void check_verdict(const DiagnosisInput& input) {
  const diagnosis::Verdict& verdict = input.diagnosis.verdict;
  const auto weighed = [&](Explanation explanation) {
    return std::ranges::count(verdict.hypotheses, explanation, &diagnosis::Hypothesis::explanation) == 1;
  };
  want(weighed(Explanation::nothing()) && weighed(Explanation::unknown()),
       "that nothing is missing, or that none of these is, was not weighed");
  for (std::size_t k = 0; k < input.mechanisms.size(); ++k)
    want(weighed(k) && verdict.of(k).name == input.mechanisms[k].name,
         "mechanism " + std::string(input.mechanisms[k].name) + " was not weighed");
  want(weighed(verdict.winner) && weighed(verdict.answer), "an answer beyond the hypotheses");
  want(std::ranges::all_of(verdict.set, weighed), "the set holds what is no hypothesis");
}

}  // namespace

void check(const DiagnosisInput& input) {
  const diagnosis::Diagnosis& d = input.diagnosis;
  const std::vector<diagnosis::Cell>& in = d.compared.cells;
  const auto cells = static_cast<Index>(in.size());
  want(cells > 0 && !input.soundings.empty(), "no cells or no soundings");
  for (const diagnosis::Cell& cell : in)
    want(cell.sounding >= 0 && cell.sounding < static_cast<int>(input.soundings.size()),
         "a cell of no sounding");
  for (const diagnosis::Mismatch& m : d.location.mismatches)
    want(m.sounding >= -1 && m.sounding < static_cast<int>(input.soundings.size()),
         "an interval of no sounding");
  const auto parameters = static_cast<Index>(input.parameters.size());
  const auto check_fit = [&](const diagnosis::Recalibration& fit) {
    want(fit.curve.size() == cells, "curves of another length than the cells");
    want(fit.place.size() == parameters && fit.deviation.size() == parameters,
         "another number of study parameters");
  };
  want(input.recorded.size() == cells && input.baseline.size() == cells,
       "curves of another length than the cells");
  check_fit(d.null.recalibrated);
  for (const diagnosis::MechanismFit& mechanism : d.mechanisms) check_fit(mechanism.recalibrated);
  for (const Sounding& s : input.soundings)
    want(s.recorded.depth.size() == s.recorded.q_c.size() &&
             s.baseline.depth.size() == s.baseline.q_c.size() &&
             (!s.solver || s.solver->depth.size() == s.solver->q_c.size()),
         "depths and q_c of sounding " + s.name + " differ in number");
  check_mechanisms(input);
  check_verdict(input);
}

std::string title_of(const DiagnosisInput& input, Explanation explanation) {
  return explanation.is_mechanism() ? std::string(input.mechanisms[explanation.mechanism()].title)
                                    : input.diagnosis.verdict.of(explanation).name;
}

std::string title_of(const DiagnosisInput& input, const std::string& name) {
  for (const solver::Mechanism& mechanism : input.mechanisms)
    if (mechanism.name == name) return std::string(mechanism.title);
  return name;
}

double baseline_place(const StudyParameter& parameter) {
  const double width = parameter.upper - parameter.lower;
  return width == 0.0 ? 0.5 : (parameter.baseline - parameter.lower) / width;
}

double study_value(const StudyParameter& parameter, double place) {
  return parameter.lower + place * (parameter.upper - parameter.lower);
}

std::string value_text(const StudyParameter& parameter, double place) {
  return parameter.is_choice() ? parameter.quantity->format(place < 0.5 ? parameter.lower : parameter.upper)
                               : brief(study_value(parameter, place));
}

std::vector<std::size_t> rivals(const DiagnosisInput& input) {
  constexpr std::size_t most = 3;
  const diagnosis::Diagnosis& d = input.diagnosis;
  std::vector<std::size_t> others = d.verdict.mechanisms_in_set();
  if (d.best) std::erase(others, d.best->mechanism);
  others.resize(std::min(others.size(), most));
  return others;
}

}  // namespace cpt::reports::diagnosed
