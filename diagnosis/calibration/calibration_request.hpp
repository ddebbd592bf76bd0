// What the researcher asks of a calibration: which recordings, which study, which channels, how much may be
// amiss. Plain data; read_calibration_request.hpp makes it from TOML.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "diagnosis/request.hpp"
#include "solver/channels.hpp"

namespace cpt::diagnosis {

struct CalibrationRequest {
  std::filesystem::path file;  ///< absolute path of the request
  std::string name;            ///< file name without extension
  std::string title;
  std::filesystem::path study;                   ///< absolute
  std::vector<SoundingRequest> soundings;        ///< at least one, without known differences
  std::vector<const solver::Channel*> channels;  ///< that a sounding measures; q_c first if it is among them
  bool channels_are_given = false;               ///< else all that study and recordings have
  double cell_height = 0.005;                    // [m] of the depth grid
  double noise = 0.01;                           // [-] relative, of q_c; of a prior its scale
  bool noise_is_known = false;                   ///< else half-normal
  double discrepancy = 0.05;                     // [-] relative: scale of the prior of its deviation
  double discrepancy_length = 0.0;               // [m] correlation over depth
  int chains = 4;
  std::uint64_t seed = 1;
  std::filesystem::path folder;  ///< NAME-calibration: the answer
};

}  // namespace cpt::diagnosis
