// A study of the numerics with known effects: what the page says of them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "parameters/all_realizations.hpp"
#include "parameters/read_study.hpp"
#include "results/ledger/ledger.hpp"
#include "validation/numerics/page.hpp"
#include "validation/numerics/sentences.hpp"
#include "validation/numerics/settings_figure.hpp"
#include "validation/numerics/systematic.hpp"
#include "validation/numerics/write_numerics.hpp"

namespace cpt::validation::numerics {
namespace {

namespace fs = std::filesystem;

constexpr const char* study_text = R"(
title = "Made-up numerics"
profile = "homogeneous_clay"
preset = "quick"
[parameters]
"numerics.courant" = { baseline = 0.95, lower = 0.5 }
"clay.G_kPa" = { baseline = 552, lower = 423 }
[[points]]
name = "fine"
"numerics.refinement" = 2
[[points]]
name = "finest"
"numerics.refinement" = 4
[[points]]
name = "light"
"numerics.mass_scaling" = 100
[[points]]
name = "slow"
"penetrometer.speed_m_per_s" = 0.02
[[points]]
name = "fine and slow"
"numerics.refinement" = 2
"penetrometer.speed_m_per_s" = 0.02
[[points]]
name = "left"
"numerics.point_shift" = -0.25
[[points]]
name = "right"
"numerics.point_shift" = 0.25
[[windows]]
name = "deep"
from_m = 0.4
to_m = 0.5
)";

// 240 kPa at cell size zero, first order; light inertia takes 3 kPa off, other settings next to nothing; the
// repeats lie 0.5 kPa to either side.
double q_c(const solver::Setup& setup) {
  double value = 240.0 + 12.0 / setup.numerics.refinement + 2.0 * setup.numerics.point_shift;
  if (setup.numerics.mass_scaling < 1.0e4) value -= 3.0;
  if (setup.penetrometer.speed < 0.04) value += 0.1;
  if (setup.numerics.courant < 0.95) value -= 0.2;
  return value * 1.0e3;
}

// 10 kPa, a quarter more with light inertia.
double f_s(const solver::Setup& setup) { return setup.numerics.mass_scaling < 1.0e4 ? 12.5e3 : 10.0e3; }

class Numerics : public ::testing::Test {
 protected:
  Numerics() {
    std::string name = (fs::temp_directory_path() / "cpt_numerics_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no scratch folder");
    folder_ = name;
  }
  ~Numerics() override { fs::remove_all(folder_); }

  // Runs the study but for one realization, by the name of its point.
  [[nodiscard]] NumericsStudy run(std::string_view left_out = {}) const {
    const auto study =
        std::get<parameters::Study>(parameters::parse_study(study_text, folder_ / "made_up.toml"));
    fs::remove(study.database);  // of an earlier call
    const auto realizations = parameters::all_realizations(study);
    results::Ledger ledger = results::Ledger::open_for_run(study, realizations, {study_text});
    for (const parameters::Realization& realization : realizations) {
      if (parameters::parameter_name(study, realization) == left_out && realization.id > 1) continue;
      solver::Outcome outcome;
      outcome.status = solver::Status::completed;
      outcome.steps = 1000;
      outcome.material_points = 12000;
      for (double depth = 0.01; depth < 0.55; depth += 0.01) {
        outcome.profile.depth.push_back(depth);
        outcome.profile.q_c.push_back(q_c(parameters::make_setup(study, realization)));
        outcome.profile.f_s.push_back(f_s(parameters::make_setup(study, realization)));
      }
      ledger.record(realization.id, outcome);
    }
    return read_numerics(study.database);
  }

