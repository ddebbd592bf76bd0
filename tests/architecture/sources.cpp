#include "tests/architecture/sources.hpp"

#include <algorithm>
#include <fstream>
#include <regex>
#include <set>

namespace cpt::tests {
namespace {

namespace fs = std::filesystem;

bool is_source(const fs::path& file) { return file.extension() == ".hpp" || file.extension() == ".cpp"; }

std::vector<fs::path> sources_below(const std::string& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(PROJECT_ROOT) / folder))
    if (is_source(entry.path())) files.push_back(fs::relative(entry.path(), PROJECT_ROOT));
  return files;
}

}  // namespace

std::string where(const Include& include) {
  return include.file.string() + ":" + std::to_string(include.line) + ": " + include.header;
}

std::vector<std::string> source_folders() {
  const std::set<std::string> others = {"benchmarks", "build", "tests"};
  std::vector<std::string> folders;
  for (const auto& entry : fs::directory_iterator(PROJECT_ROOT)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_directory() && !name.starts_with('.') && !others.contains(name) &&
        !sources_below(name).empty())
      folders.push_back(name);
  }
  std::ranges::sort(folders);
  return folders;
}

std::vector<fs::path> source_files() {
  std::vector<fs::path> files;
  for (const std::string& folder : source_folders())
    for (const fs::path& file : sources_below(folder)) files.push_back(file);
  return files;
}

std::vector<Include> includes() {
  static const std::regex pattern("\\s*#\\s*include\\s*([<\"])([^>\"]+)[>\"].*");
  std::vector<Include> list;
  for (const fs::path& file : source_files()) {
    int number = 0;
    for (const std::string& line : lines_of(file)) {
      ++number;
      std::smatch match;
      if (std::regex_match(line, match, pattern)) list.push_back({file, number, match[2], match[1] == "\""});
    }
  }
  return list;
}

std::vector<std::string> lines_of(const fs::path& file) {
  std::ifstream stream(fs::path(PROJECT_ROOT) / file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace cpt::tests
