#include "results/ledger/setup_text.hpp"

#include <sstream>

namespace cpt::results {

std::map<std::string, std::string> setup_by_name(const std::string& canonical_text) {
  std::map<std::string, std::string> setup;
  std::istringstream lines(canonical_text);
  for (std::string line; std::getline(lines, line);)
    if (const auto equals = line.find(" = "); equals != std::string::npos) {
      std::string& value = setup[line.substr(0, equals)];
      value += (value.empty() ? "" : "; ") + line.substr(equals + 3);
    }
  return setup;
}

}  // namespace cpt::results
