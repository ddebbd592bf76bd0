// Files that are either there whole or as they were before.
#pragma once

#include <filesystem>
#include <string_view>

#include "results/error.hpp"

namespace cpt::results {

/// Writes `start` and `rest` to FILE.tmp, down to the disk, and renames it to FILE, down to the disk too.
/// Throws Error, naming the file and why, and leaves no FILE.tmp.
void write_atomically(const std::filesystem::path& file, std::string_view start, std::string_view rest);

/// Renames a file that is written to its name, down to the disk. Throws Error and removes `temporary`.
void move_into_place(const std::filesystem::path& temporary, const std::filesystem::path& file);

}  // namespace cpt::results
