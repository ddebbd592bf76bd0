// What is read out of a recording, for the terminal and for other programs.
#pragma once

#include <string>
#include <vector>

#include "recordings/interpretation.hpp"
#include "results/tables/table_format.hpp"

namespace cpt::cli {

/// What it rests on and what was found: assumptions, soil_behaviour, spikes, odd_speeds. All rows.
[[nodiscard]] std::vector<results::NamedTable> interpretation_tables(
    const recordings::Recording& recording, const recordings::Interpretation& interpretation);

/// The same to read: sentences, and tables of the first or largest rows.
[[nodiscard]] std::string interpretation_text(const recordings::Recording& recording,
                                              const recordings::Interpretation& interpretation);

/// A column of values for each reading that is derived from it: "q_t_kPa", ...
struct DerivedColumn {
  const char* name;            // "q_t"
  const char* unit;            // "kPa"
  const char* header;          // "q_t_kPa"
  std::vector<double> values;  // in that unit
};
[[nodiscard]] std::vector<DerivedColumn> derived_columns(const recordings::Interpretation& interpretation);

}  // namespace cpt::cli
