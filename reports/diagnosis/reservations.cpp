// What must be known beside the headline, so that nobody takes an answer for more than it is.
#include <fmt/format.h>

#include <cmath>

#include "reports/diagnosis/answer.hpp"
#include "reports/diagnosis/errors.hpp"
#include "reports/diagnosis/sentences.hpp"
#include "reports/diagnosis/words.hpp"

namespace cpt::reports::diagnosed {
namespace {

// "a, b and c"; "a, b, c and 4 more".
std::string few_of(std::vector<std::string> items) {
  const std::size_t more = items.size() > most_told ? items.size() - most_told : 0;
  items.resize(items.size() - more);
  if (more > 0) items.push_back(fmt::format("{} more", more));
  return listed(items);
}

std::string worse_than(const std::string& what, double with, double without) {
  if (!(with > without) || percent(percent_of(with)) == percent(percent_of(without))) return "";
  return fmt::format(
      "{} the fit is worse than with the study's parameters alone: it leaves an error of {} in "
      "place of {}.",
      what, percent(percent_of(with)), percent(percent_of(without)));
}

// The figures draw the best effect whatever the answer is.
std::vector<std::string> of_the_best_effect(const DiagnosisInput& input) {
  const diagnosis::Diagnosis& d = input.diagnosis;
  if (!d.best) return {};
  const std::string title = title_of(input, d.best->mechanism);
  std::vector<std::string> all = {worse_than(fmt::format("With the best effect, {},", title),
                                             d.with_best().rmse, d.null.recalibrated.rmse)};
  if (const auto solver = solver_in_cells(input)) {
    VectorXd null = d.null.recalibrated.curve;
    for (Index i = 0; i < null.size(); ++i)
      if (!std::isfinite((*solver)(i))) null(i) = (*solver)(i);  // the same cells for both
    all.push_back(worse_than(fmt::format("Run in the full solver with the best effect, {},", title),
                             rmse(input.recorded, *solver), rmse(input.recorded, null)));
  }
  if (d.best->held_out && d.best->held_out->upper < 0.0)
    all.push_back(fmt::format("On depths held out of the fit, {} predicts worse than nothing.", title));
  return all;
}

std::string at_bounds(const DiagnosisInput& input) {
  const diagnosis::Diagnosis& d = input.diagnosis;
  const Explanation answer = d.verdict.answer;
  const diagnosis::Recalibration& fit =
      answer.is_mechanism() ? d.mechanisms[answer.mechanism()].recalibrated : d.null.recalibrated;
  std::vector<std::string> ends;
  for (std::size_t j = 0; j < input.parameters.size(); ++j) {
    const StudyParameter& p = input.parameters[j];
    const double place = fit.place(static_cast<Index>(j));
    if (!p.is_choice() && (place < 0.005 || place > 0.995))
      ends.push_back(fmt::format("{} = {}{}", p.quantity->symbol, brief(place < 0.5 ? p.lower : p.upper),
                                 unit_after(p.quantity->unit)));
  }
  std::string text;
  if (!ends.empty())
    text = fmt::format("The fit presses against the study's bounds: {}. Beyond them it might need less else.",
                       few_of(ends));
  if (answer.is_mechanism())
    if (const std::string own = at_ends(input, answer.mechanism()); !own.empty())
      text += (text.empty() ? "" : " ") + own;
  return text;
}

std::string in_words(const DiagnosisInput& input, Explanation explanation) {
  const std::string name = explanation.is_nothing()   ? "that nothing is missing"
                           : explanation.is_unknown() ? "something outside the catalogue"
                                                      : title_of(input, explanation);
  return fmt::format("{} ({})", name, probability(input.diagnosis.verdict.of(explanation).probability));
}

std::string not_ruled_out(const DiagnosisInput& input) {
  const diagnosis::Verdict& verdict = input.diagnosis.verdict;
  if (verdict.set.empty()) return "No explanation is left: the set of answers is empty.";
  if (verdict.set.size() == verdict.hypotheses.size())
    return fmt::format("This recording rules nothing out: all {} explanations stay possible.",
                       verdict.set.size());
  const bool several_named = verdict.answer.is_mechanism() && verdict.mechanisms_in_set().size() > 1;
  std::vector<std::string> others;
  for (const Explanation explanation : verdict.set)
    if (explanation != verdict.answer && !(several_named && explanation.is_mechanism()))
      others.push_back(in_words(input, explanation));
  return others.empty() ? "" : fmt::format("Not ruled out: {}.", few_of(others));
}

}  // namespace

std::vector<std::string> reservations(const DiagnosisInput& input) {
  std::vector<std::string> all = {not_ruled_out(input)};
  for (const std::string& sentence : of_the_best_effect(input)) all.push_back(sentence);
  all.push_back(at_bounds(input));
  std::erase(all, "");
  return all;
}

bool stands_alone(const DiagnosisInput& input) {
  return input.diagnosis.verdict.set.size() == 1 && reservations(input).empty();
}

}  // namespace cpt::reports::diagnosed
