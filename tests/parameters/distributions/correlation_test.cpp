#include <fmt/format.h>

#include "parameters/designs/design.hpp"
#include "tests/parameters/distributions/with_openturns.hpp"
#include "tests/parameters/studies.hpp"

namespace cpt::parameters {
namespace {

using Correlations = WithOpenTurns;

// Three distributed rows and one without a distribution, lines 7 to 11; the design's section is next.
std::string study_with(const std::string& correlation, const std::string& kind = "propagation") {
  const auto normal = [](const char* name, double mean, double deviation) {
    return fmt::format(
        "\"{}\" = {{ distribution = {{ kind = \"normal\", mean = {}, standard_deviation = {} }} }}\n", name,
        mean, deviation);
  };
  return sand_study("[parameters]\n" + normal("sand.G_ref", 743, 30) + normal("sand.D_r_percent", 36, 3) +
                    normal("sand.phi_cs_deg", 30, 0.5) + "\"sand.H\" = { upper = 75 }\n[design]\nkind = \"" +
                    kind + "\"\n" + (kind == "propagation" ? "runs = 400\n" : "") + "[correlation]\n" +
                    correlation);
}

TEST_F(Correlations, DrawInputsTogether) {
  const Study study = study_of(study_with("\"sand.G_ref\" = { \"sand.D_r_percent\" = 0.8 }\n"));
  ASSERT_EQ(study.correlations.size(), 1u);
  const Eigen::MatrixXd places = design_places(study);
  const auto together = [&](Eigen::Index a, Eigen::Index b) {
    return 12.0 *
           ((places.col(a).array() - 0.5) * (places.col(b).array() - 0.5)).mean();  // of uniform places
  };
  EXPECT_NEAR(together(0, 1), 0.8, 0.03);
  EXPECT_NEAR(together(0, 2), 0.0, 0.05);
  ASSERT_EQ(study.points.size(), 400u);
  EXPECT_DOUBLE_EQ(study.points[7].changes[1].value, study.rows[1].marginal->quantile(places(7, 1)));
}

void expect_error(const std::string& text, const std::string& key, const std::string& message,
                  const std::string& hint) {
  const auto errors = errors_of(text);
  ASSERT_EQ(errors.size(), 1u) << text << format(errors);
  EXPECT_EQ(errors[0].key, key) << format(errors);
  EXPECT_NE(errors[0].message.find(message), std::string::npos) << format(errors);
  EXPECT_NE(errors[0].hint.find(hint), std::string::npos) << format(errors);
}

TEST_F(Correlations, SayWhatCannotBe) {
  expect_error(study_with("\"sand.G_ref\" = 0.5\n"), "correlation.sand.G_ref", "must be a table", "such as");
  expect_error(study_with("\"sand.G_reff\" = { \"sand.D_r_percent\" = 0.5 }\n"), "correlation.sand.G_reff",
               "is no row of the design", "sand.G_ref");
  expect_error(study_with("\"sand.G_ref\" = { \"sand.H\" = 0.5 }\n"), "correlation.sand.G_ref.sand.H",
               "has no distribution", "give its row");
  expect_error(study_with("\"sand.G_ref\" = { \"sand.G_ref\" = 0.5 }\n"), "correlation.sand.G_ref.sand.G_ref",
               "is the row itself", "");
  expect_error(study_with("\"sand.G_ref\" = { \"sand.D_r_percent\" = 1 }\n"),
               "correlation.sand.G_ref.sand.D_r_percent", "no rank correlation", "");
  expect_error(study_with("\"sand.G_ref\" = { \"sand.D_r_percent\" = 0.5 }\n"
                          "\"sand.D_r_percent\" = { \"sand.G_ref\" = 0.4 }\n"),
               "correlation.sand.D_r_percent.sand.G_ref", "given twice", "");
  expect_error(study_with("\"sand.G_ref\" = { \"sand.D_r_percent\" = 0.5 }\n", "latin_hypercube"),
               "correlation", "has no effect", "propagation");
}

TEST_F(Correlations, OfferTheNearestThatCanBe) {
  const std::string text = study_with(
      "\"sand.G_ref\" = { \"sand.D_r_percent\" = 0.9, \"sand.phi_cs_deg\" = 0.9 }\n"
      "\"sand.D_r_percent\" = { \"sand.phi_cs_deg\" = -0.9 }\n");
  const auto errors = errors_of(text);
  ASSERT_EQ(errors.size(), 1u) << format(errors);
  EXPECT_NE(errors[0].message.find("not positive definite"), std::string::npos);
  // What the hint offers is taken.
  double rho[3];
  const char* const names[] = {"sand.G_ref with sand.D_r_percent: ", "sand.G_ref with sand.phi_cs_deg: ",
                               "sand.D_r_percent with sand.phi_cs_deg: "};
  for (int i = 0; i < 3; ++i) {
    const auto at = errors[0].hint.find(names[i]);
    ASSERT_NE(at, std::string::npos) << errors[0].hint;
    rho[i] = 0.99 *
             std::stod(errors[0].hint.substr(at + std::string(names[i]).size()));  // three decimals are shown
  }
  EXPECT_TRUE(errors_of(study_with(fmt::format(
                            "\"sand.G_ref\" = {{ \"sand.D_r_percent\" = {}, \"sand.phi_cs_deg\" = {} }}\n"
                            "\"sand.D_r_percent\" = {{ \"sand.phi_cs_deg\" = {} }}\n",
                            rho[0], rho[1], rho[2])))
                  .empty());
}

}  // namespace
}  // namespace cpt::parameters
