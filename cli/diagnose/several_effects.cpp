#include "cli/diagnose/several_effects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/cone_class.hpp"
#include "diagnosis/several/findings_store.hpp"
#include "solver/channels.hpp"

namespace cpt::cli {
namespace {

using namespace diagnosis;

bool has_sleeve(const SoundingData& sounding) {
  constexpr auto least = 10;  // readings, as of q_c
  return std::ranges::count_if(sounding.recording.readings, [&](const recordings::Reading& reading) {
           return std::isfinite(reading.f_s) && reading.depth >= sounding.request.from &&
                  reading.depth <= sounding.request.to;
         }) >= least;
}

}  // namespace

SeveralEffects several_effects(const Request& request, const std::vector<SoundingData>& soundings) {
  constexpr double usual_noise = 0.01, level_of_sleeve = 0.35;
  const solver::Channel &tip = solver::channel("q_c"), &sleeve = solver::channel("f_s");
  ChannelList channels = {&tip};
  std::vector<ChannelFacts> facts(1);
  ConeAccuracy floor{0.0, 0.0};
  if (request.cone_class > 0) floor = cone_accuracy(request.cone_class);
  facts[0].floor = ConeAccuracy::scatter * floor.tip;
  if (request.measurement > 0.0)
    facts[0].noise = ChannelNoise{request.measurement, facts[0].floor, request.correlation};
  if (std::ranges::all_of(soundings, has_sleeve)) {
    channels.push_back(&sleeve);
    const double of_tip = request.measurement > 0.0 ? request.measurement : usual_noise;
    facts.push_back({.noise = ChannelNoise{of_tip * sleeve.deviation_over_q_c,
                                           ConeAccuracy::scatter * floor.sleeve, request.correlation},
                     .factor = request.simulated ? 0.0 : level_of_sleeve});
  }
  SeveralEffects made{assemble(request, soundings, channels), {}};
  SeveralOptions options;
  options.seed = request.seed;
  for (const solver::Layer& layer : soundings.front().study.study.baseline.layers)
    options.soil_boundaries.push_back(layer.bottom);
  made.findings = find_several(made.assembled.problem, facts, options);
  return made;
}

std::string several_text(const SeveralEffects& effects) {
  const Findings& found = effects.findings;
  const Problem& problem = effects.assembled.problem;
  std::string text = "Several effects at once (on trial, not yet judged by a sealed round): ";
  if (!found.naming.alarm) {
    text += fmt::format("no sign that something is missing (P = {:.2f}, alarm below {:.2f})", found.nothing,
                        found.alarm_level);
  } else {
    std::vector<std::string> names;
    for (const std::size_t k : found.naming.named) names.push_back(problem.mechanisms[k].name);
    for (const EffectGroup& group : found.naming.groups) {
      std::vector<std::string> members;
      for (const std::size_t k : group.effects) members.push_back(problem.mechanisms[k].name);
      names.push_back(fmt::format("one of {}", fmt::join(members, ", ")));
    }
    if (found.naming.something_else) names.emplace_back("something else");
    text += names.empty() ? "something is missing, and no effect is more probable than not"
                          : fmt::format("{}", fmt::join(names, "; "));
  }
  for (std::size_t k = 0; k < problem.mechanisms.size(); ++k)
    if (const double inclusion = found.explained.inclusion(static_cast<Index>(k)); inclusion > 0.1)
      text += fmt::format("\n  {:<22} P = {:.2f}", problem.mechanisms[k].name, inclusion);
  text += fmt::format("\n  {:<22} P = {:.2f}", "something else", found.explained.something_else);
  text += fmt::format("\n  most probable together: {} (P = {:.2f}, check p = {:.3f})",
                      subset_name(found.explained.subsets.front().subset, problem),
                      found.explained.subsets.front().probability, found.check.p);
  return text;
}

}  // namespace cpt::cli
