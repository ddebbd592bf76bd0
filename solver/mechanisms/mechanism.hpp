// What the catalogue says of a mechanism: a physical effect that the study leaves out and that can be
// switched on.
#pragma once

#include <string_view>
#include <vector>

#include "solver/quantities.hpp"

namespace cpt::solver {

/// How a diagnosis looks for a parameter.
enum class Prior {
  even,   ///< evenly over the range
  depth,  ///< a place: evenly over the depths that are compared, whatever the range
  /// A fault of the instrument, mostly small: the range is four times what the cone's class allows, and two
  /// of three lie within that (the cube of an even number from -1 to 1).
  accuracy
};

/// A parameter of a mechanism, with the range over which a diagnosis looks for it.
struct MechanismParameter {
  Quantity quantity;                ///< name, unit, valid range; settable in a study like any other
  double prior_lower, prior_upper;  ///< [study units]
  Prior prior = Prior::even;
};

struct Mechanism {
  std::string_view name;       ///< "surface_compaction"; its quantities begin with it
  std::string_view title;      ///< what an engineer would say: "sand compacted near the surface"
  std::string_view equation;   ///< in plain text
  std::string_view source;     ///< of the equation and the prior
  std::string_view signature;  ///< what to expect in q_c, one sentence
  ActsOn acts_on;              ///< on soils of which laws, if not on all
  int needs_interfaces = 0;    ///< depths at which two soils must meet for it to act
  /// The first is the strength. The mechanism is off, bit for bit, where all parameters have their defaults.
  std::vector<MechanismParameter> parameters;
  /// Acts on what is recorded of the push (reading.hpp), not on the push: known without a run of its own.
  bool of_reading = false;
};

}  // namespace cpt::solver
