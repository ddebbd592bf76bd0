// Numbers between commas on the command line: 0.2,0.4,0.53
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cpt::cli {

/// One or more numbers. Throws BadInput that names the option.
[[nodiscard]] std::vector<double> parse_numbers(std::string_view option, const std::string& text);

/// Two numbers; `form` says what they are: "R_M,DEPTH_M". Throws BadInput.
[[nodiscard]] std::pair<double, double> parse_pair(std::string_view option, std::string_view form,
                                                   const std::string& text);

}  // namespace cpt::cli
