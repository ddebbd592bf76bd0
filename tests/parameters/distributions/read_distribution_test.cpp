#include "parameters/distributions/read_distribution.hpp"

#include <cmath>

#include "tests/parameters/distributions/with_openturns.hpp"

namespace cpt::parameters {
namespace {

class ReadDistribution : public WithOpenTurns {
 protected:
  // What `d = TEXT` says of a quantity.
  std::optional<Distribution> read(const std::string& text, std::string_view quantity = "sand.G_ref") {
    errors_ = ErrorList("study.toml");
    const auto document = parse_document("d = " + text + "\n" + data_);
    const Value& root = std::get<Value>(document);
    return read_distribution(root.find("d")->value, *solver::find_quantity(quantity), "d", root, errors_);
  }

  void expect_refused(const std::string& text, const std::string& key, const std::string& message,
                      std::string_view quantity = "sand.G_ref") {
    EXPECT_FALSE(read(text, quantity)) << text;
    const auto errors = errors_.sorted();
    ASSERT_EQ(errors.size(), 1u) << text << format(errors);
    EXPECT_EQ(errors[0].key, key) << text;
    EXPECT_EQ(errors[0].line, 1);
    EXPECT_NE(errors[0].message.find(message), std::string::npos) << format(errors);
  }

  ErrorList errors_{"study.toml"};
  std::string data_;
};

TEST_F(ReadDistribution, ByMomentsQuantilesAndParameters) {
  const auto lognormal = read(R"({ kind = "lognormal", mean = 743, cv = 0.1 })");
  ASSERT_TRUE(lognormal) << format(errors_.sorted());
  EXPECT_NEAR(marginal(*lognormal)->mean(), 743.0, 1e-6);
  EXPECT_NEAR(marginal(*lognormal)->standard_deviation(), 74.3, 1e-6);
  const auto normal =
      read(R"({ kind = "normal", quantiles = [[0.05, 600], [0.95, 900]], min = 500, max = 1000 })");
  ASSERT_TRUE(normal) << format(errors_.sorted());
  EXPECT_EQ(normal->least, 500.0);
  EXPECT_EQ(normal->most, 1000.0);
  EXPECT_EQ(read(R"({ kind = "uniform", min = 600, max = 900 })")->parameters, (std::vector{600.0, 900.0}));
  EXPECT_EQ(read(R"({ kind = "triangular", min = 600, mode = 700, max = 900 })")->parameters,
            (std::vector{600.0, 700.0, 900.0}));
  EXPECT_EQ(read(R"({ kind = "beta", min = 600, max = 900, alpha = 2, beta = 3 })")->parameters,
            (std::vector{2.0, 3.0, 600.0, 900.0}));
}

TEST_F(ReadDistribution, EmpiricalValuesComeFromTheSectionData) {
  const std::string asked = R"({ kind = "empirical", file = "lab.csv", column = "G" })";
  expect_refused(asked, "d.column", "[data.\"lab.csv\"] has no array G of 5 numbers or more");
  data_ = "[data.\"lab.csv\"]\nG = [700, 720, 710, 720, 690]\n";
  const auto values = read(asked);
  ASSERT_TRUE(values) << format(errors_.sorted());
  EXPECT_EQ(values->values, (std::vector{690.0, 700.0, 710.0, 720.0}));
  EXPECT_EQ(values->weights, (std::vector{0.2, 0.2, 0.2, 0.4}));
  EXPECT_EQ(marginal(*values)->quantile(0.5), 710.0);
  data_ = "[data.\"lab.csv\"]\nG = [700, 720, 710, 720, -1]\n";
  expect_refused(asked, "d.column", "-1 is outside the valid range");
  data_ = "[data.\"lab.csv\"]\nG = [700, 720, 710, 720]\n";
  expect_refused(asked, "d.column", "of 5 numbers or more");
}

TEST_F(ReadDistribution, DiscreteValuesAreSortedAndWeighed) {
  const auto values = read(R"({ kind = "discrete", values = [900, 700, 900], weights = [1, 2, 1] })");
  ASSERT_TRUE(values);
  EXPECT_EQ(values->values, (std::vector{700.0, 900.0}));
  EXPECT_EQ(values->weights, (std::vector{0.5, 0.5}));
  const auto wall =
      read(R"({ kind = "discrete", values = ["rigid", "flexible"], weights = [3, 1] })", "chamber.wall");
  ASSERT_TRUE(wall) << format(errors_.sorted());
  EXPECT_EQ(wall->weights.size(), 2u);
}

TEST_F(ReadDistribution, EndsAtTheValidRangeOfItsQuantity) {
  const solver::Quantity& quantity = *solver::find_quantity("sand.G_ref");
  const auto normal = read(R"({ kind = "normal", mean = 743, cv = 0.1 })");
  ASSERT_TRUE(normal);
  EXPECT_EQ(normal->least, quantity.min);
  EXPECT_EQ(normal->most, quantity.max);
  EXPECT_GE(marginal(*normal)->quantile(0.0), quantity.min);
}

TEST_F(ReadDistribution, SaysWhatCannotBe) {
  expect_refused(R"("normal")", "d", "must be a table");
  expect_refused(R"({ mean = 743 })", "d.kind", "is missing");
  expect_refused(R"({ kind = "gauss", mean = 743 })", "d.kind", "is not one of");
  expect_refused(R"({ kind = "normal", mean = 743 })", "d.standard_deviation", "is missing");
  expect_refused(R"({ kind = "normal", mean = 743, cv = 0.1, standard_deviation = 70 })",
                 "d.standard_deviation", "beside cv");
  expect_refused(R"({ kind = "normal", mean = 743, cv = -0.1 })", "d.cv", "must be above 0");
  expect_refused(R"({ kind = "normal", mean = 743, cv = 0.1, mode = 3 })", "d.mode", "unknown key");
  expect_refused(R"({ kind = "normal", mean = 743, cv = 0.1, min = 800, max = 700 })", "d.max",
                 "is not above min");
  expect_refused(R"({ kind = "lognormal", mean = -743, standard_deviation = 10 })", "d.mean", "above 0");
  expect_refused(R"({ kind = "normal", mean = 743, quantiles = [[0.1, 1], [0.2, 2]] })", "d.mean",
                 "beside quantiles");
  expect_refused(R"({ kind = "normal", quantiles = [[0.9, 600], [0.1, 900]] })", "d.quantiles", "must rise");
  expect_refused(R"({ kind = "normal", quantiles = [[0.1, 600]] })", "d.quantiles", "two pairs");
  expect_refused(R"({ kind = "normal", quantiles = [[0.1, 600], [1.0, 700]] })", "d.quantiles",
                 "no probability");
  expect_refused(R"({ kind = "uniform", min = 900, max = 600 })", "d.max", "is not above min");
  expect_refused(R"({ kind = "uniform", min = 600, max = 900, mean = 700 })", "d.mean", "beside min and max");
  expect_refused(R"({ kind = "triangular", min = 600, mode = 950, max = 900 })", "d.mode",
                 "outside of 600 to 900");
  expect_refused(R"({ kind = "beta", min = 600, max = 900, mean = 700, cv = 0.9 })", "d.cv",
                 "cannot be between");
  expect_refused(R"({ kind = "discrete", values = [] })", "d.values", "not empty");
  expect_refused(R"({ kind = "discrete", values = [700, 800], weights = [1] })", "d.weights",
                 "1 numbers for 2");
  expect_refused(R"({ kind = "discrete", values = [700, 800], weights = [1, 0] })", "d.weights",
                 "must be above 0");
  expect_refused(R"({ kind = "discrete", values = [700, -1] })", "d.values", "outside the valid range");
  expect_refused(R"({ kind = "normal", mean = 743, cv = 2 })", "d", "outside the valid range");
  expect_refused(R"({ kind = "normal", mean = 1, cv = 2 })", "d.kind", "nothing for a choice",
                 "chamber.wall");
  expect_refused(R"({ kind = "discrete", values = ["soft"] })", "d.values", "must be one of", "chamber.wall");
}

}  // namespace
}  // namespace cpt::parameters
