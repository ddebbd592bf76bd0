// What goes wrong with the files of a campaign, in words for its user.
#pragma once

#include <stdexcept>

namespace cpt::results {

/// A database or curve file that cannot be used: locked, damaged, of another program or schema, unwritable.
/// `what()` names the file and what to do.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A database whose structure is damaged.
struct Damaged : Error {
  using Error::Error;
};

/// A signal ended the wait for a file.
struct Interrupted : Error {
  using Error::Error;
};

/// Another running campaign holds the database.
struct Locked : Error {
  using Error::Error;
};

}  // namespace cpt::results
