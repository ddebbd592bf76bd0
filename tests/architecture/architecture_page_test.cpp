// The page's tables are read as they are meant, and they hold of the tree.
#include "tests/architecture/architecture_page.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "tests/architecture/sources.hpp"

namespace cpt::tests {
namespace {

TEST(ArchitecturePage, ListsGoOnInTheNextLineAfterAComma) {
  const auto layers =
      layers_in({"## Layers", "An arrow -> means", "", "    a  -> nothing of the project  first",
                 "    b  -> a               second;", "                          more of it",
                 "    c  -> b,              third ->", "          a               more",
                 "    d  -> all             last", "", "    e  -> a"});
  ASSERT_EQ(layers.size(), 4U);
  EXPECT_EQ(layers[0].below, std::set<std::string>{});
  EXPECT_EQ(layers[1].below, std::set<std::string>{"a"});
  EXPECT_EQ(layers[2].below, (std::set<std::string>{"a", "b"}));
  EXPECT_EQ(layers[3].below, (std::set<std::string>{"a", "b", "c"}));
}

TEST(ArchitecturePage, PlacesOfLibrariesStandInBackticks) {
  const auto libraries = libraries_in({"| library | only in |", "|---|---|", "| A, b | `x/a.cpp`, `y/` |",
                                       "| C | everywhere |", "", "| D | `z/` |"});
  ASSERT_EQ(libraries.size(), 2U);
  EXPECT_EQ(libraries[0].name, "A, b");
  EXPECT_EQ(libraries[0].places, (std::vector<std::string>{"x/a.cpp", "y/"}));
  EXPECT_EQ(libraries[1].places, std::vector<std::string>{""});
}

TEST(ArchitecturePage, PromisesAreTheRowsWithAName) {
  const auto promises =
      promises_in({"| what | where | the list | new files | files that get a line |", "|---|---|---|---|---|",
                   "| law (`law`), of soil | `a.hpp` | `b.hpp` | 2 | 1 |",
                   "| figure | `c.cpp` | `d.hpp` | 1 | 3 |", "", "| e (`e`) | | | 1 | 1 |"});
  ASSERT_EQ(promises.size(), 1U);
  EXPECT_EQ(promises[0].what, "law");
  EXPECT_EQ(promises[0].new_files, 2);
  EXPECT_EQ(promises[0].touched_files, 1);
}

TEST(ArchitecturePage, KnowsEveryFolderOfTheTree) {
  std::vector<std::string> named;
  for (const Layer& layer : layers()) named.push_back(layer.name);
  std::ranges::sort(named);
  EXPECT_EQ(named, source_folders());
}

// A layer includes only those above it on the page, so that there is no cycle.
TEST(ArchitecturePage, LayersStandInTheirOrder) {
  std::set<std::string> above;
  for (const Layer& layer : layers()) {
    for (const std::string& other : layer.below)
      EXPECT_TRUE(above.contains(other)) << layer.name << ": " << other;
    above.insert(layer.name);
  }
}

TEST(ArchitecturePage, TheBuildHasTheSameOrder) {
  std::vector<std::string> named;
  for (const Layer& layer : layers()) named.push_back(layer.name);
  for (const std::string& line : lines_of("CMakeLists.txt")) {
    if (!line.starts_with("set(layers ")) continue;
    std::istringstream words(line.substr(11, line.find(')') - 11));
    std::vector<std::string> built;
    for (std::string word; words >> word;)
      if (word != "packaging") built.push_back(word);
    EXPECT_EQ(built, named);
    return;
  }
  ADD_FAILURE() << "CMakeLists.txt has no set(layers ...)";
}

}  // namespace
}  // namespace cpt::tests
