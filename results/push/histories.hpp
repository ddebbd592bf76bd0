// What happened to material points and at the wall while the cone went down, as an HDF5 file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "results/files/error.hpp"
#include "results/push/soil_at_end.hpp"
#include "solver/simulate.hpp"

namespace cpt::results {

/// A place in the chamber.
struct Place {
  double r;      // [m] from the axis
  double depth;  // [m] below the soil's top
  bool operator==(const Place&) const = default;
};

/// Depths below the soil's top, both ends included.
struct DepthInterval {
  double from, to;  // [m]
  bool operator==(const DepthInterval&) const = default;
};

/// One number over the push, a value for each row of Histories::tip_depth.
struct HistoryColumn {
  std::string unit;
  std::vector<double> values;
  bool operator==(const HistoryColumn&) const = default;
};
using HistoryColumns = std::map<std::string, HistoryColumn>;

/// A material point that was followed: the one in the soil that was nearest to the wanted place at the start.
struct PointHistory {
  Place wanted;
  Place start;  ///< where it was
  std::int64_t id = 0;
  std::string material;
  HistoryColumns columns;  ///< "stress_rr", ... as point_quantities() lists them
  bool operator==(const PointHistory&) const = default;
};

/// Stresses beside the wall: the mean, weighted by volume, over the outermost column of material points of
/// the soil between two depths, or of the one nearest to their middle if none lies between.
struct WallHistory {
  DepthInterval between;
  int points = 0;
  HistoryColumns columns;  ///< sigma_r and sigma_v [Pa], compression-positive
  bool operator==(const WallHistory&) const = default;
};

struct Histories {
  std::map<std::string, std::string> origin;  ///< attributes of the file's root: study, inputs, versions, ...
  std::vector<double> tip_depth;              // [m] one row each: the start, then the end of each depth bin
  std::vector<PointHistory> points;
  std::vector<WallHistory> walls;
  solver::DepthProfile profile;
  SoilAtEnd end;
};

/// Writes the file whole (docs/output.md describes it); throws Error.
void write_histories(const std::filesystem::path& file, const Histories& histories);

/// Throws Error if the file is missing or damaged.
[[nodiscard]] Histories read_histories(const std::filesystem::path& file);

}  // namespace cpt::results
