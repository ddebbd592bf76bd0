// Which sign a file puts before its decimals. A comma may be one, or set thousands apart; the file as a whole
// tells, or the comma is refused.
#pragma once

#include <optional>
#include <string_view>

#include "recordings/recording.hpp"

namespace cpt::recordings {

/// "12,5" as 12.5; nothing where the comma may set thousands apart ("1,234") or the text is not of that form.
[[nodiscard]] std::optional<double> certain_decimal_comma(std::string_view text);

/// number(), or a certain decimal comma: for values that stand alone.
[[nodiscard]] std::optional<double> lone_number(std::string_view text);

/// Hears all numbers of a file first, then reads them. Decimals follow a comma where one number can have no
/// other meaning and none has a point.
class DecimalMark {
 public:
  void hear(std::string_view text);
  [[nodiscard]] bool comma() const { return certain_ && !point_; }
  /// As recordings::number_of_any_size, with commas where they are the file's decimal mark.
  [[nodiscard]] std::optional<double> number_of_any_size(std::string_view text) const;
  [[nodiscard]] std::optional<double> number(std::string_view text) const;
  /// Tells that decimals follow a comma, if they do.
  void tell(Recording& recording) const;

 private:
  bool point_ = false, certain_ = false;
};

}  // namespace cpt::recordings
