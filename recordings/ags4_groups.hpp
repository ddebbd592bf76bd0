// An AGS4 file as its groups: tables of texts.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recordings/delimited.hpp"
#include "recordings/recording_error.hpp"
#include "recordings/text.hpp"

namespace cpt::recordings {

struct AgsRow {
  int line = 0;
  std::vector<PlacedText> cells;  ///< without the leading "DATA"; as many as headings
};
struct AgsGroup {
  std::string name;
  int line = 0;
  int unit_line = 0;                         ///< 0: it has no UNIT row
  std::vector<std::string> headings, units;  ///< units: empty or as many as headings
  std::vector<AgsRow> rows;
  std::vector<int> unit_columns;  ///< where the units stand in their line

  [[nodiscard]] std::optional<std::size_t> place_of(std::string_view heading) const;
  /// The text under a heading; "" if there is no such heading.
  [[nodiscard]] std::string text(const AgsRow& row, std::string_view heading) const;
  [[nodiscard]] std::string unit(std::string_view heading) const;
};

[[nodiscard]] std::vector<AgsGroup> read_ags_groups(const std::vector<Line>& lines, Problems& problems);
/// All of a name, in the file's order: a file joined from several deliveries holds a group more than once.
[[nodiscard]] std::vector<const AgsGroup*> find_groups(const std::vector<AgsGroup>& groups,
                                                       std::string_view name);

}  // namespace cpt::recordings
