// The page of a concealed benchmark: how often the diagnosis was right, and what it missed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "validation/concealed/judge.hpp"

namespace cpt::validation::concealed {

/// One plan's cases, opened.
struct Benchmark {
  std::string name, title, profile, preset, drawn;
  std::vector<std::string> mechanisms;  ///< that its diagnoses weigh
  std::vector<Judged> cases;
  int withheld = 0;     ///< drawn, but their solver runs failed
  int solver_runs = 0;  ///< behind all its diagnoses, the truths not counted
};

/// Writes the page and, in the folder of its name beside it, its figures; returns all files. `note` is text
/// that the page begins with after its title (Markdown; how the thresholds were frozen), may be empty.
std::vector<std::filesystem::path> write_page(const std::vector<Benchmark>& benchmarks,
                                              const std::string& note, const std::filesystem::path& file);

/// A case counts as detectable from this strength [standard deviations] on.
inline constexpr double detectable = 3.0;
/// And as strong from this.
inline constexpr double strong = 6.0;

}  // namespace cpt::validation::concealed
