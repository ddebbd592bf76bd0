#include "reports/diagnosis/write_diagnosis_report.hpp"

#include <algorithm>

#include "reports/diagnosis/figures.hpp"
#include "reports/diagnosis/numbers.hpp"
#include "reports/diagnosis/page.hpp"
#include "reports/figure_files.hpp"

namespace cpt::reports::diagnosed {
namespace {

namespace fs = std::filesystem;

std::string file_part(std::string name) {
  std::ranges::replace_if(
      name,
      [](char c) {
        const bool keep = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                          c == '-' || c == '_' || c == '.';
        return !keep;
      },
      '_');
  name.resize(std::min<std::size_t>(name.size(), 100));
  while (name.starts_with('.')) name.front() = '_';  // no hidden file
  return name.empty() ? "recording" : name;
}

std::vector<NamedFigure> figures_of(const DiagnosisInput& input) {
  return {
      {"diagnosis-profile",
       "Cone resistance over depth: recorded, simulated, with the study's parameters refitted, and with "
       "the best effect. Shaded: where recording and simulation part.",
       profile_figure(input)},
      {"diagnosis-residual",
       "What is left of the difference, in per cent of the simulated cone resistance, before and after "
       "the best effect is added.",
       residual_figure(input)},
      {"diagnosis-probability",
       "Probability of each explanation after the recording; the tick is its probability before.",
       probability_figure(input)},
      {"diagnosis-isolability", "How far apart the effects are in this recording, in standard deviations.",
       isolability_figure(input)},
      {"diagnosis-posterior",
       "Parameters of the best effect: what the recording says, and the range "
       "looked at.",
       posterior_figure(input)}};
}

}  // namespace

std::vector<fs::path> write_diagnosis_report(const DiagnosisInput& input, const fs::path& folder) {
  check(input);
  make_directory(folder);
  std::vector<LinkedFigure> linked;
  std::vector<fs::path> files{folder / (file_part(input.name) + "-diagnosis.md"), folder / "diagnosis.json"};
  for (const NamedFigure& figure : figures_of(input)) {
    const auto written = write_figure(figure, folder);
    if (written.empty()) continue;
    linked.push_back({figure.name + ".png", figure.caption});
    files.insert(files.end(), written.begin(), written.end());
  }
  write_text(files[0], page(input, linked));
  write_text(files[1], diagnosis_json(input));
  return files;
}

}  // namespace cpt::reports::diagnosed
