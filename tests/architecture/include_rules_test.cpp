// The fence of docs/architecture.md, held over every source file: who may include whom, and where names from
// outside may appear. The page's two tables are the rules; a change of them is a change of the architecture.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/architecture/architecture_page.hpp"
#include "tests/architecture/sources.hpp"

namespace cpt::tests {
namespace {

namespace fs = std::filesystem;

// Headers of the page's libraries; "" has none in C++. The standard library's may be included everywhere.
const std::map<std::string, std::string> headers = {
    {"fmt", "fmt/.*"},
    {"toml++", "toml\\+\\+/.*"},
    {"SQLite", "sqlite3\\.h"},
    {"HDF5", "hdf5\\.h"},
    {"OpenSSL (SHA-256)", "openssl/.*"},
    {"MPI", "mpi\\.h"},
    {"librsvg, cairo", "librsvg/.*|cairo.*"},
    {"giflib", "gif_lib\\.h"},
    {"D3, Observable Plot (JavaScript)", ""},
    {"CLI11", "CLI/.*"},
    {"nlohmann/json", "nlohmann/.*"},
    {"Eigen", "(unsupported/)?Eigen/.*"},
    {"Boost.Math", "boost/math/.*"},
    {"Boost.PropertyTree (XML)", "boost/property_tree/.*"},
    {"Boost.Random", "boost/random/.*"},
    {"OpenTURNS", "openturns/.*"},
    {"OpenMP, vector instructions", "omp\\.h|immintrin\\.h"},
    {"POSIX: modules", "dlfcn\\.h"},
    {"POSIX: files and locks", "(sys/[a-z]+|fcntl|poll|unistd)\\.h"},
    {"POSIX: processes and signals", "(sched|signal|spawn)\\.h"},
};
const std::regex standard("[a-z_0-9]+");

std::string layer_of(const fs::path& file) { return file.begin()->string(); }

bool lies_in(const fs::path& file, const std::string& place) {
  return file == place ||
         ((place.empty() || place.ends_with('/')) && file.generic_string().starts_with(place));
}

std::map<std::string, std::set<std::string>> may_include() {
  std::map<std::string, std::set<std::string>> rules;
  for (const Layer& layer : layers()) rules[layer.name] = layer.below;
  return rules;
}

TEST(IncludeRules, FindsTheSources) {
  EXPECT_GT(source_files().size(), 400U);
  EXPECT_GT(includes().size(), 2000U);
}

TEST(IncludeRules, LayersIncludeOnlyWhatIsBelowThem) {
  const auto rules = may_include();
  for (const Include& include : includes()) {
    if (!include.quoted) continue;
    const std::string layer = layer_of(include.file);
    const std::string other = layer_of(include.header);
    EXPECT_TRUE(rules.contains(other))
        << where(include) << ": include project files from the root of the project";
    EXPECT_TRUE(other == layer || (rules.contains(layer) && rules.at(layer).contains(other)))
        << where(include);
  }
}

// A layer that the page lets in and nothing includes: the fence is wider than it need be.
TEST(IncludeRules, LayersIncludeAllThatThePageSays) {
  std::map<std::string, std::set<std::string>> used;
  for (const Include& include : includes())
    if (include.quoted) used[layer_of(include.file)].insert(layer_of(include.header));
  for (const auto& [layer, below] : may_include())
    for (const std::string& other : below)
      EXPECT_TRUE(used[layer].contains(other)) << layer << " -> " << other;
}

TEST(IncludeRules, ProjectHeadersAreQuotedAndExist) {
  const auto rules = may_include();
  for (const Include& include : includes()) {
    const bool ours = rules.contains(layer_of(include.header)) && include.header.ends_with(".hpp");
    EXPECT_EQ(ours, include.quoted) << where(include);
    EXPECT_TRUE(!include.quoted || fs::exists(fs::path(PROJECT_ROOT) / include.header)) << where(include);
  }
}

TEST(IncludeRules, FilesHaveNoCycles) {
  std::map<std::string, std::vector<std::string>> included;
  for (const Include& include : includes())
    if (include.quoted) included[include.file.generic_string()].push_back(include.header);
  std::set<std::string> done, open;
  const std::function<void(const std::string&)> visit = [&](const std::string& file) {
    if (open.contains(file)) ADD_FAILURE() << file << " includes itself";
    if (open.contains(file) || done.contains(file)) return;
    open.insert(file);
    for (const std::string& header : included[file]) visit(header);
    open.erase(file);
    done.insert(file);
  };
  std::vector<std::string> files;
  for (const auto& [file, list] : included) files.push_back(file);
  for (const std::string& file : files) visit(file);
}

TEST(IncludeRules, ThirdPartyHeadersStayInTheirPlaces) {
  const std::vector<Library> page = libraries();
  for (const Library& library : page) EXPECT_TRUE(headers.contains(library.name)) << library.name;
  EXPECT_EQ(page.size(), headers.size());
  std::vector<std::pair<std::regex, const Library*>> rules;
  for (const Library& library : page)
    if (headers.contains(library.name)) rules.emplace_back(headers.at(library.name), &library);
  std::set<std::pair<const Library*, std::string>> used;
  for (const Include& include : includes()) {
    if (include.quoted || std::regex_match(include.header, standard)) continue;
    bool allowed = false;
    for (const auto& [pattern, library] : rules)
      if (std::regex_match(include.header, pattern))
        for (const std::string& place : library->places)
          if (lies_in(include.file, place)) {
            allowed = true;
            used.insert({library, place});
          }
    EXPECT_TRUE(allowed) << where(include);
  }
  for (const Library& library : page)
    for (const std::string& place : library.places)
      EXPECT_TRUE(used.contains({&library, place}) || headers.at(library.name).empty())
          << library.name << " is not in " << place;
}

TEST(Files, HeadersAreGuardedAndFilesStayShort) {
  for (const fs::path& file : source_files()) {
    const std::vector<std::string> lines = lines_of(file);
    EXPECT_LE(lines.size(), 500U) << file;
    EXPECT_TRUE(file.extension() == ".cpp" || std::ranges::find(lines, "#pragma once") != lines.end())
        << file;
  }
}

}  // namespace
}  // namespace cpt::tests
