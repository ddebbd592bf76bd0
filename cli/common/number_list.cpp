#include "cli/common/number_list.hpp"

#include <fmt/format.h>

#include <cmath>

#include "cli/common/study_argument.hpp"
#include "parameters/written_number.hpp"

namespace cpt::cli {

std::vector<double> parse_numbers(std::string_view option, const std::string& text) {
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    const std::optional<double> value = parameters::written_number(word);
    if (!value || !std::isfinite(*value)) {
      const std::string hint = parameters::number_hint(word);
      throw BadInput(
          fmt::format("{} {}: '{}' is not a number{}", option, text, word, hint.empty() ? "" : "; " + hint));
    }
    numbers.push_back(*value);
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
