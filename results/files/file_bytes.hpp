// Files read whole, and what is no file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace cpt::results {

inline constexpr std::size_t largest_text = 64U << 20U;  ///< [bytes] more than any text that a person writes

/// "is a folder", "is a pipe", "is a socket" or "is a device": what stands where a file should. Empty for a
/// file, and where there is nothing, or nothing is known of it.
[[nodiscard]] std::string_view not_a_file(const std::filesystem::path& file);

/// All of a file, or of a pipe until its writers end; nothing, and why, where it cannot be read: it is
/// missing, a folder, a socket, nobody's to read, the disk fails, it is a pipe to which nobody writes
/// (std::errc::broken_pipe), a signal ends the wait for a pipe's writer (std::errc::interrupted), or it holds
/// more than `most` bytes (std::errc::file_too_large), as a device without an end does.
[[nodiscard]] std::optional<std::string> bytes_of(const std::filesystem::path& file, std::error_code& why,
                                                  std::size_t most = largest_text);

/// Why bytes_of() gave nothing, in words for the user.
[[nodiscard]] std::string cause_of(const std::filesystem::path& file, const std::error_code& why,
                                   std::size_t most = largest_text);

}  // namespace cpt::results
