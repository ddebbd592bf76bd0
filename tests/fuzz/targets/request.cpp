#include <cmath>

#include "diagnosis/calibration/read_calibration_request.hpp"
#include "diagnosis/read_request.hpp"
#include "tests/fuzz/targets.hpp"
#include "tests/fuzz/targets/quick_study.hpp"

namespace cpt::fuzz {

namespace {

bool is_calibration(std::string_view toml) {
  const auto read = diagnosis::parse_calibration_request(toml, "/requests/fuzzed.toml", quick_study());
  const auto* sound = std::get_if<diagnosis::CalibrationRequest>(&read);
  if (sound == nullptr) {
    promise(!std::get<std::vector<parameters::StudyError>>(read).empty(), "a refused calibration has errors");
    return false;
  }
  promise(!sound->channels.empty() && !sound->soundings.empty(), "there is something to compare");
  promise(std::isfinite(sound->noise) && sound->noise > 0.0 && sound->discrepancy > 0.0 && sound->chains >= 4,
          "deviations are positive");
  return true;
}

}  // namespace

Fate request(std::string_view toml) {
  (void)diagnosis::study_of_request(toml, "/requests/fuzzed.toml");
  const diagnosis::RequestOrErrors read =
      diagnosis::parse_request(toml, "/requests/fuzzed.toml", quick_study());
  if (const auto* errors = std::get_if<std::vector<parameters::StudyError>>(&read)) {
    promise(!errors->empty() && !format(*errors).empty(), "a refused request has errors");
    return is_calibration(toml) ? Fate::sound : Fate::refused;
  }
  const auto& sound = std::get<diagnosis::Request>(read);
  promise(!sound.soundings.empty() && !sound.mechanisms.empty(), "there is something to explain, and with");
  for (const diagnosis::SoundingRequest& sounding : sound.soundings)
    promise(std::isfinite(sounding.from) && sounding.from < sounding.to, "a sounding has a depth range");
  return Fate::sound;
}

}  // namespace cpt::fuzz
