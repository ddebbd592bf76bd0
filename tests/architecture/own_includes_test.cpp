// Every file includes what it uses, itself or through headers of the project. The quickstart's unity build
// (CMakePresets.json) would hide what is missing until somebody builds without.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/architecture/sources.hpp"

namespace cpt {
namespace {

namespace fs = std::filesystem;

// Names, and the headers of which one has to be included where they are used.
const std::vector<std::pair<std::vector<std::string>, std::set<std::string>>> homes = {
    {{"sort", "stable_sort", "find_if", "any_of", "all_of", "none_of", "count_if", "copy_if", "min_element",
      "max_element", "minmax_element", "clamp", "transform", "lower_bound", "upper_bound", "binary_search",
      "equal_range", "nth_element"},
     {"algorithm"}},
    {{"array"}, {"array"}},
    {{"sqrt",  "exp",  "log",    "log10",   "log1p",    "expm1", "pow",   "sin", "cos",    "tan",
      "floor", "ceil", "lround", "llround", "isfinite", "isnan", "hypot", "erf", "lgamma", "lerp"},
     {"cmath"}},
    {{"int64_t", "uint64_t", "int32_t", "uint32_t", "uint8_t", "int8_t", "uint16_t"}, {"cstdint"}},
    {{"filesystem"}, {"filesystem"}},
    {{"ifstream", "ofstream", "fstream"}, {"fstream"}},
    {{"function", "greater", "less", "plus"}, {"functional"}},
    {{"numeric_limits"}, {"limits"}},
    {{"map", "multimap"}, {"map"}},
    {{"unique_ptr", "shared_ptr", "make_unique", "make_shared"}, {"memory"}},
    {{"numbers"}, {"numbers"}},
    {{"accumulate", "iota", "inner_product", "partial_sum", "midpoint"}, {"numeric"}},
    {{"optional", "nullopt"}, {"optional"}},
    {{"set", "multiset"}, {"set"}},
    {{"span"}, {"span"}},
    {{"istringstream", "ostringstream", "stringstream"}, {"sstream"}},
    {{"runtime_error", "logic_error", "invalid_argument", "out_of_range", "domain_error"}, {"stdexcept"}},
    {{"string", "to_string"},
     {"string", "filesystem", "fstream", "sstream", "stdexcept", "fmt/format.h", "CLI/CLI.hpp"}},
    {{"string_view"}, {"string_view", "string", "filesystem", "charconv"}},
    {{"pair", "exchange", "swap"},
     {"utility", "map", "vector", "algorithm", "variant", "memory", "optional"}},
    {{"variant", "get_if", "holds_alternative", "visit", "monostate"}, {"variant"}},
    {{"vector"}, {"vector"}},
};
// The same for namespaces of others; a file that only declares `class X;` of one needs no header.
const std::map<std::string, std::set<std::string>> namespaces = {
    {"fmt", {"fmt/format.h"}}, {"CLI", {"CLI/CLI.hpp"}}, {"Eigen", {"Eigen/Core", "Eigen/Dense"}}};

const std::map<std::string, std::set<std::string>>& headers_by_name() {
  static const auto headers = [] {
    std::map<std::string, std::set<std::string>> map;
    for (const auto& [names, home] : homes)
      for (const std::string& name : names) map["std::" + name] = home;
    for (const auto& [name, home] : namespaces) map[name] = home;
    return map;
  }();
  return headers;
}

struct Source {
  std::vector<std::string> headers;  // included
  std::set<std::string> names;       // used: std::NAME, or another namespace
};

// Without comments and what stands in quotes.
std::string code_of(const std::string& line) {
  std::string code;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line.compare(i, 2, "//") == 0) break;
    if (line[i] == '"')
      while (++i < line.size() && line[i] != '"') i += line[i] == '\\' ? 1 : 0;
    else
      code += line[i];
  }
  return code;
}

Source read(const fs::path& file) {
  static const std::regex include("\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"].*");
  static const std::regex name(R"re(\b(std::(?:ranges::)?[a-z_0-9]+|fmt|CLI|Eigen)\b(::|[^:]|$))re");
  static const std::regex declared(R"re(namespace (CLI|Eigen) \{)re");
  Source source;
  std::ifstream stream(file);
  std::set<std::string> forward;
  for (std::string line; std::getline(stream, line);) {
    std::smatch match;
    if (std::regex_match(line, match, include)) {
      source.headers.push_back(match[1]);
      continue;
    }
    if (std::regex_search(line, match, declared)) forward.insert(match[1]);
    const std::string code = code_of(line);
    for (std::sregex_iterator use(code.begin(), code.end(), name), end; use != end; ++use) {
      std::string used = (*use)[1];
      if (const auto ranges = used.find("ranges::"); ranges != std::string::npos) used.erase(ranges, 8);
      if (used.starts_with("std::") || (*use)[2] == "::") source.names.insert(used);
    }
  }
  for (const std::string& known : forward) source.names.erase(known);
  return source;
}

std::map<std::string, Source> all_sources() {
  std::map<std::string, Source> sources;
  for (const fs::path& file : tests::source_files())
    sources[file.string()] = read(fs::path(PROJECT_ROOT) / file);
  return sources;
}

// Headers from outside that a file sees.
void collect(const std::map<std::string, Source>& sources, const std::string& file,
             std::set<std::string>& visited, std::set<std::string>& headers) {
  if (!visited.insert(file).second) return;
  const auto found = sources.find(file);
  if (found == sources.end()) {
    headers.insert(file);
    return;
  }
  for (const std::string& header : found->second.headers) collect(sources, header, visited, headers);
}

// "std::map" and the like that a file uses without a header of it.
std::vector<std::string> missing(const std::map<std::string, Source>& sources, const std::string& file) {
  std::set<std::string> visited, headers;
  collect(sources, file, visited, headers);
  std::vector<std::string> names;
  for (const std::string& name : sources.at(file).names) {
    const auto home = headers_by_name().find(name);
    if (home == headers_by_name().end()) continue;
    bool seen = false;
    for (const std::string& header : home->second) seen = seen || headers.contains(header);
    if (!seen) names.push_back(name);
  }
  return names;
}

TEST(OwnIncludes, EveryFileIncludesWhatItUses) {
  const auto sources = all_sources();
  ASSERT_GT(sources.size(), 300U);
  for (const auto& [file, source] : sources)
    for (const std::string& name : missing(sources, file))
      ADD_FAILURE() << file << ": uses " << name << ", includes none of its headers";
}

TEST(OwnIncludes, WhatIsMissingIsFound) {
  const std::map<std::string, Source> sources = {
      {"a.hpp", {{"map"}, {}}},
      {"a.cpp", {{"a.hpp", "fmt/format.h"}, {"std::map", "std::vector", "fmt", "std::string"}}}};
  EXPECT_EQ(missing(sources, "a.cpp"), std::vector<std::string>{"std::vector"});
}

TEST(OwnIncludes, CommentsAndTextsAreNoUse) {
  EXPECT_EQ(code_of(R"re(f("std::map \" x", a);  // std::set)re"), "f(, a);  ");
}

}  // namespace
}  // namespace cpt
