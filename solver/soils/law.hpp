// What a constitutive law says of itself: its parameters, its state, how it starts, what it does at the
// cone's face, what it refuses, and its stress update.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "solver/constitutive/batch.hpp"
#include "solver/problem.hpp"
#include "solver/setup.hpp"

namespace cpt::solver {

struct LeftBehind;

/// A parameter of a law. Names have no soil yet: "s_u_kPa".
struct LawQuantity {
  std::string_view name, symbol, unit;
  double scale;     ///< SI value = scale * study value
  double min, max;  ///< valid range in study units, both ends included
  std::vector<std::string_view> choices;
  std::string_view meaning, source;
  double (*get)(const LawParameters&);
  void (*set)(LawParameters&, double);
  bool integer = false;  ///< must be whole
  bool silent = false;   ///< came after results had been stored: its default leaves no trace in the settings
};

/// A state variable of a material point beside stress and void ratio; a law has at most two.
struct StateVariable {
  std::string_view name, unit, meaning;
};
inline constexpr std::size_t most_state_variables = 2;
using PointHistory = std::array<double, most_state_variables>;

/// What a point starts from. Stresses are tension-positive.
struct PointStart {
  double depth;                   // [m] below the soil's top
  double s_rr, s_zz, s_tt, s_rz;  // [Pa]
  double e;                       // [-] void ratio
};

/// A law with a soil's parameters and the mechanisms that act on it, ready for a run.
class SoilModel {
 public:
  virtual ~SoilModel() = default;
  /// Updates stress, void ratio and state of a batch for one step; returns the largest P-wave modulus K + 4/3
  /// G [Pa] after it. Each point's result depends on that point alone.
  [[nodiscard]] virtual double update(const Batch& batch) const = 0;
  /// Poisson's ratio [-] of its elastic response.
  [[nodiscard]] virtual double poissons_ratio() const = 0;
  /// Points among the first `count` of a batch whose state a safeguard of the law holds, where the law itself
  /// would be undefined.
  [[nodiscard]] virtual std::int32_t safeguarded(const Batch&, std::int32_t /*count*/) const { return 0; }
  /// State variables at the start.
  [[nodiscard]] virtual PointHistory start(const PointStart&) const { return {}; }
};

/// What limits the sliding of a soil along the penetrometer.
struct ContactStrength {
  double friction = 0.0;  // [-] tangent of the contact friction angle
  double adhesion = 0.0;  // [Pa]
};

/// Which of the numerical settings that differ for sand and clay a law takes: a law with a yield surface of
/// its own at every point is treated as sand, whose stresses are never averaged.
enum class TreatedAs : std::uint8_t { sand, clay };

class Law {
 public:
  virtual ~Law() = default;

  [[nodiscard]] virtual std::string_view name() const = 0;    ///< "norsand", as in a study
  [[nodiscard]] virtual std::string_view title() const = 0;   ///< "NorSand"
  [[nodiscard]] virtual std::string_view models() const = 0;  ///< "drained sand"
  [[nodiscard]] virtual std::string_view source() const = 0;
  /// Where it departs from its source, one sentence.
  [[nodiscard]] virtual std::string_view departs() const = 0;
  [[nodiscard]] virtual std::span<const LawQuantity> quantities() const = 0;
  /// Of a soil with these mechanisms on.
  [[nodiscard]] virtual std::span<const StateVariable> state(const LawParameters&, const Mechanisms&) const {
    return {};
  }
  [[nodiscard]] virtual LawParameters defaults() const = 0;

  [[nodiscard]] virtual TreatedAs treated_as() const = 0;
  /// Whether contact.friction_ratio and contact.adhesion_ratio act on it.
  [[nodiscard]] virtual bool has_friction() const = 0;
  [[nodiscard]] virtual bool has_adhesion() const = 0;
  [[nodiscard]] virtual ContactStrength contact(const LawParameters&, const Contact&) const = 0;

  [[nodiscard]] virtual double void_ratio(const LawParameters&) const = 0;     ///< [-] before the push
  [[nodiscard]] virtual double grain_density(const LawParameters&) const = 0;  ///< [kg/m3]
  /// Whether mechanisms and an earlier push change its density.
  [[nodiscard]] virtual bool density_varies() const { return false; }
  /// Void ratio [-] at a depth [m], these included.
  [[nodiscard]] virtual double void_ratio_at(const Setup&, const LawParameters& parameters, const LeftBehind&,
                                             double /*depth*/) const {
    return void_ratio(parameters);
  }

  /// Void ratio [-] on the critical state line at a mean effective stress [Pa]; NaN without one.
  [[nodiscard]] virtual double critical_void_ratio(const LawParameters&, double /*p*/) const {
    return std::numeric_limits<double>::quiet_NaN();
  }

  [[nodiscard]] virtual std::unique_ptr<const SoilModel> model(const LawParameters&,
                                                               const Mechanisms&) const = 0;

  /// What is wrong with a soil of a setup whose values are all in range. Layers are checked first; where they
  /// are not sound, `sound_layers` is false.
  [[nodiscard]] virtual std::vector<Problem> problems(const Setup& setup, std::size_t soil,
                                                      bool sound_layers) const = 0;
};

/// All laws, in the order of LawParameters.
[[nodiscard]] std::span<const Law* const> all_laws();
[[nodiscard]] const Law* find_law(std::string_view name);  ///< nullptr if there is none
[[nodiscard]] const Law& law_of(const LawParameters& parameters);
[[nodiscard]] const Law& law_of(const Soil& soil);

}  // namespace cpt::solver
