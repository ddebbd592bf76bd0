#include "solver/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cpt::solver {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Even number of rows about `height` high, at least two: rows are joined in pairs.
int even_rows(double extent, double height) {
  return std::max(2, 2 * static_cast<int>(std::lround(extent / height / 2.0)));
}

void append_lines(std::vector<double>& lines, double to, int count) {
  const double from = lines.back();
  for (int k = 1; k <= count; ++k) lines.push_back(k == count ? to : from + (to - from) * k / count);
}

void build_columns(const Setup& setup, MeshLayout& layout) {
  const Numerics& numerics = setup.numerics;
  const double R_cone = setup.penetrometer.diameter / 2.0;
  const double R = setup.chamber.radius;
  const double near_width = R_cone / numerics.face_elements;

  std::vector<double>& r = layout.r;
  r = {0.0};
  append_lines(r, R_cone, numerics.face_elements);
  layout.i_cone = numerics.face_elements;
  const double near_end = std::clamp(numerics.near_width_radius, R_cone, R);
  const int near_columns = static_cast<int>(std::lround((near_end - R_cone) / near_width));
  if (near_columns > 0) append_lines(r, R_cone + near_columns * near_width, near_columns);

  // Widths grow geometrically to the far width, then everything beyond the near columns is scaled to the
  // wall.
  const std::size_t first = r.size() - 1;
  double width = near_width;
  while (r.back() < R - 1e-12) {
    width = std::min(width * numerics.width_growth, numerics.far_width);
    r.push_back(r.back() + width);
  }
  if (r.size() - first > 2 && r.back() - R > width / 2.0) r.pop_back();
  const double scale = (R - r[first]) / (r.back() - r[first]);
  for (std::size_t i = first + 1; i < r.size(); ++i) r[i] = r[first] + (r[i] - r[first]) * scale;
  r.back() = R;

  // The last line within the radius: beyond it fine rows would be lower than the spacing of the points there.
  layout.i_joined = layout.i_cone;
  while (layout.i_joined + 1 < static_cast<std::int32_t>(r.size()) &&
         r[layout.i_joined + 1] <= numerics.coarse_rows_radius + 1e-9)
    ++layout.i_joined;

  const double slope = 1.0 / std::tan(setup.penetrometer.apex / 2.0);
  for (const double radius : r) layout.offset.push_back(std::min(radius - R_cone, 0.0) * slope);
}

void build_rows(const Setup& setup, MeshLayout& layout) {
  const Numerics& numerics = setup.numerics;
  const double face_height = -layout.offset.front();
  layout.tip_depth = face_height;
  const double z_bottom = -setup.chamber.soil_height;
  const double z_zone_bottom = -face_height - numerics.zone_below;
  const double z_zone_top = numerics.zone_above;
  const double z_top = setup.chamber.surcharge_height;

  std::vector<double>& y = layout.y;
  y = {z_bottom};
  layout.j_zone_bottom = even_rows(z_zone_bottom - z_bottom, numerics.below_height);
  append_lines(y, z_zone_bottom, layout.j_zone_bottom);
  const int under = even_rows(-z_zone_bottom, numerics.near_height);
  append_lines(y, 0.0, under);
  layout.j_face = layout.j_zone_bottom + under;
  const int over = even_rows(z_zone_top, numerics.near_height);
  append_lines(y, z_zone_top, over);
  layout.j_zone_top = layout.j_face + over;
  append_lines(y, z_top, even_rows(z_top - z_zone_top, numerics.above_height));

  layout.shear.assign(y.size(), 0.0);
  for (int j = layout.j_zone_bottom; j <= layout.j_face; ++j)
    layout.shear[j] = static_cast<double>(j - layout.j_zone_bottom) / static_cast<double>(under);
}

}  // namespace

MeshLayout chamber_layout(const Setup& setup) {
  MeshLayout layout;
  build_columns(setup, layout);
  build_rows(setup, layout);
  return layout;
}

Mesh::Mesh(MeshLayout layout) : start_(std::move(layout)), y_(start_.y), tip_depth_(start_.tip_depth) {
  build_cells();
  build_nodes();
}

void Mesh::move_tip_to(double depth) {
  tip_depth_ = depth;
  const double travel = depth - start_.tip_depth;
  const double bottom = start_.y.front(), top = start_.y.back();
  const double zone_bottom0 = start_.y[start_.j_zone_bottom], zone_top0 = start_.y[start_.j_zone_top];
  const double squeeze = (zone_bottom0 - travel - bottom) / (zone_bottom0 - bottom);
  const double stretch = (top - zone_top0 + travel) / (top - zone_top0);
  for (std::int32_t j = 0; j < static_cast<std::int32_t>(y_.size()); ++j) {
    if (j < start_.j_zone_bottom)
      y_[j] = bottom + (start_.y[j] - bottom) * squeeze;
    else if (j <= start_.j_zone_top)
      y_[j] = start_.y[j] - travel;
    else
      y_[j] = top - (top - start_.y[j]) * stretch;
  }
}

std::int32_t Mesh::node_index(std::int32_t column, std::int32_t line) const {
  return node_start_[column] + (column > start_.i_joined ? line / 2 : line);
}

