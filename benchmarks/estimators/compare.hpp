#pragma once

#include <string>

namespace cpt::benchmarks {

/// A row for each function and estimator; the sample is a CSV file with a header, places in the unit cube as
/// sobol_places orders them and a result. 1 where Martinez' estimator, the same formula in both, differs by
/// more than rounding, or where there is no sample.
int print_comparison(const std::string& sample_file);

}  // namespace cpt::benchmarks
