#include <fmt/format.h>

#include <array>
#include <cmath>

#include "drawing/palette.hpp"
#include "drawing/xy_plot.hpp"
#include "reports/depth_plot.hpp"
#include "reports/labels.hpp"
#include "reports/units.hpp"
#include "solver/constitutive/critical_state_line.hpp"
#include "solver/constitutive/element_test.hpp"
#include "validation/paper/figures.hpp"
#include "validation/paper/laboratory.hpp"

namespace cpt::validation::paper {
namespace {

using drawing::Box, drawing::Pen, drawing::plain, drawing::Rich, drawing::Svg, drawing::symbolic,
    drawing::XyCurve, drawing::XyPlot;
using reports::draw_heading, reports::kPa, reports::Legend, reports::NamedFigure;
namespace palette = drawing::palette;

using solver::ElementRow;

constexpr double one_percent = 0.01;

constexpr std::array bounds_of_H = {25.0, 75.0};  // Table 2
constexpr double as_measured = 0.15;              // [-] axial strain of a laboratory test
constexpr double to_critical_state = 0.80;  // [-] as no laboratory test, so that the paths end on the line
constexpr std::array slopes = {0.009, 0.012, 0.015};  // lambda: lower bound, baseline, upper bound, Table 2

std::vector<ElementRow> triaxial(double D_r, double p_0, double H, double axial_strain) {
  solver::ElementTest test;
  solver::NorSandParameters sand;
  sand.D_r = D_r;
  sand.H = H;
  test.material = sand;
  test.sigma_a = test.sigma_r = p_0;
  test.max_axial_strain = axial_strain;
  test.steps = 300;
  return solver::run_element_test(test).rows;
}

std::vector<ElementRow> oedometer(double H) {
  solver::ElementTest test;
  test.path = solver::ElementPath::oedometer;
  solver::NorSandParameters sand;  // at the density of the homogeneous profile
  sand.H = H;
  test.material = sand;
  test.sigma_a = 20.0e3;
  test.sigma_r = 10.0e3;
  test.max_axial_strain = 0.3;
  test.max_axial_stress = 10.0e6;
  test.steps = 1500;
  return solver::run_element_test(test).rows;
}

template <class X, class Y>
XyCurve curve(const std::vector<ElementRow>& rows, const Pen& pen, const X& x, const Y& y) {
  XyCurve made{{}, pen};
  for (const ElementRow& row : rows) made.points.push_back({x(row), y(row)});
  return made;
}

double p_kPa(const ElementRow& row) { return row.p / kPa; }
double e(const ElementRow& row) { return row.e; }
double q_MPa(const ElementRow& row) { return row.q * 1.0e-6; }
double axial(const ElementRow& row) { return row.eps_a / one_percent; }
double volumetric(const ElementRow& row) { return row.eps_v / one_percent; }
double sigma_v_kPa(const ElementRow& row) { return (row.p + 2.0 / 3.0 * row.q) / kPa; }

XyCurve critical_state(double lambda, double from_kPa, double to_kPa, const Pen& pen) {
  solver::NorSandParameters sand;
  sand.lambda = lambda;
  const solver::CriticalStateLine line(sand);
  XyCurve made{{}, pen};
  constexpr int points = 100;
  for (int i = 0; i <= points; ++i) {
    const double p = from_kPa * std::pow(to_kPa / from_kPa, static_cast<double>(i) / points);
    made.points.push_back({p, line.void_ratio(p * kPa)});
  }
  return made;
}

Rich pressure_label(double p_0) { return symbolic("p'_0 ") + plain(fmt::format("= {:g} kPa", p_0 / kPa)); }

std::string critical_state_figure() {
  Svg svg(single_plot_width, 290.0, "critical_state");
  draw_heading(svg, "Critical state line, loose sand",
               symbolic("drained triaxial tests at D_R = 1 % under the line and its bounds"));
  XyPlot plot{symbolic("p' (kPa)"), plain("e"), {}, true};
  const Pen bound{palette::muted, 0.8, "4 2"}, baseline{palette::ink, 1.2, {}};
  for (const double lambda : slopes)
    plot.curves.push_back(critical_state(lambda, 10.0, 2000.0, lambda == slopes[1] ? baseline : bound));
  for (std::size_t k = 0; k < laboratory_pressures.size(); ++k)
    plot.curves.push_back(curve(triaxial(0.01, laboratory_pressures[k], bounds_of_H[0], to_critical_state),
                                {palette::series[k], 1.0, {}}, p_kPa, e));
  const Box box{52.0, 44.0, 220.0, 205.0};
  draw(svg, box, plot);
  Legend legend{svg, box.right() + 12.0, box.y + 6.0, 105.0};
  legend.line(plain(fmt::format("λ = {:g}", slopes[1])), baseline);
  legend.line(plain(fmt::format("λ = {:g}, {:g}", slopes[0], slopes[2])), bound);
  for (std::size_t k = 0; k < laboratory_pressures.size(); ++k)
    legend.line(pressure_label(laboratory_pressures[k]), {palette::series[k], 1.0, {}});
  return svg.document("Critical state line");
}

std::string triaxial_figure() {
  constexpr double panel = 120.0, pitch_x = 182.0, pitch_y = 178.0;
  Svg svg(3.0 * pitch_x + 14.0, 70.0 + 3.0 * pitch_y, "triaxial");
  draw_heading(svg, "Drained triaxial tests",
               symbolic("sand of Table 2 at its three densities; H = 25 solid, H = 75 dashed"));
  for (std::size_t row = 0; row < laboratory_densities.size(); ++row) {
    XyPlot stress{symbolic("ε_a (%)"), plain("q (MPa)"), {}};
    XyPlot volume{symbolic("ε_a (%)"), symbolic("ε_v (%)"), {}};
    XyPlot state{symbolic("p' (kPa)"), plain("e"), {}};
    volume.y_down = true;
    state.log_x = true;
    for (std::size_t k = 0; k < laboratory_pressures.size(); ++k)
      for (const double H : bounds_of_H) {
        const Pen pen{palette::series[k], 0.9, H == bounds_of_H[0] ? "" : "3 2"};
        const auto rows = triaxial(laboratory_densities[row], laboratory_pressures[k], H, as_measured);
        stress.curves.push_back(curve(rows, pen, axial, q_MPa));
        volume.curves.push_back(curve(rows, pen, axial, volumetric));
        state.curves.push_back(curve(rows, pen, p_kPa, e));
      }
    const double top = 62.0 + pitch_y * static_cast<double>(row);
    const XyPlot* plots[] = {&stress, &volume, &state};
    for (int column = 0; column < 3; ++column)
      draw(svg, {50.0 + pitch_x * column, top, panel, panel}, *plots[column]);
    svg.text({50.0, top - 5.0},
             symbolic("D_R ") + plain(fmt::format("= {:g} %", laboratory_densities[row] / one_percent)),
             {.size = 8.0, .bold = true});
  }
  double x = 260.0;
  for (std::size_t k = 0; k < laboratory_pressures.size(); ++k, x += 95.0) {
    Legend legend{svg, x, 44.0, 95.0};
    legend.line(pressure_label(laboratory_pressures[k]), {palette::series[k], 1.0, {}});
  }
  return svg.document("Drained triaxial tests");
}

std::string oedometer_figure() {
  Svg svg(single_plot_width, 290.0, "oedometer");
  draw_heading(svg, "Oedometer",
               symbolic("sand of Table 2 at D_R = 36 %, from σ'_v = 20 kPa with K_0 = 0.5"));
  constexpr std::array values = {25.0, 50.0, 75.0};
  XyPlot plot{symbolic("σ'_v (kPa)"), plain("e"), {}, true};
  for (std::size_t k = 0; k < values.size(); ++k)
    plot.curves.push_back(curve(oedometer(values[k]), {palette::series[k], 1.1, {}}, sigma_v_kPa, e));
  const Box box{52.0, 44.0, 240.0, 205.0};
  draw(svg, box, plot);
  Legend legend{svg, box.right() + 12.0, box.y + 6.0, 85.0};
  for (std::size_t k = 0; k < values.size(); ++k)
    legend.line(plain(fmt::format("H = {:g}", values[k])), {palette::series[k], 1.1, {}});
  return svg.document("Oedometer");
}

}  // namespace

std::vector<NamedFigure> soil_figures() {
  return {{"critical_state_line",
           "Critical state line with the bounds of λ, and simulated drained triaxial tests on loose sand "
           "(Fig. 5 of "
           "the paper, without its measurements).",
           critical_state_figure()},
          {"triaxial",
           "Simulated drained triaxial tests on dense, medium dense and loose sand (Fig. 6, without its "
           "measurements).",
           triaxial_figure()},
          {"hardening",
           "H that the calibration finds from simulated triaxial tests of known H, over the state parameter "
           "before shearing (the method of Fig. 7, without its measurements).",
           hardening_figure()},
          {"oedometer", "Simulated oedometer test for several H (Fig. 8, without its measurements).",
           oedometer_figure()}};
}

}  // namespace cpt::validation::paper
