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
  std::vector<std::string> headings, units;  ///< units: empty or as many as headings
  std::vector<AgsRow> rows;

  [[nodiscard]] std::optional<std::size_t> place_of(std::string_view heading) const;
  /// The text under a heading; "" if there is no such heading.
  [[nodiscard]] std::string text(const AgsRow& row, std::string_view heading) const;
  [[nodiscard]] std::string unit(std::string_view heading) const;
};

[[nodiscard]] std::vector<AgsGroup> read_ags_groups(const std::vector<Line>& lines, Problems& problems);
/// nullptr if there is none.
[[nodiscard]] const AgsGroup* find_group(const std::vector<AgsGroup>& groups, std::string_view name);

}  // namespace cpt::recordings
