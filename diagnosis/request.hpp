// What the researcher asks: which recordings, against which study, which mechanisms. Plain data;
// read_request.hpp makes it from TOML.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "parameters/study.hpp"
#include "recordings/read_recording.hpp"
#include "solver/mechanisms/catalogue.hpp"

namespace cpt::diagnosis {

/// One sounding: a recording, and what is known to be different from the study's baseline where it was
/// pushed.
struct SoundingRequest {
  std::string name;
  std::filesystem::path recording;  ///< absolute
  recordings::ReadOptions options;
  double from = 0.0, to = 0.0;              // [m] depths to compare
  std::vector<parameters::Change> changes;  ///< known inputs, such as sigma_v0
};

struct Request {
  std::filesystem::path file;  ///< absolute path of the request
  std::string name;            ///< file name without extension
  std::string title;
  std::filesystem::path study;  ///< absolute
  std::vector<SoundingRequest> soundings;
  std::vector<SoundingRequest> candidates;  ///< pushes that could be made next; without recording
  /// That may be missing; all apply to the study. Places are looked for between the soundings' depths.
  std::vector<solver::Mechanism> mechanisms;
  double cell_height = 0.005;  // [m] of the depth grid
  double measurement = 0.0;    // [-] relative noise of the recording; 0: from its own high-pass part
  double correlation = 0.01;   // [m] its correlation length, where `measurement` is given
  int cone_class = 0;          ///< ISO 22476-1, 1 to 4; 0: not told, its faults are looked for as class 2's
  bool simulated = false;      ///< the recording is a simulation itself: it has numerical noise too
  int repeats = 8;             ///< runs of the baseline with other seeds, meshes and time steps
  int joint = 12;              ///< runs at joint values of the study's parameters
  int confirm = 3;             ///< of the mechanisms that may be the answer, so many run in the full solver
  std::uint64_t seed = 1;      ///< of the bootstraps
  std::filesystem::path database;    ///< NAME.sqlite: the answer
  std::filesystem::path report_dir;  ///< NAME-report
};

}  // namespace cpt::diagnosis
