#include "tests/parameters/studies.hpp"

namespace cpt::parameters {
namespace {

/// One error that a text must give, and no other.
struct BadStudy {
  std::string toml;
  int line;
  std::string key;
  std::string message;  // part of it
  std::string hint;     // part of it; "" for no hint
};

void expect_errors(const std::vector<BadStudy>& table) {
  for (const BadStudy& bad : table) {
    const std::vector<StudyError> errors = errors_of(bad.toml);
    ASSERT_EQ(errors.size(), 1u) << bad.toml << format(errors);
    const StudyError& error = errors.front();
    EXPECT_EQ(error.file, "/studies/sand.toml");
    EXPECT_EQ(error.line, bad.line) << bad.toml << format(errors);
    EXPECT_EQ(error.key, bad.key) << bad.toml;
    EXPECT_NE(error.message.find(bad.message), std::string::npos) << bad.toml << format(errors);
    EXPECT_NE(error.hint.find(bad.hint), std::string::npos) << bad.toml << format(errors);
    EXPECT_EQ(error.hint.empty(), bad.hint.empty()) << bad.toml << format(errors);
  }
}

// Lines 1 to 6 of sand_study are sound; what a case adds starts at line 7.
BadStudy bad(const std::string& more, int line, const std::string& key, const std::string& message,
             const std::string& hint = "") {
  return {sand_study(more), line, key, message, hint};
}
BadStudy bad_fixed(const std::string& entry, const std::string& key, const std::string& message,
                   const std::string& hint = "") {
  return bad("[fixed]\n" + entry + "\n", 8, "fixed." + key, message, hint);
}
BadStudy bad_row(const std::string& entry, const std::string& key, const std::string& message,
                 const std::string& hint = "") {
  return bad("[parameters]\n" + entry + "\n", 8, "parameters." + key, message, hint);
}

TEST(BadStudy, Sections) {
  const std::string profile = "profile = \"homogeneous_sand\"\n";
  expect_errors({
      {window, 1, "profile", "is missing", "one of homogeneous_sand"},
      {"profile = \"sand\"\n" + window, 1, "profile", "\"sand\" is not one of homogeneous_sand",
       "\"homogeneous_sand\"?"},
      {"profile = \"homogenous_sand\"\n" + window, 1, "profile", "is not one of", "\"homogeneous_sand\"?"},
      {"profile = 3\n" + window, 1, "profile", "must be a text, not a number", "one of homogeneous_sand"},
      {"profile = \"\"\n" + window, 1, "profile", "must not be empty", "one of homogeneous_sand"},
      {profile + "preset = \"Quick\"\n" + window, 2, "preset", "is not one of quick, standard, paper, fine",
       "\"quick\"?"},
      {profile + "preset = true\n" + window, 2, "preset", "must be a text, not true or false",
       "one of quick, standard"},
      {profile + "titel = \"x\"\n" + window, 2, "titel", "unknown key", "did you mean title?"},
      {profile + "title = 1\n" + window, 2, "title", "must be a text", ""},
      {profile + "parameters = 1\n" + window, 2, "parameters", "must be a table", "[parameters]"},
      {profile + "fixed = []\n" + window, 2, "fixed", "must be a table, not an array", "[fixed]"},
      {profile, 0, "windows", "at least one", "[[windows]]"},
      {profile + "windows = 1\n", 2, "windows", "must be an array", "[[windows]]"},
      {profile + "windows = []\n", 2, "windows", "at least one", "[[windows]]"},
      {profile + "[windows]\nname = \"a\"\n", 2, "windows", "must be an array", "[[windows]]"},
      bad("[output]\ndatabse = \"a\"\n", 8, "output.databse", "unknown key", "database?"),
      bad("[output]\ndatabase = 1\n", 8, "output.database", "must be a text", ""),
      bad("[output]\ncurves = \"\"\n", 8, "output.curves", "must not be empty", ""),
      bad("[output]\ncurves = \"sand.sqlite\"\n", 7, "output", "/studies/sand.sqlite would hold two things"),
      bad("[output]\ndatabase = \"./sand.toml\"\n", 7, "output", "/studies/sand.toml would hold two things"),
      bad("[limits]\nwall_minuts = 3\n", 8, "limits.wall_minuts", "unknown key", "wall_minutes?"),
      bad("[limits]\nwall_minutes = 0\n", 8, "limits.wall_minutes", "0 must be above 0"),
      bad("[limits]\nwall_minutes = \"30\"\n", 8, "limits.wall_minutes", "must be a number",
          "30, without quotes"),
      bad("[limits]\nwall_minutes = inf\n", 8, "limits.wall_minutes", "finite number, not inf"),
  });
}

TEST(BadStudy, Values) {
  expect_errors({
      bad_fixed("\"sand.H\" = \"25\"", "sand.H", "must be a number, not the text \"25\"",
                "write 25, without quotes"),
      bad_fixed("\"sand.H\" = \"high\"", "sand.H", "not the text \"high\""),
      bad_fixed("\"sand.H\" = true", "sand.H", "must be a number, not true or false"),
      bad_fixed("\"sand.H\" = [25]", "sand.H", "must be a number, not an array"),
      bad_fixed("\"sand.H\" = 1979-05-27", "sand.H", "must be a number, not a date"),
      bad_fixed("\"sand.H\" = { baseline = 25 }", "sand.H", "must be one value, not a table", "[parameters]"),
      bad_fixed("\"sand.H\" = nan", "sand.H", "finite number, not nan"),
      bad_fixed("\"sand.H\" = -inf", "sand.H", "finite number, not -inf"),
      bad_fixed("\"sand.H\" = -25", "sand.H", "-25 is outside the valid range 1 to 2000"),
      bad_fixed("\"numerics.courant\" = 1.2", "numerics.courant",
                "1.2 is outside the valid range 0.05 to 0.98"),
      bad_fixed("\"numerics.face_elements\" = 2.5", "numerics.face_elements", "2.5 must be a whole number"),
      bad_fixed("\"chamber.wall\" = 1", "chamber.wall", "must be one of flexible, rigid, not a number"),
      bad_fixed("\"chamber.wall\" = \"ridgid\"", "chamber.wall", "is not one of flexible, rigid",
                "\"rigid\"?"),
      bad_fixed("\"chamber.wall\" = \"Rigid\"", "chamber.wall", "is not one of", "\"rigid\"?"),
  });
}

TEST(BadStudy, Units) {
  expect_errors({
      bad_fixed("\"initial.sigma_v0_kPa\" = 50000", "initial.sigma_v0_kPa",
                "outside the valid range 1 to 2000 kPa", "the unit is kPa: 50000 Pa would be 50"),
      bad_fixed("\"initial.sigma_v0_kPa\" = 0.05", "initial.sigma_v0_kPa", "outside", "0.05 MPa would be 50"),
      bad_fixed("\"sand.D_r_percent\" = 0.36", "sand.D_r_percent", "1 to 100 %",
                "(as a fraction) would be 36"),
      bad_fixed("\"sand.phi_cs_deg\" = 0.5236", "sand.phi_cs_deg", "20 to 45 deg", "0.5236 rad would be 30"),
      bad_fixed("\"penetrometer.final_depth_m\" = 530", "penetrometer.final_depth_m", "m",
                "530 mm would be 0.53"),
      bad_fixed("\"sand.rho_grains_kg_per_m3\" = 2.65", "sand.rho_grains_kg_per_m3", "kg/m3",
                "2.65 g/cm3 would be 2650"),
      bad_fixed("\"penetrometer.speed_m_per_s\" = 40", "penetrometer.speed_m_per_s", "m/s",
                "40 mm/s would be 0.04"),
  });
}

TEST(BadStudy, UnknownQuantities) {
  expect_errors({
      bad_fixed("\"sand.lamda\" = 0.01", "sand.lamda", "unknown quantity", "did you mean sand.lambda?"),
      bad_fixed("\"sand.phi_cs\" = 30", "sand.phi_cs", "unknown", "sand.phi_cs_deg?"),
      bad_fixed("\"sand.phi_cs_rad\" = 0.5", "sand.phi_cs_rad", "unknown", "sand.phi_cs_deg?"),
      bad_fixed("\"initial.sigma_h0_Pa\" = 25000", "initial.sigma_h0_Pa", "unknown", "initial.sigma_h0_kPa?"),
      bad_fixed("\"sand.s_u_kPa\" = 25", "sand.s_u_kPa", "unknown",
                "s_u_kPa is a parameter of tresca (no soil here); sand is of norsand"),
      bad_fixed("radius_m = 0.4", "radius_m", "unknown", "chamber.radius_m?"),
      bad_fixed("numerics.curant = 0.4", "numerics.curant", "unknown", "numerics.courant?"),
      bad_fixed("qwertyuiop = 0.4", "qwertyuiop", "unknown", "campaign list quantities"),
      bad_fixed("\"numerics.zones\" = []", "numerics.zones", "unknown", "[[zones]]"),
      bad_fixed("sand = 3", "sand", "is a group of quantities", "sand.NAME"),
      bad_row("\"Sand.H\" = { upper = 75 }", "Sand.H", "unknown", "sand.H?"),
      bad_row("sand.h = { upper = 75 }", "sand.h", "unknown", "sand.H?"),
      bad_row("sand.H.upper.x = 75", "sand.H.upper", "must be a number, not a table"),
  });
}

TEST(BadStudy, Rows) {
  expect_errors({
      bad_row("sand.H = 25", "sand.H", "must be a row", "[fixed]"),
      bad_row("sand.H = {}", "sand.H", "nothing differs from the baseline 25", "[fixed]"),
      bad_row("sand.H = { baseline = 30 }", "sand.H", "nothing differs from the baseline 30", "[fixed]"),
      bad_row("sand.H = { lower = 25, upper = 25 }", "sand.H", "nothing differs", "[fixed]"),
      bad_row("sand.H = { baseline = 25, alternative = 25 }", "sand.H", "nothing differs", "[fixed]"),
      bad_row("sand.H = { lower = 30 }", "sand.H.lower", "30 is above the baseline 25", "lower <= baseline"),
      bad_row("sand.H = { upper = 20, lower = 10 }", "sand.H.upper", "20 is below the baseline 25",
              "lower <="),
      bad_row("chamber.wall = { upper = \"flexible\" }", "chamber.wall.upper",
              "flexible is below the baseline rigid", "lower <= "),
      bad_row("sand.H = { lower = 20, alternative = 75 }", "sand.H.alternative", "cannot stand beside",
              "keep the alternative"),
      bad_row("sand.H = { baseline = 25, uper = 75 }", "sand.H.uper", "unknown key", "did you mean upper?"),
      bad_row("sand.H = { baseline = \"25\", upper = 75 }", "sand.H.baseline", "must be a number",
              "25, without"),
      bad_row("sand.H = { upper = nan }", "sand.H.upper", "finite number"),
      bad_row("sand.H = { upper = 7500 }", "sand.H.upper", "7500 is outside the valid range 1 to 2000"),
      bad_row("numerics.face_elements = { upper = 3.5 }", "numerics.face_elements.upper", "whole number"),
      bad_row("initial.sigma_h0_kPa = { upper = 35000 }", "initial.sigma_h0_kPa.upper", "outside",
              "35000 Pa would be 35"),
      bad("[fixed]\nsand.H = 30\n[parameters]\n\"sand.H\" = { upper = 75 }\n", 10, "parameters.sand.H",
          "already given as fixed.sand.H in line 8", "keep one"),
      bad("[fixed]\nsand.H = 30\n\"sand.H\" = 31\n", 9, "fixed.sand.H", "already given", "keep one"),
      bad_row("clay.s_u_kPa = { upper = 30 }", "clay.s_u_kPa", "has no effect: the profile has no clay"),
      bad_fixed("contact.adhesion_ratio = 0.3", "contact.adhesion_ratio",
                "acts on Tresca, Mohr-Coulomb, and no layer is of that"),
      {"profile = \"homogeneous_clay\"\n" + window + "[parameters]\nsand.H = { upper = 75 }\n", 7,
       "parameters.sand.H", "the profile has no sand", ""},
  });
}

TEST(BadStudy, Windows) {
  const auto one = [](const std::string& fields) {
    return "profile = \"homogeneous_sand\"\n[[windows]]\n" + fields;
  };
  const std::string peak = "name = \"p\"\ncentre = \"baseline_peak\"\n";
  expect_errors({
      {one("from_m = 0.4\nto_m = 0.5\n"), 2, "windows.name", "is missing", ""},
      {one("name = \"two words\"\nfrom_m = 0.4\nto_m = 0.5\n"), 3, "windows.name", "only letters", ""},
      {one("name = \"a\"\nto_m = 0.5\n"), 2, "windows.from_m", "is missing", ""},
      {one("name = \"a\"\nfrom_m = 0.5\nto_m = 0.4\n"), 5, "windows.to_m", "from 0.5 m to 0.4 m", ""},
      {one("name = \"a\"\nfrom_m = 0.4\nto_m = 0.5\nwidth_m = 0.1\n"), 6, "windows.width_m", "with a centre",
       ""},
      {one("name = \"a\"\nfrom_m = 0.4\nto_m = 0.5\ncenter = \"baseline_peak\"\n"), 6, "windows.center",
       "unknown key", "centre?"},
      {one("name = \"a\"\nfrom_m = 0.45\nto_m = 0.6\n"), 2, "windows.a",
       "ends at penetrometer.final_depth_m = 0.53", "penetrometer.final_depth_m = 0.61 reaches it"},
      {one("name = \"a\"\nfrom_m = 0.45\nto_m = 1.6\n"), 2, "windows.a", "reaches 1.6 m",
       "from_m and to_m may lie from 0.02"},
      {one("name = \"a\"\nfrom_m = 0.01\nto_m = 0.1\n"), 2, "windows.a", "the tip at the start, 0.0219 m",
       "from_m and to_m may lie from 0.022 to 0.53 m"},
      {one(peak + "between_m = [0.02, 0.4]\nwidth_m = 0.01\n"), 2, "windows.p", "the tip at the start",
       "between_m, with half of width_m to spare, may lie from 0.027 to 0.525 m"},
      {one("name = \"a\"\nfrom_m = 0.5\nto_m = 0.5001\n"), 2, "windows.a", "less than one bin", ""},
      {one(peak + "width_m = 0.002\n"), 2, "windows.between_m", "is missing", "between_m = ["},
      {one(peak + "width_m = 0.002\nbetween_m = [0.3]\n"), 6, "windows.between_m", "must be two depths",
       "between_m"},
      {one(peak + "width_m = 0.002\nbetween_m = [0.3, \"x\"]\n"), 6, "windows.between_m", "must be a number",
       ""},
      {one(peak + "width_m = 0.002\nbetween_m = [0.4, 0.3]\n"), 6, "windows.between_m", "depths grow", ""},
      {one(peak + "between_m = [0.3, 0.4]\n"), 2, "windows.width_m", "is missing", ""},
      {one(peak + "between_m = [0.3, 0.4]\nwidth_m = 0\n"), 6, "windows.width_m", "0 must be above 0", ""},
      {one(peak + "between_m = [0.3, 0.53]\nwidth_m = 0.01\n"), 2, "windows.p", "reaches 0.535 m",
       "0.54 reaches it"},
      {one(peak + "between_m = [0.3, 0.4]\nwidth_m = 0.01\nto_m = 0.5\n"), 7, "windows.to_m",
       "without a centre", ""},
      {one("name = \"a\"\ncentre = \"peak\"\nbetween_m = [0.3, 0.4]\nwidth_m = 0.01\n"), 4, "windows.centre",
       "is not one of baseline_peak, baseline_trough", "\"baseline_peak\"?"},
      bad("[[windows]]\nname = \"sand\"\nfrom_m = 0.3\nto_m = 0.4\n", 8, "windows.name",
          "names another window"),
      bad("[parameters]\npenetrometer.final_depth_m = { lower = 0.5 }\n", 3, "windows.sand",
          "reaches 0.5255 m", "0.53 reaches it"),
  });
}

TEST(BadStudy, LayersAndZones) {
  const std::string top = "[[layers]]\ntop_m = 0\nbottom_m = 0.4\nsoil = \"sand\"\n";
  expect_errors({
      bad("[[layers]]\ntop_m = 0\nbottom_m = 1\nsoil = \"silt\"\n", 10, "layers.soil",
          "is not one of sand, clay", "[soils.silt] with its law"),
      bad("[[layers]]\ntop_m = 0\nsoil = \"sand\"\n", 7, "layers.bottom_m", "is missing"),
      bad("[[layers]]\ntop = 0\ntop_m = 0\nbottom_m = 1\nsoil = \"sand\"\n", 8, "layers.top", "unknown",
          "top_m?"),
      bad(top, 9, "layers.bottom_m", "the layers end at 0.4 m, but chamber.soil_height_m = 1",
          "give chamber.soil_height_m = 0.4 under [fixed]"),
      bad(top + "[[layers]]\ntop_m = 0.5\nbottom_m = 1\nsoil = \"sand\"\n", 12, "layers.top_m",
          "starts at 0.5 m, but the one above it ends at 0.4 m (line 9)"),
      bad(top + "[[layers]]\ntop_m = 0.4\nbottom_m = 0.3\nsoil = \"sand\"\n", 13, "layers.bottom_m",
          "no thickness", "grow downward"),
      bad("layers = 1\n", 7, "windows.layers", "unknown key"),  // still inside the last window
      bad("[[zones]]\nouter_radius_m = 0.45\ncolumns = 1.5\nrows_per_m = 300\n", 9, "zones.columns",
          "whole number"),
      bad("[[zones]]\nouter_radius_m = 0.45\ncolumns = 1e12\nrows_per_m = 300\n", 9, "zones.columns",
          "at most"),
      bad("[[zones]]\nouter_radius_m = 0.45\ncolumns = 0\nrows_per_m = 300\n", 7, "zones", "0 columns"),
      bad("[[zones]]\nouter_radius_m = 0.01\ncolumns = 9\nrows_per_m = 300\n", 7, "zones",
          "must exceed 0.01265"),
      bad("[[zones]]\nouter_radius_m = 0.45\ncolumns = 90\nrows_per_m = 0\n", 7, "zones", "rows per metre"),
  });
}

TEST(BadStudy, ImpossiblePhysics) {
  expect_errors({
      bad_fixed("sand.e_min = 0.9", "sand.e_min", "must be below sand.e_max = 0.89"),
      bad_fixed("sand.e_max = 0.5", "sand.e_max", "sand.e_min = 0.552 must be below sand.e_max = 0.5"),
      bad_fixed("initial.sigma_h0_kPa = 5", "initial.sigma_h0_kPa", "this sand bears at most"),
      bad_row("initial.sigma_h0_kPa = { lower = 10, upper = 35 }", "initial.sigma_h0_kPa.lower",
              "; initial.sigma_h0_kPa may be 1"),
      bad_row("initial.sigma_v0_kPa = { upper = 150 }", "initial.sigma_v0_kPa.upper", "q/p' of 1.88"),
      bad_fixed("penetrometer.final_depth_m = 0.9", "penetrometer.final_depth_m",
                "no room for the compressing mesh"),
      bad_row("chamber.soil_height_m = { lower = 0.6 }", "chamber.soil_height_m.lower", "no room"),
      bad_row("penetrometer.final_depth_m = { upper = 0.8 }", "penetrometer.final_depth_m.upper",
              "cells would be empty"),
      bad_row("numerics.near_height_m = { lower = 0.003 }", "numerics.near_height_m.lower", "3.00 mm high"),
      bad_row("numerics.face_elements = { upper = 8 }", "numerics.face_elements.upper", "1.58 mm wide"),
      {"profile = \"homogeneous_clay\"\n" + window + "[parameters]\nclay.s_u_kPa = { lower = 14 }\n", 7,
       "parameters.clay.s_u_kPa.lower", "Tresca bears at most 2 s_u", ""},
      {"profile = \"homogeneous_clay\"\n" + window + "[fixed]\ninitial.sigma_h0_kPa = 120\n", 7,
       "fixed.initial.sigma_h0_kPa", "K_0 = 2.4", ""},
  });
}

TEST(BadStudy, EveryErrorInOnePassInTheOrderOfTheFile) {
  const std::vector<StudyError> errors = errors_of(
      "profile = \"homogeneous_sand\"\n"                                  // 1
      "presett = \"quick\"\n"                                             // 2 unknown key
      "[fixed]\n"                                                         //
      "\"numerics.courant\" = 2\n"                                        // 4 out of range
      "\"clay.G_kPa\" = 500\n"                                            // 5 no clay
      "[parameters]\n"                                                    //
      "\"sand.H\" = { baseline = 25, lower = 30, uper = 75 }\n"           // 7 crossed, 7 unknown key
      "\"sand.nu\" = { lower = \"a\", upper = 9 }\n"                      // 8 type, 8 range
      "\"initial.sigma_h0_kPa\" = { lower = 2 }\n"                        // 9 impossible
      "[[windows]]\nname = \"w\"\nfrom_m = 0.3\nto_m = 0.2\ndepth = 1\n"  // 13 order, 14 unknown key
      "[limits]\nwall_minutes = -1\n");                                   // 16
  std::vector<int> lines;
  for (const StudyError& error : errors) lines.push_back(error.line);
  EXPECT_EQ(lines, (std::vector<int>{2, 4, 5, 7, 7, 8, 8, 9, 13, 14, 16})) << format(errors);
}

// A quantity whose own value is wrong is not judged together with others.
TEST(BadStudy, NoErrorFollowsFromAnotherError) {
  expect_errors({
      bad_fixed(
          "penetrometer.final_depth_m = \"0.6\"\n[[windows]]\nname = \"deep\"\nfrom_m = 0.55\nto_m = 0.58",
          "penetrometer.final_depth_m", "must be a number", "0.6, without"),
      bad_fixed("sand.e_min = \"low\"\nsand.e_max = 0.5", "sand.e_min", "must be a number"),
      {"profile = \"layerd\"\n" + window +
           "[parameters]\nclay.s_u_kPa = { upper = 30 }\nsand.H = { upper = 75 }\n",
       1, "profile", "is not one of", ""},
  });
}

TEST(BadStudy, SyntaxErrorsHaveLineAndColumn) {
  const std::vector<StudyError> errors = errors_of("profile = \"homogeneous_sand\"\npreset = quick\n");
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0].line, 2);
  EXPECT_GE(errors[0].column, 10);
  EXPECT_NE(errors[0].hint.find("once this is mended"), std::string::npos);
}

TEST(BadStudy, FilesThatCannotBeRead) {
  for (const auto& [file, message] :
       {std::pair("/no/such/study.toml", "there is no such file"), std::pair("/", "is not a file")}) {
    const StudyOrErrors result = read_study(file);
    const auto* errors = std::get_if<std::vector<StudyError>>(&result);
    ASSERT_NE(errors, nullptr);
    ASSERT_EQ(errors->size(), 1u);
    EXPECT_EQ(errors->front().file, file);
    EXPECT_EQ(errors->front().line, 0);
    EXPECT_EQ(errors->front().message, message);
  }
}

TEST(StudyError, ReadsLikeACompilersMessage) {
  const std::vector<StudyError> errors = {{"a.toml", 3, 5, "fixed.sand.H", "is wrong", "make it right"},
                                          {"a.toml", 0, 0, "", "cannot be read", ""}};
  EXPECT_EQ(format(errors),
            "a.toml:3:5: error: fixed.sand.H: is wrong\n    hint: make it right\n"
            "a.toml: error: cannot be read\n2 errors\n");
  EXPECT_EQ(format(std::span(errors).subspan(1)), "a.toml: error: cannot be read\n1 error\n");
}

}  // namespace
}  // namespace cpt::parameters
