#include <fmt/format.h>

#include <array>
#include <cmath>

#include "drawing/palette.hpp"
#include "drawing/xy_plot.hpp"
#include "parameters/calibration/hardening.hpp"
#include "reports/depth_plot.hpp"
#include "reports/labels.hpp"
#include "reports/units.hpp"
#include "solver/constitutive/element_test.hpp"
#include "validation/paper/figures.hpp"
#include "validation/paper/laboratory.hpp"

namespace cpt::validation::paper {
namespace {

using drawing::Box, drawing::Pen, drawing::plain, drawing::Svg, drawing::symbolic, drawing::XyCurve,
    drawing::XyPlot;
namespace palette = drawing::palette;

constexpr std::array known_H = {25.0, 50.0, 75.0};  // over the range that the paper found

// A test as a laboratory would report it: engineering strains, a reading every 0.05 %.
calibration::TriaxialCurve simulated(double D_r, double p_0, double H) {
  constexpr double last_strain = 0.05, spacing = 0.0005;
  solver::ElementTest test;
  solver::NorSandParameters sand;
  sand.D_r = D_r;
  sand.H = H;
  test.material = sand;
  test.sigma_a = test.sigma_r = p_0;
  test.max_axial_strain = -std::log1p(-last_strain);
  test.steps = static_cast<int>(std::lround(last_strain / spacing));
  calibration::TriaxialCurve curve;
  curve.p_0 = p_0;
  curve.D_r = D_r;
  for (const solver::ElementRow& row : solver::run_element_test(test).rows)
    curve.readings.push_back({-std::expm1(-row.eps_a), row.q, -std::expm1(-row.eps_v)});
  return curve;
}

}  // namespace

std::string hardening_figure() {
  Svg svg(single_plot_width, 290.0, "hardening");
  reports::draw_heading(svg, "Calibration of H",
                        symbolic("found from the initial stiffness of simulated tests at D_R = 80, 51, 1 %"));
  XyPlot plot{symbolic("ψ_0"), plain("H"), {}};
  plot.room = {{-0.4, 0.0}, {0.1, 100.0}};
  const Pen known{palette::muted, 0.8, "4 2"};
  for (const double H : known_H) plot.curves.push_back({{{-0.4, H}, {0.1, H}}, known});
  for (std::size_t k = 0; k < laboratory_pressures.size(); ++k) {
    XyCurve found{{}, {palette::series[k], 1.0, {}}, 2.6};
    for (std::size_t i = 0; i < laboratory_densities.size(); ++i) {
      const double H = known_H[(i + k) % known_H.size()];  // a Latin square: each at each density and stress
      const auto fit = calibration::fit_hardening(
          simulated(laboratory_densities[i], laboratory_pressures[k], H), solver::NorSandParameters{});
      found.points.push_back({fit.psi_0, fit.H});
    }
    plot.curves.push_back(std::move(found));
  }
  const Box box{52.0, 44.0, 230.0, 205.0};
  draw(svg, box, plot);
  reports::Legend legend{svg, box.right() + 12.0, box.y + 6.0, 95.0};
  legend.line(plain("known H"), known);
  for (std::size_t k = 0; k < laboratory_pressures.size(); ++k)
    legend.dot(symbolic("p'_0 ") + plain(fmt::format("= {:g} kPa", laboratory_pressures[k] / reports::kPa)),
               palette::series[k]);
  return svg.document("Calibration of H");
}

}  // namespace cpt::validation::paper
