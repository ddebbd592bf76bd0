// What `campaign --version` prints.
#pragma once

#include <string>

namespace cpt::cli {

/// "campaign 0.1.0 (commit 0123456789, solver 0.4)"; the commit that the build was configured at, if it was a
/// clone. It is for the reader alone: stored results name the two versions.
[[nodiscard]] std::string version();

}  // namespace cpt::cli
