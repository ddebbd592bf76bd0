// From what the campaign stored and what was recorded to the problem that the statistics solve.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/design.hpp"
#include "diagnosis/diagnose.hpp"
#include "recordings/recording.hpp"
#include "results/ledger/snapshot.hpp"
#include "solver/channels.hpp"

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

/// Cells between the depths that are asked for.
[[nodiscard]] SoundingGrid grid_of(const SoundingRequest& sounding, double cell_height);

/// What makes a recording useless whatever the simulation: throws std::invalid_argument, with a sentence for
/// the user, where it has no q_c, no overlap with the depths asked for, one constant value, or values in
/// fewer than 10 cells. Worth asking before the solver runs.
void check_recording(const SoundingRequest& sounding, const recordings::Recording& recording,
                     double cell_height);

/// What is compared of each sounding, in this order.
using ChannelList = std::vector<const solver::Channel*>;

/// Throws std::invalid_argument, with a sentence for the user, where recording and simulation do not fit
/// together: as check_recording, and fewer than 10 common cells, magnitudes a hundredfold
/// apart, a baseline that failed.
[[nodiscard]] Assembled assemble(const Request& request, const std::vector<SoundingData>& soundings);
/// The same of several channels (q_c and others that recordings have), one behind the other in each sounding,
/// of runs with less of their scatter (Quieted): the problem's baseline is the mean of it and its repeats.
[[nodiscard]] Assembled assemble(const Request& request, const std::vector<SoundingData>& soundings,
                                 const ChannelList& channels);

/// The problem as it would be of pushes not made yet, or of what was not recorded of those that were: the
/// baseline stands for the recording. The channel's noise is that of q_c times what the list of channels
/// says. Throws as assemble.
[[nodiscard]] Assembled assemble_unmeasured(const Request& request,
                                            const std::vector<SoundingData>& soundings,
                                            const solver::Channel& measured, const NoiseModel& measurement);

}  // namespace cpt::diagnosis
