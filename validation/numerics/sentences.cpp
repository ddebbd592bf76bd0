#include "validation/numerics/sentences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawing/text.hpp"
#include "parameters/designs/variation.hpp"

namespace cpt::validation::numerics {
namespace {

using results::Convergence;

constexpr std::pair<std::string_view, std::string_view> names[] = {
    {refinement, "cell size"},
    {"numerics.point_density", "material points a cell"},
    {"numerics.courant", "time step"},
    {"numerics.mass_scaling", "mass scaling"},
    {"numerics.step_levels", "local time steps"},
    {"numerics.pic_fraction", "share of PIC"},
    {"numerics.start_distance_m", "start of the push"},
    {"penetrometer.speed_m_per_s", "speed"}};

std::string sentence(const Effect& effect, const std::optional<results::RepeatNoise>& repeats) {
  const Setting& setting = *effect.setting;
  if (effect.change == 0.0)
    return fmt::format("- **{}**: {} = {} in place of {} does not change q̄<sub>c</sub>.\n", words(setting),
                       setting.quantity->name, value_text(setting, effect.value),
                       value_text(setting, setting.baseline));
  std::string text = fmt::format("- **{}**: {} = {} in place of {} changes q̄<sub>c</sub> by {}",
                                 words(setting), setting.quantity->name, value_text(setting, effect.value),
                                 value_text(setting, setting.baseline), percent(effect.change));
  if (repeats)
    text += fmt::format(", {} (± {})",
                        effect.told ? "more than the repeats explain" : "no more than the repeats scatter",
                        percent(results::prediction_half_width(*repeats) / repeats->mean));
  return text + ".\n";
}

std::string sentence(const MeshTriple& triple, const NumericsStudy& study, std::string_view window) {
  const results::DiscretizationError& error = triple.error;
  std::string text = fmt::format("Refinements {}, {} and {}: ", triple.refinement[0], triple.refinement[1],
                                 triple.refinement[2]);
  switch (error.convergence) {
    case Convergence::constant:
      return text + "the result does not vary: no order can be read.";
    case Convergence::oscillatory:
      text += fmt::format(
          "q̄<sub>c</sub> does not move one way: no order can be read, half the range is {} of q̄<sub>c</sub>",
          percent(error.band));
      break;
    case Convergence::diverging:
      text += "the differences do not shrink as the cells do: no error can be estimated";
      break;
    case Convergence::monotone:
      text += fmt::format("observed order {}, {} kPa at cell size zero, GCI of the finest {}",
                          drawing::decimals(error.order, 2), drawing::number(error.extrapolated, 4),
                          percent(error.band));
      if (error.order > results::formal_order)
        text += fmt::format("; an order above {:g} makes no sense for these cells, {:g} was used",
                            results::formal_order, results::formal_order);
      if (error.order < results::least_order)
        text +=
            "; an order this low makes no sense: the meshes are too coarse or too noisy, the limit is a "
            "guess";
      break;
  }
  const auto repeats = repeats_in(study, window);
  const double difference = std::abs(triple.meshes[0].value - triple.meshes[1].value);
  if (repeats && difference < results::prediction_half_width(*repeats))
    text += "; the two finest differ by no more than the repeats scatter, which leaves the order open";
  return text + ".";
}

}  // namespace

std::string percent(double ratio, int digits) { return drawing::decimals(100.0 * ratio, digits) + " %"; }

std::string value_text(const Setting& setting, double value) {
  const std::string text = setting.quantity->format(value);
  return setting.quantity->unit == "-" ? text : fmt::format("{} {}", text, setting.quantity->unit);
}

std::string words(const Setting& setting) {
  for (const auto& [name, text] : names)
    if (name == setting.quantity->name) return std::string(text);
  return std::string(setting.quantity->meaning);
}

std::vector<MeshTriple> mesh_triples(const NumericsStudy& study, std::string_view window) {
  std::vector<std::pair<double, double>> found;  // refinement, q_c
  for (const Setting& setting : study.settings)
    if (setting.quantity->name == refinement)
      for (auto run = setting.runs.rbegin(); run != setting.runs.rend(); ++run)
        if (const auto q_c = mean_in(study.campaign, run->realization, window))
          found.emplace_back(run->value, *q_c);
  std::vector<MeshTriple> triples;
  for (std::size_t k = 0; k + 2 < found.size(); ++k) {
    MeshTriple triple{};
    for (std::size_t i = 0; i < 3; ++i) {
      triple.refinement[i] = found[k + i].first;
      triple.meshes[i] = {1.0 / found[k + i].first, found[k + i].second};
    }
    triple.error = results::discretization_error(triple.meshes);
    triples.push_back(triple);
  }
  return triples;
}

std::vector<Effect> effects(const NumericsStudy& study, std::string_view window, std::size_t channel) {
  const auto reference = reference_in(study, window, channel);
  const auto repeats = repeats_in(study, window, channel);
  std::vector<Effect> found;
  if (!reference || !(*reference > 0.0)) return found;
  for (const Setting& setting : study.settings) {
    const auto run = most_accurate(study.campaign, setting);
    if (!run || run->value == setting.baseline) continue;
    const auto mean = mean_in(study.campaign, run->realization, window, channel);
    if (!mean) continue;
    const double change = parameters::differ(*mean, *reference) ? *mean / *reference - 1.0 : 0.0;
    found.push_back({&setting, run->value, change, told_from_repeats(*mean, *reference, repeats)});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Effect& a, const Effect& b) { return std::abs(a.change) > std::abs(b.change); });
  return found;
}

std::string sentences(const NumericsStudy& study, std::string_view window) {
  std::string text;
  const auto repeats = repeats_in(study, window);
  for (const Effect& effect : effects(study, window)) text += sentence(effect, repeats);
  for (const MeshTriple& triple : mesh_triples(study, window))
    text += fmt::format("- {}\n", sentence(triple, study, window));
  return text;
}

}  // namespace cpt::validation::numerics
