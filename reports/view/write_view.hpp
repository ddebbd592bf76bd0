// The view of a push: its stored fields as frames and as an animation of them.
#pragma once

#include <functional>
#include <map>

#include "reports/view/frame.hpp"

namespace cpt::reports::view {

/// What to draw. Quantities are names of view_quantities().
struct ViewRequest {
  std::vector<std::string> show = {"void_ratio_change", "p", "displacement"};  ///< 1 to 4
  std::optional<double> radius;  ///< [m] of the soil shown about the tip; nothing: whole chamber
  std::map<std::string, drawing::Range>
      ranges;                       ///< ends of scales, in the quantity's unit; others are fitted
  int frames = 0;                   ///< at most, evenly over the stored depths; 0: all
  int width = 1000;                 ///< [pixels]
  double grid = 0.0;                ///< [m] as in View
  double seconds_per_frame = 0.15;  ///< of the animation
};

struct WrittenView {
  std::vector<std::filesystem::path> frames;  ///< NAME-DEPTHm.png, as the fields are named
  std::filesystem::path animation;            ///< NAME-view.gif; empty where there is one frame only
  std::vector<Panel> panels;                  ///< with the scales that were used
};

/// Draws a stored push to a folder, made if need be. `drawn` is called after each frame with their number so
/// far and of all. The fields are read twice, one depth at a time: for the scales, then to draw. Throws
/// results::Error if something cannot be read or written, or lacks what is to be shown.
WrittenView write_view(const results::StoredPush& push, const ViewRequest& request,
                       const std::filesystem::path& folder,
                       const std::function<void(std::size_t, std::size_t)>& drawn);

}  // namespace cpt::reports::view
