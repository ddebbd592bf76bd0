// How the report of a diagnosis writes numbers, lists and names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cpt::reports::diagnosed {

/// A difference of ln q_c as one of q_c [%]: 100 (exp(x) - 1).
[[nodiscard]] double percent_of(double ln);
/// "38 %", "4.2 %": one decimal below ten.
[[nodiscard]] std::string percent(double value);
/// "p < 0.001" or "p = 0.034".
[[nodiscard]] std::string p_value(double p);
/// "0.93", "0.004", "below 0.001", "above 0.999".
[[nodiscard]] std::string probability(double value);
/// A depth [m] to the millimetre, without idle zeros: "0.11".
[[nodiscard]] std::string metres(double depth);
/// "14 ± 3 %": as many decimals as the deviation's first digit needs, two digits where that is a 1.
[[nodiscard]] std::string with_deviation(double value, double deviation, std::string_view unit);
/// Three significant digits without idle zeros: "40", "0.05", "12.5".
[[nodiscard]] std::string brief(double value);
/// " kPa"; nothing for "-".
[[nodiscard]] std::string unit_after(std::string_view unit);
/// First letter (of ASCII) made a capital.
[[nodiscard]] std::string capitalized(std::string text);
/// "A", "A and B", "A, B and C".
[[nodiscard]] std::string listed(const std::vector<std::string>& items, std::string_view last = "and");

/// Text made safe inside a line of Markdown and for the HTML made from it; a line end becomes a blank.
[[nodiscard]] std::string markdown(std::string_view text);
/// A symbol with its subscripts, made safe too.
[[nodiscard]] std::string markdown_symbol(std::string_view symbol);

}  // namespace cpt::reports::diagnosed
