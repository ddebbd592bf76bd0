// What may happen to a campaign from outside, done to it, and what was found: nothing finished is lost or run
// twice, the database opens, the user is told, the exit code is a documented one.
#pragma once

#include <functional>
#include <ostream>
#include <set>
#include <string>
#include <vector>

namespace cpt::tests {

/// What came of one kind of fault.
struct Finding {
  std::string fault;
  int trials = 0;
  std::set<int> exit_codes = {};  ///< of the disturbed campaigns
  std::string told = {};          ///< a line that the user reads
  int lost = 0;                   ///< finished realizations that were gone afterwards, or had other bits
  int destroyed = 0;  ///< finished realizations that the fault itself made unreadable: they were run again
  int twice = 0;      ///< finished realizations that were started again
  int unopened = 0;   ///< times that the database did not open
  std::vector<std::string> problems = {};  ///< whatever went against the promise
};

/// A kind of fault; does it so often, at random moments or places that follow from the seed.
struct Fault {
  const char* name;  ///< of the test
  int few, many;     ///< trials in a test, and for docs/reliability.md
  std::function<Finding(int trials, unsigned seed)> inject;
};
/// Names the fault where GoogleTest would print bytes.
inline void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

[[nodiscard]] const std::vector<Fault>& all_faults();

// One file each: kills.cpp, storage_faults.cpp, refusal_faults.cpp, other_faults.cpp.
[[nodiscard]] std::vector<Fault> kills();
[[nodiscard]] std::vector<Fault> storage_faults();
[[nodiscard]] std::vector<Fault> refusal_faults();
[[nodiscard]] std::vector<Fault> other_faults();

}  // namespace cpt::tests
