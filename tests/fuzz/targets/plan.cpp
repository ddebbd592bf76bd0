#include "validation/concealed/plan.hpp"

#include "tests/fuzz/targets.hpp"
#include "tests/fuzz/targets/quick_study.hpp"

namespace cpt::fuzz {

using namespace validation::concealed;

Fate plan(std::string_view toml) {
  const PlanOrErrors read = parse_plan(toml, "/plans/fuzzed.toml", quick_study());
  if (const auto* errors = std::get_if<std::vector<parameters::StudyError>>(&read)) {
    promise(!errors->empty() && !format(*errors).empty(), "a refused plan has errors");
    return Fate::refused;
  }
  const Plan& sound = std::get<Plan>(read);
  promise(sound.cases.total() > 0 && sound.cases.two_soundings <= sound.cases.total(), "there are cases");
  promise(sound.cases_folder.parent_path() == "/plans" && sound.sealed_folder.parent_path() == "/plans",
          "folders lie beside the plan");
  return Fate::sound;
}

}  // namespace cpt::fuzz
