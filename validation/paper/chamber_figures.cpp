#include <algorithm>

#include "drawing/palette.hpp"
#include "reports/depth_plot.hpp"
#include "reports/labels.hpp"
#include "validation/paper/figures.hpp"

namespace cpt::validation::paper {
namespace {

using drawing::Box, drawing::Pen, drawing::plain, drawing::Rich, drawing::Svg, drawing::symbolic;
using reports::all_completed, reports::baseline_run, reports::bound_run, reports::curve_of,
    reports::DepthPlot, reports::draw_heading, reports::Legend, reports::NamedFigure, reports::whole_profile;
namespace palette = drawing::palette;

constexpr double chamber_legend_width = 130.0;
constexpr double chamber_plot_height = 330.0;

// Curves of several campaigns, numbered anew, as one.
class Collection {
 public:
  explicit Collection(const Studies& studies) : studies_(studies) {}

  /// A realization of a study, if it is there; the baseline where `parameter` is empty.
  void add(std::string_view study, std::string_view parameter, Rich label, const Pen& pen) {
    const auto found = studies_.find(study);
    if (found == studies_.end()) return;
    const results::Snapshot& from = found->second;
    const results::RealizationRow* run =
        parameter.empty() ? baseline_run(from) : bound_run(from, parameter, "upper");
    const solver::DepthProfile* profile = run == nullptr ? nullptr : curve_of(from, run->id);
    if (profile == nullptr) return;
    results::RealizationRow row = *run;
    row.id = static_cast<int>(merged_.realizations.size()) + 1;
    merged_.curves.push_back({row.id, *profile});
    merged_.realizations.push_back(std::move(row));
    if (merged_.layers.empty()) merged_.layers = from.layers;
    labels_.push_back(std::move(label));
    pens_.push_back(pen);
  }

  /// Nothing with fewer than two curves, where there is nothing to compare.
  [[nodiscard]] std::optional<std::string> figure(const std::string& title, const Rich& line) const {
    if (merged_.curves.size() < 2) return std::nullopt;
    const double lines = all_completed(merged_) ? 1.0 : 2.0;
    Svg svg(single_plot_width, 23.0 + 12.5 * lines + 40.0 + chamber_plot_height + 14.0, "chamber");
    const double top = draw_heading(svg, merged_, title, {line});
    const Box box{50.0, top + 36.0, single_plot_width - 50.0 - chamber_legend_width - 14.0,
                  chamber_plot_height};
    const DepthPlot axes = whole_profile(merged_, merged_.curves, box);
    axes.draw_ground(svg, merged_.layers);
    svg.begin_clip(box);
    for (std::size_t i = 0; i < pens_.size(); ++i) axes.draw_curve(svg, merged_.curves[i].profile, pens_[i]);
    svg.end_clip();
    axes.draw_frame(svg);
    Legend legend{svg, box.right() + 12.0, box.y + 6.0, chamber_legend_width - 2.0};
    for (std::size_t i = 0; i < pens_.size(); ++i) legend.line(labels_[i], pens_[i]);
    return svg.document(title);
  }

 private:
  const Studies& studies_;
  results::Snapshot merged_;
  std::vector<Rich> labels_;
  std::vector<Pen> pens_;
};

}  // namespace

std::vector<NamedFigure> chamber_figures(const Studies& studies) {
  const Pen low{palette::blue, 1.0, {}}, high{palette::vermillion, 1.0, {}};
  const Pen low_dashed{palette::blue, 1.0, "4 2"}, high_dashed{palette::vermillion, 1.0, "4 2"};
  Collection walls(studies);
  walls.add(dense_rigid_study, {}, symbolic("rigid, σ'_h0 = 50 kPa"), low);
  walls.add(dense_rigid_study, inputs::sigma_h0, symbolic("rigid, σ'_h0 = 90 kPa"), high);
  walls.add(dense_flexible_study, {}, symbolic("flexible, σ'_h0 = 50 kPa"), low_dashed);
  walls.add(dense_flexible_study, inputs::sigma_h0, symbolic("flexible, σ'_h0 = 90 kPa"), high_dashed);

  Collection pushes(studies);
  pushes.add(dense_rigid_study, {}, plain("first push"), {palette::ink, 1.2, {}});
  pushes.add(second_push_study, {}, symbolic("σ'_v0 = 120 kPa"), {palette::blue, 1.0, {}});
  pushes.add(dense_rigid_study, inputs::density, symbolic("D_R = 65 %"), {palette::green, 1.0, {}});
  pushes.add(second_push_study, inputs::density, plain("both"), {palette::vermillion, 1.0, {}});

  return {
      {"boundaries",
       "Cone resistance for two walls and two initial horizontal stresses in sand of D_R 60 % under 100 kPa "
       "(Fig. 13).",
       walls.figure("Walls and horizontal stress", symbolic("sand of D_R = 60 %, σ'_v0 = 100 kPa"))},
      {"second_push",
       "Cone resistance of the first push (D_R 60 %, 100 kPa) and with the stress and density that it leaves "
       "(Fig. 16).",
       pushes.figure("Second push", symbolic("sand of D_R = 60 %, σ'_v0 = 100 kPa, rigid wall"))}};
}

}  // namespace cpt::validation::paper
