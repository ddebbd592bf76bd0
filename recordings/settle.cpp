#include "recordings/settle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cpt::recordings {
namespace {

constexpr double steepest = 45.0 * std::numbers::pi / 180.0;  // [rad] more is no cone's inclination
constexpr double slack = 0.02;                                // [m] rounding of stated depths

bool known(double value) { return !std::isnan(value); }

void turn_sign(Recording& recording, double Reading::*quantity, const char* name) {
  Lines negative;
  bool positive = false;
  for (const Reading& reading : recording.readings) {
    if (reading.*quantity < 0.0) negative.add(reading.line);
    positive = positive || reading.*quantity > 0.0;
  }
  if (negative.rows == 0) return;
  if (positive) {
    recording.remarks.push_back({negative, fmt::format("negative {}", name), "kept",
                                 "others are positive: these rows lie above the ground"});
    return;
  }
  for (Reading& reading : recording.readings) reading.*quantity = std::abs(reading.*quantity);
  recording.remarks.push_back({negative, fmt::format("{} is negative throughout", name), "sign turned",
                               "depth counts positive downward from the ground"});
}

// Stated depths that cannot belong to the lengths are not used where there are lengths.
void drop_impossible_depths(Recording& recording) {
  Lines impossible;
  for (const Reading& r : recording.readings)
    if (known(r.depth) && known(r.length) && (r.depth > r.length + slack || r.depth < 0.5 * r.length - slack))
      impossible.add(r.line);
  if (impossible.rows == 0) return;
  for (Reading& reading : recording.readings)
    if (known(reading.length)) reading.depth = not_given;
  recording.remarks.push_back({impossible, "corrected depth longer than, or under half of, the length",
                               "the whole column of corrected depths is not used",
                               "a depth is at most the length along the rods"});
}

struct Walk {
  Lines placed, without_inclination;
  double largest_correction = 0.0;  // [m]
};

// Gives each row that has a length but no depth one that goes on from the row before.
Walk walk_down(Recording& recording) {
  Walk walk;
  double length = not_given, depth = not_given, cosine = 1.0;
  for (Reading& reading : recording.readings) {
    if (!known(reading.length)) continue;
    const bool usable = std::abs(reading.inclination) < steepest;
    if (usable) cosine = std::cos(reading.inclination);
    if (!known(reading.depth)) {
      reading.depth = known(depth) ? depth + (reading.length - length) * cosine : reading.length;
      walk.placed.add(reading.line);
      if (!usable) walk.without_inclination.add(reading.line);
      walk.largest_correction = std::max(walk.largest_correction, std::abs(reading.length - reading.depth));
    }
    length = reading.length;
    depth = reading.depth;
  }
  return walk;
}

void remark_on_steep_rows(Recording& recording) {
  Lines steep;
  for (const Reading& reading : recording.readings)
    if (std::abs(reading.inclination) >= steepest) steep.add(reading.line);
  if (steep.rows > 0)
    recording.remarks.push_back({steep, "inclination of 45 degrees or more",
                                 "kept, but not used to correct depths",
                                 "no cone is pushed on at such an angle; the sensor failed"});
}

}  // namespace

void choose_depths(Recording& recording) {
  turn_sign(recording, &Reading::length, "length");
  turn_sign(recording, &Reading::depth, "depth");
  drop_impossible_depths(recording);
  remark_on_steep_rows(recording);
  const bool stated = has(recording, &Reading::depth);
  const bool inclined = has(recording, &Reading::inclination);
  const Walk walk = walk_down(recording);
  recording.depth_rule = stated     ? DepthRule::stated
                         : inclined ? DepthRule::from_inclination
                                    : DepthRule::length;
  if (walk.placed.rows > 0) {
    const std::string voids = inclined && walk.without_inclination.rows > 0
                                  ? fmt::format("; for {} without inclination the last one known counts",
                                                walk.without_inclination.rows)
                                  : "";
    if (stated)
      recording.remarks.push_back(
          {walk.placed, "no corrected depth, but a length", "depth goes on from the row before" + voids,
           "until the first corrected depth or inclination the rods count as vertical"});
    else if (inclined)
      recording.remarks.push_back(
          {walk.placed, "no corrected depth, but an inclination",
           fmt::format("depth is the length corrected by the inclination, by up to {:.3f} m{}",
                       walk.largest_correction, voids),
           "an inclined cone is less deep than its rods are long"});
    else
      recording.remarks.push_back({walk.placed, "neither corrected depth nor inclination",
                                   "depth is the length along the rods",
                                   "there is nothing to correct it with"});
  }

  SetAside unplaced{{}, "neither depth nor length"};
  std::erase_if(recording.readings, [&](const Reading& reading) {
    if (known(reading.depth)) return false;
    unplaced.lines.add(reading.line);
    return true;
  });
  if (unplaced.lines.rows > 0) recording.set_aside.push_back(unplaced);
}

void put_in_order(Recording& recording) {
  Lines fallen;
  for (std::size_t i = 1; i < recording.readings.size(); ++i)
    if (recording.readings[i].depth < recording.readings[i - 1].depth) fallen.add(recording.readings[i].line);
  if (fallen.rows == 0) return;
  std::stable_sort(recording.readings.begin(), recording.readings.end(),
                   [](const Reading& a, const Reading& b) { return a.depth < b.depth; });
  recording.remarks.push_back({fallen, "depth less than in the row before", "rows put in order of depth",
                               "where rods were drawn up, two passes of the same soil now alternate"});
}

void settle(Recording& recording, Problems& problems) {
  choose_depths(recording);
  mark_stops(recording);
  put_in_order(recording);
  remark_on_values(recording);
  if (recording.readings.empty())
    problems.add(0, 0, "no row with a depth", "at least one reading");
  else if (!has(recording, &Reading::q_c))
    problems.add(0, 0, "no value of q_c", "at least one", "all are void; is the right column taken for q_c?");
}

}  // namespace cpt::recordings
