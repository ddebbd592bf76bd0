// The header of a GEF file: its entries, its columns and its facts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "recordings/recording.hpp"
#include "recordings/recording_error.hpp"
#include "recordings/text.hpp"

namespace cpt::recordings {

struct GefColumn {
  int quantity = 0;  ///< 0: the header has no COLUMNINFO for it
  std::string unit, name;
  int line = 0;
  std::optional<double> void_value;
};

struct GefHeader {
  std::vector<GefColumn> columns;
  char column_separator = ' ';
  char record_separator = '\n';
  std::optional<int> last_scan;  ///< rows that the header promises
  std::size_t data = 0;          ///< index of the first line behind the header
};

/// Reads up to #EOH=. Test, position, cone and zeros go into the recording; the rest becomes facts.
[[nodiscard]] GefHeader read_gef_header(const std::vector<Line>& lines, Recording& recording,
                                        Problems& problems);

}  // namespace cpt::recordings
