// A measured sounding as plain data: what a file holds, in SI units, and everything that was found odd about
// it. Nothing in here was interpolated, and nothing left out without a line that says so.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace cpt::recordings {

inline constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

/// One row of the file. NaN: void, or not in the file.
struct Reading {
  int line = 0;                    ///< of the file, from 1
  double depth = not_given;        // [m] below the ground, positive downward; finite once the file is read
  double length = not_given;       // [m] of penetration along the rods
  double q_c = not_given;          // [Pa] cone resistance as measured, not corrected for u_2
  double f_s = not_given;          // [Pa] sleeve friction
  double u_2 = not_given;          // [Pa] pore pressure at the cone's shoulder
  double inclination = not_given;  // [rad] of the cone from the vertical, resultant
  double speed = not_given;        // [m/s] of the push
  double time = not_given;         // [s] from a zero of the file's own
  bool predrilled = false;         ///< above the predrilled depth
  bool after_stop = false;         ///< the push stood still between the row before in the file and this one
};

/// A line of the file's header: "cone area", "1000", "mm2".
struct Fact {
  std::string name, value, unit;
};

/// Which rows of the file are meant.
struct Lines {
  int rows = 0;   ///< how many; 0: the file as a whole
  int first = 0;  ///< line of the first; 0 if none is meant
  int last = 0;
  void add(int line);
};

/// Something odd in the file and what became of it.
struct Remark {
  Lines lines;
  std::string found, done, why;
};

/// Rows that were read but are not among the readings.
struct SetAside {
  Lines lines;
  std::string reason;
};

/// A sensor's reading in the air before and after the push.
struct ZeroReading {
  double before = not_given;  // [Pa]
  double after = not_given;   // [Pa]
  double drift = not_given;   // [Pa] after - before; never applied to the readings
};

/// Where the depths come from.
enum class DepthRule {
  stated,            ///< the file gives depths
  from_inclination,  ///< the integral of the cosine of the inclination over the length
  length             ///< the length along the rods, for want of anything better
};
[[nodiscard]] std::string_view name_of(DepthRule rule);

struct Recording {
  std::string file;
  std::string format;  ///< its name, as read_recording.cpp has it
  std::string id;      ///< the test's own name; the file's name without ending if it has none
  std::string date;    ///< as YYYY-MM-DD where the file allows that, else as the file has it; "" if not given
  double x = not_given, y = not_given;  // [m] in the file's own system
  double elevation = not_given;         // [m] of the ground, in the file's own datum
  double predrilled_depth = not_given;  // [m]
  double stated_end = not_given;        // [m] of length at which the header lets the push end
  double cone_area = not_given;         // [m2] of the base
  double area_quotient = not_given;     // [-] net area ratio a of the cone
  ZeroReading q_c_zero, f_s_zero, u_2_zero;
  std::vector<Fact> facts;  ///< everything else of the header, in the file's order
  DepthRule depth_rule = DepthRule::stated;
  int rows_read = 0;              ///< readings.size() plus all rows set aside
  std::vector<Reading> readings;  ///< depths are finite and do not fall
  std::vector<SetAside> set_aside;
  std::vector<Remark> remarks;
};

/// One quantity of all readings: column(recording, &Reading::q_c).
[[nodiscard]] std::vector<double> column(const Recording& recording, double Reading::*quantity);
/// Whether any reading has a value of it.
[[nodiscard]] bool has(const Recording& recording, double Reading::*quantity);

/// How a quantity is spread; NaN if there is no value.
struct Spread {
  int values = 0;  ///< that are not void
  double min = not_given, median = not_given, max = not_given;
};
[[nodiscard]] Spread spread(const std::vector<double>& values);

}  // namespace cpt::recordings
