#include "validation/paper/own_extreme.hpp"

#include "reports/labels.hpp"
#include "results/statistics/sensitivity.hpp"
#include "results/statistics/windows.hpp"

namespace cpt::validation::paper {
namespace {

struct Extreme {
  double depth, q_c;
};

std::optional<Extreme> extreme_of(const results::Snapshot& campaign, const parameters::Window& sought,
                                  std::string_view parameter, std::string_view side) {
  const results::RealizationRow* run = reports::bound_run(campaign, parameter, side);
  if (run == nullptr) run = reports::baseline_run(campaign);  // a bound without a run equals the baseline
  if (run == nullptr || !run->completed()) return std::nullopt;
  const solver::DepthProfile* curve = reports::curve_of(campaign, run->id);
  if (curve == nullptr) return std::nullopt;
  const auto place = results::resolve_window(sought, *curve);
  if (!place) return std::nullopt;
  const auto mean = results::average(*curve, place.value);
  if (!mean) return std::nullopt;
  return Extreme{0.5 * (place.value.from + place.value.to), mean.value.mean};
}

}  // namespace

std::optional<OwnExtremes> own_extremes(const results::Snapshot& campaign, const results::WindowRow& window,
                                        std::string_view parameter) {
  using Kind = parameters::Window::Kind;
  if (window.kind != "peak" && window.kind != "trough") return std::nullopt;
  const parameters::Window sought{window.name, window.kind == "peak" ? Kind::peak : Kind::trough,
                                  window.search_from_m, window.search_to_m, window.width_m};
  const auto lower = extreme_of(campaign, sought, parameter, "lower");
  const auto upper = extreme_of(campaign, sought, parameter, "upper");
  if (!lower || !upper) return std::nullopt;
  return OwnExtremes{results::sensitivity_index(lower->q_c, upper->q_c), lower->depth, upper->depth};
}

}  // namespace cpt::validation::paper
