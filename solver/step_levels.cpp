#include "solver/step_levels.hpp"

#include <algorithm>

namespace cpt::solver {

StepLevels::StepLevels(const Mesh& mesh)
    : cell_(mesh.cells().size(), 0),
      node_(static_cast<std::size_t>(mesh.node_count()), 0),
      highest_(node_),
      lowest_node_(cell_) {}

// A hanging node moves with its two neighbours, and what acts on it acts on them.
void StepLevels::follow_cells(const Mesh& mesh) {
  std::ranges::fill(node_, static_cast<std::int8_t>(highest_level));
  for (std::size_t c = 0; c < cell_.size(); ++c)
    for (const std::int32_t n : mesh.cells()[c].node) node_[n] = std::min(node_[n], cell_[c]);
  for (const HangingNode& h : mesh.hanging_nodes()) {
    node_[h.lower] = std::min(node_[h.lower], node_[h.node]);
    node_[h.upper] = std::min(node_[h.upper], node_[h.node]);
  }
  for (const HangingNode& h : mesh.hanging_nodes()) node_[h.node] = std::min(node_[h.lower], node_[h.upper]);
  for (std::size_t c = 0; c < cell_.size(); ++c) {
    lowest_node_[c] = highest_level;
    for (const std::int32_t n : mesh.cells()[c].node) lowest_node_[c] = std::min(lowest_node_[c], node_[n]);
  }
}

void StepLevels::assign(const Mesh& mesh, const std::vector<double>& stable, double step, int most) {
  for (std::size_t c = 0; c < cell_.size(); ++c) {
    std::int8_t level = 0;
    while (level < most && stable[c] >= step * static_cast<double>(2 << level)) ++level;
    cell_[c] = level;
  }
  // Each pass carries the limit one cell further.
  for (int pass = 0; pass < most; ++pass) {
    follow_cells(mesh);
    for (std::size_t c = 0; c < cell_.size(); ++c)
      cell_[c] = std::min(cell_[c], static_cast<std::int8_t>(lowest_node_[c] + 1));
  }
  follow_cells(mesh);
  std::ranges::fill(highest_, static_cast<std::int8_t>(0));
  for (std::size_t c = 0; c < cell_.size(); ++c)
    for (const std::int32_t n : mesh.cells()[c].node) highest_[n] = std::max(highest_[n], cell_[c]);
  most_ = cell_.empty() ? 0 : *std::ranges::max_element(cell_);
}

}  // namespace cpt::solver
