// What tables, figures and sentences of a calibration are made of.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/calibration/calibrate.hpp"
#include "diagnosis/calibration/rank_check.hpp"

namespace cpt::reports::calibrated {

struct ReportedInput {
  std::string name, symbol, unit;
  double lower = 0.0, upper = 1.0;   ///< what the emulator knows
  bool discrete = false;             ///< a choice or a whole number
  std::vector<std::string> choices;  ///< names of the values 0, 1, ...; empty of numbers
};

struct ReportedChannel {
  std::string name, symbol;  ///< "q_c", with what stands behind "_" a subscript
};

struct CalibrationReport {
  std::string title, study;
  int training_runs = 0;
  std::vector<std::string> soundings;
  std::vector<ReportedChannel> channels;  ///< of Posterior::bands
  std::vector<ReportedInput> inputs;      ///< of the first of Posterior::unknowns
  diagnosis::Posterior posterior;
  diagnosis::SamplerOptions limits;
  bool shifts_points = false;  ///< the study's runs draw where their points lie
};

struct RankReport {
  std::string title, study;
  int training_runs = 0;
  diagnosis::RankCheck check;
  std::uint64_t seed = 1;  ///< of the band's simulation
};

}  // namespace cpt::reports::calibrated
