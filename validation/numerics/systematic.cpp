#include "validation/numerics/systematic.hpp"

#include <fmt/format.h>

#include <cmath>

#include "drawing/markdown.hpp"
#include "drawing/text.hpp"
#include "solver/channels.hpp"
#include "validation/numerics/sentences.hpp"

namespace cpt::validation::numerics {
namespace {

using drawing::table_head, drawing::table_line;

constexpr std::string_view head = R"(
## Systematic error beside the noise

What finer cells, more material points and less inertia do to the averages of a baseline, each as far as it was run, and
together (root of the sum of squares): the error is at least that, and larger where the cells converge to further away, which the
tables of the meshes tell; beside it the noise, within which one more run lies with a probability of 95 %. An index
SI is a difference of two runs on one mesh; how far the systematic error moves it would take both on a finer one.

)";

std::string cell(std::optional<double> ratio) { return ratio ? percent(*ratio) : "–"; }

std::string sentence(const NumericsStudy& study, std::string_view window, const std::string& symbol,
                     const SystematicError& error) {
  constexpr double shown = 0.0005;  // what rounds to 0.0 %
  if (error.together < shown)
    return fmt::format("- {}, window {}: the resolution does not move {}.\n", study.campaign.campaign.title,
                       window, symbol);
  std::string text = fmt::format("- {}, window {}: the resolution moves {} by {} together",
                                 study.campaign.campaign.title, window, symbol, percent(error.together));
  if (error.chance)
    text += fmt::format(", {} the noise of ± {}", error.together > *error.chance ? "more than" : "within",
                        percent(*error.chance));
  return text + ".\n";
}

}  // namespace

std::optional<SystematicError> systematic_error(const NumericsStudy& study, std::string_view window,
                                                std::size_t channel) {
  SystematicError error;
  double squares = 0.0;
  for (const Effect& effect : effects(study, window, channel)) {
    const std::string_view name = effect.setting->quantity->name;
    if (name == refinement)
      error.cell_size = effect.change;
    else if (name == "numerics.point_density")
      error.points = effect.change;
    else if (name == "numerics.mass_scaling")
      error.inertia = effect.change;
    else
      continue;
    squares += effect.change * effect.change;
  }
  if (!error.cell_size && !error.points && !error.inertia) return std::nullopt;
  error.together = std::sqrt(squares);
  if (const auto repeats = repeats_in(study, window, channel))
    error.chance = results::prediction_half_width(*repeats) / repeats->mean;
  return error;
}

std::string systematic_section(const std::vector<NumericsStudy>& studies) {
  std::string rows, found;
  for (const NumericsStudy& study : studies)
    for (const results::WindowRow& window : study.campaign.windows)
      for (std::size_t k = 0; k < solver::channel_count; ++k) {
        if (!solver::channels()[k].required) continue;
        const auto error = systematic_error(study, window.name, k);
        if (!error) continue;
        const std::string symbol = drawing::html(drawing::symbolic(solver::channels()[k].symbol));
        rows += table_line({study.campaign.campaign.profile, study.campaign.campaign.preset, window.name,
                            symbol, cell(error->cell_size), cell(error->points), cell(error->inertia),
                            percent(error->together), error->chance ? "± " + percent(*error->chance) : "–"});
        found += sentence(study, window.name, symbol, *error);
      }
  if (rows.empty()) return "";
  return std::string(head) +
         table_head({"profile", "preset", "window", "average of", "cell size", "material points",
                     "mass scaling", "together", "noise"}) +
         rows + "\n" + found;
}

}  // namespace cpt::validation::numerics
