// Laboratory tests beside what the single element makes of them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "parameters/calibration/oedometer_curve.hpp"
#include "parameters/calibration/triaxial_curve.hpp"
#include "solver/constitutive/element_test.hpp"

namespace cpt::calibration {

/// p_0 and e_0 or D_r of each triaxial test must be known.
struct LaboratoryTests {
  std::vector<TriaxialCurve> triaxial;
  std::vector<OedometerCurve> oedometer;
};

/// What is measured, on the scale on which its scatter is alike for all tests.
enum class Channel : std::uint8_t {
  q,      ///< [-] deviator stress over the test's largest
  eps_v,  ///< [-] volumetric strain of a triaxial test
  e,      ///< [-] void ratio of an oedometer test
  ln_G_0  ///< [-] ln of the shear modulus at small strains
};
inline constexpr std::size_t channel_count = 4;
/// "q / q_max"
[[nodiscard]] std::string_view to_string(Channel channel);

/// One measured number.
struct Observation {
  Channel channel;
  std::size_t test;  ///< triaxial tests first, then oedometer tests
  double measured;
};

/// All rows of a test of this sand, to the last reading's strain (triaxial) or stress (oedometer), one each
/// 0.025 % of strain. A sub-step's tolerance is at most 1e-5: with the law's usual 1e-3 derivatives by small
/// steps are those of its jumps.
[[nodiscard]] solver::ElementResult simulate(const TriaxialCurve& curve,
                                             const solver::NorSandParameters& sand);
[[nodiscard]] solver::ElementResult simulate(const OedometerCurve& curve,
                                             const solver::NorSandParameters& sand);

/// Shear modulus [Pa] at small strains before shearing: G_ref p_a / (e_0 - e_min*) (p_0 / p_a)^b, the law's
/// stiffness (solver/constitutive/norsand_constants.hpp).
[[nodiscard]] double small_strain_modulus(const TriaxialCurve& curve, const solver::NorSandParameters& sand);

class SimulatedTests {
 public:
  explicit SimulatedTests(LaboratoryTests tests);

  /// Test by test, channel by channel, in the order of the readings; readings at the start, where
  /// every sand is alike, are left out.
  [[nodiscard]] const std::vector<Observation>& observations() const { return observations_; }

  /// The same numbers of this sand. Empty, or the reason why a test does not run; values are then void.
  [[nodiscard]] std::string run(const solver::NorSandParameters& sand, std::vector<double>& values) const;

 private:
  LaboratoryTests tests_;
  std::vector<Observation> observations_;
  std::vector<double> largest_q_;  // [Pa] of each triaxial test
};

}  // namespace cpt::calibration
