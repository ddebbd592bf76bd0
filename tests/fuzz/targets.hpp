// The readers of files that come from outside, one function each, which checks what the reader promises for
// any bytes: they are read with sound values or refused with a reason.
//
// corpus/NAME/ holds the inputs of a target: small sound ones, those that coverage-guided fuzzing
// (scripts/fuzz) found to reach further code, and every one that once did harm. corpus_test.cpp reads them
// all and mutations of them; libfuzzer.cpp makes a fuzzer of one target.
#pragma once

#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace cpt::fuzz {

enum class Fate { sound, refused };

/// Throws std::logic_error, which no reader throws for what a file says, if a promise was broken.
inline void promise(bool kept, const std::string& what) {
  if (!kept) throw std::logic_error("broken promise: " + what);
}

struct Target {
  std::string_view name;  ///< also of its folder in corpus/ and its file in dictionaries/, if it has one
  Fate (*read)(std::string_view bytes);
  std::string_view seeds;  ///< folder of the project with more inputs; empty for none
  int mutations;           ///< that the test tries of the corpus as a whole
};
[[nodiscard]] std::span<const Target> targets();

// In targets/, one file each.
Fate study(std::string_view toml);
Fate request(std::string_view toml);
Fate plan(std::string_view toml);
Fate recording(std::string_view bytes);
Fate triaxial_curve(std::string_view text);
Fate oedometer_curve(std::string_view text);
Fate database(std::string_view bytes);
Fate stored_values(std::string_view edits);
Fate hdf5_file(std::string_view bytes);
Fate hdf5_content(std::string_view layout);

/// The files of corpus/NAME/ and of the target's seeds, in alphabetical order.
[[nodiscard]] std::vector<std::filesystem::path> corpus(const Target& target);

/// The words of dictionaries/NAME.dict, in libFuzzer's format: one quoted text a line with \" \\ and \xNN.
/// None if there is no such file.
[[nodiscard]] std::vector<std::string> dictionary(const Target& target);

[[nodiscard]] std::string bytes_of(const std::filesystem::path& file);

}  // namespace cpt::fuzz
