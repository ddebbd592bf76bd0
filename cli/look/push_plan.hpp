// campaign push: what the command line asks for, checked against the study.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "parameters/realization.hpp"
#include "results/push/push_recorder.hpp"

namespace cpt::cli {

/// As on the command line.
struct PushArguments {
  std::filesystem::path study;
  int id = 1;
  std::vector<std::string> settings;  // name=value
  std::vector<std::string> fields_at, track, wall_between;
  double fields_every = 0.0;  // [m]; 0: at no further depths
  std::string radial_between;
  std::filesystem::path folder;
  int threads = 0;
  bool keep = false;
};

/// One push: its input, what to record, and where that goes.
struct Push {
  parameters::Study study;
  parameters::Realization realization;
  solver::Setup setup;
  results::PushRequest request;
  results::DepthInterval radial_between{};
  std::filesystem::path folder;
  std::string name;  // of the files

  [[nodiscard]] std::filesystem::path file(std::string_view ending) const {
    return folder / (name + std::string(ending));
  }
};

/// Throws BadInput for an input or a place that cannot be.
[[nodiscard]] Push plan_push(const PushArguments& arguments);

/// Attributes of the histories: study and realization, every input, what was recorded, versions.
[[nodiscard]] std::map<std::string, std::string> origin_of(const Push& push, solver::Status status);

/// Whether the push's folder holds this very push, completed: the same inputs, solver and recording.
[[nodiscard]] bool is_recorded(const Push& push);

}  // namespace cpt::cli
