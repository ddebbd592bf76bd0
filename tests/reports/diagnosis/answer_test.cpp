// The sentences of every kind of answer.
#include "reports/diagnosis/answer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/reports/diagnosis/made_up_diagnosis.hpp"

namespace cpt::reports::diagnosed {
namespace {

std::string told(const DiagnosisInput& input) {
  check(input);
  const Answer answer = answer_of(input);
  std::string text = answer.headline;
  for (const std::string& paragraph : answer.paragraphs) text += "\n" + paragraph;
  return text;
}

void expect(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << part << "\nis not in\n" << text;
}

void expect_not(const std::string& text, const std::string& part) {
  EXPECT_EQ(text.find(part), std::string::npos) << part << "\nis in\n" << text;
}

TEST(DiagnosisAnswer, NamesOneEffectWithPlaceSizeFitAndProof) {
  const std::string text = told(named_case());
  EXPECT_EQ(answer_of(named_case()).kind, AnswerKind::named);
  expect(text,
         "Between 0.03 and 0.113 m the recording is 38 % (410 kPa) above the simulation, p < 0.001, after "
         "allowing for the study's parameters.");
  expect(text,
         "Sand compacted near the surface can explain the difference (probability 0.93): ΔDᵣ = 14 ± 3 % "
         "(increase of the relative density at the soil's top) and ℓ = 60 ± 10 mm");
  expect(text, "A looser or denser lens in the sand cannot (probability 0.01).");
  expect(text,
         "Curves drawn with sand compacted near the surface in the simulation look like the recording "
         "(predictive "
         "check, p = 0.84, limit 0.01)");
  expect(text,
         "the error on depths held out of the fit falls from 21 % to 6.0 % (gain in log score 0.83 per "
         "cell, 90 % interval 0.51 to 1.18).");
  expect(text, "Run in the full solver");
  expect(text, "leave the same explanation in front");
  expect_not(text, "says little");
}

TEST(DiagnosisAnswer, NamesSoundingsAndSigns) {
  DiagnosisInput input = named_case(2);
  auto& mismatches = input.diagnosis.location.mismatches;
  mismatches[0].sounding = -1;
  mismatches.push_back({1, 0.2, 0.25, std::log(0.9), -10.0, -95e3, 15.0, 0.021});
  const std::string text = told(input);
  expect(text, "In all soundings, between 0.03 and 0.113 m");
  expect(text,
         "In push 2, between 0.2 and 0.25 m the recording is 10 % (95 kPa) below the simulation, p = "
         "0.021.");
  mismatches.resize(5, mismatches[1]);
  expect(told(input), "2 more intervals are in the table below.");
}

TEST(DiagnosisAnswer, SaysWhereAParameterIsWeak) {
  DiagnosisInput input = named_case();
  input.diagnosis.mechanisms[0].deviation(1) = 0.27;
  input.diagnosis.mechanisms[0].mode(0) = 1.0;
  expect(told(input), "The recording says little about ℓ. The best value of ΔDᵣ lies at the end");
}

TEST(DiagnosisAnswer, NothingIsMissingTellsWhatMoved) {
  const std::string text = told(nothing_missing_case());
  EXPECT_EQ(answer_of(nothing_missing_case()).kind, AnswerKind::nothing_missing);
  expect(text, "Nothing is missing");
  expect(text, "At no depth does the recording depart");
  expect(text, "(probability 0.87)");
  expect(text, "p = 0.68");
  expect(text, "Within their bounds, these study parameters moved most: Dᵣ from 60 to 64 %.");
  expect(text, "no proof");
}

TEST(DiagnosisAnswer, AWeakNothingIsNotSoldAsCertain) {
  DiagnosisInput input = nothing_missing_case();
  input.diagnosis.hypotheses[3].probability = 0.07;
  input.diagnosis.hypotheses[0].probability = 0.8;
  const std::string text = told(input);
  expect(text, "No firm sign that anything is missing.");
  expect(text, "0.07, would have to be below 0.05");
  expect(text, "sand compacted near the surface would come first (probability 0.80)");
}

TEST(DiagnosisAnswer, NoneOfTheseOffersAPairAsAHint) {
  const std::string text = told(none_of_these_case());
  EXPECT_EQ(answer_of(none_of_these_case()).kind, AnswerKind::none_of_these);
  expect(text, "Something is missing that is not in the catalogue.");
  expect(text, "Between 0.03 and 0.113 m");
  expect(text,
         "None of the 3 catalogued effects accounts for it: that it is something else has probability "
         "0.83, the best of the catalogue, sand compacted near the surface, has 0.10.");
  expect(text, "sand compacted near the surface together with a shifted depth datum (log evidence 4.2 above");
}

TEST(DiagnosisAnswer, AFailedCheckOverrulesTheProbability) {
  const std::string text = told(gate_failed_case());
  EXPECT_EQ(answer_of(gate_failed_case()).kind, AnswerKind::gate_failed);
  expect(text, "No effect of the catalogue passes the check");
  expect(text, "the most probable of the catalogue (probability 0.93)");
  expect(text, "do not look like the recording (predictive check, p = 0.002, limit 0.01)");
  expect(text, "Therefore the answer is “none of these”.");
  DiagnosisInput null = nothing_missing_case();
  null.diagnosis.answer = 4;
  null.diagnosis.gate->p = 0.004;
  expect(told(null), "No effect of the catalogue stands out, and “nothing is missing” is left");
}

TEST(DiagnosisAnswer, IndistinguishableNamesTheSetAndTheNextMeasurement) {
  const std::string text = told(indistinguishable_case());
  EXPECT_EQ(answer_of(indistinguishable_case()).kind, AnswerKind::indistinguishable);
  expect(text,
         "Sand compacted near the surface or a looser or denser lens in the sand: this recording cannot "
         "tell which.");
  expect(text, "A looser or denser lens in the sand (probability 0.41): ΔDᵣ,lens = ");
  expect(text, "a second push at 100 kPa (at least 4.3 standard deviations between any two, 2.5 wanted)");
  expect(text,
         "The answer depends on the width of the priors: with parameter ranges x 2 “a looser or denser lens "
         "in the sand” would come first.");
  DiagnosisInput input = indistinguishable_case();
  input.diagnosis.next = {{"the sleeve friction", 1.9}};
  expect(told(input), "none would tell them apart; the sleeve friction comes nearest");
}

TEST(DiagnosisAnswer, WorksWithoutACatalogue) {
  DiagnosisInput input = nothing_missing_case();
  input.mechanisms.clear();
  diagnosis::Diagnosis& d = input.diagnosis;
  d.hypotheses.erase(d.hypotheses.begin(), d.hypotheses.begin() + 3);
  d.mechanisms.clear();
  d.pairs.clear();
  d.isolability.resize(0, 1);
  d.best.reset();
  d.held_out.reset();
  d.variations.clear();
  d.winner = d.answer = 0;
  d.set = {0};
  expect(told(input), "Nothing is missing");
}

TEST(DiagnosisInput, RefusesPartsThatDoNotBelongTogether) {
  DiagnosisInput other_order = named_case();
  std::swap(other_order.mechanisms[0], other_order.mechanisms[1]);
  EXPECT_THROW(check(other_order), std::invalid_argument);
  DiagnosisInput short_curve = named_case();
  short_curve.recorded.conservativeResize(7);
  EXPECT_THROW(check(short_curve), std::invalid_argument);
  DiagnosisInput parameter_lost = named_case();
  parameter_lost.parameters.pop_back();
  EXPECT_THROW(check(parameter_lost), std::invalid_argument);
}

}  // namespace
}  // namespace cpt::reports::diagnosed
