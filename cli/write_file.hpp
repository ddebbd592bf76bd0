// Text to a file that the command line names.
#pragma once

#include <filesystem>
#include <string_view>

namespace cpt::cli {

/// Replaces the file; throws results::Error if it cannot be written.
void write_file(const std::filesystem::path& file, std::string_view text);

}  // namespace cpt::cli
