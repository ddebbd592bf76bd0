// Who made a result: versions, the hash of all settings, and the clock. Nothing here names a machine or a
// user.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "solver/setup.hpp"
#include "solver/simulate.hpp"

namespace cpt::results {

/// Version of this program, as in CMakeLists.txt.
[[nodiscard]] std::string_view program_version();

/// SHA-256 in lower-case hexadecimal, 64 characters.
[[nodiscard]] std::string sha256(std::string_view bytes);

/// Of what runs the setup: the embedded solver, or an external program, as the study says.
[[nodiscard]] std::string solver_version(const solver::Setup& setup);

/// Hash of every input of a run and of the solver's version: equal hashes mean equal bits.
[[nodiscard]] std::string settings_hash(const solver::Setup& setup);

/// Now, UTC, ISO 8601 with milliseconds: "2024-05-01T12:00:00.000Z".
[[nodiscard]] std::string utc_now();

/// Index of the first bin in which two curves differ in any bit (or in length), their number where what an
/// external program gave differs; nullopt if they are the same.
[[nodiscard]] std::optional<std::size_t> first_difference(const solver::DepthProfile& a,
                                                          const solver::DepthProfile& b);

}  // namespace cpt::results
