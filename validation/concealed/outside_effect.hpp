// Effects on a recording that no mechanism of the catalogue has: what "none of these" is for.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "diagnosis/random.hpp"
#include "solver/mechanisms/catalogue.hpp"

namespace cpt::validation::concealed {

/// One effect. What `size` and `length` mean depends on the kind.
struct OutsideEffect {
  std::string kind;
  double size = 0.0;    // [-]
  double depth = 0.0;   // [m]
  double length = 0.0;  // [m]
};

/// stone         q (1 + size exp(-((z - depth) / length)^2 / 2)): a stone or a hard lump beside the cone
/// laminae       q (1 + size sin(2 pi (z - depth) / length)): thin layers, alternately denser and looser
/// zero jump     q + size mean(q) below depth: a blow has overloaded the cell
/// stuck         q as it was at depth, over length: sand grains jam the gap behind the cone
/// pauses        q (1 - size exp(-(z - z_p) / 8 mm)) after each pause, z_p = depth + k length: stress relaxed
/// zero drift    q + size mean(q) (z - z_0) / (z_1 - z_0)
/// zero offset   q + size mean(q)
/// gain drift    q (1 + size (z - z_0) / (z_1 - z_0))
/// The last three were drawn before the catalogue had them, and are judged as its mechanisms.
[[nodiscard]] std::span<const std::string_view> outside_kinds();  ///< that are drawn

/// The mechanism of the catalogue that the effect is by now; nullptr if there is none.
[[nodiscard]] const solver::Mechanism* catalogued(const OutsideEffect& effect);

/// Size, depth and length drawn for depths of [from, to] m: sizes from barely to plainly visible.
[[nodiscard]] OutsideEffect draw_outside(std::string_view kind, double from, double to,
                                         diagnosis::Random& random);

/// q_c [Pa] at `depth` [m] with the effect; no less than 1 kPa. Throws std::invalid_argument for an unknown
/// kind.
[[nodiscard]] std::vector<double> with_outside(const OutsideEffect& effect, std::span<const double> depth,
                                               std::span<const double> q_c);

}  // namespace cpt::validation::concealed
