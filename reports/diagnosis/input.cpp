#include "reports/diagnosis/input.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace cpt::reports::diagnosed {
namespace {

void want(bool good, const std::string& problem) {
  if (!good) throw std::invalid_argument("diagnosis report: " + problem);
}

void check_mechanisms(const DiagnosisInput& input) {
  const diagnosis::Diagnosis& d = input.diagnosis;
  const std::size_t mechanisms = d.mechanisms.size();
  want(input.mechanisms.size() == mechanisms, "facts of another number of mechanisms than were diagnosed");
  want(d.hypotheses.size() == mechanisms + 2, "another number of hypotheses than mechanisms and two");
  want(d.winner < d.hypotheses.size() && d.answer < d.hypotheses.size(), "an answer beyond the hypotheses");
  for (std::size_t k = 0; k < mechanisms; ++k) {
    const MechanismFacts& facts = input.mechanisms[k];
    want(facts.name == d.mechanisms[k].name && facts.name == d.hypotheses[k].name,
         "mechanism " + facts.name + " is in another order");
    const auto dimensions = static_cast<Index>(facts.parameters.size());
    for (const VectorXd* v : {&d.mechanisms[k].mean, &d.mechanisms[k].deviation, &d.mechanisms[k].mode,
                              &d.mechanisms[k].lower, &d.mechanisms[k].upper})
      want(v->size() == dimensions, "mechanism " + facts.name + " has another number of parameters");
  }
  const auto k = static_cast<Index>(mechanisms);
  want(k == 0 || (d.isolability.rows() == k && d.isolability.cols() == k + 1),
       "the isolability matrix has another size");
  want(std::ranges::all_of(d.set, [&](std::size_t i) { return i < d.hypotheses.size(); }),
       "the set holds what is no hypothesis");
  want(!d.best || *d.best < mechanisms, "the best mechanism is none of the catalogue");
}

}  // namespace

void check(const DiagnosisInput& input) {
  const diagnosis::Diagnosis& d = input.diagnosis;
  const auto cells = static_cast<Index>(d.cells.size());
  want(cells > 0 && !input.soundings.empty(), "no cells or no soundings");
  for (const diagnosis::Cell& cell : d.cells)
    want(cell.sounding >= 0 && cell.sounding < static_cast<int>(input.soundings.size()),
         "a cell of no sounding");
  for (const diagnosis::Mismatch& m : d.location.mismatches)
    want(m.sounding >= -1 && m.sounding < static_cast<int>(input.soundings.size()),
         "an interval of no sounding");
  want(input.recorded.size() == cells && input.baseline.size() == cells &&
           d.recalibrated.curve.size() == cells && (!d.best || d.with_best.curve.size() == cells),
       "curves of another length than the cells");
  const auto parameters = static_cast<Index>(input.parameters.size());
  want(d.recalibrated.place.size() == parameters && d.recalibrated.deviation.size() == parameters,
       "another number of study parameters");
  for (const Sounding& s : input.soundings)
    want(s.recorded.depth.size() == s.recorded.q_c.size() &&
             s.baseline.depth.size() == s.baseline.q_c.size() &&
             (!s.solver || s.solver->depth.size() == s.solver->q_c.size()),
         "depths and q_c of sounding " + s.name + " differ in number");
  check_mechanisms(input);
}

std::string title_of(const DiagnosisInput& input, std::size_t hypothesis) {
  return hypothesis < input.mechanisms.size() ? input.mechanisms[hypothesis].title
                                              : input.diagnosis.hypotheses[hypothesis].name;
}

std::string title_of(const DiagnosisInput& input, const std::string& name) {
  for (const MechanismFacts& facts : input.mechanisms)
    if (facts.name == name) return facts.title;
  return name;
}

double study_value(const MechanismParameterFacts& parameter, double phi) {
  return parameter.lower + phi * (parameter.upper - parameter.lower);
}

double study_deviation(const MechanismParameterFacts& parameter, double deviation) {
  return deviation * (parameter.upper - parameter.lower);
}

double baseline_place(const StudyParameter& parameter) {
  const double width = parameter.upper - parameter.lower;
  return width == 0.0 ? 0.5 : (parameter.baseline - parameter.lower) / width;
}

double study_value(const StudyParameter& parameter, double place) {
  return parameter.lower + place * (parameter.upper - parameter.lower);
}

std::vector<std::size_t> rivals(const DiagnosisInput& input) {
  constexpr std::size_t most = 3;
  std::vector<std::size_t> others;
  for (const std::size_t k : diagnosis::mechanisms_in_set(input.diagnosis))
    if (k != input.diagnosis.best && k < input.diagnosis.with.size() && others.size() < most)
      others.push_back(k);
  return others;
}

std::vector<std::size_t> by_probability(const DiagnosisInput& input, std::size_t count) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    return input.diagnosis.hypotheses[a].probability > input.diagnosis.hypotheses[b].probability;
  });
  return order;
}

}  // namespace cpt::reports::diagnosed
