// GEF-CPT, the Dutch exchange format (CUR, Geotechnical Exchange Format for CPT-Data, 1999 to 2006).
//
//   #COLUMNINFO= 2, MPa, qc, 2        column, unit, name, quantity
//   #COLUMNVOID= 2, -9999
//   #EOH=
//   0.00 -9999 ...
//
// Columns are taken by their quantity: 1 length, 2 q_c, 3 f_s, 6 u_2, 8 inclination (or 9 and 10, or 21 and
// 22, its two components), 11 corrected depth, 12 time. Separators are those that the header declares, and
// blanks and line ends where the data do not follow it.
#pragma once

#include "recordings/read_recording.hpp"
#include "recordings/text.hpp"

namespace cpt::recordings {

[[nodiscard]] bool is_gef(std::string_view first_line);
void read_gef(const std::vector<Line>& lines, const ReadOptions& options, Recording& recording,
              Problems& problems);

}  // namespace cpt::recordings
