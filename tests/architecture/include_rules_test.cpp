// The layers of docs/architecture.md, checked over every source file: who may include whom, and where
// third-party names may appear. A change of these tables is a change of the architecture.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const std::map<std::string, std::set<std::string>> may_include = {
    {"drawing", {}},
    {"solver", {}},
    {"recordings", {}},
    {"parameters", {"solver"}},
    {"results", {"parameters", "solver"}},
    {"campaign", {"parameters", "results", "solver"}},
    {"diagnosis", {"recordings", "results", "campaign", "parameters", "solver"}},
    {"reports", {"drawing", "results", "diagnosis", "parameters", "solver"}},
    {"validation", {"drawing", "results", "diagnosis", "reports", "parameters", "solver"}},
    {"cli",
     {"campaign", "diagnosis", "drawing", "parameters", "recordings", "reports", "results", "solver",
      "validation"}},
};

// Headers from outside by pattern, and the only files (or folders, ending in '/') that may include them; ""
// is all. What matches nothing here may not be included at all.
struct Outside {
  const char* pattern;
  std::vector<std::string> places;
};
const std::vector<Outside> outside = {
    {"[a-z_0-9]+", {""}},  // the standard library
    {"fmt/.*", {""}},
    {"toml\\+\\+/.*", {"parameters/document.cpp"}},
    {"sqlite3\\.h", {"results/files/database.cpp"}},
    {"hdf5\\.h", {"results/files/hdf5_file.cpp"}},
    {"openssl/.*", {"results/ledger/provenance.cpp"}},
    {"mpi\\.h", {"campaign/mpi_transport.cpp"}},
    {"CLI/.*", {"cli/"}},
    {"nlohmann/.*",
     {"results/tables/json_document.cpp", "results/tables/table_format.cpp", "reports/",
      "validation/concealed/"}},
    {"librsvg/.*|cairo.*", {"drawing/pdf.cpp", "drawing/png.cpp", "drawing/text.cpp"}},
    {"gif_lib\\.h", {"drawing/gif.cpp"}},
    {"Eigen/.*",
     {"solver/", "parameters/calibration/trend.cpp", "parameters/designs/", "diagnosis/",
      "validation/concealed/"}},
    {"boost/math/.*",
     {"parameters/calibration/hardening.cpp", "results/statistics/discretization_error.cpp",
      "results/statistics/repeat_noise.cpp", "validation/concealed/scoring.cpp",
      "parameters/designs/bootstrap.cpp"}},
    {"boost/property_tree/.*", {"results/files/vtk_reader.cpp"}},
    {"boost/random/.*", {"parameters/designs/"}},
    {"omp\\.h|immintrin\\.h", {"solver/"}},
    // The operating system: locks on files, processes, the terminal.
    {"(sys/[a-z]+|fcntl|poll|unistd)\\.h", {"results/", "campaign/"}},
    {"(sched|signal|spawn)\\.h", {"campaign/"}},
};

struct Include {
  fs::path file;  // relative to the root
  int line;
  std::string header;
  bool quoted;
};

bool is_source(const fs::path& file) { return file.extension() == ".hpp" || file.extension() == ".cpp"; }

std::vector<fs::path> sources() {
  std::vector<fs::path> files;
  for (const auto& [layer, allowed] : may_include)
    if (fs::exists(fs::path(PROJECT_ROOT) / layer))
      for (const auto& entry : fs::recursive_directory_iterator(fs::path(PROJECT_ROOT) / layer))
        if (is_source(entry.path())) files.push_back(fs::relative(entry.path(), PROJECT_ROOT));
  return files;
}

std::vector<Include> includes() {
  const std::regex pattern("\\s*#\\s*include\\s*([<\"])([^>\"]+)[>\"].*");
  std::vector<Include> list;
  for (const fs::path& file : sources()) {
    std::ifstream stream(fs::path(PROJECT_ROOT) / file);
    int number = 0;
    for (std::string line; std::getline(stream, line);) {
      ++number;
      std::smatch match;
      if (std::regex_match(line, match, pattern)) list.push_back({file, number, match[2], match[1] == "\""});
    }
  }
  return list;
}

std::string where(const Include& include) {
  return include.file.string() + ":" + std::to_string(include.line) + ": " + include.header;
}

std::string layer_of(const fs::path& file) { return file.begin()->string(); }

TEST(IncludeRules, FindsTheSources) {
  EXPECT_GT(sources().size(), 50U);
  EXPECT_GT(includes().size(), 200U);
}

TEST(IncludeRules, LayersIncludeOnlyWhatIsBelowThem) {
  for (const Include& include : includes()) {
    if (!include.quoted) continue;
    const std::string layer = layer_of(include.file);
    const std::string other = layer_of(include.header);
    EXPECT_TRUE(may_include.contains(other))
        << where(include) << ": include project files from the root of the project";
    EXPECT_TRUE(other == layer || may_include.at(layer).contains(other)) << where(include);
  }
}

TEST(IncludeRules, ProjectHeadersAreQuotedAndExist) {
  for (const Include& include : includes()) {
    const bool ours = may_include.contains(layer_of(include.header)) && include.header.ends_with(".hpp");
    EXPECT_EQ(ours, include.quoted) << where(include);
    EXPECT_TRUE(!include.quoted || fs::exists(fs::path(PROJECT_ROOT) / include.header)) << where(include);
  }
}

bool allowed(const Include& include) {
  for (const Outside& rule : outside) {
    if (!std::regex_match(include.header, std::regex(rule.pattern))) continue;
    for (const std::string& place : rule.places)
      if (include.file == place ||
          ((place.empty() || place.ends_with('/')) && include.file.string().starts_with(place)))
        return true;
  }
  return false;
}

TEST(IncludeRules, ThirdPartyHeadersStayInTheirPlaces) {
  for (const Include& include : includes()) EXPECT_TRUE(include.quoted || allowed(include)) << where(include);
}

TEST(IncludeRules, LayersHaveNoCycles) {
  std::set<std::string> done;
  std::set<std::string> open;
  const std::function<void(const std::string&)> visit = [&](const std::string& layer) {
    ASSERT_FALSE(open.contains(layer)) << layer << " depends on itself";
    if (done.contains(layer)) return;
    open.insert(layer);
    for (const std::string& below : may_include.at(layer)) visit(below);
    open.erase(layer);
    done.insert(layer);
  };
  for (const auto& [layer, below] : may_include) visit(layer);
}

TEST(Files, HeadersAreGuardedAndFilesStayShort) {
  for (const fs::path& file : sources()) {
    std::ifstream stream(fs::path(PROJECT_ROOT) / file);
    int lines = 0;
    bool guarded = false;
    for (std::string line; std::getline(stream, line); ++lines) guarded = guarded || line == "#pragma once";
    EXPECT_LE(lines, 500) << file;
    EXPECT_TRUE(guarded || file.extension() == ".cpp") << file;
  }
}

}  // namespace
