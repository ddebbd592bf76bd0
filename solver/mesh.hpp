// Structured quadrilaterals with vertical sides that follow the penetrometer.
//
// Column lines are fixed in r. Row lines are sheared inside the cone's radius, so that one of them lies on
// the conical face; one column line lies on the shaft. A zone of rows around the tip moves with the cone; the
// rows below it compress towards the chamber's bottom, the rows above it stretch (moving and compressing
// mesh: Beuth 2012; Al-Kafaji 2013). Beyond a radius, rows are joined two by two; the mid-side nodes on that
// column line hang between their neighbours. Cells inside the penetrometer do not exist.
//
// z points upward and is zero at the soil's top, so the depth of the tip is -z.
#pragma once

#include <cstdint>
#include <vector>

#include "solver/setup.hpp"

namespace cpt::solver {

/// Shape of one cell at the mesh's present position. Bottom and top edges are linear in the natural
/// coordinate xi in [-1, 1]: z_bottom(xi) = zb0 + zb1 xi, z_top(xi) = zt0 + zt1 xi.
struct CellShape {
  double r_c, a;    // [m] radius of the centre, half width
  double zb0, zb1;  // [m]
  double zt0, zt1;  // [m]
};

/// Where a point lies: its cell and natural coordinates, clamped to the cell at the outer boundaries.
struct Location {
  std::int32_t cell;
  double xi, eta;
};

/// What a cell is made of; does not change as the mesh moves.
struct Cell {
  std::int32_t column;       // left column line
  std::int32_t bottom, top;  // row lines
  std::int32_t node[4];      // bottom left, bottom right, top right, top left
  // Natural coordinates beyond which a point has left the cell; infinite at the walls, axis, bottom, top and
  // shaft.
  double xi_min, xi_max, eta_min, eta_max;
};

/// A node between two others on the line where rows are joined: value = (1 - weight) lower + weight upper.
struct HangingNode {
  std::int32_t node, lower, upper;
  std::int32_t line, line_lower, line_upper;
};

/// Cells that meet at a node: cell index and local corner, -1 where there is none. Fixed order.
struct NodeCells {
  std::int32_t cell[4];
  std::int32_t corner[4];
};

/// The lines that make a mesh, at its start.
struct MeshLayout {
  std::vector<double> r;       // [m] column lines, from the axis to the wall
  std::vector<double> offset;  // [m] offset of the conical face below the shoulder at each column line, <= 0
  std::vector<double> y;       // [m] row lines at and beyond the cone's radius, from the bottom upward
  std::vector<double> shear;   // [-] share of `offset` that each row line follows
  std::int32_t i_cone = 0;     // column line on the shaft; 0 without a penetrometer
  std::int32_t i_joined = 0;   // column line beyond which rows are joined two by two
  std::int32_t j_zone_bottom = 0, j_face = 0, j_zone_top = 0;  // row lines that move with the cone
  double tip_depth = 0.0;                                      // [m]
};

/// The chamber with the cone wished in place: the shoulder level with the soil's top.
[[nodiscard]] MeshLayout chamber_layout(const Setup& setup);

class Mesh {
 public:
  explicit Mesh(MeshLayout layout);

  /// Puts the tip at this depth [m] and moves all row lines accordingly.
  void move_tip_to(double depth);
  /// Puts the column lines elsewhere [m]; as many as there are.
  void move_columns_to(const std::vector<double>& r) { start_.r = r; }

  [[nodiscard]] CellShape shape(const Cell& cell) const;
  /// Cell and natural coordinates of a point anywhere; points outside the domain or inside the penetrometer
  /// are clamped to the nearest boundary cell.
  [[nodiscard]] Location locate(double r, double z) const;

  /// Puts a point that lies inside the penetrometer on the nearest point of its surface; others stay.
  void move_outside(double& r, double& z) const;

  [[nodiscard]] const std::vector<Cell>& cells() const { return cells_; }
  [[nodiscard]] const std::vector<NodeCells>& node_cells() const { return node_cells_; }
  [[nodiscard]] const std::vector<HangingNode>& hanging_nodes() const { return hanging_; }
  [[nodiscard]] double hanging_weight(const HangingNode& node) const;
  [[nodiscard]] std::int32_t node_count() const { return static_cast<std::int32_t>(node_cells_.size()); }
  [[nodiscard]] double node_r(std::int32_t node) const { return start_.r[node_column_[node]]; }
  [[nodiscard]] double node_z(std::int32_t node) const {
    return line_z(node_column_[node], node_line_[node]);
  }

  // Boundary nodes, from the axis outward or from bottom to top.
  [[nodiscard]] const std::vector<std::int32_t>& axis_nodes() const { return axis_; }
  [[nodiscard]] const std::vector<std::int32_t>& bottom_nodes() const { return bottom_; }
  [[nodiscard]] const std::vector<std::int32_t>& wall_nodes() const { return wall_; }
  /// Nodes on the conical face from the tip to the shoulder (both included).
  [[nodiscard]] const std::vector<std::int32_t>& face_nodes() const { return face_; }
  /// Nodes on the shaft from the one above the shoulder upward.
  [[nodiscard]] const std::vector<std::int32_t>& shaft_nodes() const { return shaft_; }

  [[nodiscard]] const std::vector<double>& column_lines() const { return start_.r; }
  [[nodiscard]] double top() const { return y_.back(); }
  [[nodiscard]] double bottom() const { return y_.front(); }
  [[nodiscard]] double tip_depth() const { return tip_depth_; }

 private:
  [[nodiscard]] double line_z(std::int32_t column, std::int32_t line) const {
    return y_[line] + start_.shear[line] * start_.offset[column];
  }
  [[nodiscard]] std::int32_t node_index(std::int32_t column, std::int32_t line) const;
  void build_cells();
  void build_nodes();

  MeshLayout start_;
  std::vector<double> y_;  // [m] row lines now
  double tip_depth_ = 0.0;

  std::vector<Cell> cells_;
  std::vector<std::int32_t> column_start_;  // first cell of each column
  std::vector<std::int32_t> node_start_;    // first node of each column line
  std::vector<std::int32_t> node_column_, node_line_;
  std::vector<NodeCells> node_cells_;
  std::vector<HangingNode> hanging_;
  std::vector<std::int32_t> axis_, bottom_, wall_, face_, shaft_;
};

}  // namespace cpt::solver
