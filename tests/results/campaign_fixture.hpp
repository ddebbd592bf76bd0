// A small study and made-up outcomes, to drive the ledger as a campaign does.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "parameters/all_realizations.hpp"
#include "parameters/realization.hpp"
#include "parameters/study.hpp"
#include "results/ledger/ledger.hpp"
#include "results/ledger/snapshot.hpp"
#include "solver/quantities.hpp"

namespace cpt::results {

/// A folder of its own for each test, removed at the end.
class ScratchFolder : public ::testing::Test {
 protected:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "cpt_results_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no scratch folder");
    folder = name;
  }
  ~ScratchFolder() override { std::filesystem::remove_all(folder); }
  std::filesystem::path folder;
};

inline parameters::Row row(std::string_view name, double lower, double baseline, double upper) {
  return {solver::find_quantity(name), baseline, lower, upper};
}

/// Five rows: two-sided, one-sided above (N), one-sided below (radius), a choice and one more number; 8
/// bounds.
inline parameters::Study sand_study(const std::filesystem::path& folder) {
  parameters::Study study;
  study.file = folder / "sand.toml";
  study.name = "sand";
  study.title = "Homogeneous sand";
  study.profile = solver::Profile::homogeneous_sand;
  study.preset = solver::Preset::quick;
  study.baseline = solver::make_setup(study.profile, study.preset);
  study.rows = {row("sand.H", 20, 25, 75), row("sand.N", 0.1, 0.1, 0.3),
                row("chamber.radius_m", 0.30, 0.45, 0.45), row("chamber.wall", 0, 1, 1),
                row("initial.sigma_h0_kPa", 15, 25, 35)};
  study.windows = {{"deep", parameters::Window::Kind::fixed, 0.30, 0.32, 0.0},
                   {"peak", parameters::Window::Kind::peak, 0.10, 0.20, 0.010}};
  study.database = folder / "sand.sqlite";
  study.curves = folder / "sand.h5";
  study.report_dir = folder / "sand-report";
  study.wall_limit_seconds = std::numeric_limits<double>::infinity();
  return study;
}

/// A curve that rises with depth, with a bump at 0.15 m and digits that no rounding survives.
inline solver::DepthProfile curve(double level_Pa) {
  solver::DepthProfile profile;
  for (int i = 0; i < 800; ++i) {
    const double depth = (i + 0.5) * 0.0005;
    profile.depth.push_back(depth);
    profile.q_c.push_back(level_Pa * (std::sqrt(depth) + 0.8 * std::exp(-std::pow((depth - 0.15) / 0.02, 2)) +
                                      0.01 * std::sin(977.0 * depth)));
    profile.f_s.push_back(profile.q_c.back() / 137.0);
  }
  return profile;
}

inline solver::Outcome completed(double level_Pa) {
  solver::Outcome outcome;
  outcome.status = solver::Status::completed;
  outcome.profile = curve(level_Pa);
  outcome.audit = {1e-16, 2e-4, 3e-3, 0.01, 2, 1e-5, 2e-5};
  outcome.steps = 12345;
  outcome.material_points = 11999;
  outcome.wall_seconds = 1.5;
  return outcome;
}

inline solver::Outcome failed(solver::Status status, std::string reason) {
  solver::Outcome outcome;
  outcome.status = status;
  outcome.reason = std::move(reason);
  return outcome;
}

inline Ledger open(const parameters::Study& study, bool retry_failed = false) {
  return Ledger::open_for_run(study, parameters::all_realizations(study), {"[study]\n", retry_failed});
}

/// Everything in the database but times, as text: equal texts mean equal campaigns.
std::string dump_without_times(const std::filesystem::path& database);

}  // namespace cpt::results
