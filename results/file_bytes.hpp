// Files read whole.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>

namespace cpt::results {

/// All of a file; nothing, and why, where it cannot be read: it is missing, a folder, nobody's to read, the
/// disk fails, or it holds more than `most` bytes (std::errc::file_too_large), as a device without an end
/// does.
[[nodiscard]] std::optional<std::string> bytes_of(const std::filesystem::path& file, std::error_code& why,
                                                  std::size_t most = SIZE_MAX);

}  // namespace cpt::results
