// AGS4, the British exchange format (Association of Geotechnical and Geoenvironmental Specialists).
//
//   "GROUP","SCPT"
//   "HEADING","LOCA_ID","SCPG_TESN","SCPT_DPTH","SCPT_RES","SCPT_FRES","SCPT_PWP2"
//   "UNIT","","","m","MN/m2","kN/m2","kN/m2"
//   "TYPE","ID","X","2DP","3DP","2DP","2DP"
//   "DATA","CPT01","1","0.02","1.250","10.1","-2.0"
//
// Readings are those of group SCPT; SCPG, LOCA and PROJ give the facts of the push. A blank is a void.
// SCPT_DPTH is taken as a depth. A file may hold several pushes: one is read, and the rows of the others are
// set aside.
#pragma once

#include "recordings/read_recording.hpp"
#include "recordings/text.hpp"

namespace cpt::recordings {

[[nodiscard]] bool is_ags4(std::string_view first_line);
/// Adds an error that lists the pushes where there are several and `options.push` names none or not one.
void read_ags4(const std::vector<Line>& lines, const ReadOptions& options, Recording& recording,
               Problems& problems);

}  // namespace cpt::recordings
