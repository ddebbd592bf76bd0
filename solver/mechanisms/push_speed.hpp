// A push at another speed than that for which the clay's strength is given.
//
//   s_u = s_u,0 (1 + lambda log10(V / V_0))      Dayal & Allen, Can. Geotech. J. 12 (1975) 336
//
// One factor on all of the clay's strength, its adhesion to the penetrometer with it: the solver's own speed
// stays, and the strength's spread over strain rates around the cone is rate_dependence.hpp.
#pragma once

namespace cpt::solver {

struct PushSpeed {
  double decades = 0.0;  // [-] log10(V / V_0)
  double lambda = 0.1;   // [-] rise of s_u per tenfold speed

  [[nodiscard]] bool on() const { return decades != 0.0; }
  /// Factor on the strength [-].
  [[nodiscard]] double factor() const { return 1.0 + lambda * decades; }
};

}  // namespace cpt::solver
