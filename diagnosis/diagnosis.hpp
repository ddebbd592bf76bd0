// All that a diagnosis found.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/covariance.hpp"
#include "diagnosis/held_out.hpp"
#include "diagnosis/isolability.hpp"
#include "diagnosis/locate.hpp"
#include "diagnosis/verdict.hpp"

namespace cpt::diagnosis {

/// What was compared: the complete rows of the problem, and how much noise they hold.
struct Compared {
  std::vector<Index> rows;  ///< of the problem
  std::vector<Cell> cells;  ///< of these rows; all vectors of cells refer to them
  NoiseModel measurement;
  std::optional<ShrunkCovariance> numerical;
};

/// The study without any mechanism.
struct NullFit {
  Recalibration recalibrated;
  PredictiveCheck check;
};

struct MechanismFit {
  MechanismEvidence evidence;
  Recalibration recalibrated;  ///< the null beside it; the curve includes it
};

/// The most probable mechanism, whatever the answer is.
struct BestMechanism {
  std::size_t mechanism;
  std::optional<HeldOutGain> held_out;  ///< none if one block would be all
};

/// The answer with other prior widths.
struct PriorVariation {
  std::string what;
  std::string answer;
  bool changed;
};

struct Diagnosis {
  Compared compared;
  NullFit null;
  Location location;
  std::vector<MechanismFit> mechanisms;  ///< in the problem's order
  std::vector<PairEvidence> pairs;       ///< the most probable first
  Verdict verdict;
  Isolability isolability;
  std::vector<NextMeasurement> next;  ///< filled in by what rank_next_measurements says
  std::optional<BestMechanism> best;  ///< none where no mechanism was weighed
  std::vector<PriorVariation> variations;

  /// The null beside the best mechanism, where there is one.
  [[nodiscard]] const Recalibration& with_best() const { return mechanisms[best->mechanism].recalibrated; }
};

}  // namespace cpt::diagnosis
