// Drawing, sealing and recording of concealed cases.
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>

#include "tests/diagnosis/request_fixture.hpp"
#include "validation/concealed/plan.hpp"
#include "validation/concealed/truth.hpp"

namespace cpt::validation::concealed {
namespace {

using namespace diagnosis;
using Eigen::VectorXd;

const std::string plan_text =
    "title = \"c\"\nstudy = \"sand.toml\"\n"
    "[[soundings]]\nname = \"low\"\nfrom_m = 0.04\nto_m = 0.28\n"
    "[[soundings]]\nname = \"high\"\nfrom_m = 0.04\nto_m = 0.28\nfixed = { \"initial.sigma_v0_kPa\" = 60 }\n"
    "[noise]\nmeasurement_percent = 2\ncorrelation_mm = 10\n";
const std::string cases = "[cases]\nnothing = 5\nsingle = 12\npair = 4\noutside = 6\ntwo_soundings = 9\n";

Plan plan_of(const std::string& toml) {
  PlanOrErrors parsed = parse_plan(toml, "/studies/bench.toml", quick_sand());
  if (const auto* errors = std::get_if<std::vector<parameters::StudyError>>(&parsed)) {
    ADD_FAILURE() << format(*errors);
    return {};
  }
  return std::get<Plan>(std::move(parsed));
}

std::string errors_in(const std::string& toml) {
  const PlanOrErrors parsed = parse_plan(toml, "/studies/bench.toml", quick_sand());
  const auto* errors = std::get_if<std::vector<parameters::StudyError>>(&parsed);
  return errors != nullptr ? format(*errors) : "";
}

TEST(ConcealedPlan, SaysWhatIsWrong) {
  EXPECT_NE(errors_in(plan_text).find("how many cases of which kind"), std::string::npos);
  EXPECT_NE(errors_in(plan_text + "[cases]\nnothing = -1\n").find("whole number"), std::string::npos);
  EXPECT_NE(errors_in(plan_text + "[cases]\nnothing = 3\ntwo_soundings = 4\n").find("more than the 3 cases"),
            std::string::npos);
  EXPECT_NE(errors_in(plan_text + "[cases]\nnothign = 3\n").find("nothign"), std::string::npos);
  const std::string with_recording =
      "study = \"sand.toml\"\n[[soundings]]\nname = \"a\"\nrecording = \"a.csv\"\nfrom_m = 0.04\nto_m = "
      "0.28\n" +
      cases;
  EXPECT_NE(errors_in(with_recording).find("recording"), std::string::npos);
}

TEST(ConcealedTruth, DrawsWhatThePlanAsksFor) {
  const Plan plan = plan_of(plan_text + cases);
  const parameters::Study study = quick_sand();
  const std::vector<Truth> truths = draw_truths(plan, study, 7);
  ASSERT_EQ(truths.size(), 27U);
  std::map<std::string, int> kinds, mechanisms, outsides;
  int two = 0;
  for (const Truth& truth : truths) {
    ++kinds[truth.kind()];
    two += truth.soundings.size() == 2 ? 1 : 0;
    for (const Part& part : truth.parts) {
      ++mechanisms[std::string(part.mechanism.name)];
      EXPECT_TRUE((part.place.array() > 0.0).all() && (part.place.array() < 1.0).all());
    }
    if (truth.parts.size() == 2) {
      EXPECT_NE(truth.parts[0].mechanism.name, truth.parts[1].mechanism.name);
    }
    if (truth.outside) ++outsides[truth.outside->kind];
  }
  EXPECT_EQ(kinds["nothing"], 5);
  EXPECT_EQ(kinds["single"], 12);
  EXPECT_EQ(kinds["pair"], 4);
  EXPECT_EQ(kinds["outside"], 6);
  EXPECT_EQ(two, 9);
  EXPECT_EQ(outsides.size(), outside_kinds().size());
  EXPECT_EQ(mechanisms.size(), plan.request.mechanisms.size());

  const std::vector<Truth> same = draw_truths(plan, study, 7), other = draw_truths(plan, study, 8);
  for (std::size_t i = 0; i < truths.size(); ++i) EXPECT_EQ(to_json(truths[i]), to_json(same[i]));
  EXPECT_NE(to_json(truths[0]), to_json(other[0]));
}

TEST(ConcealedTruth, RunsDifferFromTheAnalysisAndKeepWhatIsKnown) {
  const Plan plan = plan_of(plan_text + cases);
  const parameters::Study study = quick_sand();
  const std::vector<Truth> truths = draw_truths(plan, study, 7);
  const parameters::Study low = truth_study(plan, study, truths, 0),
                          high = truth_study(plan, study, truths, 1);
  EXPECT_EQ(low.points.size(), truths.size());
  EXPECT_EQ(high.points.size(), 9U);
  EXPECT_DOUBLE_EQ(high.baseline.initial.sigma_v0, 60e3);
  EXPECT_EQ(low.database, "/studies/bench-sealed/sounding-1.sqlite");
  for (const parameters::DesignPoint& point : high.points) {
    EXPECT_TRUE(std::ranges::none_of(
        point.changes, [](const auto& change) { return change.quantity->name == "initial.sigma_v0_kPa"; }));
    // The soil is the same in both soundings, material points, mesh and time step are not.
    const auto beside = std::ranges::find(low.points, point.name, &parameters::DesignPoint::name);
    ASSERT_NE(beside, low.points.end());
    for (const parameters::Change& change : point.changes)
      for (const parameters::Change& other : beside->changes)
        if (change.quantity == other.quantity) {
          const bool numerical = change.quantity->name.starts_with("numerics.");
          EXPECT_EQ(change.value == other.value, !numerical) << change.quantity->name;
        }
  }
}

TEST(ConcealedTruth, SealsAndSurvivesJson) {
  const Plan plan = plan_of(plan_text + cases);
  const std::vector<Truth> truths = draw_truths(plan, quick_sand(), 3);
  for (const Truth& truth : truths) EXPECT_EQ(to_json(truth_from_json(to_json(truth), plan)), to_json(truth));
  Truth changed = truths[0];
  changed.soil(0) += 1e-9;
  EXPECT_EQ(seal_of("salt", truths[0]), seal_of("salt", truths[0]));
  EXPECT_NE(seal_of("salt", truths[0]), seal_of("other", truths[0]));
  EXPECT_NE(seal_of("salt", truths[0]), seal_of("salt", changed));
  EXPECT_THROW((void)truth_from_json({{"case", 1}}, plan), std::invalid_argument);
}

TEST(ConcealedTruth, RequestAsksWhatThePlanSays) {
  const Plan plan = plan_of(plan_text + cases);
  const parameters::Study study = quick_sand();
  for (const Truth& truth : draw_truths(plan, study, 5)) {
    const std::string text = request_text(plan, study, truth);
    const auto parsed = parse_request(text, plan.cases_folder / request_file(truth.id), study);
    const auto* errors = std::get_if<std::vector<parameters::StudyError>>(&parsed);
    ASSERT_EQ(errors, nullptr) << format(*errors);
    const Request& request = std::get<Request>(parsed);
    EXPECT_EQ(request.soundings.size(), truth.soundings.size());
    const auto name = [](const solver::Mechanism& mechanism) { return mechanism.name; };
    EXPECT_TRUE(std::ranges::equal(request.mechanisms, plan.request.mechanisms, {}, name, name));
    EXPECT_TRUE(request.simulated);
    EXPECT_DOUBLE_EQ(request.measurement, 0.02);
    EXPECT_EQ(study_of_request(text, plan.cases_folder / "x.toml"), "/studies/sand.toml");
    // Nothing of the truth is in it.
    for (const Part& part : truth.parts)
      EXPECT_EQ(text.find(to_json(truth)["parts"][0]["place"].dump()), std::string::npos)
          << part.mechanism.name;
  }
}

solver::DepthProfile level_profile() {
  solver::DepthProfile profile;
  for (int i = 0; i < 4000; ++i) {
    profile.depth.push_back(0.00025 + 0.0005 * i);
    profile.q_c.push_back(2e6);
    profile.f_s.push_back(0.0);
  }
  return profile;
}

std::vector<double> noise_in(const std::string& text) {
  std::vector<double> noise;
  for (std::size_t at = text.find('\n') + 1; at < text.size(); at = text.find('\n', at) + 1)
    noise.push_back(std::log(std::stod(text.substr(text.find(',', at) + 1)) / 2.0));
  return noise;
}

TEST(ConcealedRecording, HasTheNoiseOfThePlan) {
  const Plan plan = plan_of(plan_text + cases);
  Truth truth{1, {}, {}, VectorXd::Zero(3), {Numerics{0.0, 1.0, 1.0, 11}}};
  const std::vector<double> noise = noise_in(recording_text(plan, truth, 0, level_profile()));
  ASSERT_EQ(noise.size(), 2000U);  // a reading each millimetre
  double square = 0.0, product = 0.0;
  for (std::size_t i = 0; i + 10 < noise.size(); ++i) {
    square += noise[i] * noise[i];
    product += noise[i] * noise[i + 10];
  }
  EXPECT_NEAR(std::sqrt(square / 1990.0), 0.02, 0.003);
  EXPECT_NEAR(product / square, std::exp(-1.0), 0.15);
  truth.soundings[0].noise_seed = 12;
  EXPECT_NE(noise_in(recording_text(plan, truth, 0, level_profile())), noise);
}

TEST(OutsideEffect, DoesWhatItsFormulaSays) {
  const std::vector<double> depth{0.05, 0.10, 0.15, 0.20}, q_c{1e6, 2e6, 3e6, 4e6};
  const auto made = [&](OutsideEffect effect) { return with_outside(effect, depth, q_c); };
  EXPECT_NEAR(made({"stone", 0.5, 0.10, 0.01})[1], 3e6, 1.0);
  EXPECT_NEAR(made({"stone", 0.5, 0.10, 0.01})[3], 4e6, 1.0);
  EXPECT_NEAR(made({"laminae", 0.1, 0.05, 0.2})[1], 2.2e6, 1.0);
  EXPECT_NEAR(made({"zero offset", -0.1, 0.0, 0.1})[0], 0.75e6, 1.0);
  EXPECT_NEAR(made({"zero drift", 0.1, 0.0, 0.15})[3], 4.25e6, 1.0);
  EXPECT_NEAR(made({"zero drift", 0.1, 0.0, 0.15})[0], 1e6, 1.0);
  EXPECT_NEAR(made({"pauses", 0.3, 0.10, 0.06})[0], 1e6, 1.0);
  EXPECT_NEAR(made({"pauses", 0.3, 0.10, 0.06})[1], 1.4e6, 1.0);
  EXPECT_NEAR(made({"gain drift", -0.2, 0.0, 0.15})[3], 3.2e6, 1.0);
  EXPECT_NEAR(made({"zero jump", -0.2, 0.12, 0.0})[1], 2e6, 1.0);
  EXPECT_NEAR(made({"zero jump", -0.2, 0.12, 0.0})[2], 2.5e6, 1.0);
  EXPECT_EQ(made({"stuck", 1.0, 0.09, 0.07}), (std::vector<double>{1e6, 1e6, 1e6, 4e6}));
  for (const double q : made({"zero offset", -5.0, 0.0, 0.1})) EXPECT_GT(q, 0.0);
  EXPECT_THROW((void)made({"ghost", 0.0, 0.0, 0.0}), std::invalid_argument);
  Random random(1, 1);
  std::vector<double> fine, rising;
  for (int i = 0; i < 200; ++i) fine.push_back(0.04 + 0.001 * i), rising.push_back(1e6 + 1e4 * i);
  for (const std::string_view kind : outside_kinds())
    EXPECT_NE(with_outside(draw_outside(kind, 0.04, 0.21, random), fine, rising), rising) << kind;
}

TEST(OutsideEffect, IsJudgedAsTheCataloguesOnceThatHasIt) {
  for (const std::string_view kind : outside_kinds())
    EXPECT_EQ(catalogued({std::string(kind), 0.1, 0.1, 0.1}), nullptr) << kind;
  Truth truth{1, {}, OutsideEffect{"zero drift", 0.1, 0.0, 0.1}, {}, {}};
  EXPECT_EQ(truth.kind(), "single");
  EXPECT_EQ(catalogued(*truth.outside), solver::find_mechanism("zero_drift"));
  truth.outside->kind = "gain drift";
  EXPECT_EQ(catalogued(*truth.outside), solver::find_mechanism("gain_drift"));
  truth.outside->kind = "stone";
  EXPECT_EQ(truth.kind(), "outside");
}

}  // namespace
}  // namespace cpt::validation::concealed
