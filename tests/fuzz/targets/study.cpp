#include "parameters/all_realizations.hpp"
#include "parameters/read_study.hpp"
#include "tests/fuzz/targets.hpp"

namespace cpt::fuzz {

using namespace parameters;

Fate study(std::string_view toml) {
  const StudyOrErrors read = parse_study(toml, "/studies/fuzzed.toml");
  if (const auto* errors = std::get_if<std::vector<StudyError>>(&read)) {
    promise(!errors->empty(), "a refused study has errors");
    for (const StudyError& error : *errors) {
      promise(!error.message.empty(), "an error says what is wrong");
      promise((error.line > 0) == (error.column > 0), "an error's place is whole or the file");
    }
    promise(!format(*errors).empty(), "errors can be told");
    return Fate::refused;
  }
  const Study& sound = std::get<Study>(read);
  for (const Realization& realization : all_realizations(sound))
    promise(solver::problems(make_setup(sound, realization)).empty(), "every realization can be run");
  return Fate::sound;
}

}  // namespace cpt::fuzz
