#include "results/ledger/output_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "results/files/error.hpp"

namespace cpt::results {

std::string output_text(const std::vector<solver::ProgramResult>& results) {
  std::string text;
  for (const solver::ProgramResult& result : results)  // names are letters, digits, _ and -
    text += fmt::format("{}\"{}\": ", text.empty() ? "{" : ", ", result.name) +
            (result.x.empty() ? fmt::format("{}", fmt::join(result.y, ", "))
                              : fmt::format("{{\"x\": [{}], \"y\": [{}]}}", fmt::join(result.x, ", "),
                                            fmt::join(result.y, ", ")));
  return text.empty() ? text : text + "}";
}

std::vector<solver::ProgramResult> parse_output_text(const std::string& text) {
  std::vector<solver::ProgramResult> results;
  if (text.empty()) return results;
  try {
    const auto object = nlohmann::ordered_json::parse(text);
    for (const auto& [name, value] : object.items()) {
      if (value.is_number())
        results.push_back({name, {}, {value.template get<double>()}});
      else
        results.push_back({name, value.at("x").template get<std::vector<double>>(),
                           value.at("y").template get<std::vector<double>>()});
    }
  } catch (const nlohmann::json::exception& problem) {
    throw Error(fmt::format("the outputs of a realization cannot be read: {}", problem.what()));
  }
  return results;
}

}  // namespace cpt::results
