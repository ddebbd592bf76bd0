// Random damage to files.
#pragma once

#include <random>
#include <span>
#include <string>

namespace cpt::fuzz {

/// The bytes after one to `most` edits: bits flipped, bytes overwritten, inserted and erased, lines repeated
/// and dropped, the end cut off, words put in. The same for the same state of the generator.
[[nodiscard]] std::string mutated(std::string bytes, std::span<const std::string> words, std::mt19937& random,
                                  int most = 5);

}  // namespace cpt::fuzz
