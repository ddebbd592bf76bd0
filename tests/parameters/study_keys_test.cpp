// The list of a study's keys says what the reader does.
#include "parameters/study_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/parameters/studies.hpp"

namespace cpt::parameters {
namespace {

// A design that knows the key.
std::string_view kind_with(std::string_view key) {
  if (key == "runs" || key == "sections" || key == "estimator") return "sobol";
  if (key == "sampling" || key == "until" || key == "numerical_error_percent") return "propagation";
  return key == "first_runs" ? "latin_hypercube" : "morris";
}

// Keys that a study has whose realizations another program runs.
bool of_program(const KeyTable& table, const Key& key) {
  return (table.name == "limits" && key.name != "wall_minutes") ||
         (table.name == "windows" && (key.name == "output" || key.name == "from" || key.name == "to"));
}

// The table [name] or [[name]] with this one key, and with what makes the reader look at the key.
std::string table_with(const KeyTable& table, const Key& key, const std::string& value) {
  if (table.name == "parameters")
    return fmt::format("[parameters]\n\"{}\" = {{ {} = {} }}\n",
                       key.name == "field" ? "sand.D_r_percent" : "sand.H", key.name, value);
  std::string text = fmt::format("{0}{1}{2}\n", table.list ? "[[" : "[", table.name, table.list ? "]]" : "]");
  if (table.name == "design" && key.name != "kind")
    text += fmt::format("kind = \"{}\"\n", kind_with(key.name));
  if (key.name == "between_m" || key.name == "width_m") text += "centre = \"baseline_peak\"\n";
  if (table.name == "zones")
    for (const Key& other : table.keys)
      if (other.name != key.name) text += fmt::format("{} = 1\n", other.name);
  return text + fmt::format("{} = {}\n", key.name, value);
}

// What the reader says of a study with this key.
std::vector<StudyError> errors_with(const KeyTable& table, const Key& key, const std::string& value) {
  if (of_program(table, key))
    return errors_of(
        "[solver]\ncommand = [\"sh\"]\n[solver.inputs]\na = 1\n[solver.outputs]\nf = {}\ns = { over = \"z\" "
        "}\n" +
        table_with(table, key, value));
  const auto line = [&](std::string_view name, std::string_view usual) {
    return table.name.empty() && key.name == name ? "" : fmt::format("{} = \"{}\"\n", name, usual);
  };
  std::string text = table.name.empty() ? fmt::format("{} = {}\n", key.name, value) : "";
  text += line("profile", "homogeneous_sand") + line("preset", "quick") + window;
  if (table.name == "design") text += "[parameters]\n\"sand.H\" = { upper = 75 }\n";
  if (!table.name.empty()) text += table_with(table, key, value);
  return errors_of(text);
}

TEST(StudyKeys, TheReaderReadsEveryOneOfThem) {
  int keys = 0;
  for (const KeyTable& table : study_keys())
    for (const Key& key : table.keys) {
      ++keys;
      EXPECT_FALSE(key.meaning.empty() || key.type.empty() || key.usually.empty()) << key.name;
      // A date is nothing that any key takes.
      const auto errors = errors_with(table, key, "1979-05-27");
      const bool told = std::ranges::any_of(errors, [&](const StudyError& error) {
        return error.key.ends_with(key.name) && error.message.starts_with("must be");
      });
      EXPECT_TRUE(told) << table.name << "." << key.name << "\n" << format(errors);
    }
  EXPECT_GE(keys, 30);
}

TEST(StudyKeys, NumbersKeepTheirRange) {
  int ranges = 0;
  for (const KeyTable& table : study_keys())
    for (const Key& key : table.keys) {
      if (!std::isfinite(key.least) || !std::isfinite(key.most)) continue;
      ++ranges;
      const double step = key.type.starts_with("even") ? 2.0 : 1.0;
      const std::string range = fmt::format("{} to {}", key.least, key.most);
      EXPECT_NE(values_of(key).find(range), std::string::npos);
      for (const double value : {key.least - step, key.least, key.most, key.most + step}) {
        const auto errors = errors_with(table, key, fmt::format("{:.0f}", value));
        const bool refused = std::ranges::any_of(
            errors, [&](const StudyError& error) { return error.message.find(range) != std::string::npos; });
        EXPECT_EQ(refused, value < key.least || value > key.most)
            << table.name << "." << key.name << " = " << value << "\n"
            << format(errors);
      }
    }
  EXPECT_EQ(ranges, 10);
}

TEST(StudyKeys, ChoicesAreAllTaken) {
  for (const KeyTable& table : study_keys())
    for (const Key& key : table.keys)
      for (const std::string_view choice : key.choices)
        for (const StudyError& error : errors_with(table, key, fmt::format("\"{}\"", choice)))
          EXPECT_EQ(error.message.find("is not one of"), std::string::npos) << error.message;
}

TEST(StudyKeys, WhatHoldsWithoutThemIsWhatTheReaderTakes) {
  const auto usual = [](const char* table, const char* key) {
    return std::string(key_named(study_keys(), table, key).usually);
  };
  const Study plain = study_of("profile = \"homogeneous_sand\"\n" + window);
  EXPECT_EQ(solver::to_string(plain.preset), usual("", "preset"));
  EXPECT_EQ(plain.title, "sand");
  EXPECT_EQ(plain.database.filename(), "sand.sqlite");
  const std::string rows = "[parameters]\n\"sand.H\" = { upper = 75 }\n\"sand.nu\" = { upper = 0.3 }\n";
  const Design morris = study_of(sand_study(rows + "[design]\nkind = \"morris\"\n")).design;
  EXPECT_EQ(std::to_string(morris.trajectories), usual("design", "trajectories"));
  EXPECT_EQ(std::to_string(morris.levels), usual("design", "levels"));
  EXPECT_EQ(std::to_string(morris.seed), usual("design", "seed"));
  const Design hypercube = study_of(sand_study(rows + "[design]\nkind = \"latin_hypercube\"\n")).design;
  const Design sobol = study_of(sand_study(rows + "[design]\nkind = \"sobol\"\n")).design;
  const Design propagation = study_of(sand_study(rows + "[design]\nkind = \"propagation\"\n")).design;
  EXPECT_EQ(fmt::format("{} for each parameter; of sobol {}, of propagation {}", hypercube.runs / 2,
                        sobol.runs, propagation.runs),
            usual("design", "runs"));
}

}  // namespace
}  // namespace cpt::parameters
