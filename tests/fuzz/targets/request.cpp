#include <cmath>

#include "diagnosis/read_request.hpp"
#include "tests/fuzz/targets.hpp"
#include "tests/fuzz/targets/quick_study.hpp"

namespace cpt::fuzz {

Fate request(std::string_view toml) {
  (void)diagnosis::study_of_request(toml, "/requests/fuzzed.toml");
  const diagnosis::RequestOrErrors read =
      diagnosis::parse_request(toml, "/requests/fuzzed.toml", quick_study());
  if (const auto* errors = std::get_if<std::vector<parameters::StudyError>>(&read)) {
    promise(!errors->empty() && !format(*errors).empty(), "a refused request has errors");
    return Fate::refused;
  }
  const auto& sound = std::get<diagnosis::Request>(read);
  promise(!sound.soundings.empty() && !sound.mechanisms.empty(), "there is something to explain, and with");
  for (const diagnosis::SoundingRequest& sounding : sound.soundings)
    promise(std::isfinite(sounding.from) && sounding.from < sounding.to, "a sounding has a depth range");
  return Fate::sound;
}

}  // namespace cpt::fuzz
