#include "tests/architecture/architecture_page.hpp"

#include <algorithm>
#include <regex>
#include <stdexcept>

#include "tests/architecture/sources.hpp"

namespace cpt::tests {
namespace {

const char* const page = "docs/architecture.md";

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

// What stands before the words beside it, which two spaces or more keep apart.
std::string list_part(const std::string& text) {
  const std::string all = trimmed(text);
  return trimmed(all.substr(0, all.find("  ")));
}

std::set<std::string> names_in(const std::string& list, const std::vector<Layer>& above) {
  std::set<std::string> names;
  if (list == "nothing of the project") return names;
  if (list == "all")
    for (const Layer& layer : above) names.insert(layer.name);
  else
    for (std::size_t at = 0; at < list.size();) {
      const std::size_t end = std::min(list.find(',', at), list.size());
      names.insert(trimmed(list.substr(at, end - at)));
      at = end + 1;
    }
  return names;
}

}  // namespace

std::vector<Layer> layers_in(const std::vector<std::string>& lines) {
  std::vector<Layer> layers;
  for (auto line = std::ranges::find(lines, "## Layers"); line != lines.end(); ++line) {
    const std::size_t arrow = line->find("->");
    if (!line->starts_with("    ") || arrow == std::string::npos || (*line)[4] == ' ') {
      if (!layers.empty() && line->empty()) break;
      continue;
    }
    const std::string name = trimmed(line->substr(0, arrow));
    std::string list = list_part(line->substr(arrow + 2));
    while (list.ends_with(',') && line + 1 != lines.end()) list += " " + list_part(*++line);
    layers.push_back({name, names_in(list, layers)});
  }
  return layers;
}

std::vector<Library> libraries_in(const std::vector<std::string>& lines) {
  static const std::regex place("`([^`]+)`");
  std::vector<Library> libraries;
  auto line = std::ranges::find(lines, "| library | only in |");
  if (line == lines.end()) throw std::runtime_error("no table of libraries");
  for (line += 2; line != lines.end() && line->starts_with("| "); ++line) {
    const std::size_t bar = line->find(" | ", 2);
    Library library{line->substr(2, bar - 2), {}};
    for (std::sregex_iterator match(line->begin() + bar, line->end(), place), end; match != end; ++match)
      library.places.push_back((*match)[1]);
    if (library.places.empty() && line->substr(bar + 3) == "everywhere |") library.places.emplace_back();
    libraries.push_back(library);
  }
  return libraries;
}

std::vector<Promise> promises_in(const std::vector<std::string>& lines) {
  static const std::regex row(R"re(\| [^|]*\(`([a-z]+)`\)[^|]*\|.*\| (\d+) \| (\d+) \|)re");
  std::vector<Promise> list;
  auto line = std::ranges::find(lines, "| what | where | the list | new files | files that get a line |");
  if (line == lines.end()) throw std::runtime_error("no table of what is added");
  for (line += 2; line != lines.end() && line->starts_with("| "); ++line)
    if (std::smatch match; std::regex_match(*line, match, row))
      list.push_back({match[1], std::stoi(match[2]), std::stoi(match[3])});
  return list;
}

std::vector<Layer> layers() { return layers_in(lines_of(page)); }
std::vector<Library> libraries() { return libraries_in(lines_of(page)); }
std::vector<Promise> promises() { return promises_in(lines_of(page)); }

}  // namespace cpt::tests
