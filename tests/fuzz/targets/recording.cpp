#include <cmath>

#include "recordings/interpretation.hpp"
#include "recordings/read_recording.hpp"
#include "tests/fuzz/targets.hpp"

namespace cpt::fuzz {
namespace {

using namespace recordings;

// What every recording promises (recording.hpp).
void check(const Recording& r) {
  promise(!r.readings.empty(), "a recording has readings");
  std::size_t rows = r.readings.size();
  for (const SetAside& set : r.set_aside) {
    promise(set.lines.rows > 0 && !set.reason.empty(), "rows are set aside for a reason");
    rows += static_cast<std::size_t>(set.lines.rows);
  }
  promise(static_cast<std::size_t>(r.rows_read) == rows, "no row is lost");
  double depth = -1e300;
  bool measured = false;
  for (const Reading& reading : r.readings) {
    promise(std::isfinite(reading.depth) && reading.depth >= depth, "depth rises");
    promise(reading.line > 0, "a reading knows its line");
    depth = reading.depth;
    measured = measured || !std::isnan(reading.q_c);
    for (const double value : {reading.length, reading.q_c, reading.f_s, reading.u_2, reading.inclination,
                               reading.speed, reading.time})
      promise(!std::isinf(value), "values are finite or not measured");
  }
  promise(measured, "some q_c is measured");
  for (const Remark& remark : r.remarks)
    promise(!remark.found.empty() && !remark.done.empty() && !remark.why.empty(), "a remark says all");
}

// What every interpretation promises (interpretation.hpp).
void check(const Recording& r, const Interpretation& it) {
  for (const std::size_t size :
       {it.q_t.size(), it.R_f.size(), it.ground.size(), it.behaviour.size(), it.speed.speed.size()})
    promise(size == r.readings.size(), "one value for each reading");
  for (const Behaviour& b : it.behaviour)
    promise(b.zone >= 0 && b.zone <= 9 && (b.zone == 0 || std::isfinite(b.I_c)), "a zone comes from an I_c");
  double depth = -1e300;
  for (const BehaviourInterval& interval : it.intervals) {
    promise(interval.from >= depth && interval.to >= interval.from, "intervals follow each other");
    promise(interval.zone > 0 && interval.of_zone > 0 && interval.of_zone <= interval.readings,
            "an interval has readings of its zone");
    depth = interval.to;
  }
  for (const Spike& spike : it.spikes) promise(spike.reading < r.readings.size(), "a spike is a reading");
  for (const OddSpeed& run : it.odd_speeds)
    promise(run.readings > 0 && run.from <= run.to, "a run of odd speed has readings");
}

bool sound(std::string_view bytes, const char* name, const ReadOptions& options) {
  const RecordingOrErrors read = parse_recording(bytes, name, options);
  if (const auto* recording = std::get_if<Recording>(&read)) {
    check(*recording);
    check(*recording, interpret(*recording));
    return true;
  }
  const auto& errors = std::get<std::vector<RecordingError>>(read);
  promise(!errors.empty() && !format(errors).empty(), "a refused recording has errors");
  for (const RecordingError& error : errors) {
    promise(!error.file.empty() && !error.found.empty() && !error.expected.empty(), "an error says all");
    promise((error.line > 0) == (error.column > 0), "an error's place is whole or the file");
  }
  return false;
}

}  // namespace

Fate recording(std::string_view bytes) {
  static const ReadOptions csv{.format = {},
                               .columns = {{"depth_m", "z_m"}, {"q_c_MPa", "tip_MPa"}, {"f_s_kPa", "sleeve"}},
                               .voids = {-9999.0},
                               .push = {}};
  static const ReadOptions one_push{.format = {}, .columns = {}, .voids = {}, .push = "CPT1/1"};
  bool read = sound(bytes, "a.csv", csv);
  read = sound(bytes, "a.ags", one_push) || read;
  for (const char* name : {"a.gef", "a.ags", "a.cpt", "a.csv", "a"}) read = sound(bytes, name, {}) || read;
  return read ? Fate::sound : Fate::refused;
}

}  // namespace cpt::fuzz