  fs::path folder_;
};

bool has(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

TEST_F(Numerics, SettingsAreThoseChangedAlone) {
  const NumericsStudy study = run();
  std::vector<std::string_view> names;
  for (const Setting& setting : study.settings) names.push_back(setting.quantity->name);
  EXPECT_EQ(names, (std::vector<std::string_view>{"numerics.refinement", "numerics.courant",
                                                  "numerics.mass_scaling", "penetrometer.speed_m_per_s"}));
  ASSERT_EQ(study.settings[0].runs.size(), 3u);
  EXPECT_EQ(study.settings[0].runs[2].value, 4.0);
  EXPECT_EQ(study.settings[3].runs.size(), 2u);  // not the one that changes the mesh, too
  EXPECT_EQ(study.repeats.size(), 3u);
  const auto repeats = repeats_in(study, "deep");
  ASSERT_TRUE(repeats);
  EXPECT_NEAR(repeats->mean, 252.0, 1e-9);
  EXPECT_NEAR(repeats->deviation, 0.5, 1e-9);
  EXPECT_EQ(most_accurate(study.campaign, study.settings[0])->value, 4.0);
  EXPECT_EQ(most_accurate(study.campaign, study.settings[2])->value, 100.0);
}

TEST_F(Numerics, EffectsAreRankedAndHeldAgainstTheRepeats) {
  const NumericsStudy study = run();
  const std::vector<Effect> found = effects(study, "deep");
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(words(*found[0].setting), "cell size");
  EXPECT_NEAR(found[0].change, -9.0 / 252.0, 1e-9);
  EXPECT_TRUE(found[0].told);  // t s sqrt(1 + 1/3) = 4.303 * 0.5 * 1.155 = 2.48 kPa
  EXPECT_EQ(words(*found[1].setting), "mass scaling");
  EXPECT_TRUE(found[1].told);
  EXPECT_EQ(words(*found[2].setting), "time step");
  EXPECT_FALSE(found[2].told);
  EXPECT_FALSE(found[3].told);
  const std::string text = sentences(study, "deep");
  EXPECT_TRUE(
      has(text, "numerics.mass_scaling = 100 in place of 10000 changes q̄<sub>c</sub> by −1.2 %, more than"))
      << text;
  EXPECT_TRUE(has(text, "penetrometer.speed_m_per_s = 0.02 m/s in place of 0.04 m/s")) << text;
}

TEST_F(Numerics, MeshesGiveTheOrderAndTheLimit) {
  const NumericsStudy study = run();
  const auto triples = mesh_triples(study, "deep");
  ASSERT_EQ(triples.size(), 1u);
  EXPECT_NEAR(triples[0].error.order, 1.0, 1e-6);
  EXPECT_NEAR(triples[0].error.extrapolated, 240.0, 1e-6);
  EXPECT_TRUE(has(sentences(study, "deep"), "observed order 1.00, 240.0 kPa at cell size zero"));
  EXPECT_TRUE(mesh_triples(run("finest"), "deep").empty());
}

// Finest cells take 9 of 252 kPa off, light inertia 3; no run has more points.
TEST_F(Numerics, TheSystematicErrorStandsBesideTheNoise) {
  const NumericsStudy study = run();
  const auto error = systematic_error(study, "deep");
  ASSERT_TRUE(error);
  EXPECT_NEAR(*error->cell_size, -9.0 / 252.0, 1e-9);
  EXPECT_FALSE(error->points);
  EXPECT_NEAR(*error->inertia, -3.0 / 252.0, 1e-9);
  EXPECT_NEAR(error->together, std::hypot(9.0, 3.0) / 252.0, 1e-9);
  ASSERT_TRUE(error->chance);
  EXPECT_NEAR(*error->chance, results::prediction_half_width(*repeats_in(study, "deep")) / 252.0, 1e-9);
  const std::string text = systematic_section({study});
  EXPECT_NE(text.find("| −3.6 % | – | −1.2 % | 3.8 % | ± "), std::string::npos) << text;
  EXPECT_NE(text.find(error->together > *error->chance ? "more than the noise" : "within the noise"),
            std::string::npos)
      << text;
  // Each channel by itself.
  const auto of_friction = systematic_error(study, "deep", 1);
  ASSERT_TRUE(of_friction);
  EXPECT_NEAR(*of_friction->cell_size, 0.0, 1e-9);
  EXPECT_NEAR(of_friction->together, 0.25, 1e-9);
  EXPECT_TRUE(has(text, "| deep | f<sub>s</sub> | 0.0 % | – | 25.0 % | 25.0 % | ± 0.0 % |")) << text;
  // Without its repeats nothing is said of chance.
  NumericsStudy alone = run();
  alone.repeats.resize(1);
  EXPECT_FALSE(systematic_error(alone, "deep")->chance);
  alone.settings.clear();
  EXPECT_FALSE(systematic_error(alone, "deep"));
  EXPECT_EQ(systematic_section({alone}), "");
}

TEST_F(Numerics, WhatHasNotRunIsLeftOut) {
  const NumericsStudy study = run("light");
  EXPECT_EQ(effects(study, "deep").size(), 3u);
  const NumericsStudy coarser = run("finest");
  EXPECT_EQ(effects(coarser, "deep").front().value, 2.0);
  const std::string text = page({study}, "figures");
  EXPECT_TRUE(has(text, "| pending |")) << text;
  const NumericsStudy without_repeats = run("left");
  EXPECT_FALSE(repeats_in(without_repeats, "deep"));
  EXPECT_TRUE(has(page({without_repeats}, "figures"), "fewer than 3"));
  EXPECT_FALSE(has(page({without_repeats}, "figures"), "(**"));
}

// Nothing that was changed changes more than the last digits: no effect, no order, no noise.
TEST_F(Numerics, ResultsThatDoNotVaryHaveNoOrderAndNoEffect) {
  NumericsStudy study = run();
  double last_digits = 0.0;
  for (results::WindowMeanRow& mean : study.campaign.window_means)
    mean.q_c_mean_kPa = 252.0 + (last_digits += 3e-13);
  for (const Effect& effect : effects(study, "deep")) {
    EXPECT_EQ(effect.change, 0.0);
    EXPECT_FALSE(effect.told);
  }
  const std::string text = page({study}, "figures");
  EXPECT_TRUE(has(text, "in place of 10000 does not change q̄<sub>c</sub>.")) << text;
  EXPECT_TRUE(has(text, "Refinements 4, 2 and 1: the result does not vary: no order can be read."));
  EXPECT_TRUE(has(text, "| undefined: the result does not vary |"));
  EXPECT_FALSE(has(text, "(**")) << "bold: more than the repeats explain";
}

TEST_F(Numerics, ThePageAndItsFigureAreWritten) {
  const auto files = write_numerics({run()}, folder_ / "out.md");
  ASSERT_EQ(files.size(), 3u);
  for (const fs::path& file : files) EXPECT_GT(fs::file_size(file), 1000u) << file;
  std::ifstream stream(files.front());
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  EXPECT_TRUE(has(text, "](out/made_up.svg)"));
  EXPECT_TRUE(fs::exists(folder_ / "out/made_up.svg"));
  EXPECT_TRUE(has(text, "(**−3.6 %**)"));
}

}  // namespace
}  // namespace cpt::validation::numerics
