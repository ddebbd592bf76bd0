// How much more, or less, an effect does in other soil.
#pragma once

#include "diagnosis/curve_emulator.hpp"

namespace cpt::diagnosis {

/// In each curve delta(phi, t) = (1 + sum_j c_j s_j) delta(phi), s = t - t_0 the soil's places less the
/// baseline's. c is that of a ridge regression of the effect's joint runs whose penalty predicts them best
/// when each is left out in turn (Allen 1974); where none helps, c = 0 and the effect is the same in all
/// soil.
class SoilScaling {
 public:
  /// `effect` is what `emulator` was made from.
  SoilScaling(const std::vector<Cell>& cells, const MechanismEffect& effect, const CurveEmulator& emulator);

  /// The emulator in soil of these places less the baseline's (p): its curves times the factor, at least 0.1,
  /// and for its joint runs' residuals what the others' factors leave of each.
  [[nodiscard]] CurveEmulator at(const VectorXd& s) const;

 private:
  struct Part {
    Index top, count;  // of a curve's cells
    VectorXd c;        // p
  };
  const CurveEmulator* emulator_;
  std::vector<Part> parts_;
  MatrixXd left_out_;  // n x joint runs
};

}  // namespace cpt::diagnosis
