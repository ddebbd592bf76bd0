#include "diagnosis/predictive_check.hpp"

#include <gtest/gtest.h>

#include "diagnosis/parameters_prior.hpp"
#include "tests/diagnosis/toy.hpp"

namespace cpt::diagnosis {
namespace {

struct Setting {
  std::vector<Cell> cells = toy::cells();
  NullModel null = toy::null(cells);
  Whitener M{null.covariance};
  CurveEmulator lens{toy::lens(cells, 40)};
  MatrixXd draws = draw_null(null, 500, 1);

  [[nodiscard]] PredictiveCheck check(const VectorXd& residual) const {
    const MechanismEvidence posterior = mechanism_evidence(MechanismLikelihood(lens, M), residual);
    return check_mechanism(cells, null.covariance, lens, posterior, residual, draws, 2);
  }
};

TEST(PredictiveCheck, PassesTheTruthAsOftenAsItShould) {
  const Setting s;
  const MatrixXd cases = draw_null(s.null, 60, 5);
  int failed = 0;
  double mean = 0.0;
  for (Index k = 0; k < 60; ++k) {
    const PredictiveCheck check = s.check(cases.col(k) + toy::lens_curve(s.cells, 0.6, 0.37));
    failed += check.p < 0.05 ? 1 : 0;
    mean += check.chi_square_p / 60.0;
  }
  EXPECT_LE(failed, 8);
  EXPECT_NEAR(mean, 0.5, 0.13);
}

TEST(PredictiveCheck, StopsWhatTheWinnerCannotMake) {
  const Setting s;
  const VectorXd noise = draw_null(s.null, 1, 5).col(0);
  const VectorXd wave = toy::curve(s.cells, [](double z) { return 0.15 * std::sin(50.0 * z); });
  EXPECT_LT(s.check(noise + toy::lens_curve(s.cells, 0.6, 0.37) + wave).p, 0.01);
  EXPECT_GT(check_null(s.cells, s.M, noise, s.draws).p, 0.01);
  EXPECT_LT(check_null(s.cells, s.M, noise + wave, s.draws).p, 0.01);
}

}  // namespace
}  // namespace cpt::diagnosis
