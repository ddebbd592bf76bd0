// Marks on rows and remarks on values: stops, predrilling, voids, magnitudes, zeros.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "recordings/settle.hpp"
#include "recordings/units.hpp"

namespace cpt::recordings {
namespace {

constexpr double pause = 5.0;                     // [s] beyond an ordinary step: the push stood still
constexpr double least_q_c = 10.0 * kPa;          // medians outside of these are
constexpr double largest_q_c = 150.0 * MPa;       // not those of a soil
constexpr double largest_friction_ratio = 0.3;    // [-] of medians
constexpr double smallest_friction_ratio = 2e-5;  // [-]

struct Sensor {
  const char* name;
  double Reading::*value;
};
constexpr Sensor sensors[] = {{"q_c", &Reading::q_c}, {"f_s", &Reading::f_s}, {"u_2", &Reading::u_2}};

// What an ordinary step takes: median time and median length of steps that go down.
struct Step {
  double time, length;
};
Step ordinary_step(const std::vector<Reading>& readings) {
  std::vector<double> times, lengths;
  for (std::size_t i = 1; i < readings.size(); ++i) {
    const double time = readings[i].time - readings[i - 1].time;
    const double length = readings[i].depth - readings[i - 1].depth;
    if (!(time >= 0.0) || !(length > 0.0)) continue;
    times.push_back(time);
    lengths.push_back(length);
  }
  return {spread(times).median, spread(lengths).median};
}

std::string depths_of(const std::vector<double>& depths) {
  constexpr std::size_t shown = 12;
  std::string text;
  for (std::size_t i = 0; i < std::min(shown, depths.size()); ++i)
    text += fmt::format("{}{:.2f}", i == 0 ? "" : ", ", depths[i]);
  return text + (depths.size() > shown ? ", ... m" : " m");
}

void remark_on_voids(Recording& recording) {
  for (const Sensor& quantity : sensors) {
    Lines voids;
    for (const Reading& reading : recording.readings)
      if (std::isnan(reading.*quantity.value)) voids.add(reading.line);
    const auto rows = static_cast<int>(recording.readings.size());
    if (voids.rows > 0 && voids.rows < rows)
      recording.remarks.push_back({voids, fmt::format("{} is void", quantity.name), "kept without a value",
                                   "nothing is interpolated"});
  }
}

void mark_predrilled(Recording& recording) {
  if (std::isnan(recording.predrilled_depth) || recording.predrilled_depth <= 0.0) return;
  Lines above, measured;
  for (Reading& reading : recording.readings) {
    reading.predrilled = reading.depth < recording.predrilled_depth - 1e-6;
    if (!reading.predrilled) continue;
    above.add(reading.line);
    if (!std::isnan(reading.q_c)) measured.add(reading.line);
  }
  if (above.rows == 0) return;
  recording.remarks.push_back(
      {above, fmt::format("rows above the predrilled depth of {:g} m", recording.predrilled_depth),
       "kept and marked as predrilled",
       measured.rows > 0
           ? fmt::format("{} of them hold a q_c, which is not that of undisturbed soil", measured.rows)
           : "there is no soil to measure"});
}

void remark_on_magnitudes(Recording& recording) {
  const double q_c = spread(column(recording, &Reading::q_c)).median;
  const double f_s = spread(column(recording, &Reading::f_s)).median;
  if (q_c < least_q_c || q_c > largest_q_c)
    recording.remarks.push_back({{},
                                 fmt::format("median q_c is {:.4g} kPa", q_c / kPa),
                                 "nothing",
                                 "soils have 10 kPa to 150 MPa: the unit may be off by a factor of 1000"});
  const double ratio = f_s / q_c;
  if (f_s > 0.0 && q_c > 0.0 && (ratio > largest_friction_ratio || ratio < smallest_friction_ratio))
    recording.remarks.push_back({{},
                                 fmt::format("median f_s is {:.3g} of median q_c", ratio),
                                 "nothing",
                                 "soils have 0.001 to 0.1: the unit of one may be off by a factor of 1000"});
  const auto remark_where = [&](const char* found, const char* why,
                                const std::function<bool(const Reading&)>& odd) {
    Lines lines;
    for (const Reading& reading : recording.readings)
      if (odd(reading)) lines.add(reading.line);
    if (lines.rows > 0) recording.remarks.push_back({lines, found, "kept", why});
  };
  remark_where("negative q_c", "a drifting zero or suction; soil cannot pull the cone",
               [](const Reading& r) { return r.q_c < 0.0; });
  remark_where("values beyond 500 MPa", "no sensor reaches so far: perhaps a void that is not declared",
               [](const Reading& r) {
                 return std::any_of(std::begin(sensors), std::end(sensors),
                                    [&](const Sensor& q) { return std::abs(r.*q.value) > 500.0 * MPa; });
               });
}

void remark_on_zero(Recording& recording, const char* name, const ZeroReading& zero, double median) {
  if (std::isnan(zero.drift)) return;
  const std::string share =
      median > 0.0 ? fmt::format(", {:.2g} % of the median", 100.0 * std::abs(zero.drift) / median) : "";
  const std::string ends = std::isnan(zero.after) ? fmt::format("{:.6g} kPa before", zero.before / kPa)
                                                  : fmt::format("{:.6g} kPa before and {:.6g} kPa after",
                                                                zero.before / kPa, zero.after / kPa);
  recording.remarks.push_back({{},
                               fmt::format("zero of {} is {} the push", name, ends),
                               fmt::format("drift of {:.4g} kPa not applied{}", zero.drift / kPa, share),
                               "nobody knows over which part of the push it arose"});
}

void remark_on_end(Recording& recording) {
  double last = not_given;
  for (const Reading& reading : recording.readings)
    last = std::fmax(last, std::isnan(reading.length) ? reading.depth : reading.length);
  if (std::abs(recording.stated_end - last) > 0.05)
    recording.remarks.push_back(
        {{},
         fmt::format("the header lets the push end at {:g} m, the last row is at {:g} m",
                     recording.stated_end, last),
         "nothing",
         "rows may be missing, or the header was not brought up to date"});
}

}  // namespace

void mark_stops(Recording& recording) {
  std::vector<Reading>& rows = recording.readings;
  const Step step = ordinary_step(rows);
  Lines paused, repeated, backward;
  std::vector<double> where;
  double standing = 0.0;  // [s]
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double length = rows[i].depth - rows[i - 1].depth;
    const double time = rows[i].time - rows[i - 1].time;
    const double lost = time - step.time * std::max(0.0, length / step.length);
    if (lost > pause) standing += lost;
    rows[i].after_stop = rows[i].after_stop || lost > pause;
    if (rows[i].after_stop) {
      // A push that starts again slowly makes two long steps of one stop.
      if (!rows[i - 1].after_stop) where.push_back(rows[i - 1].depth);
      paused.add(rows[i].line);
    }
    if (std::abs(length) < 1e-9) {
      rows[i].after_stop = true;
      repeated.add(rows[i].line);
    }
    if (time < 0.0) backward.add(rows[i].line);
  }
  if (paused.rows > 0)
    recording.remarks.push_back(
        {paused,
         fmt::format("the push stood still {} time{}{}, at {}", where.size(), where.size() == 1 ? "" : "s",
                     standing > 0.0 ? fmt::format(", {:.0f} s in all", standing) : "", depths_of(where)),
         "kept and marked as after a stop",
         "pore pressure changes while the cone stands, and q_c starts anew"});
  if (repeated.rows > 0)
    recording.remarks.push_back({repeated, "the depth of the row before again",
                                 "kept and marked as after a stop", "the cone did not move in between"});
  if (backward.rows > 0)
    recording.remarks.push_back(
        {backward, "a time before that of the row before", "kept", "no stop is looked for there"});
}

void remark_on_values(Recording& recording) {
  mark_predrilled(recording);
  remark_on_voids(recording);
  remark_on_magnitudes(recording);
  remark_on_end(recording);
  const auto median = [&](double Reading::*quantity) { return spread(column(recording, quantity)).median; };
  remark_on_zero(recording, "q_c", recording.q_c_zero, median(&Reading::q_c));
  remark_on_zero(recording, "f_s", recording.f_s_zero, median(&Reading::f_s));
  remark_on_zero(recording, "u_2", recording.u_2_zero, median(&Reading::u_2));
}

}  // namespace cpt::recordings
