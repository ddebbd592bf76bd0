// The two tables of docs/architecture.md that are the fence: the layers, and where names from outside may
// appear.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace cpt::tests {

struct Layer {
  std::string name;
  std::set<std::string> below;  // which it may include
};
/// In the order of the page.
[[nodiscard]] std::vector<Layer> layers();

struct Library {
  std::string name;
  std::vector<std::string> places;  // files, or folders with a '/' at the end; "" is all
};
[[nodiscard]] std::vector<Library> libraries();

// From the lines of a page.
[[nodiscard]] std::vector<Layer> layers_in(const std::vector<std::string>& lines);
[[nodiscard]] std::vector<Library> libraries_in(const std::vector<std::string>& lines);

}  // namespace cpt::tests
