// What a push records over depth, each channel told once: recorder, messages between processes, ledger,
// curves, tables and reports read this list. A new channel is a member of DepthProfile, its entry in
// channels.cpp and the code that measures it.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "solver/penetrometer.hpp"

namespace cpt::solver {

/// What an external program gave for one of its declared outputs (external_program.hpp).
struct ProgramResult {
  std::string name;
  std::vector<double> x;  ///< abscissa of a curve, rising; empty of a scalar
  std::vector<double> y;  ///< as long as x; one number of a scalar
  friend bool operator==(const ProgramResult&, const ProgramResult&) = default;
};

/// Depth profile of a push, one row a depth bin. A channel that was not recorded, as by an earlier program,
/// is empty; all others have the length of `depth`.
struct DepthProfile {
  std::vector<double> depth;             // [m] centre of the bin, depth of the tip below the soil's top
  std::vector<double> q_c;               // [Pa]
  std::vector<double> f_s;               // [Pa]
  std::vector<double> wall_stress = {};  // [Pa]
  /// In place of all others, of an external program: in the order and the units of their declaration.
  std::vector<ProgramResult> declared = {};

  [[nodiscard]] bool is_empty() const { return depth.empty() && declared.empty(); }
};

/// What a step tells the channels.
struct StepLoads {
  PenetrometerLoad penetrometer;
  double wall_stress = 0.0;  // [Pa] on the chamber's wall at the level of the tip, compression-positive
};

struct Channel {
  std::string_view name;     ///< of columns and keys, with "_kPa" or "_Pa" behind
  std::string_view symbol;   ///< UTF-8, what stands behind "_" is a subscript
  std::string_view title;    ///< "cone tip resistance"
  std::string_view meaning;  ///< where it is measured and how it is averaged, with its sign
  std::vector<double> DepthProfile::*values;
  /// Averaged over the time spent in a bin; a force [N] where it is divided by the cone's projected area,
  /// else a stress [Pa].
  double (*measured)(const StepLoads&);
  bool by_projected_area;
  bool required;  ///< a curve without it is none
  /// Accuracy of a recording relative to that of q_c (ISO 22476-1:2012, Table 2); NaN where no standard
  /// tells.
  double deviation_over_q_c;
};

/// All members of a profile but the depths and what an external program gave.
inline constexpr std::size_t channel_count = sizeof(DepthProfile) / sizeof(std::vector<double>) - 2;

/// q_c first.
[[nodiscard]] std::span<const Channel> channels();
[[nodiscard]] const Channel& channel(std::string_view name);  ///< throws std::out_of_range
/// The name with what stands behind it in columns: "q_c_kPa".
[[nodiscard]] std::string in_unit(const Channel& channel, std::string_view unit);

/// Whether all channels have one value a bin or none, the required ones one a bin; and a declared curve as
/// many ordinates as abscissas.
[[nodiscard]] bool is_even(const DepthProfile& profile);

}  // namespace cpt::solver
