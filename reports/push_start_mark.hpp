// The start of the push, named in a plot of q_c over depth that draws it apart.
#pragma once

#include "reports/depth_plot.hpp"

namespace cpt::reports {

/// Nothing where the profile has no such part or the plot does not show it.
void mark_start(drawing::Svg& svg, const DepthPlot& plot, const solver::DepthProfile& profile);

}  // namespace cpt::reports
