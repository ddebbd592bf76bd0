#include "reports/diagnosis/answer.hpp"

#include <fmt/format.h>

#include "drawing/text.hpp"
#include "reports/diagnosis/sentences.hpp"
#include "reports/diagnosis/words.hpp"

namespace cpt::reports::diagnosed {
namespace {

std::string joined(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences)
    if (!sentence.empty()) text += (text.empty() ? "" : " ") + sentence;
  return text;
}

std::string chance(const DiagnosisInput& input, Explanation explanation) {
  return "probability " + probability(input.diagnosis.verdict.of(explanation).probability);
}

// "A looser lens cannot (probability 0.01)." `can` and `cannot` go with every title, one thing or several.
std::string runner_up(const DiagnosisInput& input) {
  const diagnosis::Verdict& verdict = input.diagnosis.verdict;
  for (const std::size_t k : verdict.mechanisms_by_probability()) {
    if (verdict.answer == k || verdict.in_set(k)) continue;
    const bool out = verdict.of(k).probability < 0.05;
    return fmt::format("{} {} ({}).", capitalized(title_of(input, k)),
                       out ? "cannot" : "would be less likely", chance(input, k));
  }
  return "";
}

// What besides mechanisms the set still holds.
std::string also_possible(const DiagnosisInput& input) {
  const diagnosis::Verdict& verdict = input.diagnosis.verdict;
  std::string text;
  if (verdict.in_set(Explanation::unknown()))
    text = fmt::format("Something outside the catalogue stays possible ({}).",
                       chance(input, Explanation::unknown()));
  if (verdict.in_set(Explanation::nothing()) && verdict.answer.is_mechanism())
    text += fmt::format(
        "{}Its effect stands only {} standard deviations out of what the study's parameters and the noise "
        "can do.",
        text.empty() ? "" : " ",
        brief(input.diagnosis.isolability.strength(static_cast<Index>(verdict.answer.mechanism()))));
  return text;
}

Answer named(const DiagnosisInput& input) {
  const std::size_t k = input.diagnosis.verdict.answer.mechanism();
  const std::string title = capitalized(title_of(input, k));
  return {AnswerKind::named,
          title + " can explain what the simulation lacks.",
          {},
          {joined({where_it_differs(input),
                   fmt::format("{} can explain the difference ({}): {}.", title, chance(input, k),
                               fitted_parameters(input, k)),
                   weak_parameters(input, k), runner_up(input), also_possible(input), check_passed(input)}),
           joined({held_out(input), solver_confirms(input)}), prior_widths(input)}};
}

Answer indistinguishable(const DiagnosisInput& input) {
  std::vector<std::string> titles, fits;
  for (const std::size_t k : input.diagnosis.verdict.mechanisms_in_set()) {
    titles.push_back(title_of(input, k));
    fits.push_back(fmt::format("{} ({}): {}.", capitalized(title_of(input, k)), chance(input, k),
                               fitted_parameters(input, k)));
  }
  const std::string next = next_measurement(input);
  return {AnswerKind::indistinguishable,
          fmt::format("{}: this recording cannot tell which.", capitalized(listed(titles, "or"))),
          {},
          {joined({where_it_differs(input),
                   "Each of these can explain the difference, and the recording does "
                   "not tell them apart."}),
           joined(fits), joined({also_possible(input), check_passed(input)}),
           next.empty() ? "No further measurement was weighed that could tell them apart." : next,
           joined({held_out(input), solver_confirms(input)}), prior_widths(input)}};
}

Answer nothing_missing(const DiagnosisInput& input) {
  const diagnosis::Diagnosis& d = input.diagnosis;
  const diagnosis::Hypothesis& nothing = d.verdict.of(Explanation::nothing());
  const bool sure = nothing.probability >= 0.5;
  const std::string weight =
      sure ? fmt::format("Nothing needs to be added to the simulation ({}).",
                         chance(input, nothing.explanation))
           : fmt::format(
                 "There is no firm sign that physics is missing: the probability that nothing is, {}, would "
                 "have to be below {}.",
                 probability(nothing.probability), brief(input.options.alarm));
  const std::string next =
      d.best ? fmt::format("Of the catalogued effects, {} would come first ({}).",
                           title_of(input, d.best->mechanism), chance(input, d.best->mechanism))
             : "";
  return {AnswerKind::nothing_missing,
          sure ? "Nothing is missing: the study's parameters within their bounds, and noise, are enough."
               : "No firm sign that anything is missing.",
          {},
          {joined({where_it_differs(input), weight, check_passed(input)}),
           joined({recalibration_error(input), parameters_moved(input)}), joined({next, held_out(input)}),
           prior_widths(input)}};
}

Answer none_of_these(const DiagnosisInput& input) {
  const diagnosis::Diagnosis& d = input.diagnosis;
  std::string what =
      fmt::format("None of the {} catalogued effects accounts for it: that it is something else has {}",
                  input.mechanisms.size(), chance(input, d.verdict.answer));
  if (d.best)
    what += fmt::format(", the best of the catalogue, {}, has {}", title_of(input, d.best->mechanism),
                        probability(d.verdict.of(d.best->mechanism).probability));
  return {AnswerKind::none_of_these,
          "Something is missing that is not in the catalogue.",
          {},
          {joined({where_it_differs(input), what + ".", recalibration_error(input)}), best_pair(input),
           held_out(input), prior_widths(input)}};
}

Answer gate_failed(const DiagnosisInput& input) {
  const diagnosis::Verdict& verdict = input.diagnosis.verdict;
  const bool nothing = verdict.winner.is_nothing();
  const std::string winner = title_of(input, verdict.winner);
  const std::string what =
      nothing
          ? fmt::format("No effect of the catalogue stands out, and “{}” is left ({}).", winner,
                        chance(input, verdict.winner))
          : fmt::format("{} is the most probable of the catalogue ({}), with {}.", capitalized(winner),
                        chance(input, verdict.winner), fitted_parameters(input, verdict.winner.mechanism()));
  return {AnswerKind::gate_failed,
          nothing ? "The study's parameters are not enough, and no effect of the catalogue stands out."
                  : "No effect of the catalogue passes the check: something else is missing.",
          {},
          {joined({where_it_differs(input), what, check_passed(input),
                   fmt::format("Therefore the answer is “{}”.", title_of(input, verdict.answer))}),
           best_pair(input), joined({held_out(input), solver_confirms(input)}), prior_widths(input)}};
}

}  // namespace

const char* name_of(AnswerKind kind) {
  constexpr const char* names[] = {"named", "indistinguishable", "nothing_missing", "none_of_these",
                                   "gate_failed"};
  return names[static_cast<int>(kind)];
}

Answer answer_of(const DiagnosisInput& input) {
  const diagnosis::Verdict& verdict = input.diagnosis.verdict;
  Answer answer = verdict.gate_failed()                    ? gate_failed(input)
                  : verdict.answer.is_unknown()            ? none_of_these(input)
                  : verdict.answer.is_nothing()            ? nothing_missing(input)
                  : verdict.mechanisms_in_set().size() > 1 ? indistinguishable(input)
                                                           : named(input);
  answer.reservations = reservations(input);
  std::erase(answer.paragraphs, "");
  return answer;
}

}  // namespace cpt::reports::diagnosed
