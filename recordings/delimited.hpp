// Delimited text: tables of fields between separators, as RFC 4180 has them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "recordings/recording_error.hpp"
#include "recordings/text.hpp"

namespace cpt::recordings {

/// A field without its quotes, and where its first character stands.
struct PlacedText {
  std::string text;
  int line;    ///< from 1
  int column;  ///< from 1, in characters
};

/// The fields of one line. A field that begins with a quote ends with one; a quote inside is doubled. Other
/// fields are taken as they stand, without the blanks around them. After a problem, those before it.
[[nodiscard]] std::vector<PlacedText> fields_of(const Line& line, char separator, Problems& problems);

/// A line of names and the rows below it, each as long.
struct DelimitedTable {
  std::vector<PlacedText> names;  ///< not empty, each once; the % that Dakota puts first is left out
  std::vector<std::vector<PlacedText>> rows;
};

/// Reads a table whose fields are set apart by semicolons, commas, tabs or blanks, whichever the names are;
/// a field in quotes may hold line breaks. Blank lines, and lines above the names that start with #, do not
/// count. Whatever is wrong goes to `problems`.
[[nodiscard]] DelimitedTable read_delimited(std::string_view text, Problems& problems);

}  // namespace cpt::recordings
