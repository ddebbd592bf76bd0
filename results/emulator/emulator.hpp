// The emulator of a study: its inputs, the runs it was made of, and each of its outputs with how good it is.
// Plain data; training.hpp makes it from a ledger, emulator_file.hpp stores it.
#pragma once

#include <Eigen/Dense>
#include <string>
#include <string_view>
#include <vector>

#include "results/emulator/output_emulator.hpp"
#include "results/emulator/validation.hpp"

namespace cpt::results {

/// An input in its study unit; a value of a choice is the index of the alternative.
struct EmulatorInput {
  std::string name, unit;
  double lower = 0.0, upper = 1.0, baseline = 0.0;  ///< lower < upper
  bool logarithmic = false;                         ///< places are equally spaced in ln(value); lower > 0
  bool integer = false;                             ///< takes whole numbers
  std::vector<std::string> choices;                 ///< of a choice the names of lower and upper; else empty

  /// Where a value lies in the unit interval: 0 at lower, 1 at upper, linear between, in ln(value) where it
  /// is logarithmic. The emulator's processes are functions of places.
  [[nodiscard]] double place(double value) const;
  /// "22.3 to 33.5 kPa", "rigid or flexible"
  [[nodiscard]] std::string range() const;
  /// "27.9", "rigid"
  [[nodiscard]] std::string text(double value) const;
  friend bool operator==(const EmulatorInput&, const EmulatorInput&) = default;
};

/// Why a value is none of the input: "must be 22.3 to 33.5 kPa"; empty if it is.
[[nodiscard]] std::string out_of_range(const EmulatorInput& input, double value);

/// A run that an emulator was made of.
struct TrainedRun {
  int id = 0;                 ///< of the realization when it was made
  std::string settings_hash;  ///< all inputs and the solver's version
  friend bool operator==(const TrainedRun&, const TrainedRun&) = default;
};

/// What an output is: a window's average of a channel or its whole curve; of an external program the window's
/// result or a declared curve.
struct OutputLabel {
  std::string name;  ///< "deep.q_c_mean_kPa", of a curve "q_c_kPa"; of an external program its own
  std::string unit = "kPa";
  std::string over = "depth", over_unit = "m";  ///< abscissa of a curve
};

struct EmulatedOutput : OutputLabel {
  Eigen::VectorXd abscissa;  ///< [over_unit] of a curve's values, depths of a push; empty of an average
  OutputEmulator emulator;
  Validation validation;
  [[nodiscard]] bool is_curve() const { return abscissa.size() > 0; }
};

struct Emulator {
  std::string study;           ///< its name
  std::string solver_version;  ///< of its runs
  std::vector<EmulatorInput> inputs;
  std::vector<TrainedRun> runs;
  std::vector<EmulatedOutput> outputs;
  std::string windows;  ///< the study's windows as they were averaged over, for the eye and to be compared

  /// nullptr if there is none.
  [[nodiscard]] const EmulatorInput* input(std::string_view name) const;
  [[nodiscard]] const EmulatedOutput* output(std::string_view name) const;
  /// Places (points x inputs) of points in study units.
  [[nodiscard]] Eigen::MatrixXd places(const Eigen::MatrixXd& values) const;
};

/// "Q2 = 0.84 on held-out runs, below 0.9"; empty where the output is good enough.
[[nodiscard]] std::string refusal_of(const EmulatedOutput& output);

/// `count` of the candidates (places, points x inputs) that tell most where the emulator knows least, in
/// order: each time the one whose run would take most off the variance of the emulated outputs, each relative
/// to its variance over the runs, over every eighth candidate, given the runs and the candidates taken before
/// (Cohn 1996, Neural Networks 9, 1071-1083; the largest variance itself lies in corners, which tell little
/// of the rest). Variances need no values, so that all are there at once. Fewer if there are fewer.
[[nodiscard]] std::vector<Eigen::Index> worst_places(const Emulator& emulator,
                                                     const Eigen::MatrixXd& candidates, Eigen::Index count);

}  // namespace cpt::results
