#include "recordings/interpretation.hpp"

#include <algorithm>
#include <cmath>

namespace cpt::recordings {
namespace {

constexpr double thinnest = 0.2;        // [m] interval that is told
constexpr double thinnest_share = 0.1;  // [-] of the sounding, where that is less

Origin origin(const std::optional<double>& given) { return given ? Origin::given : Origin::assumed; }

bool possible_quotient(double a) { return a > 0.0 && a <= 1.0; }

/// The area quotient that counts; nothing where none is known or it cannot be one.
std::optional<double> area_quotient(const Recording& recording, const KnownGround& known) {
  if (known.area_quotient) return known.area_quotient;
  if (possible_quotient(recording.area_quotient)) return recording.area_quotient;
  return std::nullopt;
}

void correct(const Recording& recording, const KnownGround& known, Interpretation& result) {
  const auto a = area_quotient(recording, known);
  const bool u_2 = has(recording, &Reading::u_2);
  result.corrected = a && u_2;
  if (!u_2)
    result.why_not_corrected = "the recording has no u_2";
  else if (!a)
    result.why_not_corrected = std::isnan(recording.area_quotient)
                                   ? "the file gives no area quotient of the cone"
                                   : "the file's area quotient is not between 0 and 1";
  if (result.corrected)
    result.assumptions.push_back(
        {"area quotient a", *a, "", known.area_quotient ? Origin::given : Origin::from_file});
  for (const Reading& r : recording.readings) {
    result.q_t.push_back(result.corrected ? corrected_resistance(r.q_c, r.u_2, *a) : r.q_c);
    result.R_f.push_back(result.q_t.back() > 0.0 ? 100.0 * r.f_s / result.q_t.back() : not_given);
  }
}

void classify(const Recording& recording, const KnownGround& known, Interpretation& result) {
  if (!has(recording, &Reading::f_s)) {
    result.why_no_behaviour = "the recording has no f_s";
    result.behaviour.resize(recording.readings.size());
    result.ground.resize(recording.readings.size(), {not_given, not_given});
    return;
  }
  GroundModel model;
  model.unit_weight = known.unit_weight.value_or(model.unit_weight);
  model.water_table = known.water_table.value_or(model.water_table);
  model.surcharge = known.surcharge.value_or(model.surcharge);
  result.assumptions.push_back(
      {"unit weight of the soil", model.unit_weight / 1e3, "kN/m3", origin(known.unit_weight)});
  result.assumptions.push_back(
      {"depth of the water table", model.water_table, "m", origin(known.water_table)});
  result.assumptions.push_back({"surcharge", model.surcharge / 1e3, "kPa", origin(known.surcharge)});
  for (std::size_t i = 0; i < recording.readings.size(); ++i) {
    const Reading& r = recording.readings[i];
    result.ground.push_back(ground_at(r.depth, model));
    result.behaviour.push_back(r.predrilled ? Behaviour{}
                                            : behaviour_2009(result.q_t[i], r.f_s, result.ground.back()));
  }
  const BehaviourProfile profile{column(recording, &Reading::depth), result.q_t, result.R_f,
                                 result.behaviour};
  result.least_interval = std::min(thinnest, thinnest_share * (profile.depth.back() - profile.depth.front()));
  result.intervals = behaviour_intervals(profile, result.least_interval);
  if (result.intervals.empty())
    result.why_no_behaviour = "no reading has q_t above the vertical stress and f_s above zero";
}

}  // namespace

std::string_view name_of(Origin origin) {
  switch (origin) {
    case Origin::given:
      return "given";
    case Origin::from_file:
      return "of the file";
    case Origin::assumed:
      break;
  }
  return "assumed";
}

Interpretation interpret(const Recording& recording, const KnownGround& known) {
  Interpretation result;
  correct(recording, known, result);
  classify(recording, known, result);
  result.spikes = spikes(recording);
  result.speed = push_speed(recording);
  result.odd_speeds = odd_speeds(recording, result.speed);
  return result;
}

}  // namespace cpt::recordings
