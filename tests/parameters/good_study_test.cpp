#include <cmath>

#include "parameters/all_realizations.hpp"
#include "tests/parameters/studies.hpp"
#include "tests/solver/default_soils.hpp"

namespace cpt::parameters {
namespace {

using solver::Soil;

TEST(GoodStudy, DefaultsComeFromTheFileNameAndThePreset) {
  const Study study = study_of("profile = \"homogeneous_clay\"\n" + window, "/studies/one/clay.toml");
  EXPECT_EQ(study.file, "/studies/one/clay.toml");
  EXPECT_EQ(study.name, "clay");
  EXPECT_EQ(study.title, "clay");
  EXPECT_EQ(study.profile, solver::Profile::homogeneous_clay);
  EXPECT_EQ(study.preset, solver::Preset::standard);
  EXPECT_EQ(study.database, "/studies/one/clay.sqlite");
  EXPECT_EQ(study.curves, "/studies/one/clay.h5");
  EXPECT_EQ(study.report_dir, "/studies/one/clay-report");
  EXPECT_TRUE(std::isinf(study.wall_limit_seconds));
  EXPECT_TRUE(study.rows.empty());
  EXPECT_EQ(solver::canonical_text(study.baseline),
            solver::canonical_text(solver::make_setup(study.profile, study.preset)));
}

TEST(GoodStudy, RelativeFileNamesBecomeAbsolute) {
  const Study study = study_of(sand_study(""), "here/./sand.toml");
  EXPECT_EQ(study.file, std::filesystem::current_path() / "here/sand.toml");
  EXPECT_EQ(study.database, std::filesystem::current_path() / "here/sand.sqlite");
}

TEST(GoodStudy, TitleOutputAndLimits) {
  const Study study = study_of("title = \"A title\"\n" +
                               sand_study("[output]\ndatabase = \"out/a.sqlite\"\ncurves = \"/tmp/a.h5\"\n"
                                          "report = \"../pages\"\n[limits]\nwall_minutes = 1.5\n"));
  EXPECT_EQ(study.title, "A title");
  EXPECT_EQ(study.database, "/studies/out/a.sqlite");
  EXPECT_EQ(study.curves, "/tmp/a.h5");
  EXPECT_EQ(study.report_dir, "/pages");
  EXPECT_EQ(study.wall_limit_seconds, 90.0);
}

TEST(GoodStudy, FixedInputsInEverySpelling) {
  const Study study =
      study_of(sand_study("[fixed]\n\"numerics.courant\" = 0.5\nsand.phi_cs_deg = 31\n"
                          "[fixed.initial]\nsigma_v0_kPa = 60\nself_weight = \"none\"\n"));
  EXPECT_EQ(study.baseline.numerics.courant, 0.5);
  EXPECT_DOUBLE_EQ(solver::sand_of(study.baseline).phi_cs, 31.0 * std::acos(-1.0) / 180.0);
  EXPECT_EQ(study.baseline.initial.sigma_v0, 60.0e3);
  EXPECT_EQ(study.baseline.initial.self_weight, solver::SelfWeight::none);
}

TEST(GoodStudy, RowsKeepTheOrderOfTheFileAndMoveTheBaseline) {
  const Study study =
      study_of(sand_study("[parameters]\n"
                          "\"sand.phi_cs_deg\" = { baseline = 32, lower = 29.5, upper = 33 }\n"
                          "sand.H = { upper = 75, baseline = 30 }\n"
                          "\"initial.sigma_h0_kPa\" = { lower = 15 }\n"
                          "contact.friction_ratio = { baseline = 0.4, lower = 0.4, upper = 0.9 }\n"));
  ASSERT_EQ(study.rows.size(), 4u);
  const auto row = [&](std::size_t i, std::string_view name, double lower, double baseline, double upper) {
    EXPECT_EQ(study.rows[i].quantity->name, name);
    EXPECT_EQ(study.rows[i].lower, lower);
    EXPECT_EQ(study.rows[i].baseline, baseline);
    EXPECT_EQ(study.rows[i].upper, upper);
    EXPECT_EQ(study.rows[i].quantity->value(study.baseline), baseline);
  };
  row(0, "sand.phi_cs_deg", 29.5, 32, 33);
  row(1, "sand.H", 30, 30, 75);
  row(2, "initial.sigma_h0_kPa", 15, 25, 25);  // baseline of the preset
  row(3, "contact.friction_ratio", 0.4, 0.4, 0.9);
}

TEST(GoodStudy, AnAlternativeTakesTheSideItSortsTo) {
  const Study study =
      study_of(sand_study("[parameters]\n"
                          "chamber.wall = { baseline = \"rigid\", alternative = \"flexible\" }\n"
                          "chamber.radius_m = { baseline = 0.45, alternative = 0.3 }\n"
                          "initial.self_weight = { alternative = \"saturated\" }\n"
                          "numerics.face_elements = { alternative = 3 }\n"));
  ASSERT_EQ(study.rows.size(), 4u);
  const auto sides = [&](std::size_t i) {
    const Row& row = study.rows[i];
    return row.quantity->format(row.lower) + " " + row.quantity->format(row.upper);
  };
  EXPECT_EQ(sides(0), "flexible rigid");
  EXPECT_EQ(sides(1), "0.3 0.45");
  EXPECT_EQ(sides(2), "submerged saturated");
  EXPECT_EQ(sides(3), "2 3");
}

TEST(GoodStudy, WindowsFixedAndCentred) {
  const Study study = study_of(
      "profile = \"layered_sand_clay\"\npreset = \"quick\"\n"
      "[[windows]]\nname = \"top\"\nfrom_m = 0.1\nto_m = 0.15\n"
      "[[windows]]\nname = \"peak-1\"\ncentre = \"baseline_peak\"\nbetween_m = [0.285, 0.325]\nwidth_m = "
      "0.0023\n"
      "[[windows]]\nname = \"trough_1\"\ncentre = \"baseline_trough\"\nbetween_m = [0.25, 0.295]\nwidth_m = "
      "0.0042\n");
  ASSERT_EQ(study.windows.size(), 3u);
  EXPECT_EQ(study.windows[0].name, "top");
  EXPECT_EQ(study.windows[0].kind, Window::Kind::fixed);
  EXPECT_EQ(study.windows[0].from, 0.1);
  EXPECT_EQ(study.windows[0].to, 0.15);
  EXPECT_EQ(study.windows[1].kind, Window::Kind::peak);
  EXPECT_EQ(study.windows[1].from, 0.285);
  EXPECT_EQ(study.windows[1].to, 0.325);
  EXPECT_EQ(study.windows[1].width, 0.0023);
  EXPECT_EQ(study.windows[2].kind, Window::Kind::trough);
}

TEST(GoodStudy, LayersAndZonesReplaceThoseOfThePreset) {
  const Study study =
      study_of(sand_study("[fixed]\nchamber.soil_height_m = 0.96\nclay.s_u_kPa = 30\n"
                          "[[layers]]\ntop_m = 0\nbottom_m = 0.4\nsoil = \"sand\"\n"
                          "[[layers]]\ntop_m = 0.4\nbottom_m = 0.96\nsoil = \"clay\"\n"
                          "[[zones]]\nouter_radius_m = 0.05\ncolumns = 20\nrows_per_m = 300\n"
                          "[[zones]]\nouter_radius_m = 0.45\ncolumns = 30\nrows_per_m = 200\n"));
  ASSERT_EQ(study.baseline.layers.size(), 2u);
  EXPECT_EQ(study.baseline.layers[0].soil, solver::default_sand);
  EXPECT_EQ(study.baseline.layers[1].soil, solver::default_clay);
  EXPECT_EQ(study.baseline.layers[1].top, 0.4);
  EXPECT_EQ(study.baseline.layers[1].bottom, 0.96);
  ASSERT_EQ(study.baseline.numerics.zones.size(), 2u);
  EXPECT_EQ(study.baseline.numerics.zones[0].outer_radius, 0.05);
  EXPECT_EQ(study.baseline.numerics.zones[0].columns, 20);
  EXPECT_EQ(study.baseline.numerics.zones[1].rows_per_metre, 200.0);
}

TEST(GoodStudy, AHomogeneousProfileFollowsTheSoilsHeight) {
  const Study study = study_of(sand_study("[fixed]\nchamber.soil_height_m = 0.96\n"));
  ASSERT_EQ(study.baseline.layers.size(), 1u);
  EXPECT_EQ(study.baseline.layers[0].bottom, 0.96);
}

}  // namespace
}  // namespace cpt::parameters
