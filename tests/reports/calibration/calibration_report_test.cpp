// What a calibration says follows from its numbers, and what it writes can be read again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "parameters/read_study.hpp"
#include "reports/calibration/figures.hpp"
#include "reports/calibration/posterior_study.hpp"
#include "reports/calibration/sentences.hpp"
#include "reports/calibration/tables.hpp"
#include "reports/calibration/write_calibration.hpp"
#include "tests/parameters/distributions/with_openturns.hpp"

namespace cpt::reports::calibrated {
namespace {

using Eigen::Index;

// Two inputs and a deviation; ten cells of which 3 to 5 are higher and 8 is lower than simulated.
CalibrationReport made_up() {
  CalibrationReport report{"Two <inputs>", "sand", 60, {"first"}, {{"q_c", "q_c"}}, {}, {}, {}};
  report.inputs = {{"sand.H", "H", "-", 25.0, 75.0, false, {}},
                   {"contact.friction_ratio", "k", "-", 0.3, 0.9, false, {}}};
  diagnosis::Posterior& posterior = report.posterior;
  diagnosis::Random random(1, 0);
  posterior.draws.resize(500, 3);
  posterior.prior_draws.resize(500, 3);
  for (Index i = 0; i < 500; ++i) {
    posterior.draws.row(i) << 50.0 + 4.0 * std::tanh(random.normal()), 0.31 + 0.58 * random.uniform(), 2.0;
    posterior.prior_draws.row(i) << 25.0 + 50.0 * random.uniform(), 0.3 + 0.6 * random.uniform(),
        random.uniform();
  }
  posterior.draws.col(2) += 0.1 * posterior.prior_draws.col(2);
  const char* names[] = {"sand.H", "contact.friction_ratio", "discrepancy q_c"};
  for (Index j = 0; j < 3; ++j)
    posterior.unknowns.push_back({names[j],
                                  j < 2 ? "-" : "%",
                                  j < 2,
                                  diagnosis::spread_of(posterior.prior_draws.col(j)),
                                  diagnosis::spread_of(posterior.draws.col(j)),
                                  {1.002, 900.0, 700.0}});
  posterior.correlation = diagnosis::rank_correlation_of(posterior.draws.leftCols(2));
  posterior.correlation(0, 1) = posterior.correlation(1, 0) = -0.6;
  posterior.sample.converged = true;
  posterior.sample.convergence.assign(3, {1.002, 900.0, 700.0});
  posterior.sample.chains.assign(4, Eigen::MatrixXd::Zero(2000, 3));
  std::vector<diagnosis::CalibratedBand>& bands = posterior.bands.emplace_back();
  for (int i = 0; i < 10; ++i) {
    const double percent = i >= 3 && i <= 5 ? 6.0 : i == 8 ? -4.0 : 0.5;
    bands.push_back({{0, 0.0525 + 0.005 * i, 0.005},
                     1000.0 + percent * 10.0,
                     {1000.0, 10.0, 980.0, 1000.0, 1020.0},
                     {1000.0, 30.0, 940.0, 1000.0, 1060.0},
                     {percent, 1.0, percent - 2.0, percent, percent + 2.0}});
  }
  return report;
}

bool says(const std::vector<std::string>& sentences, const std::string& words) {
  return std::ranges::any_of(sentences, [&](const auto& s) { return s.find(words) != std::string::npos; });
}

TEST(CalibrationReport, SentencesSayWhatTheNumbersSay) {
  CalibrationReport report = made_up();
  const double left = report.posterior.unknowns[0].left();
  ASSERT_LT(left, 0.5);
  ASSERT_GT(report.posterior.unknowns[1].left(), 0.9);
  std::vector<std::string> told = calibration_sentences(report);
  EXPECT_TRUE(says(
      told, "Learnt from the recordings, with the standard deviation over that of the prior: sand.H (to " +
                std::to_string(std::lround(100.0 * left)) + " %)."))
      << told[0];
  EXPECT_TRUE(says(told, "hardly anything of: contact.friction_ratio"));
  EXPECT_TRUE(says(told, "q_c is recorded 6.0 % higher than simulated from 0.065 to 0.080 m"));
  EXPECT_TRUE(says(told, "q_c is recorded 4.0 % lower than simulated from 0.090 to 0.095 m"));
  EXPECT_TRUE(says(
      told, "The chains agree: largest R-hat 1.002, least effective size 700, of 8000 draws in 4 chains"));
  EXPECT_EQ(apart_depths(report.posterior.bands[0], 0).size(), 2U);

  for (auto& band : report.posterior.bands[0]) band.discrepancy = {0.5, 1.0, -1.5, 0.5, 2.5};
  report.posterior.sample.converged = false;
  report.posterior.sample.convergence[1].r_hat = 1.2;
  told = calibration_sentences(report);
  EXPECT_TRUE(says(told, "Nowhere does the discrepancy of q_c keep its 90 % band off zero."));
  EXPECT_TRUE(says(told, "do not agree within the limit (largest R-hat 1.200"));
}

class CalibrationStudy : public parameters::WithOpenTurns {};

TEST_F(CalibrationStudy, PosteriorRowsMakeAStudy) {
  const CalibrationReport report = made_up();
  const std::string text =
      "profile = \"homogeneous_sand\"\npreset = \"quick\"\n[fixed]\n\"penetrometer.final_depth_m\" = 0.1\n"
      "[[windows]]\nname = \"w\"\nfrom_m = 0.05\nto_m = 0.06\n" +
      posterior_study(report);
  const auto parsed = parameters::parse_study(text, "/studies/next.toml");
  const auto* errors = std::get_if<std::vector<parameters::StudyError>>(&parsed);
  ASSERT_EQ(errors, nullptr) << text << format(*errors);
  const auto& study = std::get<parameters::Study>(parsed);
  ASSERT_EQ(study.rows.size(), 2U);
  for (std::size_t j = 0; j < 2; ++j) {
    ASSERT_NE(study.rows[j].marginal, nullptr);
    const diagnosis::Spread& spread = report.posterior.unknowns[j].posterior;
    EXPECT_NEAR(study.rows[j].marginal->mean(), spread.mean, 0.1 * spread.deviation);
    EXPECT_NEAR(study.rows[j].marginal->standard_deviation(), spread.deviation, 0.15 * spread.deviation);
  }
  EXPECT_EQ(posterior_study(report).find("shift_points"), std::string::npos);
  CalibrationReport shifted = report;
  shifted.shifts_points = true;
  EXPECT_NE(posterior_study(shifted).find("\nshift_points = true\n\n[parameters]"), std::string::npos);
  ASSERT_EQ(study.correlations.size(), 1U);
  EXPECT_NEAR(study.correlations[0].rho, -0.6, 1e-3);
}

TEST(CalibrationReport, TablesFiguresAndFilesAreWhole) {
  const CalibrationReport report = made_up();
  EXPECT_EQ(posterior_table(report).rows.size(), 3U);
  EXPECT_EQ(draws_table(report).rows.size(), 500U);
  EXPECT_EQ(draws_table(report).columns.at(3), "discrepancy q_c percent");
  EXPECT_EQ(bands_table(report).rows.size(), 10U);
  EXPECT_EQ(correlation_table(report).rows.at(0).at(2), results::Cell(-0.6));
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "made-up-calibration";
  std::filesystem::remove_all(folder);
  for (const auto& file : write_calibration(report, folder))
    EXPECT_TRUE(std::filesystem::exists(file)) << file;
  EXPECT_TRUE(std::filesystem::exists(folder / "bands.png"));
  std::ifstream stream(folder / "marginals.svg");
  const std::string svg{std::istreambuf_iterator<char>(stream), {}};
  EXPECT_NE(svg.find("Two &lt;inputs&gt;"), std::string::npos);
  std::filesystem::remove_all(folder);
}

TEST(CalibrationReport, RanksAreToldAsTheyAre) {
  RankReport report{"Check", "sand", 60, {}, 1};
  report.check.unknowns = {"even", "low"};
  report.check.ranks.resize(100, 2);
  report.check.truths = Eigen::MatrixXd::Zero(100, 2);
  for (int i = 0; i < 100; ++i) {
    report.check.cases.push_back("run " + std::to_string(i));
    report.check.ranks.row(i) << i, i / 2;
    report.check.converged.push_back(i != 5);
  }
  const results::Table table = uniformity_table(report);
  EXPECT_EQ(table.rows[0].at(4), results::Cell(std::string("yes")));
  EXPECT_EQ(table.rows[1].at(4), results::Cell(std::string("no")));
  const std::vector<std::string> told = rank_sentences(report);
  EXPECT_TRUE(
      says(told, "Ranks of 1 of 2 unknowns over 100 recordings leave the 95 % band of uniform ones (low)"));
  EXPECT_TRUE(says(told, "Of 1 of the 100 recordings the chains did not agree"));
  EXPECT_EQ(ranks_table(report).rows.size(), 200U);
  EXPECT_NE(ranks_figure(report).find("<svg"), std::string::npos);
}

}  // namespace
}  // namespace cpt::reports::calibrated
