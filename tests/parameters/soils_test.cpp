// The section [soils] of a study.
#include <algorithm>

#include "solver/soils/law.hpp"
#include "tests/parameters/studies.hpp"

namespace cpt::parameters {
namespace {

const std::string two_soils =
    "[soils.loose]\nlaw = \"norsand\"\n[soils.soft]\nlaw = \"tresca\"\n"
    "[[layers]]\ntop_m = 0\nbottom_m = 0.3\nsoil = \"loose\"\n"
    "[[layers]]\ntop_m = 0.3\nbottom_m = 1\nsoil = \"soft\"\n";

TEST(Soils, TakeThePlaceOfThoseThatEveryStudyHas) {
  const Study study = study_of(sand_study(two_soils + "[fixed]\n\"loose.H\" = 40\n[parameters]\n"
                                                      "\"soft.s_u_kPa\" = { lower = 20, upper = 35 }\n"));
  ASSERT_EQ(study.baseline.soils.size(), 2U);
  EXPECT_EQ(study.baseline.soils[0].name, "loose");
  EXPECT_EQ(solver::as<solver::NorSandParameters>(study.baseline.soils[0]).H, 40.0);
  EXPECT_EQ(study.baseline.layers[1].soil, 1U);
  ASSERT_EQ(study.rows.size(), 1U);
  EXPECT_EQ(study.rows[0].quantity->name, "soft.s_u_kPa");
  EXPECT_EQ(study.rows[0].baseline, 27.9);
}

TEST(Soils, NamedAsTheDefaultsHaveTheSameSettings) {
  const Study own =
      study_of(sand_study("[soils.sand]\nlaw = \"norsand\"\n[soils.clay]\nlaw = \"tresca\"\n"
                          "[[layers]]\ntop_m = 0\nbottom_m = 0.3\nsoil = \"sand\"\n"
                          "[[layers]]\ntop_m = 0.3\nbottom_m = 1\nsoil = \"clay\"\n"));
  const Study usual =
      study_of(sand_study("[[layers]]\ntop_m = 0\nbottom_m = 0.3\nsoil = \"sand\"\n"
                          "[[layers]]\ntop_m = 0.3\nbottom_m = 1\nsoil = \"clay\"\n"));
  EXPECT_EQ(solver::canonical_text(own.baseline), solver::canonical_text(usual.baseline));
}

// The profile's layers keep their names; what these stand for may be another law.
TEST(Soils, MayBeTheProfilesUnderAnotherLaw) {
  const Study study =
      study_of(sand_study("[soils.sand]\nlaw = \"mohr_coulomb\"\n[fixed]\n\"sand.phi_deg\" = 35\n"));
  EXPECT_NE(solver::canonical_text(study.baseline).find("soils = sand mohr_coulomb\n"), std::string::npos);
  EXPECT_NE(solver::canonical_text(study.baseline).find("sand.phi_deg = 35\n"), std::string::npos);
}

void expect_error(const std::string& more, const std::string& key, const std::string& message,
                  const std::string& hint) {
  const std::vector<StudyError> errors = errors_of(sand_study(more));
  const auto found = std::ranges::find(errors, key, &StudyError::key);
  ASSERT_NE(found, errors.end()) << more << format(errors);
  EXPECT_GT(found->line, 0);
  EXPECT_NE(found->message.find(message), std::string::npos) << format(errors);
  EXPECT_NE(found->hint.find(hint), std::string::npos) << format(errors);
}

TEST(Soils, WhatIsWrongIsSaidWithItsPlace) {
  expect_error("[soils.silt]\nlaw = \"norsnad\"\n", "soils.silt.law", "is not one of norsand, tresca",
               "norsand");
  expect_error("[soils.silt]\n", "soils.silt.law", "is missing", "one of norsand, tresca");
  expect_error("[soils.silt]\nlaw = \"norsand\"\nH = 3\n", "soils.silt.H", "unknown key",
               "under [fixed] or [parameters]: \"silt.NAME\"");
  expect_error("[soils]\nsilt = \"norsand\"\n", "soils.silt", "must be a table", "[soils.silt] with law");
  expect_error("[soils.chamber]\nlaw = \"norsand\"\n", "soils.chamber", "means something else", "otherwise");
  expect_error("[soils.\"9a\"]\nlaw = \"norsand\"\n", "soils.9a", "is no name for a soil", "a letter first");
  expect_error("[soils]\n", "soils", "names no soil", "");
  expect_error("[soils.silt]\nlaw = \"norsand\"\n", "soils",
               "names no soil \"sand\", which layers of the profile have", "[[layers]]");
  expect_error(two_soils + "[soils.unused]\nlaw = \"norsand\"\n", "soils.unused", "no layer consists of it",
               "[[layers]]");
  expect_error("[soils.a]\nlaw = \"norsand\"\n[[layers]]\ntop_m = 0\nbottom_m = 1\nsoil = \"b\"\n",
               "layers.soil", "is not one of a", "");
  expect_error("[soils.a]\nlaw = \"norsand\"\n[[layers]]\ntop_m = 0\nbottom_m = 1\n", "layers.soil",
               "is missing", "");
  expect_error(two_soils + "[fixed]\n\"soft.H\" = 40\n", "fixed.soft.H", "unknown quantity",
               "H is a parameter of norsand (loose); soft is of tresca");
  expect_error(two_soils + "[fixed]\n\"soft.kappa\" = 0.1\n", "fixed.soft.kappa", "unknown quantity",
               "kappa is a parameter of modified_cam_clay (no soil here); soft is of tresca");
  expect_error(two_soils + "[fixed]\n\"soft.temperature_of_the_room\" = 20\n",
               "fixed.soft.temperature_of_the_room", "unknown quantity",
               "`campaign list laws` prints the parameters of tresca");
  expect_error(two_soils + "[fixed]\n\"sand.H\" = 40\n", "fixed.sand.H", "unknown quantity", "loose.H");
  expect_error(two_soils + "[fixed]\n\"loose.e_min\" = 0.95\n", "fixed.loose.e_min", "must be below", "");
}

// One slip, one error: what follows from it is not told.
TEST(Soils, WhatDependsOnAnErrorIsNotJudged) {
  const std::string quantities =
      "[fixed]\n\"loose.H\" = 40\n[fixed.soft]\ns_u_kPa = 20\n[[points]]\nname = \"a\"\n\"soft.s_u_kPa\" = "
      "30\n";
  ASSERT_TRUE(errors_of(sand_study(two_soils + quantities)).empty());
  for (const auto& [slip, mended, key] :
       {std::tuple{"law = \"trseca\"", "law = \"tresca\"", "soils.soft.law"},
        {"[soils.so-ft]", "[soils.soft]", "soils.so-ft"},
        {"soil = \"sotf\"", "soil = \"soft\"", "layers.soil"},
        {"bottom_m = \"1\"\n", "bottom_m = 1\n", "layers.bottom_m"}}) {
    std::string text = two_soils + quantities;
    text.replace(text.find(mended), std::string_view(mended).size(), slip);
    const std::vector<StudyError> errors = errors_of(sand_study(text));
    ASSERT_FALSE(errors.empty()) << slip;
    EXPECT_EQ(errors.front().key, key);
    EXPECT_EQ(errors.size(), 1U) << format(errors);
  }
}

// A soil given twice is TOML's own error.
TEST(Soils, GivenTwiceAreASyntaxError) {
  EXPECT_FALSE(errors_of(sand_study("[soils.a]\nlaw = \"norsand\"\n[soils.a]\nlaw = \"norsand\"\n")).empty());
}

}  // namespace
}  // namespace cpt::parameters
