// What is wrong with [soils] and [[layers]] is told once, where it stands; what follows from it is not.
#include "tests/parameters/studies.hpp"

namespace cpt::parameters {
namespace {

std::string layer(const std::string& top, const std::string& bottom, const std::string& soil) {
  return "[[layers]]\ntop_m = " + top + "\nbottom_m = " + bottom + "\nsoil = \"" + soil + "\"\n";
}

const std::string soft_section = "[soils.soft]\nlaw = \"modified_cam_clay\"\n";  // lines 9 and 10
const std::string loose_layer = layer("0", "0.15", "loose");                     // lines 13 to 16
const std::string soft_layer = layer("0.15", "0.25", "soft");                    // lines 17 to 20
const std::string dense_layer = layer("0.25", "1", "dense");                     // lines 21 to 24

std::string sound_study() {
  return sand_study("[soils.loose]\nlaw = \"norsand\"\n" + soft_section +
                    "[soils.dense]\nlaw = \"norsand\"\n" + loose_layer + soft_layer + dense_layer +
                    "[parameters]\n\"loose.D_r_percent\" = { upper = 40 }\n\"soft.OCR\" = { upper = 3 }\n"
                    "\"soft.lambda\" = { upper = 0.25 }\n\"dense.H\" = { upper = 75 }\n[fixed]\n"
                    "\"contact.friction_ratio\" = 0.4\n[design]\nkind = \"morris\"\nparameters = "
                    "[\"soft.OCR\", \"dense.H\"]\n");
}

struct Slip {
  std::string sound, wrong;
};
struct Told {
  int line;
  std::string key;
  std::string text;  // part of message and hint
};

void expect_told(const std::vector<Slip>& slips, const std::vector<Told>& expected) {
  std::string text = sound_study();
  for (const Slip& slip : slips) {
    ASSERT_NE(text.find(slip.sound), std::string::npos) << slip.sound;
    text.replace(text.find(slip.sound), slip.sound.size(), slip.wrong);
  }
  const std::vector<StudyError> errors = errors_of(text);
  ASSERT_EQ(errors.size(), expected.size()) << slips.front().wrong << format(errors);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    EXPECT_EQ(errors[i].line, expected[i].line) << format(errors);
    EXPECT_EQ(errors[i].key, expected[i].key) << format(errors);
    EXPECT_NE((errors[i].message + " " + errors[i].hint).find(expected[i].text), std::string::npos)
        << format(errors);
  }
}

// The layer of soft with another text in place of a part.
Slip in_soft(const std::string& part, const std::string& other) {
  std::string text = soft_layer;
  text.replace(text.find(part), part.size(), other);
  return {soft_layer, text};
}

TEST(Layers, AStudyOfThreeSoilsIsSound) { EXPECT_TRUE(errors_of(sound_study()).empty()); }

TEST(Layers, OneMistakeInATableIsToldOnce) {
  expect_told({{soft_layer, soft_layer + "colour = 3\n"}}, {{21, "layers.colour", "top_m, bottom_m, soil"}});
  expect_told({in_soft("soil", "soill")}, {{20, "layers.soill", "did you mean soil?"}});
  expect_told({in_soft("top_m", "top")}, {{18, "layers.top", "did you mean top_m?"}});
  expect_told({in_soft("soil = \"soft\"\n", "")}, {{17, "layers.soil", "one of loose, soft, dense"}});
  expect_told({in_soft("bottom_m = 0.25\n", "")}, {{17, "layers.bottom_m", "is missing"}});
  expect_told({in_soft("\"soft\"", "3")}, {{20, "layers.soil", "one of loose, soft, dense"}});
  expect_told({in_soft("\"soft\"", "\"\"")}, {{20, "layers.soil", "must not be empty"}});
  expect_told({in_soft("\"soft\"", "\"sfot\"")}, {{20, "layers.soil", "did you mean \"soft\"?"}});
  expect_told({in_soft("0.25", "\"0.25\"")}, {{19, "layers.bottom_m", "write 0.25, without quotes"}});
}

TEST(Layers, OneDepthThatIsWrongIsToldWhereItStands) {
  expect_told({in_soft("0.25", "0.05")}, {{19, "layers.bottom_m", "from 0.15 m to 0.05 m has no thickness"}});
  expect_told({in_soft("0.15", "0.17")},
              {{18, "layers.top_m", "starts at 0.17 m, but the one above it ends at 0.15 m (line 15)"}});
  expect_told({in_soft("0.15", "0.12")}, {{18, "layers.top_m", "without gaps or overlaps"}});
  expect_told({{loose_layer, layer("-0.1", "0.15", "loose")}},
              {{14, "layers.top_m", "the soil's top is at 0 m"}});
  expect_told({{dense_layer, layer("0.25", "0.9", "dense")}},
              {{23, "layers.bottom_m", "give chamber.soil_height_m = 0.9 under [fixed]"}});
  expect_told({{dense_layer, layer("0.25", "1000", "dense")}},
              {{23, "layers.bottom_m", "end them at 1 m; chamber.soil_height_m may be 0.2 to 3 m"}});
  expect_told({{"[fixed]\n", "[fixed]\n\"chamber.soil_height_m\" = 0.5\n"}},
              {{23, "layers.bottom_m", "end at 1 m, but chamber.soil_height_m = 0.5"}});
  expect_told({in_soft("0.25", "0.152"), {dense_layer, layer("0.152", "1", "dense")}},
              {{17, "layers", "2 mm thick"}});
}

TEST(Layers, OneMistakeInTheSoilsIsToldOnce) {
  expect_told({{soft_section, ""}}, {{18, "layers.soil", "add [soils.soft] with its law"}});
  expect_told({{"[soils.soft]", "[soils.sfot]"}}, {{20, "layers.soil", "did you mean \"sfot\"?"}});
  expect_told({{"[soils.soft]", "[soil.soft]"}}, {{9, "soil", "did you mean soils?"}});
  expect_told({{soft_section, "[soils.soft]\nlwa = \"modified_cam_clay\"\n"}},
              {{10, "soils.soft.lwa", "did you mean law?"}});
  expect_told({{"modified_cam_clay", "cam_clay"}},
              {{10, "soils.soft.law", "did you mean \"modified_cam_clay\"?"}});
  expect_told({{soft_section, soft_section + "[soils.spare]\nlaw = \"tresca\"\n"}},
              {{11, "soils.spare", "no layer consists of it"}});
  expect_told({{soft_section, soft_section + "[soils.spare]\nlaw = \"tresca\"\n"},
               {"[fixed]\n", "[fixed]\n\"spare.s_u_kPa\" = 30\n\"contact.adhesion_ratio\" = 0.4\n"}},
              {{11, "soils.spare", "no layer consists of it"}});
  expect_told({{soft_section, soft_section + "OCR = 2\n"}}, {{11, "soils.soft.OCR", "\"soft.NAME\" = ..."}});
}

TEST(Layers, AHeadingThatIsWrongIsToldOnce) {
  expect_told({in_soft("[[layers]]", "[[layer]]")}, {{17, "layer", "did you mean layers?"}});
  expect_told({{soft_layer + dense_layer, ""}, {"[[layers]]", "[layers]"}},
              {{13, "layers", "start each with [[layers]]"}});
  expect_told(
      {{"[soils.loose]", "[soil.loose]"}, {"[soils.soft]", "[soil.soft]"}, {"[soils.dense]", "[soil.dense]"}},
      {{7, "soil", "did you mean soils?"}});
  expect_told({{"[[layers]]", "[[layer]]"}, {"[[layers]]", "[[layer]]"}, {"[[layers]]", "[[layer]]"}},
              {{13, "layer", "did you mean layers?"}});
  expect_told({{"[[windows]]", "[[windos]]"}}, {{3, "windos", "did you mean windows?"}});
}

TEST(Layers, SoilsThatAreNotTheProfilesWantLayers) {
  const std::vector<StudyError> errors = errors_of(
      "profile = \"layered_sand_clay\"\n[[windows]]\nname = \"w\"\nfrom_m = 0.2\nto_m = 0.25\n"
      "[soils.loose]\nlaw = \"norsand\"\n[parameters]\n\"loose.H\" = { upper = 75 }\n");
  ASSERT_EQ(errors.size(), 1U) << format(errors);
  EXPECT_EQ(errors.front().message,
            "names no soil \"clay\" and no soil \"sand\", which layers of the profile have");
}

// The gap that it leaves, its soil that is in no layer, and that soil's quantities are one mistake.
TEST(Layers, ALayerThatWasForgottenIsToldOnce) {
  expect_told({{soft_layer, ""}}, {{18, "layers.top_m",
                                    "a layer of soft from 0.15 to 0.25 m closes the gap; without one, leave "
                                    "out [soils.soft] in line 9"}});
}

TEST(Layers, TwoMistakesAreTwoErrors) {
  const Slip misspelt_law = {"modified_cam_clay", "modified_camclay"};
  const Slip spare = {soft_section, soft_section + "[soils.spare]\nlaw = \"tresca\"\n"};
  expect_told({misspelt_law, in_soft("0.25", "0.05")},
              {{10, "soils.soft.law", ""}, {19, "layers.bottom_m", "no thickness"}});
  expect_told({misspelt_law, {dense_layer, layer("0.25", "1", "dnese")}},
              {{10, "soils.soft.law", ""}, {24, "layers.soil", "did you mean \"dense\"?"}});
  expect_told({misspelt_law, {"loose.D_r_percent", "loose.D_r_prcent"}},
              {{10, "soils.soft.law", ""}, {26, "parameters.loose.D_r_prcent", "loose.D_r_percent?"}});
  expect_told({misspelt_law, {"upper = 40", "upper = 400"}},
              {{10, "soils.soft.law", ""}, {26, "parameters.loose.D_r_percent.upper", "valid range"}});
  expect_told({in_soft("\"soft\"", "\"sfot\""), {dense_layer, layer("0.25", "0.9", "dense")}},
              {{20, "layers.soil", ""}, {23, "layers.bottom_m", "end at 0.9 m"}});
  expect_told({spare, in_soft("\"soft\"", "\"sfot\"")},
              {{11, "soils.spare", "no layer"}, {22, "layers.soil", "did you mean \"soft\"?"}});
  expect_told({spare, in_soft("0.25", "\"0.25\"")},
              {{11, "soils.spare", "no layer"}, {21, "layers.bottom_m", "without quotes"}});
  expect_told({in_soft("0.15", "0.17"), {dense_layer, layer("0.27", "1", "dense")}},
              {{18, "layers.top_m", "0.17"}, {22, "layers.top_m", "0.27"}});
  expect_told({{soft_layer, soft_layer + "colour = 3\n"}, {dense_layer, layer("0.27", "1", "dense")}},
              {{21, "layers.colour", ""}, {23, "layers.top_m", "0.27"}});
}

// Which soils the layers of a misspelt profile have is not known.
TEST(Layers, SoilsOfAProfileThatIsNotKnownAreNotMissed) {
  const std::vector<StudyError> errors =
      errors_of("profile = \"homogeneous_clya\"\n" + window +
                "[soils.clay]\nlaw = \"tresca\"\n[fixed]\nclay.s_u_kPa = 30\n");
  ASSERT_EQ(errors.size(), 1U) << format(errors);
  EXPECT_EQ(errors.front().key, "profile");
}

}  // namespace
}  // namespace cpt::parameters
