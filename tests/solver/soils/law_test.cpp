// What every law must say of itself.
#include "solver/soils/law.hpp"

#include <gtest/gtest.h>

#include <set>

#include "solver/constitutive/element_test.hpp"
#include "solver/quantities.hpp"

namespace cpt::solver {
namespace {

TEST(Laws, AreFoundByTheirNames) {
  std::set<std::string_view> names;
  for (const Law* law : all_laws()) {
    EXPECT_EQ(find_law(law->name()), law);
    EXPECT_EQ(&law_of(law->defaults()), law) << law->name();
    EXPECT_TRUE(names.insert(law->name()).second) << law->name();
    for (const std::string_view text : {law->title(), law->models(), law->source(), law->departs()})
      EXPECT_FALSE(text.empty()) << law->name();
    EXPECT_LE(law->state(law->defaults(), {}).size(), most_state_variables) << law->name();
  }
  EXPECT_EQ(find_law("hooke"), nullptr);
}

TEST(Laws, ParametersAreReadWhereTheyAreWritten) {
  for (const Law* law : all_laws()) {
    LawParameters parameters = law->defaults();
    std::set<std::string_view> names;
    for (const LawQuantity& quantity : law->quantities()) {
      EXPECT_TRUE(names.insert(quantity.name).second) << quantity.name;
      EXPECT_FALSE(quantity.meaning.empty() || quantity.source.empty() || quantity.symbol.empty())
          << quantity.name;
      const double before = quantity.get(parameters);
      EXPECT_GE(before, quantity.min * quantity.scale) << law->name() << "." << quantity.name;
      EXPECT_LE(before, quantity.max * quantity.scale) << law->name() << "." << quantity.name;
      quantity.set(parameters, quantity.max * quantity.scale);
      EXPECT_EQ(quantity.get(parameters), quantity.max * quantity.scale) << quantity.name;
      quantity.set(parameters, before);
    }
  }
}

// The start is in equilibrium with the law: a step without strain keeps stress and state.
TEST(Laws, AStepWithoutStrainChangesNothing) {
  for (const Law* law : all_laws()) {
    const auto model = law->model(law->defaults(), {});
    const PointStress stress = {-30e3, -50e3, -30e3, 0.0};
    const double e = law->void_ratio(law->defaults());
    const PointHistory history = model->start({0.1, stress.rr, stress.zz, stress.tt, stress.rz, e});
    struct Shared {
      const SoilModel* model;
      [[nodiscard]] double update(const Batch& batch) const { return model->update(batch); }
    };
    Specimen specimen(Shared{model.get()}, stress, e, history[0], history[1]);
    specimen.strain(0.0, 0.0, 0.0, 0.0);
    EXPECT_NEAR(specimen.stress().zz, stress.zz, 1e-6) << law->name();
    EXPECT_NEAR(specimen.stress().rr, stress.rr, 1e-6) << law->name();
    EXPECT_NEAR(specimen.h_0(), history[0], 1e-6 * (1.0 + history[0])) << law->name();
    EXPECT_EQ(specimen.e(), e) << law->name();
    EXPECT_GT(specimen.modulus(), 0.0) << law->name();
  }
}

// Whatever the points beside it in a batch, bit for bit.
TEST(Laws, APointDependsOnItselfAlone) {
  for (const Law* law : all_laws()) {
    const auto model = law->model(law->defaults(), {});
    const auto run = [&](double of_others) {
      alignas(64) double f[11][batch_width];
      for (std::size_t k = 0; k < batch_width; ++k) {
        const double strain = k == 3 ? 1e-3 : of_others;
        const double values[11] = {-30e3,  -50e3,         -30e3,  1e3,          0.8, 60e3,
                                   strain, -2.0 * strain, strain, 0.3 * strain, 0.0};
        for (int i = 0; i < 11; ++i) f[i][k] = values[i];
      }
      (void)model->update(
          {batch_width, f[0], f[1], f[2], f[3], f[4], f[5], f[6], f[7], f[8], f[9], f[10], 1e-3});
      return std::array{f[0][3], f[1][3], f[2][3], f[3][3], f[4][3], f[5][3]};
    };
    EXPECT_EQ(run(0.0), run(5e-3)) << law->name();
  }
}

// At rest under 50 kPa with phi_cs = 30 degrees the lateral stress is 25 kPa.
TEST(SandStart, TakesTheImagePressureOfTheRuleThatIsAskedFor) {
  NorSandParameters sand;
  const auto p_i = [&](double sigma_h) {
    const auto model = law_of(LawParameters{sand}).model(sand, {});
    return model->start({0.1, -sigma_h, -50e3, -sigma_h, 0.0, 0.76832})[0];
  };
  const double low = p_i(15e3), at_rest = p_i(25e3), high = p_i(35e3);
  EXPECT_GT(low, at_rest);
  EXPECT_GT(at_rest, high);
  sand.start = SandStart::at_rest;
  EXPECT_DOUBLE_EQ(p_i(15e3), low);  // the initial stress lies outside
  EXPECT_NEAR(p_i(25e3), at_rest, 1e-9 * at_rest);
  EXPECT_NEAR(p_i(35e3), at_rest, 1e-9 * at_rest);
  sand.OCR = 2.0;
  EXPECT_NEAR(p_i(35e3), 2.0 * at_rest, 1e-9 * at_rest);
}

}  // namespace
}  // namespace cpt::solver
