// What a sounding says of the soil's behaviour: corrected resistance, friction ratio, index I_c and zones.
//
// Robertson, P.K. (1990). Soil classification using the cone penetration test. Can. Geotech. J. 27(1),
// 151-158. Robertson, P.K. (2009). Interpretation of cone penetration tests: a unified approach. Can.
// Geotech. J. 46(11), 1337-1355.
#pragma once

#include <string_view>

#include "recordings/recording.hpp"

namespace cpt::recordings {

inline constexpr double atmosphere = 100.0e3;  // [Pa] p_a, by which stresses are made dimensionless

/// Resistance corrected for the pore pressure behind the cone: q_t = q_c + (1 - a) u_2 [Pa].
[[nodiscard]] double corrected_resistance(double q_c, double u_2, double area_quotient);

/// Stresses in the ground [Pa], compression-positive.
struct Ground {
  double sigma_v0;            // total vertical stress
  double effective_sigma_v0;  // sigma'_v0
};

/// What has to be known or assumed of the ground: one unit weight, water at rest below its table.
struct GroundModel {
  double unit_weight = 18.0e3;  // [N/m3] of the soil, above and below the water table
  double water_table = 1.0;     // [m] depth below the ground, negative above it
  double surcharge = 0.0;       // [Pa] total vertical stress on the ground, as on a chamber's lid
};
inline constexpr double unit_weight_of_water = 9.81e3;  // [N/m3]
[[nodiscard]] Ground ground_at(double depth, const GroundModel& model);

/// Of one reading. NaN where it is not defined: no f_s, q_t <= sigma_v0, sigma'_v0 <= 0.
struct Behaviour {
  double Q_tn = not_given;  // [-] normalized resistance ((q_t - sigma_v0)/p_a) (p_a/sigma'_v0)^n
  double F_r = not_given;   // [%] normalized friction 100 f_s/(q_t - sigma_v0)
  double n = not_given;     // [-] exponent of stress
  double I_c = not_given;   // [-] soil behaviour type index
  int zone = 0;             ///< 1 to 9; 0 where there is no I_c
};

/// I_c = sqrt((3.47 - log10 Q)^2 + (1.22 + log10 F)^2) for normalized resistance Q and friction F [%]
/// (Robertson 2009, after Robertson and Wride 1998).
[[nodiscard]] double behaviour_index(double Q, double F_r);

/// Zone 1 to 9 of the normalized chart. 2 to 7 by I_c: 1.31, 2.05, 2.60, 2.95, 3.60. Before them: 1 where
/// Q < 12 exp(-1.4 F); 8 and 9 where Q > 1/(0.005 (F - 1) - 0.0003 (F - 1)^2 - 0.002) and F > 1.5 %, 9 from F
/// = 4.5 % (Robertson 2009).
[[nodiscard]] int behaviour_zone(double Q, double F_r);
/// "clays: silty clay to clay"
[[nodiscard]] std::string_view name_of_zone(int zone);

/// Exponent found together with I_c: n = 0.381 I_c + 0.05 sigma'_v0/p_a - 0.15, at most 1 (Robertson 2009).
[[nodiscard]] Behaviour behaviour_2009(double q_t, double f_s, const Ground& ground);
/// Exponent 1 (Robertson 1990).
[[nodiscard]] Behaviour behaviour_1990(double q_t, double f_s, const Ground& ground);

}  // namespace cpt::recordings
