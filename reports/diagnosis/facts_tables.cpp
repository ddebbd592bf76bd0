// Tables of what the answer rests on.
#include <fmt/format.h>

#include "drawing/markdown.hpp"
#include "drawing/text.hpp"
#include "reports/diagnosis/tables.hpp"
#include "reports/diagnosis/words.hpp"

namespace cpt::reports::diagnosed {
namespace {

using drawing::decimals, drawing::table_head, drawing::table_line;

std::string describe(const diagnosis::NoiseModel& noise) {
  return fmt::format("standard deviation {}, correlation length {} mm, {}",
                     percent(percent_of(noise.deviation)), brief(1e3 * noise.length),
                     noise.kernel == diagnosis::Kernel::ar1 ? "AR(1)" : "Matérn-3/2");
}

std::string time_text(double seconds) {
  if (seconds < 120.0) return brief(seconds) + " s";
  if (seconds < 7200.0) return brief(seconds / 60.0) + " min";
  return brief(seconds / 3600.0) + " h";
}

}  // namespace

std::string prior_widths_table(const DiagnosisInput& input) {
  if (input.diagnosis.variations.empty()) return "";
  std::string text =
      "### Other prior widths\n\n" + table_head({"variation", "most probable, before the check", "changed"});
  for (const diagnosis::PriorVariation& v : input.diagnosis.variations)
    text += table_line({markdown(v.what), markdown(title_of(input, v.answer)), v.changed ? "**yes**" : "no"});
  return text + "\n";
}

std::string study_parameters_table(const DiagnosisInput& input) {
  if (input.parameters.empty()) return "";
  const diagnosis::Diagnosis& d = input.diagnosis;
  const auto parameters = static_cast<Index>(input.parameters.size());
  std::string text =
      "### Parameters of the study\n\nPlace between the bounds, 0 at the lower and 1 at the upper one, ± "
      "standard deviation, and the value there.\n\n";
  std::vector<std::string> head{"parameter", "bounds", "baseline", "refitted: place", "value"};
  if (d.best) head.insert(head.end(), {"with the best effect: place", "value"});
  text += table_head(head);
  for (Index j = 0; j < parameters; ++j) {
    const StudyParameter& p = input.parameters[static_cast<std::size_t>(j)];
    const std::string unit = p.is_choice() ? "" : markdown(unit_after(p.quantity->unit));
    const auto value = [&](double place) { return markdown(value_text(p, place)) + unit; };
    std::vector<std::string> cells{
        fmt::format("{} ({})", markdown_symbol(p.quantity->symbol), markdown(p.quantity->name)),
        p.is_choice() ? value(0.0) + " or " + value(1.0)
                      : fmt::format("{} to {}{}", brief(p.lower), brief(p.upper), unit),
        value(baseline_place(p))};
    const auto add = [&](const diagnosis::Recalibration& fit) {
      cells.push_back(with_deviation(fit.place(j), fit.deviation(j), "-"));
      cells.push_back(value(fit.place(j)));
    };
    add(d.null.recalibrated);
    if (d.best) add(d.with_best());
    text += table_line(cells);
  }
  return text + "\n";
}

std::string noise_table(const DiagnosisInput& input) {
  const diagnosis::Compared& d = input.diagnosis.compared;
  std::string text = "### Noise\n\n" + table_head({"part", "value", "from"}) +
                     table_line({"measurement", describe(d.measurement),
                                 input.noise.measurement_given ? "given" : "the recording's high-pass part"});
  if (d.numerical)
    text += table_line({"numerical",
                        fmt::format("{}; weight of this fit {}, share {}", describe(d.numerical->target),
                                    decimals(d.numerical->weight, 2), brief(input.noise.numerical_shares)),
                        fmt::format("{} repeats of the baseline", input.noise.repeats)});
  text += table_line({"error of the response surface of the parameters",
                      input.noise.joint_runs > 0 ? "low rank" : "none",
                      fmt::format("{} runs at joint parameters", input.noise.joint_runs)});
  return text + "\n";
}

std::string provenance_table(const DiagnosisInput& input) {
  const Provenance& p = input.provenance;
  std::vector<std::string> seeds;
  for (const std::uint64_t seed : p.seeds) seeds.push_back(fmt::format("{}", seed));
  std::string text = "### Provenance\n\n" + table_head({"", ""}) +
                     table_line({"program version", markdown(p.program_version)}) +
                     table_line({"solver version", markdown(p.solver_version)}) +
                     table_line({"seeds", listed(seeds)});
  for (const SourceFile& file : p.files)
    text +=
        table_line({markdown(file.what),
                    markdown(file.path) + (file.sha256.empty() ? "" : ", SHA-256 " + markdown(file.sha256))});
  text +=
      table_line({"solver runs", fmt::format("{}", p.solver_runs)}) +
      table_line({"wall time", time_text(p.wall_s)}) +
      table_line({"cells compared", fmt::format("{} of {} mm", input.diagnosis.compared.cells.size(),
                                                brief(1e3 * input.diagnosis.compared.cells.front().height))});
  return text + "\n";
}

}  // namespace cpt::reports::diagnosed
