// Page, numbers and figures of a diagnosis, and the files they become.
#include "reports/diagnosis/page.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "reports/diagnosis/figures.hpp"
#include "reports/diagnosis/numbers.hpp"
#include "reports/diagnosis/posterior.hpp"
#include "reports/diagnosis/words.hpp"
#include "reports/diagnosis/write_diagnosis_report.hpp"
#include "tests/reports/diagnosis/made_up_diagnosis.hpp"

namespace cpt::reports::diagnosed {
namespace {

namespace fs = std::filesystem;

bool has(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

constexpr const char* hostile = "<script>|*x*_y_ [a](b) `c` \"d\" & \xff\n# e";

TEST(DiagnosisWords, NumbersAreRoundedAsPeopleWriteThem) {
  EXPECT_EQ(with_deviation(14.2, 3.1, "%"), "14 ± 3 %");
  EXPECT_EQ(with_deviation(0.5213, 0.0142, "-"), "0.521 ± 0.014");
  EXPECT_EQ(with_deviation(1234.0, 56.0, "mm"), "1234 ± 56 mm");
  EXPECT_EQ(with_deviation(14.2, 0.0, "kPa"), "14.2 kPa");
  EXPECT_EQ(brief(40.0), "40");
  EXPECT_EQ(brief(0.05), "0.05");
  EXPECT_EQ(brief(1200.4), "1200");
  EXPECT_EQ(percent(9.96), "10 %");
  EXPECT_EQ(percent(-4.24), "−4.2 %");
  EXPECT_EQ(probability(0.0001), "below 0.001");
  EXPECT_EQ(probability(0.0045), "0.004");
  EXPECT_EQ(p_value(0.000999), "p < 0.001");
  EXPECT_EQ(metres(0.1), "0.1");
  EXPECT_EQ(metres(2.0), "2.0");
  EXPECT_EQ(listed({"a", "b", "c"}), "a, b and c");
  EXPECT_NEAR(percent_of(std::log(1.38)), 38.0, 1e-9);
}

TEST(DiagnosisWords, MarkdownOfHostileTextIsHarmless) {
  EXPECT_EQ(markdown("a_b*<i>"), "a\\_b\\*&lt;i&gt;");
  EXPECT_EQ(markdown("it's\n"), "it's ");
  EXPECT_EQ(markdown_symbol("ΔDᵣ"), "ΔD<sub>r</sub>");
  EXPECT_EQ(markdown_symbol("z_<b>"), "z<sub>&lt;b&gt;</sub>");
}

TEST(DiagnosisPage, HoldsAnswerFiguresAndTablesInThisOrder) {
  const std::string text = page(indistinguishable_case(), {{"diagnosis-profile.png", "q & r"}});
  std::size_t last = 0;
  for (const char* part :
       {"# Chamber test CC-3", "**Sand compacted", "## Figures", "![q &amp; r](diagnosis-profile.png)",
        "### Hypotheses", "### Mismatch intervals", "### Effects of the catalogue", "### Before and after",
        "### Predictive checks", "### Pairs", "### Next measurement", "### Other prior widths",
        "### Parameters of the study", "### Noise", "### Provenance"}) {
    const std::size_t at = text.find(part);
    ASSERT_NE(at, std::string::npos) << part;
    EXPECT_GE(at, last) << part;
    last = at;
  }
  EXPECT_TRUE(has(text, "| 38.0 | 42.0 | < 0.001 |")) << text;
  EXPECT_TRUE(has(text, "| 0 to 40 % | 14 ± 3 % | 9.06 to 18.9 % | 14 % |")) << text;
  EXPECT_TRUE(has(text, "| flexible or rigid | flexible |"));
  EXPECT_TRUE(has(text, "| study's parameters refitted | 12 % |")) << text;
  EXPECT_TRUE(has(text, "| wall time | 90 min |"));
  EXPECT_FALSE(has(text, " nan"));
}

TEST(DiagnosisPage, EveryKindOfAnswerMakesAPage) {
  for (const DiagnosisInput& input : {named_case(3), nothing_missing_case(), none_of_these_case(),
                                      gate_failed_case(), indistinguishable_case()})
    EXPECT_GT(page(input, {}).size(), 2000u);
}

TEST(DiagnosisNumbers, AreValidJsonWithTheValuesOfTheDiagnosis) {
  const auto json = nlohmann::json::parse(diagnosis_json(named_case()));
  EXPECT_EQ(json["answer"]["kind"], "named");
  EXPECT_EQ(json["answer"]["name"], "surface_compaction");
  EXPECT_DOUBLE_EQ(json["hypotheses"][0]["probability"].get<double>(), 0.93);
  EXPECT_DOUBLE_EQ(json["location"]["mismatches"][0]["scan_step_ln"].get<double>(), std::log(1.38));
  EXPECT_GT(json["location"]["mismatches"][0]["above_refitted_Pa"].get<double>(), 0.0);
  EXPECT_NEAR(json["mechanisms"][0]["parameters"][0]["mean"].get<double>(), 14.0, 1e-12);
  EXPECT_NEAR(json["mechanisms"][0]["parameters"][1]["deviation"].get<double>(), 10.0, 1e-12);
  EXPECT_DOUBLE_EQ(json["rmse"]["recalibrated_ln"].get<double>(),
                   named_case().diagnosis.null.recalibrated.rmse);
  EXPECT_DOUBLE_EQ(json["isolability"][0][3].get<double>(), 7.9);
  EXPECT_EQ(json["cells"]["recorded_ln"].size(), 40u);
  EXPECT_EQ(json["soundings"][0]["recorded"]["q_c_Pa"].size(), 600u);
  EXPECT_EQ(json["provenance"]["solver_runs"], 184);
  EXPECT_TRUE(nlohmann::json::parse(diagnosis_json(none_of_these_case()))["gate"].is_null());
}

TEST(DiagnosisFigures, ShowNamesUnitsAndShading) {
  const DiagnosisInput input = indistinguishable_case();
  const std::string profile = profile_figure(input);
  for (const char* part : {"(kPa)", "depth (m)", "push", "recording", "full solver", "mismatch"})
    EXPECT_TRUE(has(profile, part)) << part;
  EXPECT_TRUE(has(residual_figure(input), "recorded less simulated (%)"));
  EXPECT_TRUE(has(probability_figure(input), "none of these"));
  EXPECT_TRUE(has(isolability_figure(input).value(), "1.2"));
  EXPECT_TRUE(has(posterior_figure(input).value(), "90 % interval"));
  DiagnosisInput bare = nothing_missing_case();
  bare.diagnosis.best.reset();
  EXPECT_FALSE(posterior_figure(bare).has_value());
  EXPECT_FALSE(has(profile_figure(bare), "emulator"));
}

TEST(DiagnosisFigures, LegendsNameEveryEffectWhole) {
  DiagnosisInput input = indistinguishable_case();
  for (const char* title :
       {"layer interfaces that lie elsewhere", "a cushion whose stress does not all reach the soil"}) {
    input.mechanisms[1].title = title;
    for (const std::string& svg : {profile_figure(input), residual_figure(input)})
      EXPECT_TRUE(has(svg, std::string("or with: ") + title)) << title;
  }
}

TEST(DiagnosisFigures, HostileNamesStayText) {
  DiagnosisInput input = named_case(2);
  input.title = input.soundings[0].name = input.mechanisms[0].title = hostile;
  input.mechanisms[0].parameters[0].quantity.symbol = hostile;
  solver::Quantity quantity = *input.parameters[0].quantity;
  quantity.symbol = hostile;
  input.parameters[0].quantity = &quantity;
  input.diagnosis.next = {{hostile, 3.0}};
  const std::string text = page(input, {});
  EXPECT_FALSE(has(text, "<script>"));
  EXPECT_FALSE(has(text, "\n# e"));
  EXPECT_FALSE(has(text, "[a](b)"));
  for (const std::string& svg : {profile_figure(input), residual_figure(input), probability_figure(input),
                                 isolability_figure(input).value(), posterior_figure(input).value()}) {
    EXPECT_FALSE(has(svg, "<script>"));
    EXPECT_FALSE(has(svg, "nan"));
    EXPECT_FALSE(has(svg, "\xff"));
  }
  EXPECT_TRUE(nlohmann::json::accept(diagnosis_json(input)));
}

TEST(DiagnosisPosterior, MarginalsIntegrateToOne) {
  const DiagnosisInput input = named_case();
  for (const auto& [mechanism, k] : {std::pair{0, 1}, std::pair{1, 2}, std::pair{2, 0}}) {
    const Marginal m = marginal(input.diagnosis.mechanisms[static_cast<std::size_t>(mechanism)].evidence, k);
    ASSERT_GE(m.phi.size(), 15u);
    double sum = 0.0;
    for (std::size_t i = 1; i < m.phi.size(); ++i)
      sum += 0.5 * (m.density[i] + m.density[i - 1]) * (m.phi[i] - m.phi[i - 1]);
    EXPECT_NEAR(sum, 1.0, 0.03);
  }
}

TEST(DiagnosisReport, WritesEveryFileItNames) {
  std::string scratch = (fs::temp_directory_path() / "cpt_diagnosis_XXXXXX").string();
  ASSERT_NE(mkdtemp(scratch.data()), nullptr);
  DiagnosisInput input = named_case();
  input.name = "../a b";
  const auto files = write_diagnosis_report(input, fs::path(scratch) / "report");
  ASSERT_EQ(files.size(), 12u);
  EXPECT_EQ(files[0].filename(), "_._a_b-diagnosis.md");
  EXPECT_EQ(files[1].filename(), "diagnosis.json");
  for (const fs::path& file : files) EXPECT_GT(fs::file_size(file), 500u) << file;
  std::ifstream in(files[0]);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_TRUE(has(text, "(diagnosis-posterior.png)"));
  fs::remove_all(scratch);
}

}  // namespace
}  // namespace cpt::reports::diagnosed
