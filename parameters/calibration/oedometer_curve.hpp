// An oedometer test as a laboratory reports it.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace cpt::calibration {

struct OedometerReading {
  double sigma_v;  // [Pa] vertical effective stress, > 0
  double e;        // [-] void ratio
};

/// Compression without radial strain from the first reading on, loading alone.
struct OedometerCurve {
  std::string name;  ///< as the file calls the test; its file name without ending otherwise
  double e_0 = std::numeric_limits<double>::quiet_NaN();  // [-] void ratio at the first reading's stress;
                                                          // NaN: as the first reading has it
  double K_0 = std::numeric_limits<double>::quiet_NaN();  // [-] radial over vertical stress there; NaN: 0.5
  std::vector<OedometerReading> readings;                 ///< stress does not fall
};

}  // namespace cpt::calibration
