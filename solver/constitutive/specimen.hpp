// One material point strained by hand: what element tests and the tests of the laws drive.
#pragma once

#include <functional>

#include "solver/constitutive/batch.hpp"
#include "solver/constitutive/kernels.hpp"

namespace cpt::solver {

/// Holds the state of one point and a law; copies are independent.
class Specimen {
 public:
  /// `law` is any class with `update(const Batch&)`; it is copied. Stress in Pa, tension-positive; h_0 and
  /// h_1 are the state variables that the law has.
  template <typename Law>
  Specimen(const Law& law, const PointStress& stress, double e, double h_0 = 0.0, double h_1 = 0.0)
      : update_([law](const Batch& batch) { return law.update(batch); }),
        stress_(stress),
        e_(e),
        h_0_(h_0),
        h_1_(h_1) {}

  /// Applies one strain increment (tension-positive, tensor shear).
  void strain(double d_rr, double d_zz, double d_tt, double d_rz);

  [[nodiscard]] const PointStress& stress() const { return stress_; }
  [[nodiscard]] double e() const { return e_; }
  [[nodiscard]] double h_0() const { return h_0_; }
  [[nodiscard]] double h_1() const { return h_1_; }
  [[nodiscard]] double p() const {
    return -(stress_.rr + stress_.zz + stress_.tt) / 3.0;
  }  // [Pa] mean stress
  /// Largest P-wave modulus [Pa] that the last update returned.
  [[nodiscard]] double modulus() const { return modulus_; }

 private:
  std::function<double(const Batch&)> update_;
  PointStress stress_;
  double e_, h_0_, h_1_, modulus_ = 0.0;
};

}  // namespace cpt::solver
