#include "reports/figure_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "reports/figures.hpp"
#include "reports/labels.hpp"
#include "reports/picture_files.hpp"
#include "results/files/atomic_file.hpp"

namespace cpt::reports {
namespace {

namespace fs = std::filesystem;

/// Part of a file name: letters and digits of ASCII, '_' for all else; numbered where two windows come out
/// equal.
std::string file_part(const std::string& name, std::set<std::string>& taken) {
  std::string part;
  for (const char c : name) {
    const bool keep = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
    if (keep || part.empty() || part.back() != '_') part += keep ? c : '_';
  }
  part.resize(std::min<std::size_t>(part.size(), 60));
  if (part.empty() || part == "_") part = "window";
  std::string unique = part;
  for (int k = 2; !taken.insert(unique).second; ++k) unique = fmt::format("{}-{}", part, k);
  return unique;
}

}  // namespace

void make_directory(const fs::path& directory) { results::make_folder(directory); }

void write_text(const fs::path& file, const std::string& text) { results::replace_file(file, text); }

std::vector<NamedFigure> campaign_figures(const results::Snapshot& campaign, const results::Effects& effects,
                                          drawing::Column column) {
  std::vector<NamedFigure> figures;
  std::set<std::string> taken;
  for (const results::WindowRow& window : campaign.windows) {
    const std::string part = file_part(window.name, taken);
    const bool repeated = repeat_noise_of(campaign, window.name) != nullptr;
    figures.push_back({"tornado_" + part,
                       fmt::format("Range of the average cone resistance in window {} between each input's "
                                   "lower and upper bound, whose values stand at the bar's ends.",
                                   window.name),
                       tornado_figure(campaign, window, column)});
    figures.push_back(
        {"sensitivity_" + part,
         fmt::format("Sensitivity index of each input in window {}{}; the dashed line is "
                     "SI_noise, the spread of the baseline inside the window{}.",
                     window.name, repeated ? " with its own 95 % interval, which says what is noise" : "",
                     repeated ? "" : ", which says what is noise"),
         sensitivity_figure(campaign, window, column)});
    figures.push_back({"effects_" + part,
                       fmt::format("What the design {} says of the inputs in window {}, with 95 % intervals.",
                                   effects.design, window.name),
                       effects_figure(campaign, effects, window, column)});
  }
  figures.push_back({"profiles",
                     "Cone resistance of all realizations; those furthest from the baseline in a window are "
                     "told apart.",
                     profiles_figure(campaign, column)});
  figures.push_back({"baseline", "Cone resistance of the baseline and the windows it is averaged in.",
                     baseline_figure(campaign, column)});
  return figures;
}

std::vector<fs::path> write_figure(const NamedFigure& figure, const fs::path& directory) {
  const fs::path svg = directory / (figure.name + ".svg"), png = directory / (figure.name + ".png");
  if (!figure.svg) {
    std::error_code ignored;
    for (const fs::path& file : {svg, png}) fs::remove(file, ignored);
    return {};
  }
  write_text(svg, *figure.svg);
  write_png(*figure.svg, png);
  return {svg, png};
}

}  // namespace cpt::reports
