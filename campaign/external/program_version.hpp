// The version of an external program, as it tells it itself.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace cpt::campaign {

/// `what()` says why there is none.
struct NoVersion : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What the command prints, without blanks at its ends; at most 2000 characters, within 30 s. It runs in the
/// study's folder. Throws NoVersion where it cannot be started, fails, or says nothing.
[[nodiscard]] std::string program_version(const std::vector<std::string>& command, const std::string& folder);

}  // namespace cpt::campaign
