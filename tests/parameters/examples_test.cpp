#include <array>
#include <map>

#include "parameters/all_realizations.hpp"
#include "tests/parameters/distributions/with_openturns.hpp"
#include "tests/parameters/studies.hpp"
#include "tests/solver/default_soils.hpp"

namespace cpt::parameters {
namespace {

using solver::Preset;
using solver::Profile;

Study example(const std::string& name) {
  const std::filesystem::path file = std::filesystem::path(CPT_EXAMPLES) / name;
  StudyOrErrors result = read_study(file);
  if (const auto* errors = std::get_if<std::vector<StudyError>>(&result)) {
    ADD_FAILURE() << format(*errors);
    return {};
  }
  return std::get<Study>(std::move(result));
}

void expect_study(const std::string& name, Profile profile, Preset preset, std::size_t realizations) {
  const Study study = example(name);
  EXPECT_EQ(study.profile, profile) << name;
  EXPECT_EQ(study.preset, preset) << name;
  EXPECT_EQ(all_realizations(study).size(), realizations) << name;
}

// The first study that anybody types.
TEST(Examples, TheReadmesStudyIsSound) {
  std::istringstream readme(text_of(std::filesystem::path(CPT_EXAMPLES) / ".." / "README.md"));
  std::string study;
  bool within = false;
  for (std::string line; std::getline(readme, line);) {
    if (line.starts_with("## ")) within = line == "## A study";
    if (within && line.starts_with("Mistakes")) break;
    if (within && line.starts_with("    ")) study += line.substr(4) + "\n";
  }
  EXPECT_NE(study.find("[parameters]"), std::string::npos);
  // Tells what is wrong with it, if something is.
  EXPECT_EQ(all_realizations(study_of(study)).size(), 13U);  // six bounds, six repeats, the baseline
}

TEST(Examples, HaveTheirRealizations) {
  expect_study("sens.toml", Profile::homogeneous_sand, Preset::quick, 27);
  expect_study("paper/homogeneous_sand.toml", Profile::homogeneous_sand, Preset::paper, 25);
  expect_study("paper/homogeneous_clay.toml", Profile::homogeneous_clay, Preset::paper, 16);
  expect_study("paper/layered.toml", Profile::layered_sand_clay, Preset::paper, 32);
  expect_study("paper/sand_flexible.toml", Profile::homogeneous_sand, Preset::paper, 4);
  expect_study("paper/dense_rigid.toml", Profile::homogeneous_sand, Preset::paper, 3);
  expect_study("paper/dense_flexible.toml", Profile::homogeneous_sand, Preset::paper, 2);
  expect_study("paper/second_push.toml", Profile::homogeneous_sand, Preset::paper, 2);
  expect_study("paper/image_pressure.toml", Profile::homogeneous_sand, Preset::paper, 3);
  expect_study("paper/at_rest.toml", Profile::homogeneous_sand, Preset::paper, 3);
  expect_study("paper/at_rest_flexible.toml", Profile::homogeneous_sand, Preset::paper, 3);
  expect_study("designs/varying_clay.toml", Profile::homogeneous_clay, Preset::quick, 1 + 2 + 200);
  expect_study("emulator/clay.toml", Profile::homogeneous_clay, Preset::quick, 1 + 7 + 60);
  expect_study("numerics/sand.toml", Profile::homogeneous_sand, Preset::quick, 23);
  expect_study("numerics/clay.toml", Profile::homogeneous_clay, Preset::quick, 24);
  expect_study("numerics/layered.toml", Profile::layered_sand_clay, Preset::quick, 23);
  expect_study("numerics/sand_fine.toml", Profile::homogeneous_sand, Preset::fine, 1);
  expect_study("numerics/clay_fine.toml", Profile::homogeneous_clay, Preset::fine, 1);
  expect_study("numerics/layered_fine.toml", Profile::layered_sand_clay, Preset::fine, 1);
  // The baseline, the six bounds that differ from it, and what the design adds; corners of the pairs that the
  // bounds are already come once.
  expect_study("designs/pairs.toml", Profile::homogeneous_sand, Preset::quick, 7 + 13 + 6);
  // Six of the 30 runs of its trajectories are runs that the study or another trajectory has.
  expect_study("designs/morris.toml", Profile::homogeneous_sand, Preset::quick, 7 + 6 * 5 - 6);
  expect_study("diagnosis/compacted_truth.toml", Profile::homogeneous_sand, Preset::quick, 2);
  expect_study("diagnosis/dense.toml", Profile::homogeneous_sand, Preset::quick, 9);
  expect_study("diagnosis/second_push_shares.toml", Profile::homogeneous_sand, Preset::quick, 6 + 4);
  expect_study("diagnosis/deltares.toml", Profile::layered_sand_clay, Preset::quick, 12);
  expect_study("designs/latin_hypercube.toml", Profile::homogeneous_sand, Preset::quick, 7 + 40);
  expect_study("designs/sobol.toml", Profile::homogeneous_sand, Preset::quick, 7 + 16 * 4);
}

TEST(Examples, WithDistributionsAreSound) {
  if (const std::string why = without_openturns(); !why.empty()) GTEST_SKIP() << why;
  expect_study("designs/propagation.toml", Profile::homogeneous_sand, Preset::quick, 1 + 4 * 2 + 60);
  expect_study("calibration/clay.toml", Profile::homogeneous_clay, Preset::quick, 1 + 4 * 2 + 200);
}

TEST(Examples, WithAnotherProgramAreSound) {
  EXPECT_EQ(all_realizations(example("external/ishigami.toml")).size(), 7U + 64U * 5U);
  const Study consolidation = example("external/consolidation.toml");
  EXPECT_EQ(all_realizations(consolidation).size(), 7U);
  EXPECT_EQ(consolidation.windows.size(), 2U);
  EXPECT_EQ(consolidation.version_command.size(), 3U);
  if (const std::string why = without_openturns(); !why.empty()) GTEST_SKIP() << why;
  EXPECT_EQ(all_realizations(example("external/ishigami_propagation.toml")).size(), 7U + 200U);
}

// Yost et al. (2023), sections 6.2 and 6.3: what the chamber's studies change, and nothing else.
TEST(Examples, ChamberStudiesDifferFromEachOtherAsThePaperSays) {
  const Study rigid = example("paper/dense_rigid.toml");
  EXPECT_EQ(rigid.baseline.initial.sigma_v0, 100.0e3);
  EXPECT_EQ(rigid.baseline.initial.sigma_h0, 50.0e3);
  EXPECT_DOUBLE_EQ(solver::sand_of(rigid.baseline).D_r, 0.60);
  const Study flexible = example("paper/dense_flexible.toml");
  solver::Setup setup = rigid.baseline;
  setup.chamber.wall = solver::Wall::flexible;
  EXPECT_EQ(solver::canonical_text(flexible.baseline), solver::canonical_text(setup));
  const Study second = example("paper/second_push.toml");
  setup = rigid.baseline;
  setup.initial.sigma_v0 = 120.0e3;
  setup.initial.sigma_h0 = 60.0e3;
  EXPECT_EQ(solver::canonical_text(second.baseline), solver::canonical_text(setup));
  const Study homogeneous = example("paper/homogeneous_sand.toml");
  setup = homogeneous.baseline;
  solver::sand_of(setup).OCR = 2.0;
  EXPECT_EQ(solver::canonical_text(example("paper/image_pressure.toml").baseline),
            solver::canonical_text(setup));
  setup = homogeneous.baseline;
  solver::sand_of(setup).start = solver::SandStart::at_rest;
  EXPECT_EQ(solver::canonical_text(example("paper/at_rest.toml").baseline), solver::canonical_text(setup));
  setup.chamber.wall = solver::Wall::flexible;
  EXPECT_EQ(solver::canonical_text(example("paper/at_rest_flexible.toml").baseline),
            solver::canonical_text(setup));
  setup = homogeneous.baseline;
  setup.chamber.wall = solver::Wall::flexible;
  EXPECT_EQ(solver::canonical_text(example("paper/sand_flexible.toml").baseline),
            solver::canonical_text(setup));
}

// Baselines of the examples repeat those of the presets, so that a preset and a study cannot drift apart.
TEST(Examples, BaselinesAreThoseOfThePresets) {
  for (const char* name :
       {"sens.toml", "paper/homogeneous_sand.toml", "paper/homogeneous_clay.toml", "paper/layered.toml"}) {
    const Study study = example(name);
    EXPECT_EQ(solver::canonical_text(study.baseline),
              solver::canonical_text(solver::make_setup(study.profile, study.preset)))
        << name;
  }
}

using Bounds = std::array<double, 3>;

std::map<std::string, Bounds> bounds_of(const Study& study) {
  std::map<std::string, Bounds> bounds;
  for (const Row& row : study.rows)
    bounds[std::string(row.quantity->name)] = {row.baseline, row.lower, row.upper};
  return bounds;
}

// Yost et al. (2023), Tables 2 and 3, sections 3 and 4.4: baseline, lower bound, upper bound.
TEST(Examples, LayeredStudyHasTheTablesOfThePaper) {
  const std::map<std::string, Bounds> table = {{"sand.lambda", {0.012, 0.009, 0.015}},
                                               {"sand.G_ref", {743, 700, 800}},
                                               {"sand.phi_cs_deg", {30, 29, 31}},
                                               {"sand.N", {0.1, 0.1, 0.3}},
                                               {"sand.chi_tc", {2.7, 2.5, 3.5}},
                                               {"sand.nu", {0.2, 0.1, 0.3}},
                                               {"sand.H", {25, 25, 75}},
                                               {"clay.n_0", {0.362, 0.290, 0.434}},
                                               {"clay.s_u_kPa", {27.9, 22.3, 33.5}},
                                               {"clay.G_kPa", {552, 423, 1404}},
                                               {"sand.D_r_percent", {29, 19, 39}},
                                               {"initial.sigma_h0_kPa", {25, 15, 35}},
                                               {"contact.friction_ratio", {0.5, 0.3, 0.9}},
                                               {"contact.adhesion_ratio", {0.5, 0.25, 0.5}},
                                               {"chamber.radius_m", {0.45, 0.30, 0.45}},
                                               {"chamber.wall", {1, 0, 1}}};
  const auto layered = bounds_of(example("paper/layered.toml"));
  EXPECT_EQ(layered, table);

  auto sand = bounds_of(example("paper/homogeneous_sand.toml"));
  EXPECT_EQ(sand, bounds_of(example("sens.toml")));
  EXPECT_EQ(sand["sand.D_r_percent"], (Bounds{36, 26, 46}));
  sand["sand.D_r_percent"] = table.at("sand.D_r_percent");
  for (const auto& [name, bounds] : sand) EXPECT_EQ(bounds, table.at(name)) << name;
  for (const auto& [name, bounds] : bounds_of(example("paper/homogeneous_clay.toml")))
    EXPECT_EQ(bounds, table.at(name)) << name;
}

TEST(Examples, WindowsOfThePaper) {
  for (const char* name : {"sens.toml", "paper/homogeneous_sand.toml", "paper/homogeneous_clay.toml"}) {
    const Study study = example(name);
    ASSERT_EQ(study.windows.size(), 1u) << name;
    EXPECT_EQ(study.windows[0].from, 0.5054);
    EXPECT_EQ(study.windows[0].to, 0.5255);
  }
  const Study layered = example("paper/layered.toml");
  ASSERT_EQ(layered.windows.size(), 3u);
  EXPECT_EQ(layered.windows[0].kind, Window::Kind::peak);
  EXPECT_EQ(layered.windows[0].width, 0.0023);
  EXPECT_LT(layered.windows[0].from, 0.3082);
  EXPECT_GT(layered.windows[0].to, 0.3082);
  EXPECT_EQ(layered.windows[1].kind, Window::Kind::trough);
  EXPECT_EQ(layered.windows[1].width, 0.0042);
  EXPECT_LT(layered.windows[1].from, 0.2771);
  EXPECT_GT(layered.windows[1].to, 0.2771);
}

}  // namespace
}  // namespace cpt::parameters
