#include "cli/soils/fit_plot.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "drawing/palette.hpp"
#include "drawing/xy_plot.hpp"
#include "reports/depth_plot.hpp"
#include "reports/labels.hpp"

namespace cpt::cli {
namespace {

using calibration::LaboratoryTests, calibration::engineering_strain;
using drawing::plain, drawing::symbolic, drawing::XyPlot;
namespace palette = drawing::palette;

constexpr double panel_width = 170.0, panel_height = 175.0, pitch = 228.0, left = 48.0, top = 46.0;
constexpr double mark = 1.2;            // [pt] radius of a reading
constexpr std::size_t most_marks = 60;  // of one curve
constexpr double in_kPa = 1e-3, in_percent = 100.0;

// Every so many readings, so that marks stay apart.
std::size_t stride_of(std::size_t readings) { return std::max<std::size_t>(1, readings / most_marks); }

std::string_view color_of(std::size_t test) { return palette::series[test % palette::series.size()]; }

void add(XyPlot& plot, std::vector<drawing::Point> measured, std::vector<drawing::Point> fitted,
         std::string_view color) {
  plot.curves.push_back({std::move(measured), {color, 0.6, {}}, mark});
  plot.curves.push_back({std::move(fitted), {color, 1.0, {}}});
}

void add_triaxial(const LaboratoryTests& tests, const solver::NorSandParameters& sand, XyPlot& stress,
                  XyPlot& volume) {
  for (std::size_t k = 0; k < tests.triaxial.size(); ++k) {
    const calibration::TriaxialCurve& curve = tests.triaxial[k];
    std::vector<drawing::Point> q, eps_v, q_fitted, eps_v_fitted;
    for (std::size_t i = 0; i < curve.readings.size(); i += stride_of(curve.readings.size())) {
      const calibration::Reading& reading = curve.readings[i];
      q.push_back({reading.eps_a * in_percent, reading.q * in_kPa});
      if (!std::isnan(reading.eps_v))
        eps_v.push_back({reading.eps_a * in_percent, reading.eps_v * in_percent});
    }
    for (const solver::ElementRow& row : simulate(curve, sand).rows) {
      const double eps_a = engineering_strain(row.eps_a) * in_percent;
      q_fitted.push_back({eps_a, row.q * in_kPa});
      eps_v_fitted.push_back({eps_a, engineering_strain(row.eps_v) * in_percent});
    }
    add(stress, std::move(q), std::move(q_fitted), color_of(k));
    add(volume, std::move(eps_v), std::move(eps_v_fitted), color_of(k));
  }
}

void add_oedometer(const LaboratoryTests& tests, const solver::NorSandParameters& sand, XyPlot& compression) {
  for (std::size_t k = 0; k < tests.oedometer.size(); ++k) {
    const calibration::OedometerCurve& curve = tests.oedometer[k];
    std::vector<drawing::Point> e, e_fitted;
    for (std::size_t i = 0; i < curve.readings.size(); i += stride_of(curve.readings.size()))
      e.push_back({curve.readings[i].sigma_v * in_kPa, curve.readings[i].e});
    for (const solver::ElementRow& row : simulate(curve, sand).rows)
      e_fitted.push_back({(row.p + 2.0 / 3.0 * row.q) * in_kPa, row.e});
    add(compression, std::move(e), std::move(e_fitted), color_of(tests.triaxial.size() + k));
  }
}

}  // namespace

std::string fit_plot(const LaboratoryTests& tests, const solver::NorSandParameters& sand) {
  XyPlot stress{symbolic("ε_a (%)"), plain("q (kPa)"), {}};
  XyPlot volume{symbolic("ε_a (%)"), symbolic("ε_v (%)"), {}};
  XyPlot compression{symbolic("σ'_v (kPa)"), plain("e"), {}, true};
  volume.y_down = true;
  add_triaxial(tests, sand, stress, volume);
  add_oedometer(tests, sand, compression);

  std::vector<const XyPlot*> panels;
  if (!tests.triaxial.empty()) panels = {&stress, &volume};
  if (!tests.oedometer.empty()) panels.push_back(&compression);
  const auto columns = static_cast<double>(std::max<std::size_t>(panels.size(), 2));
  const std::size_t all = tests.triaxial.size() + tests.oedometer.size();
  const double below = top + panel_height + 44.0;
  const double rows = std::ceil(static_cast<double>(all) / columns);
  drawing::Svg svg(columns * pitch + 10.0, below + rows * reports::Legend::pitch + 8.0, "fit");
  reports::draw_heading(svg, "NorSand fitted to laboratory tests",
                        plain("marks: readings; lines: the single element with the fitted parameters"));
  for (std::size_t i = 0; i < panels.size(); ++i)
    draw(svg, {left + pitch * static_cast<double>(i), top, panel_width, panel_height}, *panels[i]);
  for (std::size_t k = 0; k < all; ++k) {
    const auto column = std::fmod(static_cast<double>(k), columns);
    const double row = std::floor(static_cast<double>(k) / columns);
    reports::Legend legend{svg, left + pitch * column, below + row * reports::Legend::pitch, pitch - 30.0};
    const bool oedometer = k >= tests.triaxial.size();
    const std::string& name =
        oedometer ? tests.oedometer[k - tests.triaxial.size()].name : tests.triaxial[k].name;
    legend.line(plain(reports::shortened(name, pitch - 60.0, 7.5)), {color_of(k), 1.0, {}});
  }
  return svg.document("NorSand fitted to laboratory tests");
}

}  // namespace cpt::cli
