// Files that are either there whole or as they were before.
#pragma once

#include <filesystem>
#include <string_view>

#include "results/files/error.hpp"

namespace cpt::results {

/// Writes `start` and `rest` to FILE.tmp, down to the disk, and renames it to FILE, down to the disk too. Of
/// two programs that write the same file at once the later one waits. A link is followed, and what is no
/// ordinary file (/dev/stdout, a pipe) is written to as it is. Throws Error, naming the file and why, and
/// leaves no FILE.tmp.
void write_atomically(const std::filesystem::path& file, std::string_view start, std::string_view rest);

/// The same for what can be made again (figures, tables, pages): it is not waited for the disk.
void replace_file(const std::filesystem::path& file, std::string_view text);

/// Renames a file that is written to its name, down to the disk. Throws Error and removes `temporary`.
void move_into_place(const std::filesystem::path& temporary, const std::filesystem::path& file);

/// Makes a folder and those above it. Throws Error.
void make_folder(const std::filesystem::path& folder);

}  // namespace cpt::results
