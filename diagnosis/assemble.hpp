// From what the campaign stored and what was recorded to the problem that the statistics solve.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/design.hpp"
#include "diagnosis/diagnose.hpp"
#include "recordings/recording.hpp"
#include "results/snapshot.hpp"

namespace cpt::diagnosis {

/// A sounding with its recording and its finished campaign.
struct SoundingData {
  SoundingRequest request;
  SoundingStudy study;
  recordings::Recording recording;
  results::Snapshot campaign;
};

struct Assembled {
  Problem problem;
  std::vector<MechanismDesign> mechanisms;  ///< those of the problem, in its order
  std::vector<std::string> remarks;         ///< what was left out and why, a sentence each
};

/// Throws std::invalid_argument, with a sentence for the user, where recording and simulation do not fit
/// together: no overlap in depth, fewer than 10 common cells, a constant column, magnitudes a hundredfold
/// apart, a baseline that failed.
[[nodiscard]] Assembled assemble(const Request& request, const std::vector<SoundingData>& soundings);

}  // namespace cpt::diagnosis
