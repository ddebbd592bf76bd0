// Whether a folder is on this machine's disk or on a network, for which a database needs another journal.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace cpt::results {

enum class FileSystem { local, network };

/// By the magic number that statfs(2) tells (linux/magic.h and the sources of the file systems). FUSE may be
/// either; it counts as network, which is always safe.
[[nodiscard]] FileSystem file_system_of_magic(std::uint64_t magic);

/// Of the folder that holds `file`. Network where the system does not tell.
[[nodiscard]] FileSystem file_system_of(const std::filesystem::path& file);

/// SQLite's journal for it. WAL lets readers read while the campaign writes, but needs memory shared by all
/// processes that open the database, so they must be on one machine (sqlite.org/wal.html); the rollback
/// journal needs only locks that the network file system supports.
[[nodiscard]] constexpr std::string_view journal_mode(FileSystem system) {
  return system == FileSystem::local ? "WAL" : "DELETE";
}

}  // namespace cpt::results
