// Two propagations with made-up results, from their ledgers to numbers of the dear one.
#include "results/statistics/two_fidelities.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "parameters/all_realizations.hpp"
#include "parameters/read_study.hpp"
#include "results/files/error.hpp"
#include "tests/results/campaign_fixture.hpp"
#include "tests/solver/default_soils.hpp"

namespace cpt::results {
namespace {

class TwoStudies : public ScratchFolder {
 protected:
  using Result = std::function<double(double nu, double H)>;  // [kPa], up to the shape of the curve

  Snapshot run(const std::string& name, int runs, const Result& result, const std::string& more = "") {
    const std::string text = fmt::format(
        "profile = \"homogeneous_sand\"\npreset = \"{}\"\n[parameters]\n"
        "sand.nu = {{ baseline = 0.2, lower = 0.1, upper = 0.3 }}\nsand.H = {{ baseline = 25, upper = 75 }}\n"
        "[[windows]]\nname = \"deep\"\nfrom_m = 0.30\nto_m = 0.32\n[design]\nkind = \"propagation\"\nruns = "
        "{}\n{}",
        name == "cheap" ? "quick" : "standard", runs, more);
    auto parsed = parameters::parse_study(text, folder / (name + ".toml"));
    if (const auto* errors = std::get_if<std::vector<parameters::StudyError>>(&parsed))
      throw std::runtime_error(parameters::format(*errors));
    const auto study = std::get<parameters::Study>(std::move(parsed));
    const auto realizations = parameters::all_realizations(study);
    Ledger ledger = Ledger::open_for_run(study, realizations, {text, false});
    for (const parameters::Realization& realization : realizations) {
      const solver::Setup setup = make_setup(study, realization);
      ledger.record(realization.id,
                    completed(1e3 * result(solver::sand_of(setup).nu, solver::sand_of(setup).H)));
    }
    return read_snapshot(study.database);
  }
  static const FidelityRow& row(const TwoFidelities& both, std::string_view quantity) {
    return *std::ranges::find(both.rows, quantity, &FidelityRow::quantity);
  }
};

// Both are smooth; nu is uniform from 0.1 to 0.3, H from 25 to 75.
double dear_result(double nu, double H) { return 400.0 + 900.0 * nu + 9.0 * H + 12.0 * nu * H; }
double cheap_result(double nu, double H) {
  return 300.0 + 1100.0 * nu + 8.0 * H + 10.0 * nu * H + 6.0 * std::sin(3e3 * nu + 70.0 * H);
}

TEST_F(TwoStudies, TheEmulatorOfTheCheapOneNarrowsWhatTheDearOneTells) {
  const Snapshot dear = run("dear", 30, dear_result), cheap = run("cheap", 150, cheap_result);
  const TwoFidelities two = two_fidelities(dear, cheap), three = two_fidelities(dear, cheap, 4000);
  ASSERT_EQ(three.warnings, std::vector<std::string>{});
  const FidelityWindow& window = three.windows.at(0);
  EXPECT_EQ(window.paired, 30);
  EXPECT_GT(window.emulator_q2, 0.99);
  EXPECT_GT(window.emulator_correlation, 0.995);
  EXPECT_TRUE(std::isnan(two.windows.at(0).emulator_q2));
  const auto width = [](const parameters::Estimate& of) { return of.upper - of.lower; };
  for (const char* quantity : {"mean", "standard_deviation"}) {
    EXPECT_LT(width(row(two, quantity).combined), width(row(two, quantity).alone)) << quantity;
    EXPECT_LT(width(row(three, quantity).combined), width(row(two, quantity).combined)) << quantity;
  }
  // As good as the truth: two thousand dear runs.
  const Snapshot many = run("many", 2000, dear_result);
  const double truth = two_fidelities(many, cheap).rows.front().alone.value;
  EXPECT_LE(row(three, "mean").combined.lower, truth);
  EXPECT_GE(row(three, "mean").combined.upper, truth);
}

TEST_F(TwoStudies, AnEmulatorThatMissesTooMuchIsLeftOut) {
  const auto noise = [](double nu, double H) { return 500.0 + 100.0 * std::sin(1e5 * nu + 3e4 * H); };
  const Snapshot dear = run("dear", 20, noise), cheap = run("cheap", 80, noise);
  const TwoFidelities two = two_fidelities(dear, cheap), three = two_fidelities(dear, cheap, 1000);
  ASSERT_EQ(three.warnings.size(), 1U);
  EXPECT_NE(three.warnings[0].find("below 0.9; it is left out"), std::string::npos) << three.warnings[0];
  EXPECT_EQ(row(three, "mean").combined.value, row(two, "mean").combined.value);
}

TEST_F(TwoStudies, OneModelIsNoPair) {
  const Snapshot dear = run("dear", 20, dear_result);
  try {
    (void)two_fidelities(dear, dear);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("their baselines have the same settings"), std::string::npos)
        << error.what();
  }
}

TEST_F(TwoStudies, OtherInputsAreNoPair) {
  const Snapshot dear = run("dear", 20, dear_result), cheap = run("cheap", 40, cheap_result, "seed = 2\n");
  try {
    (void)two_fidelities(dear, cheap);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("dear and cheap are no pair: in run 1 of the design"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace cpt::results
