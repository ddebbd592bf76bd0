#include "reports/labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawing/palette.hpp"
#include "results/ledger/interrupted.hpp"

namespace cpt::reports {
namespace {

using drawing::plain, drawing::Rich, drawing::Svg, drawing::symbolic;
namespace palette = drawing::palette;

constexpr double heading_left = 8.0;  // of a figure's heading
constexpr double line_size = 8.0, line_pitch = 12.5, title_base = 17.0, below_heading = 6.0;

// Whether it is one of several soils that the study names itself: any of them may have the same symbols.
bool is_own_soil(const results::Snapshot& campaign, std::string_view group) {
  const std::string& setup = campaign.campaign.baseline_setup;
  const auto first = setup.find("soils = ");
  return first != std::string::npos && setup.find("soils = ", first + 1) != std::string::npos &&
         setup.find(fmt::format("soils = {} ", group)) != std::string::npos;
}

}  // namespace

using results::ParameterRow;
using results::RealizationRow;
using results::Snapshot;

const ParameterRow& parameter_of(const Snapshot& campaign, std::string_view name) {
  return *std::find_if(campaign.parameters.begin(), campaign.parameters.end(),
                       [&](const ParameterRow& p) { return p.name == name; });
}

const RealizationRow* baseline_run(const Snapshot& campaign) {
  const auto found = std::find_if(campaign.realizations.begin(), campaign.realizations.end(),
                                  [](const RealizationRow& r) { return r.side == "baseline"; });
  return found == campaign.realizations.end() ? nullptr : &*found;
}

const solver::DepthProfile* curve_of(const Snapshot& campaign, int realization) {
  const auto found = std::find_if(campaign.curves.begin(), campaign.curves.end(),
                                  [&](const results::CurveRow& c) { return c.realization == realization; });
  return found == campaign.curves.end() ? nullptr : &found->profile;
}

const RealizationRow* bound_run(const Snapshot& campaign, std::string_view parameter, std::string_view side) {
  const auto found =
      std::find_if(campaign.realizations.begin(), campaign.realizations.end(),
                   [&](const RealizationRow& r) { return r.parameter == parameter && r.side == side; });
  return found == campaign.realizations.end() ? nullptr : &*found;
}

std::vector<results::SensitivityRow> sensitivity_in(const Snapshot& campaign, std::string_view window) {
  std::vector<results::SensitivityRow> rows;
  std::copy_if(campaign.sensitivity.begin(), campaign.sensitivity.end(), std::back_inserter(rows),
               [&](const results::SensitivityRow& row) { return row.window == window; });
  return rows;
}

const results::RepeatNoiseRow* repeat_noise_of(const Snapshot& campaign, std::string_view window) {
  const auto found = std::find_if(campaign.repeat_noise.begin(), campaign.repeat_noise.end(),
                                  [&](const results::RepeatNoiseRow& row) { return row.window == window; });
  return found == campaign.repeat_noise.end() ? nullptr : &*found;
}

bool within_noise(const results::SensitivityRow& row) { return !row.above_noise.value_or(true); }

Rich symbol_of(const Snapshot& campaign, const ParameterRow& parameter) {
  const auto same = std::count_if(campaign.parameters.begin(), campaign.parameters.end(),
                                  [&](const ParameterRow& p) { return p.symbol == parameter.symbol; });
  Rich symbol = symbolic(parameter.symbol);
  const std::string group = parameter.name.substr(0, parameter.name.find('.'));
  if (same < 2 && !is_own_soil(campaign, group)) return symbol;
  return std::move(symbol) + plain(fmt::format(" ({})", group));
}

Rich unit_of(const ParameterRow& parameter) {
  if (parameter.unit.empty() || parameter.unit == "-") return {};
  return plain(fmt::format(" ({})", parameter.unit));
}

Rich run_label(const Snapshot& campaign, const RealizationRow& run) {
  if (run.parameter.empty()) return plain("baseline");
  if (run.side == "point" || run.side == "repeat") return plain(run.parameter);
  const ParameterRow& parameter = parameter_of(campaign, run.parameter);
  const bool bare = parameter.unit.empty() || parameter.unit == "-";
  return symbol_of(campaign, parameter) +
         plain(fmt::format(" = {}{}{}", run.value_text, bare ? "" : " ", bare ? "" : parameter.unit));
}

std::string shortened(std::string_view text, double room, double font_size, bool bold) {
  std::string whole(text);
  if (width(plain(whole), font_size, bold) <= room) return whole;
  while (!whole.empty()) {
    // Drop one character: its continuation bytes, then its first byte.
    while (!whole.empty() && (static_cast<unsigned char>(whole.back()) & 0xC0) == 0x80) whole.pop_back();
    if (!whole.empty()) whole.pop_back();
    if (width(plain(whole + "…"), font_size, bold) <= room) break;
  }
  return whole + "…";
}

std::string depth_range(double from_m, double to_m) { return fmt::format("{:.4f}–{:.4f} m", from_m, to_m); }

std::string place_of(const Snapshot& campaign, const results::WindowRow& window) {
  if (window.is_scalar() || !std::isfinite(window.from_m)) return "";
  if (window.output.empty()) return depth_range(window.from_m, window.to_m);
  const auto output = std::ranges::find(campaign.outputs, window.output, &results::OutputRow::name);
  if (output == campaign.outputs.end()) return "";
  return fmt::format("{} {}–{}{}", output->over, window.from_m, window.to_m,
                     output->over_unit == "-" ? "" : " " + output->over_unit);
}

Rich average_of(const results::WindowRow& window) {
  if (window.output.empty()) return symbolic("average q_c");
  return plain(window.is_scalar() ? window.output : "average " + window.output);
}

std::string unit_behind(const results::WindowRow& window) {
  return window.unit() == "-" ? "" : fmt::format(" {}", window.unit());
}

Rich axis_of(const results::WindowRow& window) {
  return average_of(window) + plain(window.unit() == "-" ? "" : fmt::format(" ({})", window.unit()));
}

Rich window_line(const results::WindowRow& window, const Rich& what, double figure_width) {
  return plain(
             shortened(window.name, figure_width - 2.0 * heading_left - width(what, line_size), line_size)) +
         what;
}

bool all_completed(const Snapshot& campaign) {
  return std::all_of(campaign.realizations.begin(), campaign.realizations.end(),
                     [](const RealizationRow& r) { return r.completed() || r.not_needed(); });
}

std::string state_of(const Snapshot& campaign) {
  const auto count = [&](auto has) {
    return std::count_if(campaign.realizations.begin(), campaign.realizations.end(), has);
  };
  std::string text = fmt::format("{} of {} realizations completed",
                                 count([](const RealizationRow& r) { return r.completed(); }),
                                 count([](const RealizationRow& r) { return !r.not_needed(); }));
  if (const auto failed = count([](const RealizationRow& r) { return r.failed(); }); failed > 0)
    text += fmt::format(", {} failed", failed);
  if (const auto waiting = count([](const RealizationRow& r) { return r.waiting(); }); waiting > 0)
    text += fmt::format(", {} still to run", waiting);
  if (const auto cut = count([](const RealizationRow& r) { return results::interrupted(r); }); cut > 0)
    text += fmt::format(" ({} {} running when the campaign ended)", cut, cut == 1 ? "was" : "were");
  return text;
}

double heading_height(const Snapshot& campaign, std::size_t lines, drawing::Ground ground) {
  if (ground == drawing::Ground::page) return 0.0;
  return title_base + below_heading +
         line_pitch * static_cast<double>(lines + (all_completed(campaign) ? 0 : 1));
}

double draw_heading(Svg& svg, const Snapshot& campaign, std::string_view title,
                    const std::vector<Rich>& lines) {
  if (svg.ground() == drawing::Ground::page) return 0.0;
  constexpr double title_size = 10.0;
  double y = title_base;
  svg.text({heading_left, y}, plain(shortened(title, svg.width() - 2.0 * heading_left, title_size, true)),
           {.size = title_size, .bold = true});
  for (const Rich& line : lines)
    svg.text({heading_left, y += line_pitch}, line, {.size = line_size, .color = palette::muted});
  if (!all_completed(campaign))
    svg.text({heading_left, y += line_pitch}, plain(state_of(campaign)),
             {.size = line_size, .color = palette::vermillion});
  return y + below_heading;
}

void draw_heading(Svg& svg, std::string_view title, const Rich& line) {
  svg.text({8.0, 17.0}, plain(title), {.size = 10.0, .bold = true});
  svg.text({8.0, 29.5}, line, {.size = 8.0, .color = palette::muted});
}

}  // namespace cpt::reports
