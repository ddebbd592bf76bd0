// CSV: a table of columns, of which the user says what they are.
//
//   # id = CPT40            "# name = value" before the table is a fact; id, date, x_m, y_m, elevation_m,
//   # predrilled_m = 2      predrilled_m, cone_area_cm2 and area_quotient have their place
//   z_m,tip_MPa
//   0.011,0.055646
//
// with the column map depth_m = z_m, q_c_MPa = tip_MPa. Quantities are depth, length, q_c, f_s, u_2,
// inclination, speed and time; their unit follows: depth_m, length_cm, q_c_MPa, f_s_kPa, u_2_kPa,
// inclination_deg, speed_mm_per_s, time_s. A column that is named so itself needs no entry. The first line
// that is no comment names the columns; fields are set apart by semicolons, tabs or commas, whichever the
// names are. Blank fields, "nan", "NA", "null" and the given voids are void.
#pragma once

#include <string>

#include "recordings/read_recording.hpp"
#include "recordings/text.hpp"

namespace cpt::recordings {

/// Nothing where `quantity` is a quantity with a unit of its kind; else what is wrong with it.
[[nodiscard]] std::string quantity_problem(const std::string& quantity);

void read_csv(const std::vector<Line>& lines, const ReadOptions& options, Recording& recording,
              Problems& problems);

}  // namespace cpt::recordings
