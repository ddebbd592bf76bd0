// Clay that is stronger the faster it shears.
//
//   s_u = s_u0 (1 + mu log10(max(rate, reference_rate) / reference_rate))      Einav & Randolph (2005)
//
// `rate` is the maximum shear strain rate of the step (largest less smallest principal strain rate).
#pragma once

namespace cpt::solver {

struct RateDependence {
  double mu = 0.0;                // [-] rise of s_u per tenfold rate
  double reference_rate = 0.003;  // [1/s] at which s_u was measured

  [[nodiscard]] bool on() const { return mu != 0.0; }
};

}  // namespace cpt::solver
