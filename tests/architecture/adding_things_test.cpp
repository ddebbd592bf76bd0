// The samples of tests/adding/, which scripts/adding-things builds and tries, fit the tree as it is: their
// new files are new, what they go behind stands once where they say, and they take what the page promises.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "tests/architecture/architecture_page.hpp"
#include "tests/architecture/sources.hpp"

namespace cpt::tests {
namespace {

namespace fs = std::filesystem;

const fs::path samples = fs::path(PROJECT_ROOT) / "tests" / "adding";

std::vector<std::string> sample_names() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(samples)) names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(fs::path(PROJECT_ROOT) / file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// A record of `lines`: the text goes into the file right behind the anchor.
struct AddedLine {
  std::string file, anchor, text;
};

// As written, with "\\n" for a new line.
std::string unfolded(const std::string& text) {
  std::string lines;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const bool new_line = text.compare(k, 2, "\\n") == 0;
    lines += new_line ? '\n' : text[k];
    k += new_line ? 1 : 0;
  }
  return lines;
}

std::vector<AddedLine> added_lines(const std::string& sample) {
  std::vector<AddedLine> list;
  for (const std::string& line : lines_of(samples / sample / "lines")) {
    const std::size_t first = line.find('\t'), second = line.find('\t', first + 1);
    if (second == std::string::npos) {
      ADD_FAILURE() << sample << ": no PATH, ANCHOR, TEXT: " << line;
      continue;
    }
    list.push_back({line.substr(0, first), unfolded(line.substr(first + 1, second - first - 1)),
                    unfolded(line.substr(second + 1))});
  }
  return list;
}

std::vector<fs::path> new_files(const std::string& sample) {
  const fs::path root = samples / sample / "new";
  std::vector<fs::path> files;
  if (!fs::exists(root)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(root))
    if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), root));
  return files;
}

TEST(AddingThings, EverySampleHasItsRowOnThePage) {
  std::vector<std::string> promised;
  for (const Promise& promise : promises()) promised.push_back(promise.what);
  std::ranges::sort(promised);
  EXPECT_EQ(sample_names(), promised);
}

TEST(AddingThings, TakesAsManyFilesAsThePagePromises) {
  for (const Promise& promise : promises()) {
    std::set<std::string> touched;
    for (const AddedLine& line : added_lines(promise.what)) touched.insert(line.file);
    EXPECT_EQ(static_cast<int>(new_files(promise.what).size()), promise.new_files) << promise.what;
    EXPECT_EQ(static_cast<int>(touched.size()), promise.touched_files) << promise.what;
  }
}

TEST(AddingThings, WhatLinesGoBehindStandsOnce) {
  for (const std::string& sample : sample_names())
    for (const AddedLine& line : added_lines(sample)) {
      const std::string text = text_of(line.file);
      const std::size_t first = text.find(line.anchor);
      EXPECT_FALSE(line.anchor.empty() || line.text.empty()) << sample;
      EXPECT_NE(first, std::string::npos) << sample << ": " << line.file << " lacks\n" << line.anchor;
      EXPECT_EQ(text.rfind(line.anchor), first) << sample << ": twice in " << line.file << "\n"
                                                << line.anchor;
    }
}

TEST(AddingThings, NewFilesAreNew) {
  for (const std::string& sample : sample_names())
    for (const fs::path& file : new_files(sample))
      EXPECT_FALSE(fs::exists(fs::path(PROJECT_ROOT) / file)) << sample << ": " << file;
}

}  // namespace
}  // namespace cpt::tests
