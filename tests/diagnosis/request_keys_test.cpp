// The list of a request's keys says what the readers do.
#include "diagnosis/request_keys.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tests/diagnosis/request_fixture.hpp"

namespace cpt::diagnosis {
namespace {

using parameters::Key;
using parameters::KeyTable;
using parameters::StudyError;

std::vector<StudyError> errors_with(const KeyTable& table, const Key& key, const std::string& value) {
  const std::string entry = fmt::format("{} = {}\n", key.name, value);
  const std::string study = table.name.empty() && key.name == "study" ? "" : "study = \"sand.toml\"\n";
  const std::string head =
      table.list ? fmt::format("[[{}]]\n", table.name) : fmt::format("[{}]\n", table.name);
  return errors_of(table.name.empty() ? entry + study + sounding : study + sounding + head + entry);
}

TEST(RequestKeys, TheReaderReadsEveryOneOfThem) {
  int keys = 0;
  for (const KeyTable& table : request_keys()) {
    if (table.name == "cases") continue;  // of a plan
    for (const Key& key : table.keys) {
      ++keys;
      const auto errors = errors_with(table, key, "1979-05-27");  // a date is nothing that any key takes
      const bool told = std::ranges::any_of(errors, [&](const StudyError& error) {
        return error.key.ends_with(key.name) && error.message.starts_with("must be");
      });
      EXPECT_TRUE(told) << table.name << "." << key.name << "\n" << format(errors);
    }
  }
  EXPECT_GE(keys, 21);
}

TEST(RequestKeys, WhatHoldsWithoutThemIsWhatTheReaderTakes) {
  const Request plain = request_of("study = \"sand.toml\"\n" + sounding);
  const auto usual = [](const char* table, const char* key) {
    return std::string(parameters::key_named(request_keys(), table, key).usually);
  };
  EXPECT_EQ(fmt::format("{}", plain.cell_height * 1e3), usual("options", "cell_mm"));
  EXPECT_EQ(fmt::format("{}", plain.correlation * 1e3), usual("noise", "correlation_mm"));
  EXPECT_EQ(std::to_string(plain.repeats), usual("options", "repeats"));
  EXPECT_EQ(std::to_string(plain.joint), usual("options", "joint"));
  EXPECT_EQ(std::to_string(plain.confirm), usual("options", "confirm"));
  EXPECT_EQ(std::to_string(plain.seed), usual("options", "seed"));
  EXPECT_EQ(plain.simulated ? "true" : "false", usual("noise", "simulated"));
}

}  // namespace
}  // namespace cpt::diagnosis