void Mesh::build_cells() {
  const auto lines = static_cast<std::int32_t>(y_.size());
  const auto columns = static_cast<std::int32_t>(start_.r.size());

  std::int32_t nodes = 0;
  for (std::int32_t i = 0; i < columns; ++i) {
    node_start_.push_back(nodes);
    const std::int32_t last = i < start_.i_cone ? start_.j_face : lines - 1;
    const std::int32_t step = i > start_.i_joined ? 2 : 1;
    for (std::int32_t j = 0; j <= last; j += step) {
      node_column_.push_back(i);
      node_line_.push_back(j);
      ++nodes;
    }
  }

  for (std::int32_t c = 0; c + 1 < columns; ++c) {
    column_start_.push_back(static_cast<std::int32_t>(cells_.size()));
    const std::int32_t last = c < start_.i_cone ? start_.j_face : lines - 1;
    const std::int32_t step = c >= start_.i_joined ? 2 : 1;
    for (std::int32_t j = 0; j < last; j += step) {
      Cell cell{};
      cell.column = c;
      cell.bottom = j;
      cell.top = j + step;
      cell.node[0] = node_index(c, j);
      cell.node[1] = node_index(c + 1, j);
      cell.node[2] = node_index(c + 1, j + step);
      cell.node[3] = node_index(c, j + step);
      const bool on_shaft = c == start_.i_cone && j >= start_.j_face;
      cell.xi_min = c == 0 || on_shaft ? -infinity : -1.0;
      cell.xi_max = c + 2 == columns ? infinity : 1.0;
      cell.eta_min = j == 0 ? -infinity : -1.0;
      cell.eta_max = j + step == lines - 1 ? infinity : 1.0;
      cells_.push_back(cell);
    }
  }
  column_start_.push_back(static_cast<std::int32_t>(cells_.size()));
}

void Mesh::build_nodes() {
  node_cells_.assign(node_column_.size(), NodeCells{{-1, -1, -1, -1}, {0, 0, 0, 0}});
  for (std::int32_t c = 0; c < static_cast<std::int32_t>(cells_.size()); ++c)
    for (std::int32_t k = 0; k < 4; ++k) {
      NodeCells& around = node_cells_[cells_[c].node[k]];
      std::int32_t slot = 0;
      while (around.cell[slot] >= 0) ++slot;
      around.cell[slot] = c;
      around.corner[slot] = k;
    }

  const auto columns = static_cast<std::int32_t>(start_.r.size());
  const auto lines = static_cast<std::int32_t>(y_.size());
  if (start_.i_joined < columns - 1)
    for (std::int32_t j = 1; j < lines; j += 2)
      hanging_.push_back({node_index(start_.i_joined, j), node_index(start_.i_joined, j - 1),
                          node_index(start_.i_joined, j + 1), j, j - 1, j + 1});

  for (std::int32_t j = 0; j <= start_.j_face; ++j) axis_.push_back(node_index(0, j));
  for (std::int32_t i = 0; i < columns; ++i) bottom_.push_back(node_index(i, 0));
  for (std::int32_t n = node_start_.back(); n < node_count(); ++n) wall_.push_back(n);
  for (std::int32_t i = 0; i <= start_.i_cone; ++i) face_.push_back(node_index(i, start_.j_face));
  for (std::int32_t j = start_.j_face + 1; j < lines; ++j) shaft_.push_back(node_index(start_.i_cone, j));
}

double Mesh::hanging_weight(const HangingNode& node) const {
  return (y_[node.line] - y_[node.line_lower]) / (y_[node.line_upper] - y_[node.line_lower]);
}

CellShape Mesh::shape(const Cell& cell) const {
  const double r0 = start_.r[cell.column], r1 = start_.r[cell.column + 1];
  const double bl = line_z(cell.column, cell.bottom), br = line_z(cell.column + 1, cell.bottom);
  const double tl = line_z(cell.column, cell.top), tr = line_z(cell.column + 1, cell.top);
  return {(r0 + r1) / 2.0, (r1 - r0) / 2.0, (bl + br) / 2.0,
          (br - bl) / 2.0, (tl + tr) / 2.0, (tr - tl) / 2.0};
}

Location Mesh::locate(double r, double z) const {
  const auto columns = static_cast<std::int32_t>(start_.r.size()) - 1;
  const auto above = std::upper_bound(start_.r.begin(), start_.r.end(), r);
  auto c = std::clamp(static_cast<std::int32_t>(above - start_.r.begin()) - 1, 0, columns - 1);
  // Inside the penetrometer: above the shoulder a point belongs to the shaft's column, else to the face's
  // cell.
  if (c < start_.i_cone && z > y_[start_.j_face]) c = start_.i_cone;

  const std::int32_t step = c >= start_.i_joined ? 2 : 1;
  const std::int32_t rows = column_start_[c + 1] - column_start_[c];
  const double r_c = (start_.r[c] + start_.r[c + 1]) / 2.0, a = (start_.r[c + 1] - start_.r[c]) / 2.0;
  const double xi = std::clamp((r - r_c) / a, -1.0, 1.0);
  const auto z_at = [&](std::int32_t line) {
    return 0.5 * ((1.0 - xi) * line_z(c, line) + (1.0 + xi) * line_z(c + 1, line));
  };
  std::int32_t low = 0, high = rows;  // row `low` starts at or below z
  while (high - low > 1) {
    const std::int32_t middle = (low + high) / 2;
    (z >= z_at(middle * step) ? low : high) = middle;
  }
  const double zb = z_at(low * step), zt = z_at((low + 1) * step);
  const double eta = std::clamp(2.0 * (z - zb) / (zt - zb) - 1.0, -1.0, 1.0);
  return {column_start_[c] + low, xi, eta};
}

void Mesh::move_outside(double& r, double& z) const {
  const double R = start_.r[start_.i_cone];
  if (r >= R) return;
  const double above_tip = z + tip_depth_, slope = -start_.offset.front() / R;
  const double inside = above_tip - slope * r;  // height above the face
  if (inside <= 0.0) return;
  if (z > y_[start_.j_face]) {
    r = R;
    return;
  }
  r += inside * slope / (1.0 + slope * slope);
  z -= inside / (1.0 + slope * slope);
}

}  // namespace cpt::solver
