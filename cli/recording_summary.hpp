// What a recording holds and what was found in it, for the terminal and for other programs.
#pragma once

#include <string>

#include "recordings/recording.hpp"
#include "results/table_format.hpp"

namespace cpt::cli {

/// table: the facts, the quantities and each remark, to read. csv: one table with a column `part`. json: one
/// object with the same parts as arrays, and all entries of the file's header.
[[nodiscard]] std::string summary(const recordings::Recording& recording, results::Format format);

/// All readings, one row each: line, depth_m, length_m, q_c_kPa, f_s_kPa, u_2_kPa, inclination_deg,
/// speed_mm_per_s, time_s, predrilled, after_stop.
[[nodiscard]] results::Table readings_table(const recordings::Recording& recording);

}  // namespace cpt::cli
