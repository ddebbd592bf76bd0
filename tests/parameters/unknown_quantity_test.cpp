// What is said of a quantity that a soil does not have, for every parameter of every law.
#include "parameters/unknown_quantity.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solver/soils/law.hpp"
#include "tests/parameters/studies.hpp"

namespace cpt::parameters {
namespace {

solver::Setup setup_of(const std::vector<std::pair<std::string, std::string>>& soils) {
  solver::Setup setup;
  setup.soils.clear();
  setup.layers.clear();
  for (const auto& [name, law] : soils) {
    const double top = static_cast<double>(setup.layers.size()) * 0.1;
    setup.layers.push_back({top, top + 0.1, setup.soils.size()});
    setup.soils.push_back({name, solver::find_law(law)->defaults()});
  }
  return setup;
}

bool has(const solver::Law& law, std::string_view parameter) {
  return std::ranges::find(law.quantities(), parameter, &solver::LawQuantity::name) != law.quantities().end();
}

TEST(UnknownQuantity, OfAnotherLawNamesAllLawsThatHaveItAndTheirSoils) {
  for (const solver::Law* own : solver::all_laws()) {
    std::vector<std::pair<std::string, std::string>> soils = {{"mine", std::string(own->name())}};
    for (const solver::Law* law : solver::all_laws())
      for (const std::string_view place : {"upper", "lower"})
        if (law != own && law->name() != "tresca")
          soils.emplace_back(fmt::format("{}_{}", place, law->name()), law->name());
    const solver::Setup setup = setup_of(soils);
    for (const solver::Law* law : solver::all_laws())
      for (const solver::LawQuantity& parameter : law->quantities()) {
        if (has(*own, parameter.name)) continue;
        std::string laws;
        for (const solver::Law* other : solver::all_laws())
          if (has(*other, parameter.name))
            laws +=
                fmt::format("{}{} ({})", laws.empty() ? "" : ", ", other->name(),
                            other->name() == "tresca" ? "no soil here"
                                                      : fmt::format("upper_{0}, lower_{0}", other->name()));
        const std::string text = meant_quantity(fmt::format("mine.{}", parameter.name), setup);
        EXPECT_NE(text.find(fmt::format("{} is a parameter of {}; mine is of {}", parameter.name, laws,
                                        own->name())),
                  std::string::npos)
            << text;
        EXPECT_EQ(text.find("did you mean upper_"), std::string::npos) << text;
        EXPECT_EQ(text.find("did you mean lower_"), std::string::npos) << text;
      }
  }
}

TEST(UnknownQuantity, OfASoilThatIsNotThereNamesThoseThatHaveIt) {
  const solver::Setup setup =
      setup_of({{"loose", "norsand"}, {"soft", "modified_cam_clay"}, {"dense", "norsand"}});
  for (const auto& [name, meant] : std::vector<std::pair<std::string, std::string>>{
           {"sotf.OCR", "did you mean soft.OCR?"},
           {"sotf.M", "did you mean soft.M?"},
           {"sand.M", "did you mean soft.M?"},
           {"sand.H", "did you mean loose.H or dense.H?"},
           {"H", "did you mean loose.H or dense.H?"},
           {"desne.H", "did you mean dense.H?"},
           {"sotf.H", "did you mean loose.H or dense.H?"},
           {"clay.s_u_kPa", "s_u_kPa is a parameter of tresca (no soil here)"},
           {"soft.D_r_percent",
            "D_r_percent is a parameter of norsand (loose, dense); soft is of modified_cam_clay"},
           {"soft.relative_density",
            "D_r_percent is a parameter of norsand (loose, dense); soft is of modified_cam_clay"},
           {"dense.phi_deg",
            "did you mean dense.phi_cs_deg? phi_deg is a parameter of mohr_coulomb (no soil here); dense is "
            "of "
            "norsand"},
           {"loose.kappa", "kappa is a parameter of modified_cam_clay (soft); loose is of norsand"},
           {"soft.poisson_ratio", "did you mean soft.nu?"},
           {"soft.OCRR", "did you mean soft.OCR?"},
           {"chamber.radius", "did you mean chamber.radius_m?"},
           {"loose.temperature_of_the_room", ""}})
    EXPECT_EQ(meant_quantity(name, setup), meant) << name;
}

// Of sand and clay, which every study has, only those in some layer can be given values.
TEST(UnknownQuantity, SoilsInNoLayerAreNotOffered) {
  solver::Setup setup;
  setup.layers = {{0.0, 1.0, 0}};
  EXPECT_EQ(meant_quantity("sand.s_u_kPa", setup),
            "s_u_kPa is a parameter of tresca (no soil here); sand is of norsand");
  EXPECT_EQ(meant_quantity("sand.s_u_kPa", setup, false),
            "s_u_kPa is a parameter of tresca (clay); sand is of norsand");
}

}  // namespace
}  // namespace cpt::parameters
