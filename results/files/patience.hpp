// How long to wait for a database that another program keeps locked: a database browser, a backup, sqlite3.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "results/files/error.hpp"

namespace cpt::results {

/// A database that another program, not a campaign, kept locked for longer than one waits.
struct Busy : Error {
  using Error::Error;
};

/// Asked about twenty times a second while one waits, with the seconds waited so far; false gives up, and
/// what waited throws Busy.
using Waiting = std::function<bool(const std::filesystem::path& database, double seconds)>;

/// While it lives, all databases of this program wait so; before, for ten seconds. At most one a time in use:
/// the innermost.
class Patience {
 public:
  explicit Patience(Waiting waiting);
  ~Patience();
  Patience(const Patience&) = delete;
  Patience& operator=(const Patience&) = delete;
  /// What the innermost says.
  [[nodiscard]] static bool lasts(const std::filesystem::path& database, double seconds);

 private:
  Waiting waiting_;
  Patience* outer_;
};

/// "process 4711 (sqlite3)", whoever holds a lock on the database; "another program" where the system does
/// not tell, as for programs on other machines.
[[nodiscard]] std::string who_keeps(const std::filesystem::path& database);

}  // namespace cpt::results
