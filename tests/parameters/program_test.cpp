// Studies whose solver is another program.
#include <gtest/gtest.h>

#include <filesystem>

#include "parameters/all_realizations.hpp"
#include "solver/quantities.hpp"
#include "tests/parameters/studies.hpp"

namespace cpt::parameters {
namespace {

const std::string sound =
    "[solver]\ncommand = [\"sh\", \"model.sh\"]\nversion = \"3\"\n"
    "[solver.inputs]\na = { default = 2, unit = \"kPa\", min = 1, max = 9, meaning = \"load\" }\nb = 0.5\n"
    "n = { default = 3, integer = true }\n"
    "[solver.outputs]\nf = { unit = \"m\" }\ns = { unit = \"mm\", over = \"t\", over_unit = \"d\" }\n";

TEST(ProgramStudy, HasItsInputsAsQuantities) {
  const Study study = study_of(sound +
                               "[fixed]\nb = 0.25\n[parameters]\na = { lower = 1.5, upper = 4 }\n"
                               "[limits]\nhang_minutes = 2\nmost_megabytes = 3\nretries = 1\n"
                               "[[windows]]\nname = \"late\"\noutput = \"s\"\nfrom = 10\nto = 20\n");
  ASSERT_NE(study.baseline.program, nullptr);
  const solver::ExternalProgram& program = *study.baseline.program;
  EXPECT_EQ(program.command, (std::vector<std::string>{"sh", "model.sh"}));
  EXPECT_EQ(program.folder, "/studies");
  EXPECT_EQ(program.limits.hang_seconds, 120.0);
  EXPECT_EQ(program.limits.most_bytes, 3e6);
  EXPECT_EQ(program.limits.retries, 1);
  EXPECT_EQ(study.baseline.program_inputs, (std::vector<double>{2.0, 0.25, 3.0}));
  ASSERT_EQ(study.rows.size(), 1U);
  EXPECT_EQ(study.rows[0].quantity->unit, "kPa");
  EXPECT_EQ(study.rows[0].baseline, 2.0);
  EXPECT_EQ(all_realizations(study).size(), 3U);
  EXPECT_EQ(make_setup(study, all_realizations(study)[2]).program_inputs,
            (std::vector<double>{4.0, 0.25, 3.0}));
  ASSERT_EQ(study.windows.size(), 2U);
  EXPECT_EQ(study.windows[0].kind, Window::Kind::scalar);
  EXPECT_EQ(study.windows[0].name, "f");
  EXPECT_EQ(study.windows[1].output, "s");
  EXPECT_EQ(study.windows[1].to, 20.0);
  EXPECT_EQ(solver::quantities_of(study.baseline).size(), 3U);
  EXPECT_EQ(study.rows[0].quantity, solver::find_quantity("a", study_of(sound).baseline)) << "made once";
}

TEST(ProgramStudy, MistakesAreToldWhereTheyStand) {
  const auto expect = [](const std::string& study, const std::string& key, const std::string& message,
                         const std::string& hint = "") {
    const std::vector<StudyError> errors = errors_of(study);
    ASSERT_EQ(errors.size(), 1U) << format(errors);
    EXPECT_EQ(errors[0].key, key);
    EXPECT_NE(errors[0].message.find(message), std::string::npos) << errors[0].message;
    EXPECT_NE(errors[0].hint.find(hint), std::string::npos) << errors[0].hint;
    EXPECT_GT(errors[0].line, 0);
  };
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = sound;
    text.replace(text.find(from), from.size(), to);
    return text;
  };
  expect(with("command = [\"sh\", \"model.sh\"]\n", ""), "solver.command", "is missing", "such as");
  expect(with("[\"sh\", \"model.sh\"]", "\"sh model.sh\""), "solver.command", "must be an array of texts",
         "python3");
  expect(with("[\"sh\", \"model.sh\"]", "[]"), "solver.command", "has no word");
  expect(with("[\"sh\", \"model.sh\"]", "[1]"), "solver.command", "must hold texts, not a number");
  expect(with("version", "vesion"), "solver.vesion", "unknown", "version");
  expect(with("\"3\"", "3"), "solver.version", "must be a text or a command");
  expect(with("max = 9", "max = 0"), "solver.inputs.a.max", "0 is below min = 1");
  expect(with("default = 2", "default = 10"), "solver.inputs.a.default", "10 is outside min to max, 1 to 9");
  expect(with("default = 3", "default = 3.5"), "solver.inputs.n.default", "must be a whole number");
  expect(with("b = 0.5", "b = \"half\""), "solver.inputs.b", "must be a number or a row");
  expect(with("b = 0.5", "\"b c\" = 0.5"), "solver.inputs.b c", "may hold only letters, digits");
  expect(with("over = \"t\"", "over = \"f\""), "solver.outputs.s.over", "names an output, not an abscissa");
  expect(with("unit = \"m\" ", "over_unit = \"m\" "), "solver.outputs.f.over_unit", "belongs to a curve");
  expect(sound + "[parameters]\na = { lower = 0 }\n", "parameters.a.lower",
         "outside the valid range 1 to 9 kPa");
  expect(sound + "[parameters]\naa = { lower = 1 }\n", "parameters.aa", "unknown quantity",
         "did you mean a?");
  expect(sound + "[fixed]\n\"sand.H\" = 1\n", "fixed.sand.H", "unknown quantity", "[solver.inputs]");
  expect(sound + "[limits]\nretries = 1.5\n", "limits.retries", "whole number from 0 to 10");
  expect(sound + "[limits]\nhang_minutes = 0\n", "limits.hang_minutes", "must be above 0");
  expect("profile = \"homogeneous_sand\"\n" + sound, "profile", "belongs to the embedded solver");
  expect("repeats = 2\n" + sound, "repeats", "belongs to the embedded solver");
  expect(sound + "[[windows]]\nname = \"w\"\noutput = \"f\"\nfrom = 0\nto = 1\n", "windows.output", "f", "s");
  expect(sound + "[[windows]]\nname = \"f\"\noutput = \"s\"\nfrom = 0\nto = 1\n", "windows.name",
         "names a scalar or another window already");
  expect(sound + "[[windows]]\nname = \"w\"\noutput = \"s\"\nfrom = 2\nto = 1\n", "windows.to",
         "from 2 to 1");
  expect(with("version = \"3\"", "results = \"../out.json\""), "solver.results",
         "must be a file in the realization's work folder");
  expect(with("version = \"3\"", "template = \"deck.in\""), "solver.template", "there is no such file");
  expect(with("f = { unit = \"m\" }\n", ""), "windows", "is missing", "add [[windows]]");
}

TEST(ProgramStudy, PlaceholdersOfATemplateAreInputs) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "program_study";
  std::filesystem::create_directories(folder);
  std::string text = sound;
  text.insert(text.find("version"), "template = \"deck.in\"\n");
  const auto errors_with = [&](const std::string& deck) {
    std::ofstream(folder / "deck.in") << deck;
    const StudyOrErrors read = parse_study(text, folder / "s.toml");
    const auto* errors = std::get_if<std::vector<StudyError>>(&read);
    return errors ? *errors : std::vector<StudyError>();
  };
  EXPECT_TRUE(errors_with("a = {{a}}\n{ b } {{b}}").empty());
  const auto errors = errors_with("a = {{a}}\nb = {{bb}}\n");
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_NE(errors[0].message.find("deck.in:2: \"{{bb}}\" is no input"), std::string::npos)
      << errors[0].message;
  EXPECT_EQ(errors[0].hint, "did you mean {{b}}?");
  // What a ledger keeps is read without the file.
  std::filesystem::remove_all(folder);
  EXPECT_TRUE(std::holds_alternative<Study>(parse_stored_study(text, "s")));
}

}  // namespace
}  // namespace cpt::parameters
