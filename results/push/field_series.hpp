// Fields of a push at chosen depths of the tip, one .vtu a depth and a .pvd over all of them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "results/files/vtk_file.hpp"
#include "results/push/point_quantities.hpp"
#include "solver/point_states.hpp"

namespace cpt::results {

class FieldSeries {
 public:
  /// Files go to `folder`, made if need be; the series is FOLDER/NAME.pvd. `origin` says where the data come
  /// from. Throws Error if the folder cannot be made.
  FieldSeries(std::filesystem::path folder, std::string name, std::string origin,
              std::vector<PointQuantity> quantities);

  /// Writes NAME-DEPTHm.vtu, named by the depth that was asked for, and brings the series level. `now` and
  /// `start` hold the same points in the same order. Throws Error.
  void add(double wanted_depth, double depth, const std::vector<solver::PointState>& now,
           const std::vector<solver::PointState>& start);

  [[nodiscard]] std::filesystem::path file() const;
  [[nodiscard]] std::size_t size() const { return frames_.size(); }

 private:
  std::filesystem::path folder_;
  std::string name_, origin_;
  std::vector<PointQuantity> quantities_;
  std::vector<VtkFrame> frames_;
};

}  // namespace cpt::results
