// What a recording holds and what was found in it, for the terminal and for other programs.
#pragma once

#include <string>

#include "recordings/interpretation.hpp"
#include "results/tables/table_format.hpp"

namespace cpt::cli {

/// table: the facts, the quantities, what is read out of them, and each remark, to read. csv: one table with
/// a column `part`. json: one object with the same parts as arrays, and all entries of the file's header.
[[nodiscard]] std::string summary(const recordings::Recording& recording,
                                  const recordings::Interpretation& interpretation, results::Format format);

/// All readings, one row each: line, depth_m, length_m, q_c_kPa, f_s_kPa, u_2_kPa, inclination_deg,
/// speed_mm_per_s, time_s, predrilled, after_stop; then what is derived: q_t_kPa, R_f_percent, Q_tn,
/// F_r_percent, n, I_c, zone.
[[nodiscard]] results::Table readings_table(const recordings::Recording& recording,
                                            const recordings::Interpretation& interpretation);

}  // namespace cpt::cli
