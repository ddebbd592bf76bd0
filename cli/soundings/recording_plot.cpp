#include "cli/soundings/recording_plot.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>

#include "cli/common/cells.hpp"
#include "drawing/palette.hpp"
#include "reports/depth_panels.hpp"

namespace cpt::cli {
namespace {

using recordings::Interpretation;
using recordings::Reading;
using recordings::Recording;

// By zone, from 1: fine soils blue, coarse ones yellow.
constexpr std::array<std::string_view, 9> zone_colors = {
    drawing::palette::purple, "#8c6d46", drawing::palette::blue,   drawing::palette::sky,
    drawing::palette::green,  "#f0e442", drawing::palette::orange, drawing::palette::vermillion,
    drawing::palette::faint};

std::vector<double> divided(std::vector<double> values, double by) {
  for (double& value : values) value /= by;
  return values;
}

void add_panel(reports::DepthPanels& figure, const char* title, std::vector<double> values,
               std::string_view color) {
  if (recordings::spread(values).values == 0) return;
  figure.panels.push_back({drawing::symbolic(title), std::move(values), color});
}

void add_measured(reports::DepthPanels& figure, const Recording& recording,
                  const Interpretation& interpretation, const char* quantity, const char* title,
                  double Reading::*place, double scale, std::string_view color) {
  const std::size_t before = figure.panels.size();
  add_panel(figure, title, divided(column(recording, place), scale), color);
  if (figure.panels.size() == before) return;
  for (const recordings::Spike& spike : interpretation.spikes)
    if (spike.quantity == quantity) figure.panels.back().circled.push_back(spike.reading);
}

void add_panels(reports::DepthPanels& figure, const Recording& recording,
                const Interpretation& interpretation) {
  const auto add = [&](const char* quantity, const char* title, double Reading::*place, double scale,
                       std::string_view color) {
    add_measured(figure, recording, interpretation, quantity, title, place, scale, color);
  };
  add("q_c", interpretation.corrected ? "q_c, q_t (MPa)" : "q_c (MPa)", &Reading::q_c, MPa,
      drawing::palette::ink);
  if (interpretation.corrected && !figure.panels.empty()) {
    figure.panels.back().beside = divided(interpretation.q_t, MPa);
    figure.panels.back().beside_color = drawing::palette::vermillion;
  }
  add("f_s", "f_s (kPa)", &Reading::f_s, kPa, drawing::palette::vermillion);
  add("u_2", "u_2 (kPa)", &Reading::u_2, kPa, drawing::palette::blue);
  if (!interpretation.why_no_behaviour.empty()) return;
  std::vector<double> R_f = interpretation.R_f, I_c;
  for (std::size_t i = 0; i < R_f.size(); ++i) {
    I_c.push_back(interpretation.behaviour[i].I_c);
    if (recording.readings[i].predrilled) R_f[i] = recordings::not_given;
  }
  add_panel(figure, "R_f (%)", std::move(R_f), drawing::palette::green);
  add_panel(figure, "I_c", std::move(I_c), drawing::palette::purple);
}

}  // namespace

std::string recording_plot(const Recording& recording, const Interpretation& interpretation) {
  reports::DepthPanels figure;
  figure.title = recording.id;
  figure.lines = {fmt::format("{}, {}{}{}", std::filesystem::path(recording.file).filename().string(),
                              recording.format, recording.date.empty() ? "" : ", ", recording.date),
                  fmt::format("depth: {}", name_of(recording.depth_rule))};
  figure.depth = column(recording, &Reading::depth);
  add_panels(figure, recording, interpretation);
  for (const Reading& reading : recording.readings) {
    if (reading.predrilled) figure.shaded_to = recording.predrilled_depth;
    if (reading.after_stop) figure.marks.push_back(reading.depth);
  }
  figure.bands_title = drawing::plain("zone");
  for (const recordings::BehaviourInterval& b : interpretation.intervals)
    figure.bands.push_back(
        {b.from, b.to, fmt::format("{}", b.zone), zone_colors[static_cast<std::size_t>(b.zone) - 1]});
  const auto note = [&](const char* text) {
    figure.note += (figure.note.empty() ? "" : "; ") + std::string(text);
  };
  if (!std::isnan(figure.shaded_to)) note("grey: predrilled");
  if (!figure.marks.empty()) note("ticks at the right edge: stops of the push");
  if (interpretation.corrected) note("dashed: corrected for pore pressure");
  if (!interpretation.spikes.empty()) note("circles: spikes");
  if (!figure.bands.empty()) note("zone: soil behaviour type");
  return reports::depth_panels(figure);
}

}  // namespace cpt::cli
