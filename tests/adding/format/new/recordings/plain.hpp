// A made-up format: its mark, then depth (m), q_c (MPa) and f_s (kPa) of a row, apart by blanks.
//
//   PLAIN CPT
//   0.02 1.25 10.5
#pragma once

#include "recordings/read_recording.hpp"
#include "recordings/text.hpp"

namespace cpt::recordings {

[[nodiscard]] bool is_plain(std::string_view first_line);
void read_plain(const std::vector<Line>& lines, const ReadOptions& options, Recording& recording,
                Problems& problems);

}  // namespace cpt::recordings
