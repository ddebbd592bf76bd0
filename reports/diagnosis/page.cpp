#include "reports/diagnosis/page.hpp"

#include <fmt/format.h>

#include "reports/diagnosis/answer.hpp"
#include "reports/diagnosis/tables.hpp"
#include "reports/diagnosis/words.hpp"

namespace cpt::reports::diagnosed {

std::string page(const DiagnosisInput& input, const std::vector<LinkedFigure>& figures) {
  const Answer answer = answer_of(input);
  std::string text = fmt::format("# {}\n\n**{}**\n\n", markdown(input.title), markdown(answer.headline));
  for (const std::string& reservation : answer.reservations)
    text += fmt::format("*{}*\n\n", markdown(reservation));
  for (const std::string& paragraph : answer.paragraphs) text += markdown(paragraph) + "\n\n";
  text += "## Figures\n\n";
  for (const LinkedFigure& figure : figures)
    text += fmt::format("![{0}]({1})\n\n*{0}*\n\n", markdown(figure.caption), figure.file);
  text +=
      "## Numbers\n\nPercentages are of the simulated cone resistance: 100 (exp(x) − 1) of a difference x "
      "of ln q<sub>c</sub>. All numbers are in diagnosis.json.\n\n";
  for (const auto& table : {hypotheses_table, intervals_table, fitted_parameters_table,
                            before_and_after_table, checks_table, pairs_table, next_measurements_table,
                            prior_widths_table, study_parameters_table, noise_table, provenance_table})
    text += table(input);
  text.pop_back();
  return text;
}

}  // namespace cpt::reports::diagnosed
