// NorSand: critical state plasticity of sand (Jefferies & Been 2015), exponential critical state line.
#pragma once

#include "solver/constitutive/batch.hpp"
#include "solver/constitutive/kernels.hpp"
#include "solver/mechanisms/grain_crushing.hpp"
#include "solver/soils/norsand.hpp"

namespace cpt::solver {

/// The law for one set of parameters. Choices beyond the book, all parameters of NorSandParameters:
/// associated deviatoric flow with a rounded corner at triaxial compression, or radial flow; the inner cap
/// p_i <= cap_ratio p_mx; no stress below p_min; the exponent of the hardening rule. The softening term of
/// undrained loading is left out.
class NorSand {
 public:
  /// `sand` must be in the ranges of the quantities list; otherwise results may be non-finite.
  explicit NorSand(const NorSandParameters& sand, const GrainCrushing& crushing = {});

  /// Updates stress, void ratio and image pressure of a batch for one step. Returns the largest P-wave
  /// modulus K + 4/3 G [Pa] after it. Each point's result depends on that point alone; a point with
  /// non-finite input becomes non-finite.
  double update(const Batch& batch) const { return kernels_->update_norsand(constants_, batch); }

  /// Image pressure p_i [Pa] that puts a stress state [Pa, tension-positive] on the yield surface at void
  /// ratio e, times OCR.
  [[nodiscard]] double initial_image_pressure(double s_rr, double s_zz, double s_tt, double s_rz,
                                              double e) const;

  /// Invariants, moduli, dilatancy and distance from the yield surface of one state.
  [[nodiscard]] NorSandState evaluate(const PointStress& stress, double e, double p_i) const {
    return kernels_->evaluate_norsand(constants_, stress, e, p_i);
  }

  [[nodiscard]] const NorSandConstants& constants() const { return constants_; }

 private:
  NorSandConstants constants_;
  const ConstitutiveKernels* kernels_;
  double OCR_;  // [-]
};

}  // namespace cpt::solver
