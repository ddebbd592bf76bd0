// The section [design]: its points among the study's, and what is wrong with it.
#include "parameters/designs/design.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "parameters/all_realizations.hpp"
#include "parameters/designs/morris.hpp"
#include "parameters/designs/pairs.hpp"
#include "parameters/designs/polynomial_chaos.hpp"
#include "parameters/designs/sobol.hpp"
#include "tests/parameters/studies.hpp"
#include "tests/solver/default_soils.hpp"

namespace cpt::parameters {
namespace {

const std::string rows =
    "[parameters]\n"
    "sand.nu = { baseline = 0.2, lower = 0.1, upper = 0.3 }\n"
    "sand.H = { baseline = 25, upper = 75 }\n"
    "chamber.wall = { baseline = \"rigid\", alternative = \"flexible\" }\n";

Study with(const std::string& design) { return study_of(sand_study(rows + "[design]\n" + design)); }

std::set<std::string> all_settings(const Study& study) {
  std::set<std::string> texts;
  for (const Realization& realization : all_realizations(study))
    texts.insert(settings_text(study, realization));
  return texts;
}

TEST(Design, WithoutTheSectionThereIsNone) {
  const Study study = study_of(sand_study(rows));
  EXPECT_EQ(study.design.kind, "one_at_a_time");
  EXPECT_TRUE(study.points.empty());
  EXPECT_TRUE(with("kind = \"one_at_a_time\"").points.empty());
}

TEST(Design, MorrisTakesChoicesFromOneBoundToTheOther) {
  const Study study = with("kind = \"morris\"\ntrajectories = 6\nseed = 4\n");
  const Eigen::MatrixXd places = design_places(study);
  ASSERT_EQ(places.rows(), 24);
  EXPECT_TRUE((places.col(2).array() == 0.0 || places.col(2).array() == 1.0).all());
  for (Eigen::Index t = 0; t < 6; ++t)
    EXPECT_EQ(places.col(2).segment(4 * t, 4).maxCoeff() - places.col(2).segment(4 * t, 4).minCoeff(), 1.0);
  EXPECT_EQ(study.points.at(0).name, "morris 1.1");
  EXPECT_EQ(study.points.at(1).name, "morris 1.2");
}

TEST(Design, PointsLieInTheBoxAndEqualSettingsRunOnce) {
  for (const char* design : {"kind = \"pairs\"\n", "kind = \"morris\"\nlevels = 2\n",
                             "kind = \"latin_hypercube\"\nruns = 30\n", "kind = \"sobol\"\nruns = 16\n"}) {
    const Study study = with(design);
    EXPECT_GT(study.design.points, 0U);
    EXPECT_EQ(study.points.size(), study.design.points);
    for (const DesignPoint& point : study.points)
      for (const Change& change : point.changes)
        for (const Row& row : study.rows)
          if (row.quantity == change.quantity) {
            EXPECT_GE(change.value, row.lower) << point.name;
            EXPECT_LE(change.value, row.upper) << point.name;
          }
    const auto realizations = all_realizations(study);
    EXPECT_EQ(all_settings(study).size(), realizations.size()) << design;
  }
}

// Whatever stands for a run has exactly the values that the run asks for.
TEST(Design, RunsHaveTheirRealizations) {
  for (const char* design : {"kind = \"pairs\"\n", "kind = \"sobol\"\nruns = 8\n"}) {
    const Study study = with(design);
    const Eigen::MatrixXd places = design_places(study);
    const auto realizations = all_realizations(study);
    const auto found = design_realizations(study, realizations);
    ASSERT_EQ(static_cast<long>(found.size()), run_count(study.design));
    for (std::size_t run = 0; run < found.size(); ++run) {
      const solver::Setup setup = make_setup(study, realizations[found[run]]);
      for (std::size_t j = 0; j < 3; ++j) {
        const double place = places(static_cast<Eigen::Index>(run), static_cast<Eigen::Index>(j));
        EXPECT_DOUBLE_EQ(study.rows[j].quantity->value(setup),
                         std::isnan(place) ? study.rows[j].baseline : value_at(study.rows[j], place));
      }
    }
  }
}

// Corners of a one-sided row are runs of the other row alone, or the baseline.
TEST(Design, PairsUseTheRunsThatThereAre) {
  const Study study = with("kind = \"pairs\"\nparameters = [\"sand.H\", \"chamber.wall\"]\n");
  ASSERT_EQ(study.points.size(), 1U);
  EXPECT_EQ(study.points[0].name, "pairs 1.2");
  EXPECT_EQ(value_text(study, all_realizations(study).back()), "sand.H = 75, chamber.wall = flexible");
  std::vector<std::string> used;
  const auto realizations = all_realizations(study);
  for (const std::size_t index : design_realizations(study, realizations))
    used.push_back(std::string(parameter_name(study, realizations[index])));
  EXPECT_EQ(used, (std::vector<std::string>{"chamber.wall", "pairs 1.2", "", "sand.H"}));
}

TEST(Design, StandsBetweenPointsAndRepeats) {
  const Study study =
      study_of("repeats = 2\n" + sand_study(rows + "[[points]]\nname = \"a\"\nsand.H = 50\n" +
                                            "[design]\nkind = \"latin_hypercube\"\nruns = 12\n"));
  EXPECT_EQ(study.points.size(), 15U);
  EXPECT_EQ(study.design.first_point, 1U);
  EXPECT_EQ(study.points[1].name, "latin hypercube 1");
  EXPECT_EQ(study.points[13].name, "repeat 1");
}

TEST(Design, SeedFixesThePoints) {
  const auto values = [](const std::string& seed) {
    std::vector<double> all;
    for (const DesignPoint& point : with("kind = \"sobol\"\nruns = 8\nseed = " + seed + "\n").points)
      for (const Change& change : point.changes) all.push_back(change.value);
    return all;
  };
  EXPECT_EQ(values("3"), values("3"));
  EXPECT_NE(values("3"), values("4"));
}

TEST(Design, DefaultsAreThoseOfTheDocumentation) {
  EXPECT_EQ(with("kind = \"morris\"").design.trajectories, 10);
  EXPECT_EQ(with("kind = \"morris\"").design.levels, 4);
  EXPECT_EQ(with("kind = \"latin_hypercube\"").design.runs, 30);
  EXPECT_EQ(with("kind = \"sobol\"").design.runs, 64);
  EXPECT_EQ(with("kind = \"pairs\"").design.rows.size(), 3U);
}

TEST(Design, GrownSampleKeepsItsPointsAndTheirNames) {
  const Study small = with("kind = \"latin_hypercube\"\nruns = 12"),
              grown = with("kind = \"latin_hypercube\"\nruns = 15\nfirst_runs = 12");
  ASSERT_EQ(small.points.size(), 12U);
  ASSERT_EQ(grown.points.size(), 15U);
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_EQ(grown.points[i].name, small.points[i].name);
    for (std::size_t k = 0; k < small.points[i].changes.size(); ++k)
      EXPECT_EQ(grown.points[i].changes[k].value, small.points[i].changes[k].value);
  }
  EXPECT_EQ(grown.points[14].name, "latin hypercube 15");
}

TEST(Design, ErrorsTellWhatIsWrong) {
  struct Case {
    std::string design, key, message;
  };
  for (const Case& bad :
       {Case{"runs = 5", "design.kind", "missing"},
        Case{"kind = \"moris\"", "design.kind", "did you mean \"morris\""},
        Case{"kind = \"morris\"\nruns = 5", "design.runs", "belongs to latin_hypercube, sobol"},
        Case{"kind = \"sobol\"\nfirst_runs = 5", "design.first_runs", "belongs to latin_hypercube"},
        Case{"kind = \"latin_hypercube\"\nruns = 24\nfirst_runs = 30", "design.first_runs",
             "30 must be at most runs = 24"},
        Case{"kind = \"morris\"\ntrajectory = 5", "design.trajectory", "did you mean trajectories"},
        Case{"kind = \"morris\"\nlevels = 5", "design.levels", "even number from 2 to 20"},
        Case{"kind = \"morris\"\ntrajectories = 1", "design.trajectories", "whole number from 2 to 1000"},
        Case{"kind = \"morris\"\ntrajectories = 2.5", "design.trajectories", "whole number"},
        Case{"kind = \"sobol\"\nruns = \"64\"", "design.runs", "without quotes"},
        Case{"kind = \"sobol\"\nseed = -1", "design.seed", "from 0"},
        Case{"kind = \"sobol\"\nsampling = \"latin_hypercube\"", "design.sampling", "belongs to propagation"},
        Case{"kind = \"propagation\"\nsampling = \"latin\"", "design.sampling",
             "did you mean \"latin_hypercube\""},
        Case{"kind = \"morris\"\nuntil = { half_width_percent = 3 }", "design.until",
             "belongs to propagation"},
        Case{"kind = \"propagation\"\nuntil = 3", "design.until", "must be a table, not a number"},
        Case{"kind = \"propagation\"\nuntil = { quantile = 0.9 }", "design.until.half_width_percent",
             "missing"},
        Case{"kind = \"propagation\"\nuntil = { quantile = 95, half_width_percent = 3 }",
             "design.until.quantile", "95 must be above 0 and below 1"},
        Case{"kind = \"propagation\"\nuntil = { half_width = 3 }", "design.until.half_width",
             "did you mean half_width_percent"},
        Case{"kind = \"sobol\"\nsections = 3", "design.sections", "5 and more"},
        Case{"kind = \"sobol\"\nruns = 20\nsections = 10", "design.sections", "need runs = 40 or more"},
        Case{"kind = \"sobol\"\nestimator = \"martines\"", "design.estimator", "did you mean \"martinez\""},
        Case{"kind = \"morris\"\nestimator = \"martinez\"", "design.estimator", "means nothing to morris"},
        Case{"kind = \"morris\"\nsections = 5", "design.sections", "belongs to sobol"},
        Case{"kind = \"sobol\"\nruns = 10000", "design", "asks for 50000 runs"},
        Case{"kind = \"pairs\"\nseed = 1", "design.seed", "means nothing to pairs"},
        Case{"kind = \"one_at_a_time\"\nparameters = []", "design.parameters", "every row"},
        Case{"kind = \"pairs\"\nparameters = [\"sand.nu\"]", "design.parameters", "at least 2"},
        Case{"kind = \"morris\"\nparameters = []", "design.parameters", "at least 1"},
        Case{"kind = \"morris\"\nparameters = \"sand.nu\"", "design.parameters", "array"},
        Case{"kind = \"morris\"\nparameters = [3]", "design.parameters", "names"},
        Case{"kind = \"morris\"\nparameters = [\"sand.h\"]", "design.parameters", "did you mean \"sand.H\""},
        Case{"kind = \"morris\"\nparameters = [\"sand.H\", \"sand.H\"]", "design.parameters", "twice"}}) {
    const auto errors = errors_of(sand_study(rows + "[design]\n" + bad.design + "\n"));
    ASSERT_EQ(errors.size(), 1U) << bad.design << '\n' << format(errors);
    EXPECT_EQ(errors.front().key, bad.key) << format(errors);
    EXPECT_GT(errors.front().line, 0);
    EXPECT_NE(format(errors).find(bad.message), std::string::npos) << format(errors);
  }
}

TEST(Design, ImpossibleCornersAreToldOnce) {
  // Each bound is possible alone, both together leave the chamber too small for the cone.
  const auto errors =
      errors_of(sand_study("[parameters]\nsand.nu = { baseline = 0.2, upper = 0.3 }\n"
                           "penetrometer.final_depth_m = { baseline = 0.55, upper = 0.985 }\n[design]\nkind "
                           "= \"sobol\"\nruns = 16\n"));
  int of_design = 0;
  for (const StudyError& error : errors) of_design += error.key.starts_with("design.sobol") ? 1 : 0;
  EXPECT_EQ(of_design, 1) << format(errors);
}

TEST(Design, NameOfAPointIsTaken) {
  const auto errors = errors_of(sand_study(rows + "[[points]]\nname = \"morris 1.2\"\nsand.H = 50\n" +
                                           "[design]\nkind = \"morris\"\n"));
  ASSERT_EQ(errors.size(), 1U) << format(errors);
  EXPECT_EQ(errors[0].key, "points.name");
}

TEST(Design, WholeNumbersAndChoicesTakeTheNearestValue) {
  solver::Quantity whole = *solver::find_quantity("sand.H");
  whole.integer = true;
  const Row row{&whole, 1.0, 1.0, 4.0};
  EXPECT_EQ(value_at(row, 0.0), 1.0);
  EXPECT_EQ(value_at(row, 0.4), 2.0);
  EXPECT_EQ(value_at(row, 1.0), 4.0);
  const Row wall{solver::find_quantity("chamber.wall"), 1.0, 0.0, 1.0};
  EXPECT_EQ(value_at(wall, 0.49), 0.0);
  EXPECT_EQ(value_at(wall, 0.5), 1.0);
  EXPECT_EQ(values_of(row), 4);
  EXPECT_EQ(values_of(wall), 2);
  EXPECT_EQ(values_of({solver::find_quantity("sand.H"), 25.0, 25.0, 75.0}), 0);
}

// A result that is a straight line in every input, whole numbers and choices included, from the settings that
// are really run: from the lower to the upper bounds it rises by 48, 90 and -50.
class WholeNumbers : public ::testing::Test {
 protected:
  void make(const std::string& design) {
    study = study_of(
        sand_study("[parameters]\nsand.nu = { baseline = 0.2, lower = 0.1, upper = 0.3 }\n"
                   "numerics.face_elements = { baseline = 2, lower = 1, upper = 4 }\n"
                   "chamber.wall = { baseline = \"rigid\", alternative = \"flexible\" }\n[design]\n" +
                   design));
    places = design_places(study);
    const auto realizations = all_realizations(study);
    y.resize(places.rows());
    Eigen::Index run = 0;
    for (const std::size_t index : design_realizations(study, realizations)) {
      const solver::Setup setup = make_setup(study, realizations[index]);
      y(run++) = 2000.0 + 240.0 * solver::sand_of(setup).nu + 30.0 * setup.numerics.face_elements +
                 (setup.chamber.wall == solver::Wall::rigid ? 0.0 : 50.0);
    }
    values.clear();
    for (const std::size_t row : study.design.rows) values.push_back(values_of(study.rows[row]));
  }
  // Shares of the variance: uniform; 1 to 4 with halves at the ends; two values.
  static Eigen::Vector3d shares() {
    const Eigen::Vector3d variances(48.0 * 48.0 / 12.0, 30.0 * 30.0 * 11.0 / 12.0, 50.0 * 50.0 / 4.0);
    return variances / variances.sum();
  }
  Study study;
  Eigen::MatrixXd places;
  Eigen::VectorXd y;
  std::vector<int> values;
};

TEST_F(WholeNumbers, MorrisTakesTheStepAsItIsRun) {
  for (const int levels : {2, 4, 6, 20}) {
    make(fmt::format("kind = \"morris\"\ntrajectories = 10\nlevels = {}\n", levels));
    const auto effects = elementary_effects(places, y, 1);
    const double rises[] = {48.0, 90.0, 50.0};
    for (std::size_t j = 0; j < 3; ++j) {
      EXPECT_NEAR(effects[j].mu_star.value, rises[j], 1e-8) << levels << ' ' << j;
      EXPECT_NEAR(effects[j].mu_star.lower, rises[j], 1e-8) << levels << ' ' << j;
      EXPECT_NEAR(effects[j].sigma.value, 0.0, 1e-8) << levels << ' ' << j;
      EXPECT_EQ(effects[j].used, 10);
    }
    EXPECT_NEAR(effects[1].mu.value, 90.0, 1e-8) << levels;
  }
}

TEST_F(WholeNumbers, TheExpansionHasTheExactShares) {
  make("kind = \"latin_hypercube\"\nruns = 50\n");
  EXPECT_EQ(values, (std::vector<int>{0, 4, 2}));
  const auto fit = polynomial_chaos(places, values, y);
  EXPECT_NEAR(fit.q2, 1.0, 1e-9);
  for (std::size_t j = 0; j < 3; ++j) {
    EXPECT_NEAR(fit.first[j].value, shares()(static_cast<Eigen::Index>(j)), 1e-9) << j;
    EXPECT_NEAR(fit.total[j].value, shares()(static_cast<Eigen::Index>(j)), 1e-9) << j;
  }
}

TEST_F(WholeNumbers, AveragesHoldTheSameShares) {
  make("kind = \"sobol\"\nruns = 256\n");
  const auto indices = sobol_indices(3, y, 1);
  for (std::size_t j = 0; j < 3; ++j)
    EXPECT_NEAR(indices.total[j].value, shares()(static_cast<Eigen::Index>(j)), 0.02) << j;
}

TEST_F(WholeNumbers, PairsOfAStraightLineDoNotInteract) {
  make("kind = \"pairs\"\n");
  for (Eigen::Index k = 0; k < y.size(); k += 4)
    EXPECT_EQ(interaction({y(k), y(k + 1), y(k + 2), y(k + 3)}), 0.0);
}

}  // namespace
}  // namespace cpt::parameters
