#include "cli/number_list.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "cli/study_argument.hpp"

namespace cpt::cli {

std::vector<double> parse_numbers(std::string_view option, const std::string& text) {
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    double value = 0.0;
    const auto [stop, error] = std::from_chars(text.data() + begin, text.data() + end, value);
    if (error != std::errc{} || stop != text.data() + end || !std::isfinite(value))
      throw BadInput(
          fmt::format("{} {}: '{}' is not a number", option, text, text.substr(begin, end - begin)));
    numbers.push_back(value);
    begin = end + 1;
  }
  return numbers;
}

std::pair<double, double> parse_pair(std::string_view option, std::string_view form,
                                     const std::string& text) {
  const std::vector<double> numbers = parse_numbers(option, text);
  if (numbers.size() != 2)
    throw BadInput(
        fmt::format("{} {}: must be {}, two numbers with a comma and no space", option, text, form));
  return {numbers[0], numbers[1]};
}

}  // namespace cpt::cli
