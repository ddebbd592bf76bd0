// What the mesh contributes to a number, from the same run on three meshes: observed order of convergence,
// Richardson's extrapolation and the grid convergence index (GCI).
#pragma once

#include <array>

namespace cpt::results {

/// A number found on a mesh of cell size h, in any unit > 0.
struct MeshResult {
  double h;
  double value;
};

/// How the differences behave from the coarse over the medium to the fine mesh (Stern et al. 2001, J. Fluids
/// Eng. 123, 793): same sign and shrinking as some power of h, changing sign, or growing. Constant: the three
/// are the same but for rounding (parameters/designs/variation.hpp), and have no order.
enum class Convergence { monotone, oscillatory, diverging, constant };

struct DiscretizationError {
  Convergence convergence;
  double order;         ///< [-] observed order p, at most 20; NaN unless monotone
  double extrapolated;  ///< value at h = 0; NaN unless monotone
  /// [-] half width of the band about the fine mesh's value, relative to it. Monotone: the GCI with a safety
  /// factor of 1.25. Oscillatory: half the range over the three meshes. NaN if diverging, 0 if constant.
  double band;
};

inline constexpr double formal_order = 2.0;  ///< of bilinear cells; the best that is believed
/// Below this observed order (Roache 1998: theory no longer guides) an extrapolation is a guess.
inline constexpr double least_order = 0.5;

/// From three meshes, finest first, h rising. The observed order p solves
/// (f3 - f2) / (f2 - f1) = (h3^p - h2^p) / (h2^p - h1^p), which is the procedure of Celik et al. (2008,
/// J. Fluids Eng. 130, 078001) for ratios of h that need not be equal. With r = h2 / h1 and p no larger than
/// the formal order, as an order above it says less of the mesh than of the three numbers (Oberkampf & Roy
/// 2010, section 8.7), f_0 = f1 + (f1 - f2) / (r^p - 1) and
/// GCI = 1.25 |(f1 - f2) / f1| / (r^p - 1) (Roache 1994, J. Fluids Eng. 116, 405). Wants f1 not zero.
[[nodiscard]] DiscretizationError discretization_error(const std::array<MeshResult, 3>& meshes);

}  // namespace cpt::results
