// What a process said last.
#pragma once

#include <string>
#include <string_view>

namespace cpt::campaign {

/// The last line that says something, in plain characters, 300 at most.
[[nodiscard]] std::string last_line(std::string_view text);

/// "killed by signal 11 (Segmentation fault)"
[[nodiscard]] std::string killed_by(int signal);

}  // namespace cpt::campaign
