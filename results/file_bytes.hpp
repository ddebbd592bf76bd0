// Files read whole.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <system_error>

namespace cpt::results {

/// All of a file; nothing, and why, where it cannot be read: it is missing, a folder, nobody's to read, or
/// the disk fails.
[[nodiscard]] std::optional<std::string> bytes_of(const std::filesystem::path& file, std::error_code& why);

}  // namespace cpt::results
