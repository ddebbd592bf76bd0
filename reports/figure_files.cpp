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

/// Which noise the indices of a window are held against; the caption's end.
std::string noise_words(const results::Snapshot& campaign, const std::string& window) {
  const std::string spread = "the dashed line is the spread of the baseline inside the window";
  if (const results::RepeatNoiseRow* noise = repeat_noise_of(campaign, window)) {
    const std::string so_far = results::repeats_so_far(campaign);
    const bool paired =
        std::ranges::any_of(sensitivity_in(campaign, window), [](const auto& row) { return row.pairs > 0; });
    return fmt::format(
        ", with its own 95 % interval from {} runs of the baseline with shifted material points{}{}, which "
        "says "
        "what is noise; {}.",
        noise->runs, so_far.empty() ? "" : ", " + so_far,
        paired ? ", or where its bounds were repeated, too, from these pairs" : "", spread);
  }
  const auto repeat = [](const results::RealizationRow& run) { return run.side == "repeat"; };
  const char* why = std::ranges::none_of(campaign.realizations, repeat) ? ": the study has no repeats"
                    : results::repeats_so_far(campaign).empty()         ? ": too few repeats completed"
                                                                        : " until the repeats have run";
  return fmt::format("; {}, which is the noise here{}.", spread, why);
}

}  // namespace

std::vector<NamedFigure> window_figures(const results::Snapshot& campaign, const results::Effects& effects,
                                        const results::WindowRow& window, const std::string& part,
                                        Place place) {
  std::string design = effects.design;
  std::ranges::replace(design, '_', ' ');
  const std::string average = window.output.empty() ? "the average cone resistance in window " + window.name
                              : window.is_scalar()
                                  ? window.output
                                  : fmt::format("the average {} in window {}", window.output, window.name);
  const bool propagation = effects.design == "propagation";
  return {
      {"tornado_" + part,
       fmt::format(
           "Range of {} between each input's lower and upper bound, whose values stand at the bar's ends.",
           average),
       tornado_figure(campaign, window, place)},
      {"sensitivity_" + part,
       fmt::format(
           "Sensitivity index SI of each input in window {}: the change of the average from the lower to "
           "the upper bound over that at the upper bound{}",
           window.name, window.output.empty() ? noise_words(campaign, window.name) : "."),
       sensitivity_figure(campaign, window, place)},
      {"effects_" + part,
       fmt::format("What the design {} says of window {}. {}", design, window.name,
                   propagation ? "Line: share of the runs with an average of at most so much; circles: "
                                 "quantiles with their 95 % intervals."
                               : effects_legend_words(effects.design)),
       propagation ? propagation_figure(campaign, effects, window, place)
                   : effects_figure(campaign, effects, window, place)},
      {"shapley_" + part,
       fmt::format("Where the variance of {} comes from. {}", average, effects_legend_words(effects.design)),
       propagation ? effects_figure(campaign, effects, window, place) : std::nullopt},
      {"convergence_" + part,
       propagation
           ? fmt::format("Mean, 5 and 95 % quantile of {} as the first runs alone have them, with 95 % "
                         "intervals.",
                         average)
           : fmt::format(
                 "What the first runs of the design {} alone would say of window {}: the numbers of the "
                 "largest inputs, each with its 95 % interval (cut off at the frame), over the runs that "
                 "they come from.",
                 design, window.name),
       propagation ? propagation_convergence_figure(campaign, effects, window, place)
                   : index_convergence_figure(campaign, effects, window, place)}};
}

std::vector<NamedFigure> band_figures(const results::Snapshot& campaign, const results::Effects& effects,
                                      Place place) {
  std::vector<NamedFigure> figures;
  for (const solver::Channel& channel : solver::channels())
    figures.push_back(
        {fmt::format("bands_{}", channel.name),
         fmt::format("The {} over depth with inputs drawn from their distributions: median, mean, "
                     "and where half and nine tenths of the runs lie at each depth.",
                     channel.title),
         bands_figure(campaign, effects, channel, place)});
  return figures;
}

void make_directory(const fs::path& directory) { results::make_folder(directory); }

void write_text(const fs::path& file, const std::string& text) { results::replace_file(file, text); }

std::vector<NamedFigure> campaign_figures(const results::Snapshot& campaign, const results::Effects& effects,
                                          drawing::Column column) {
  std::vector<NamedFigure> figures;
  std::set<std::string> taken;
  for (const results::WindowRow& window : campaign.windows)
    for (NamedFigure& figure :
         window_figures(campaign, effects, window, file_part(window.name, taken), column))
      figures.push_back(std::move(figure));
  const bool pushes = !campaign.is_external();
  if (pushes)
    for (NamedFigure& figure : band_figures(campaign, effects, column)) figures.push_back(std::move(figure));
  figures.push_back({"profiles",
                     "Cone resistance of all realizations; those furthest from the baseline in a window are "
                     "told apart.",
                     pushes ? profiles_figure(campaign, column) : std::nullopt});
  figures.push_back({"baseline", "Cone resistance of the baseline and the windows it is averaged in.",
                     pushes ? baseline_figure(campaign, column) : std::nullopt});
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
