// The sentences of every kind of answer.
#include "reports/diagnosis/answer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "drawing/text.hpp"
#include "reports/diagnosis/errors.hpp"
#include "reports/diagnosis/figures.hpp"
#include "reports/diagnosis/page.hpp"
#include "reports/diagnosis/sentences.hpp"
#include "reports/diagnosis/words.hpp"
#include "tests/reports/diagnosis/made_up_diagnosis.hpp"

namespace cpt::reports::diagnosed {
namespace {

std::string told(const DiagnosisInput& input) {
  check(input);
  const Answer answer = answer_of(input);
  std::string text = answer.headline;
  for (const std::string& reservation : answer.reservations) text += "\n" + reservation;
  for (const std::string& paragraph : answer.paragraphs) text += "\n" + paragraph;
  return text;
}

void expect(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << part << "\nis not in\n" << text;
}

// Mean of 100 (recorded / refitted - 1) over the cells of a depth interval, as the figure draws them.
double drawn_mean(const DiagnosisInput& input, double from, double to) {
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < input.diagnosis.compared.cells.size(); ++i) {
    const diagnosis::Cell& cell = input.diagnosis.compared.cells[i];
    if (cell.depth < from || cell.depth > to) continue;
    const auto row = static_cast<Index>(i);
    sum += 100.0 *
           (std::exp(input.recorded(row)) / std::exp(input.diagnosis.null.recalibrated.curve(row)) - 1.0);
    ++count;
  }
  return sum / count;
}

void expect_not(const std::string& text, const std::string& part) {
  EXPECT_EQ(text.find(part), std::string::npos) << part << "\nis in\n" << text;
}

TEST(DiagnosisAnswer, NamesOneEffectWithPlaceSizeFitAndProof) {
  const std::string text = told(named_case());
  EXPECT_EQ(answer_of(named_case()).kind, AnswerKind::named);
  expect(text,
         "Between 0.03 and 0.113 m the recording is on average 9.5 % (165 kPa) above the simulation with the "
         "study's parameters refitted (p < 0.001).");
  expect(text,
         "Sand compacted near the surface can explain the difference (probability 0.93): ΔDᵣ = 14 ± 3 % "
         "(increase of the relative density at the soil's top, fading downward) and ℓ = 60 ± 10 mm");
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

TEST(DiagnosisAnswer, WhereAndHowMuchAreThoseOfTheFigureWhateverTheScanSays) {
  for (const double shift : {-0.4, -0.1, 0.06, 0.5})
    for (const double step : {-0.3, 0.3}) {
      DiagnosisInput input = named_case();
      input.diagnosis.null.recalibrated.curve = input.baseline.array() + shift;
      input.diagnosis.location.mismatches[0].size = step;
      const double mean = drawn_mean(input, 0.03, 0.1125);
      const std::string text = told(input);
      const std::string side = mean < 0.0 ? "below" : "above";
      expect(text, "Between 0.03 and 0.113 m the recording is on average " + percent(std::abs(mean)) + " (");
      expect(text, " kPa) " + side + " the simulation with the study's parameters refitted");
      const bool against = (step < 0.0) != (mean < 0.0);
      (against ? expect : expect_not)(text, "is of the other sign (" + percent(percent_of(step)) + ").");
      const std::string figure = residual_figure(input);
      expect(figure, "mismatch, recording " + side);
      expect_not(figure, "mismatch, recording " + std::string(mean < 0.0 ? "above" : "below"));
      expect(page(input, {}), "| push | 0.030 | 0.113 | " + drawing::decimals(mean, 1) + " | ");
    }
}

TEST(DiagnosisAnswer, AMeanDoesNotHideTheOtherSide) {
  DiagnosisInput input = named_case();
  for (Index i = 4; i < 15; ++i)
    input.recorded(i) = input.diagnosis.null.recalibrated.curve(i) + (i < 8 ? std::log(1.1) : std::log(0.6));
  const std::string text = told(input);
  expect(text, "below the simulation with the study's parameters refitted");
  expect(text, "It lies from 40 % below to 10 % above over that interval.");
  for (Index i = 4; i < 15; ++i) input.recorded(i) = input.diagnosis.null.recalibrated.curve(i);
  expect(told(input), "the recording is on average level with the simulation with");
}

TEST(DiagnosisAnswer, WhatIsNotRuledOutStandsWithTheHeadline) {
  EXPECT_TRUE(answer_of(named_case()).reservations.empty());
  DiagnosisInput input = none_of_these_case();
  input.diagnosis.verdict.set = {Explanation::unknown(), 0, Explanation::nothing()};
  ASSERT_EQ(answer_of(input).reservations.size(), 1U);
  EXPECT_EQ(
      answer_of(input).reservations[0],
      "Not ruled out: sand compacted near the surface (0.10) and that nothing is missing (below 0.001).");
  input.diagnosis.verdict.set = {Explanation::unknown(), 0, Explanation::nothing(), 1, 2};
  EXPECT_EQ(answer_of(input).reservations[0],
            "This recording rules nothing out: all 5 explanations stay possible.");
  input.diagnosis.verdict.set = {};
  EXPECT_EQ(answer_of(input).reservations[0], "No explanation is left: the set of answers is empty.");
  const std::string text = page(input, {});
  EXPECT_LT(text.find("the set of answers is empty"), text.find("Between 0.03")) << text;
}

TEST(DiagnosisAnswer, ABestEffectThatMakesTheFitWorseIsSaidFirst) {
  DiagnosisInput input = named_case();
  EXPECT_TRUE(stands_alone(input));
  diagnosis::Recalibration& with = input.diagnosis.mechanisms[0].recalibrated;
  with.curve = input.diagnosis.null.recalibrated.curve.array() - 0.3;
  with.rmse = rmse(input.recorded, with.curve);
  std::string text = told(input);
  expect(text,
         "With the best effect, sand compacted near the surface, the fit is worse than with the study's "
         "parameters alone: it leaves an error of " +
             percent(percent_of(with.rmse)) + " in place of " +
             percent(percent_of(input.diagnosis.null.recalibrated.rmse)));
  EXPECT_FALSE(stands_alone(input));
  expect(profile_figure(input), "best effect (makes the fit worse)");
  expect(probability_figure(input), "no full bar");
  expect_not(probability_figure(named_case()), "no full bar");

  DiagnosisInput run = named_case();
  for (double& q : run.soundings[0].solver->q_c) q *= 0.5;
  text = told(run);
  expect(text,
         "Run in the full solver with the best effect, sand compacted near the surface, the fit is worse");
  DiagnosisInput held = named_case();
  held.diagnosis.best->held_out = diagnosis::HeldOutGain{0.1, 0.2, -9.0, -0.5, -0.8, -0.2};
  expect(told(held),
         "On depths held out of the fit, sand compacted near the surface predicts worse than nothing.");
}

TEST(DiagnosisAnswer, BoundsArePressedAgainstAloud) {
  DiagnosisInput input = named_case();
  input.diagnosis.mechanisms[0].recalibrated.place(0) = 1.0;
  input.diagnosis.null.recalibrated.place(1) = 0.0;
  expect(told(input), "The fit presses against the study's bounds: Dᵣ = 70 %.");
  DiagnosisInput nothing = nothing_missing_case();
  nothing.diagnosis.null.recalibrated.place(1) = 0.0;
  expect(told(nothing), "The fit presses against the study's bounds: σ'ₕ₀ = 30 kPa.");
}

TEST(DiagnosisAnswer, NamesSoundingsAndSigns) {
  DiagnosisInput input = named_case(2);
  auto& mismatches = input.diagnosis.location.mismatches;
  mismatches[0].sounding = -1;
  mismatches.push_back({1, 0.2, 0.25, std::log(0.9), -10.0, -95e3, 15.0, 0.021});
  for (Index i = 40; i < 80; ++i)
    if (const double z = input.diagnosis.compared.cells[static_cast<std::size_t>(i)].depth;
        z > 0.2 && z < 0.25)
      input.recorded(i) = input.diagnosis.null.recalibrated.curve(i) + std::log(0.9);
  const std::string text = told(input);
  expect(text, "In all soundings, between 0.03 and 0.113 m");
  expect(text,
         "In push 2, between 0.2 and 0.25 m the recording is on average 10 % (232 kPa) below the refitted "
         "simulation (p = 0.021).");
  mismatches.resize(5, mismatches[1]);
  expect(told(input), "2 more intervals are in the table below.");
}

TEST(DiagnosisAnswer, SaysWhereAParameterIsWeak) {
  DiagnosisInput input = named_case();
  input.diagnosis.mechanisms[0].evidence.deviation(1) = 0.27;
  input.diagnosis.mechanisms[0].evidence.mode(0) = 1.0;
  const std::string text = told(input);
  expect(text, "The recording says little about ℓ.");
  EXPECT_EQ(answer_of(input).reservations,
            std::vector<std::string>{"The best value of ΔDᵣ lies at the end of the range looked at."});
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
  input.diagnosis.verdict.hypotheses[3].probability = 0.07;
  input.diagnosis.verdict.hypotheses[0].probability = 0.8;
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
  null.diagnosis.verdict.answer = Explanation::unknown();
  null.diagnosis.verdict.gate->p = 0.004;
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
  std::erase_if(d.verdict.hypotheses, [](const auto& h) { return h.explanation.is_mechanism(); });
  d.mechanisms.clear();
  d.pairs.clear();
  d.isolability = {};
  d.best.reset();
  d.variations.clear();
  d.verdict.winner = d.verdict.answer = Explanation::nothing();
  d.verdict.set = {Explanation::nothing()};
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
