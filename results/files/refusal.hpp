// Why the system refuses a file, and what to do about it, in words for the user.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

namespace cpt::results {

/// "FILE: cannot be written (No space left on device); free some space and run the same command again": for
/// `what` that could not be done and an errno.
[[nodiscard]] std::string refusal(const std::filesystem::path& file, std::string_view what, int error);
[[nodiscard]] std::string refusal(const std::filesystem::path& file, std::string_view what,
                                  const std::error_code& error);

}  // namespace cpt::results
