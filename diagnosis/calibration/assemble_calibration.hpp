// From a study, its emulator and recordings to the problem that calibrate.hpp solves.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/calibration/calibration_model.hpp"
#include "diagnosis/calibration/calibration_request.hpp"
#include "recordings/recording.hpp"
#include "results/emulator/emulator.hpp"
#include "results/emulator/training.hpp"

namespace cpt::diagnosis {

/// The emulator's inputs with the study's distributions, uniform between the bounds without; and the
/// correlation of their normal scores. The emulator must live as long. Throws std::invalid_argument where the
/// study lacks an input.
[[nodiscard]] CalibrationProblem prior_of(const parameters::Study& study, const results::Emulator& emulator);

/// The problem of these recordings, one for each sounding of the request. What is left out is told in
/// `notes`: channels that the emulator refuses, that it or a recording lacks, cells without a value. Study
/// and emulator must live as long. Throws std::invalid_argument, with a sentence for the user, where no
/// channel is left, and where recording and simulation are a hundredfold apart.
[[nodiscard]] CalibrationProblem assemble_calibration(const CalibrationRequest& request,
                                                      const parameters::Study& study,
                                                      const results::Emulator& emulator,
                                                      const std::vector<recordings::Recording>& recordings,
                                                      std::vector<std::string>& notes);

/// The same without recordings, on all cells of the request: the mean curve stands for them.
[[nodiscard]] CalibrationProblem assemble_unrecorded(const CalibrationRequest& request,
                                                     const parameters::Study& study,
                                                     const results::Emulator& emulator,
                                                     std::vector<std::string>& notes);

/// A run's curve (the emulator's unit, at its depths) at a channel's cells, on its scale.
[[nodiscard]] VectorXd curve_at_cells(const CalibrationChannel& channel, const VectorXd& depth_m,
                                      const VectorXd& curve);

/// The training runs without some of them, and curves alone: `held_out` are indices of runs.
[[nodiscard]] results::TrainingRuns without_runs(const results::TrainingRuns& runs,
                                                 const std::vector<Index>& held_out);

/// `count` of the runs that the study's design has drawn from the distributions, by chance with this seed, in
/// ascending order. Throws std::invalid_argument, with a sentence for the user, where the design does not
/// draw, rows have no distribution that it drew from, or too few runs would be left for an emulator.
[[nodiscard]] std::vector<Index> held_out_runs(const parameters::Study& study,
                                               const results::TrainingRuns& runs, Index count,
                                               std::uint64_t seed);

}  // namespace cpt::diagnosis
