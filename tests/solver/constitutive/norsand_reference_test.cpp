// NorSand against the paths of an independent implementation: tests/reference/norsand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "solver/constitutive/element_test.hpp"
#include "solver/constitutive/norsand.hpp"

namespace cpt::solver {
namespace {

using Row = std::map<std::string, double>;

std::vector<Row> read(const std::string& name) {
  std::ifstream in(std::string(CPT_REFERENCE_FOLDER) + "/" + name + ".csv");
  std::string line, cell;
  std::vector<std::string> columns;
  std::getline(in, line);
  for (std::stringstream s(line); std::getline(s, cell, ',');) columns.push_back(cell);
  std::vector<Row> rows;
  while (std::getline(in, line)) {
    Row row;
    std::stringstream s(line);
    for (const std::string& column : columns) {
      std::getline(s, cell, ',');
      row[column] = std::stod(cell);
    }
    rows.push_back(row);
  }
  return rows;
}

double void_ratio(const NorSandParameters& sand) { return sand.e_max - sand.D_r * (sand.e_max - sand.e_min); }

enum class Kind { drained, undrained, isotropic, oedometer };

struct Path {
  const char* name;
  Kind kind;
  double D_r;  // [-]
  double p_0;  // [Pa] isotropic, or vertical with K_0 = 0.5
  void (*change)(NorSandParameters&);
};

void PrintTo(const Path& path, std::ostream* out) { *out << path.name; }

class NorSandReference : public testing::TestWithParam<Path> {};

// Largest strain increment of one update, as near the tip during a push.
constexpr double increment = 5e-5;

TEST_P(NorSandReference, FollowsThePath) {
  const Path& path = GetParam();
  NorSandParameters sand;
  sand.D_r = path.D_r;
  path.change(sand);
  const NorSand law(sand);
  const double sigma_r = path.kind == Kind::oedometer ? 0.5 * path.p_0 : path.p_0;
  const PointStress start = {-sigma_r, -path.p_0, -sigma_r, 0.0};
  const double e_0 = void_ratio(sand);
  Specimen specimen(law, start, e_0, law.initial_image_pressure(start.rr, start.zz, start.tt, start.rz, e_0));

  const std::vector<Row> rows = read(path.name);
  ASSERT_GT(rows.size(), 20U);
  double eps_a = 0.0, slope = -0.1;
  for (const Row& row : rows) {
    const double target = row.at("eps_a");
    const int steps = static_cast<int>(std::ceil((target - eps_a) / increment));
    for (int i = 0; i < steps; ++i) {
      const double axial = (target - eps_a) / (steps - i);
      double radial = 0.0;
      if (path.kind == Kind::undrained) radial = -0.5 * axial;
      if (path.kind == Kind::isotropic) radial = axial;
      if (path.kind == Kind::drained) {
        const auto found = drained_radial_strain(specimen, axial, path.p_0, slope * axial);
        ASSERT_TRUE(found);
        radial = *found;
        slope = radial / axial;
      }
      specimen.strain(-radial, -axial, -radial, 0.0);
      eps_a += axial;
    }
    SCOPED_TRACE("eps_a " + std::to_string(target));
    const NorSandState state = law.evaluate(specimen.stress(), specimen.e(), specimen.h_0());
    const double q = 1e3 * row.at("q"), p = 1e3 * row.at("p");
    // Where the path has just left the isotropic axis half a per cent of q is less than a step's share of it.
    ASSERT_NEAR(state.q, q, std::max(0.005 * q, 1e-4 * p));
    ASSERT_NEAR(state.p, p, 0.002 * p);
    ASSERT_NEAR(specimen.e(), row.at("e"), 1e-3);
    ASSERT_NEAR(state.psi_i, row.at("psi_i"), 1e-3);
    ASSERT_LT(std::abs(state.yield), 1e-6);
  }
}

constexpr auto base = [](NorSandParameters&) {};
constexpr auto stiff = [](NorSandParameters& sand) { sand.H = 75.0; };

INSTANTIATE_TEST_SUITE_P(All, NorSandReference,
                         testing::Values(Path{"CD_DR01_p040_base", Kind::drained, 0.01, 40e3, base},
                                         Path{"CD_DR01_p320_base", Kind::drained, 0.01, 320e3, base},
                                         Path{"CD_DR36_p040_base", Kind::drained, 0.36, 40e3, base},
                                         Path{"CD_DR36_p320_H_up", Kind::drained, 0.36, 320e3, stiff},
                                         Path{"CD_DR51_p040_base", Kind::drained, 0.51, 40e3, base},
                                         Path{"CD_DR51_p320_base", Kind::drained, 0.51, 320e3, base},
                                         Path{"CD_DR51_p320_Gref_lo", Kind::drained, 0.51, 320e3,
                                              [](NorSandParameters& sand) { sand.G_ref = 700.0; }},
                                         Path{"CD_DR51_p320_N_up", Kind::drained, 0.51, 320e3,
                                              [](NorSandParameters& sand) { sand.N = 0.3; }},
                                         Path{"CD_DR51_p320_chi_up", Kind::drained, 0.51, 320e3,
                                              [](NorSandParameters& sand) { sand.chi_tc = 3.5; }},
                                         Path{"CD_DR51_p320_lam_lo", Kind::drained, 0.51, 320e3,
                                              [](NorSandParameters& sand) { sand.lambda = 0.009; }},
                                         Path{"CD_DR51_p320_nu_up", Kind::drained, 0.51, 320e3,
                                              [](NorSandParameters& sand) { sand.nu = 0.3; }},
                                         Path{"CD_DR51_p320_phics_up", Kind::drained, 0.51, 320e3,
                                              [](NorSandParameters& sand) {
                                                sand.phi_cs = 31.0 * std::numbers::pi / 180.0;
                                              }},
                                         Path{"CD_DR80_p040_base", Kind::drained, 0.80, 40e3, base},
                                         Path{"CD_DR80_p320_base", Kind::drained, 0.80, 320e3, base},
                                         Path{"CD_DR80_p320_H_up", Kind::drained, 0.80, 320e3, stiff},
                                         Path{"CDlong_DR80_p320_base", Kind::drained, 0.80, 320e3, base},
                                         Path{"CU_DR36_p320_H25_S0", Kind::undrained, 0.36, 320e3, base},
                                         Path{"iso_DR36_H25", Kind::isotropic, 0.36, 20e3, base},
                                         Path{"oedo_DR36_H25", Kind::oedometer, 0.36, 20e3, base},
                                         Path{"oedo_DR36_H75", Kind::oedometer, 0.36, 20e3, stiff}),
                         [](const testing::TestParamInfo<Path>& path) { return path.param.name; });

// Constant volume off the triaxial axes: the axes x, y, z of the files are theta, r, z here.
void follow_constant_volume(const std::string& name, bool simple_shear) {
  const NorSandParameters sand;
  const NorSand law(sand);
  Specimen specimen(law, {-26e3, -50e3, -24e3, 0.0}, void_ratio(sand), 30.99096569e3);
  double t = 0.0;
  for (const Row& row : read(name)) {
    const int steps = static_cast<int>(std::ceil((row.at("t") - t) / increment));
    const double dt = (row.at("t") - t) / steps;
    for (int i = 0; i < steps; ++i)
      simple_shear ? specimen.strain(0.0, 0.0, 0.0, -0.5 * dt) : specimen.strain(dt, -dt, 0.0, 0.0);
    t = row.at("t");
    SCOPED_TRACE("t " + std::to_string(t));
    const PointStress& s = specimen.stress();
    const double largest = 1e3 * std::max(row.at("szz"), row.at("syz"));
    ASSERT_NEAR(-s.tt, 1e3 * row.at("sxx"), 0.005 * largest);
    ASSERT_NEAR(-s.rr, 1e3 * row.at("syy"), 0.005 * largest);
    ASSERT_NEAR(-s.zz, 1e3 * row.at("szz"), 0.005 * largest);
    ASSERT_NEAR(-s.rz, 1e3 * row.at("syz"), 0.005 * largest);
    ASSERT_NEAR(specimen.h_0(), 1e3 * row.at("p_i"), 0.005e3 * row.at("p_i"));
    ASSERT_NEAR(specimen.e(), row.at("e"), 1e-12);
  }
}

TEST(NorSandReference3d, SimpleShear) { follow_constant_volume("path3d_simple_shear_CV_assoc", true); }
TEST(NorSandReference3d, PlaneStrain) { follow_constant_volume("path3d_plane_strain_CV_assoc", false); }

// The same path with radial deviatoric flow, from the same source: tau 24.51 kPa at 10 %, associated 28.85.
TEST(NorSandReference3d, FlowRuleDecidesTheShearStrength) {
  const auto shear_stress = [](DeviatoricFlow flow) {
    NorSandParameters sand;
    sand.flow = flow;
    Specimen specimen(NorSand(sand), {-26e3, -50e3, -24e3, 0.0}, void_ratio(sand), 30.99096569e3);
    for (int i = 0; i < 1000; ++i) specimen.strain(0.0, 0.0, 0.0, -0.5e-4);
    return -specimen.stress().rz;
  };
  EXPECT_NEAR(shear_stress(DeviatoricFlow::associated), 28.85e3, 0.005 * 28.85e3);
  EXPECT_NEAR(shear_stress(DeviatoricFlow::radial), 24.51e3, 0.005 * 24.51e3);
}

}  // namespace
}  // namespace cpt::solver
