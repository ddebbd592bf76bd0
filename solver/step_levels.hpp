// Local time steps: where the soil is soft or the mesh coarse, cells are updated every second, fourth ...
// step only (subcycling; Belytschko, Yen & Mullen 1979).
//
// A cell of level l starts a step of its own at every 2^l-th step and ends it 2^l steps later; a node follows
// the lowest level of the cells around it. In between, a cell's stresses and positions stand still and its
// forces on the nodes stay, while nodes that it shares with faster cells go on. Then it moves, over all of
// its step, with the velocities that its nodes have at the end: with their mean instead it would feed waves,
// as its own forces come half a step late (docs/numerics.md). Every 2^most steps, a cycle,
// all cells and nodes meet, and the levels are given anew.
#pragma once

#include <cstdint>
#include <vector>

#include "solver/mesh.hpp"

namespace cpt::solver {

/// The highest there may be: its cells are updated every sixteenth step.
inline constexpr int highest_level = 4;

class StepLevels {
 public:
  /// All cells and nodes at level 0.
  explicit StepLevels(const Mesh& mesh);

  /// Gives each cell the highest level up to `most` whose step its own stable one [s] of `stable` bears, so
  /// that cells that share a node differ by one at most. `step` [s] is that of level 0. To be called when all
  /// meet.
  void assign(const Mesh& mesh, const std::vector<double>& stable, double step, int most);

  /// Goes on by one step.
  void advance() { ++now_ &= (1 << most_) - 1; }
  /// All cells have reached the same time.
  [[nodiscard]] bool all_meet() const { return now_ == 0; }

  [[nodiscard]] int of_cell(std::int32_t c) const { return cell_[c]; }
  [[nodiscard]] int of_node(std::int32_t n) const { return node_[n]; }
  /// The highest level of the cells around a node.
  [[nodiscard]] int highest_around(std::int32_t n) const { return highest_[n]; }

  /// A step of the cell's, or of the node's, own begins with this one.
  [[nodiscard]] bool cell_starts(std::int32_t c) const { return starts(cell_[c]); }
  [[nodiscard]] bool node_starts(std::int32_t n) const { return starts(node_[n]); }
  [[nodiscard]] bool level_starts(int level) const { return starts(level); }
  /// One of the cell's nodes starts a step.
  [[nodiscard]] bool cell_feels(std::int32_t c) const { return starts(lowest_node_[c]); }
  /// The cell's own step ends with this one.
  [[nodiscard]] bool cell_ends(std::int32_t c) const { return ((now_ + 1) & ((1 << cell_[c]) - 1)) == 0; }

 private:
  [[nodiscard]] bool starts(int level) const { return (now_ & ((1 << level) - 1)) == 0; }
  void follow_cells(const Mesh& mesh);

  std::vector<std::int8_t> cell_, node_, highest_, lowest_node_;
  int most_ = 0;  // of the levels given
  int now_ = 0;   // steps since all met
};

}  // namespace cpt::solver
