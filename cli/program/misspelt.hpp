// Hints for words of a command line that CLI11 refuses.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace cpt::cli {

/// "did you mean --slots?" for an option, a command below another or one of a list of choices that is nearly
/// the word given; "" where none is. `words` are those of the command line without the program.
[[nodiscard]] std::string misspelt_hint(const CLI::App& program, const std::vector<std::string>& words,
                                        const CLI::ParseError& problem);

}  // namespace cpt::cli
