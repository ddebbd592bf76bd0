// Geotech .cpt, the files of CPT-LOG after the Swedish Geotechnical Society's format (SGF Report 3:2012E).
//
//   $
//   HD=22.09.2022,HK=57,HO=4.00,MA=0.869,MC=10.0
//   #
//   D=4.000,QC=3.5707,FS=17.5,U=28.5,TA=1.51,B=20,%2574109515 ,F=13
//   #$
//   13:Depth unchanged for 5 second
//
// Of a row: D length (m), QC q_c (MPa), FS f_s (kPa), U u_2 (kPa), TA inclination (deg), B speed (mm/s), %
// time (milliseconds, or YYYYMMDDhhmmssmmm), F=13 the push stood still behind this row, NA NB NC zeros of q_c
// (MPa), f_s and u_2 (kPa): values on the first row, changes on the last. Of the header: HD date, HK name, HO
// predrilled depth, HX HY HZ position, MA area quotient, MC cone area (cm2). Only the first sounding of a
// file is read; rows of further ones are set aside.
#pragma once

#include "recordings/read_recording.hpp"
#include "recordings/text.hpp"

namespace cpt::recordings {

[[nodiscard]] bool is_geotech(std::string_view first_line);
void read_geotech(const std::vector<Line>& lines, const ReadOptions& options, Recording& recording,
                  Problems& problems);

}  // namespace cpt::recordings
