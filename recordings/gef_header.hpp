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
  int unit_column = 0;                  ///< where the unit stands in its line
  std::vector<double> void_values;      ///< of any size
  std::vector<std::string> void_texts;  ///< in lower case; of voids that are no numbers
};

struct GefHeader {
  std::vector<GefColumn> columns;
  char column_separator = ' ';
  char record_separator = '\n';
  bool texts = false;            ///< rows may have a text behind their last column (#COLUMNTEXT)
  std::optional<int> last_scan;  ///< rows that the header promises
  std::size_t data = 0;          ///< index of the first line behind the header
};

/// Reads up to #EOH=. Test, position, cone and zeros go into the recording; the rest becomes facts.
[[nodiscard]] GefHeader read_gef_header(const std::vector<Line>& lines, Recording& recording,
                                        Problems& problems);

}  // namespace cpt::recordings
