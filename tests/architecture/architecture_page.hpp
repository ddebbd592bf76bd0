// The tables of docs/architecture.md that are held: the layers and where names from outside may appear, which
// are the fence, and what it takes to add things.
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

/// What the page promises of something that is added.
struct Promise {
  std::string what;  // its name in brackets: "law"
  int new_files, touched_files;
};
[[nodiscard]] std::vector<Promise> promises();

// From the lines of a page.
[[nodiscard]] std::vector<Layer> layers_in(const std::vector<std::string>& lines);
[[nodiscard]] std::vector<Library> libraries_in(const std::vector<std::string>& lines);
[[nodiscard]] std::vector<Promise> promises_in(const std::vector<std::string>& lines);

}  // namespace cpt::tests
