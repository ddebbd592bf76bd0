// The project's source files and what they include.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cpt::tests {

struct Include {
  std::filesystem::path file;  // relative to the root, as all paths here
  int line;
  std::string header;
  bool quoted;
};

/// "file:line: header"
[[nodiscard]] std::string where(const Include& include);

/// Folders of the root that hold C++ and are no tests: the layers, if the page knows them all.
[[nodiscard]] std::vector<std::string> source_folders();
/// All .hpp and .cpp files of those.
[[nodiscard]] std::vector<std::filesystem::path> source_files();
[[nodiscard]] std::vector<Include> includes();

[[nodiscard]] std::vector<std::string> lines_of(const std::filesystem::path& file);

}  // namespace cpt::tests
