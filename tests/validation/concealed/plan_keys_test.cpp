// The list of a plan's own keys says what its reader does.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "diagnosis/request_keys.hpp"
#include "tests/diagnosis/request_fixture.hpp"
#include "validation/concealed/plan.hpp"

namespace cpt::validation::concealed {
namespace {

using parameters::Key;
using parameters::StudyError;

std::vector<StudyError> errors_with(const Key& key, const std::string& value) {
  const std::string text = fmt::format(
      "study = \"sand.toml\"\n[[soundings]]\nname = \"a\"\nfrom_m = 0.04\nto_m = 0.28\n"
      "[noise]\nmeasurement_percent = 1\n[cases]\n{} = {}\n",
      key.name, value);
  const auto parsed = parse_plan(text, "/requests/plan.toml", diagnosis::quick_sand());
  const auto* errors = std::get_if<std::vector<StudyError>>(&parsed);
  return errors != nullptr ? *errors : std::vector<StudyError>();
}

TEST(PlanKeys, TheReaderReadsEveryOneOfThem) {
  const auto& keys = parameters::table_named(diagnosis::request_keys(), "cases").keys;
  for (const Key& key : keys) {
    const auto errors = errors_with(key, "1979-05-27");  // a date is nothing that any key takes
    const bool told = std::ranges::any_of(errors, [&](const StudyError& error) {
      return error.key.ends_with(key.name) && error.message.starts_with("must be");
    });
    EXPECT_TRUE(told) << key.name << "\n" << format(errors);
  }
  EXPECT_GE(keys.size(), 5U);
}

}  // namespace
}  // namespace cpt::validation::concealed
