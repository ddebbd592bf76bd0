// What an external program wrote, read as its declared outputs.
#pragma once

#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "solver/channels.hpp"
#include "solver/external_program.hpp"

namespace cpt::campaign {

/// `what()` says what is wrong with it.
struct BadResults : std::runtime_error {
  BadResults(const std::string& message, bool is_not_finite = false)
      : std::runtime_error(message), not_finite(is_not_finite) {}
  bool not_finite;  ///< a NaN or an infinite number: the program ran, its numbers did not converge
};

/// From a JSON object, where it begins with a brace, or a CSV table with a header line. A scalar is a number,
/// or the first one of a column; a curve is the two arrays or columns of its name and of its abscissa, of the
/// same length, the abscissa rising; a column may end before others do. What is not declared is not read.
/// Throws BadResults.
[[nodiscard]] std::vector<solver::ProgramResult> read_results(
    std::string_view text, std::span<const solver::ProgramOutput> declared);

}  // namespace cpt::campaign
