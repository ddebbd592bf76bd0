// From the cells' sums to the motion of the nodes: stages 1 and 2 of a step, and the time step with its
// levels.
#include <algorithm>
#include <cmath>

#include "solver/for_each_index.hpp"
#include "solver/model.hpp"

namespace cpt::solver {
namespace {

constexpr double corner_xi[4] = {-1.0, 1.0, 1.0, -1.0};
constexpr double corner_eta[4] = {-1.0, -1.0, 1.0, 1.0};

}  // namespace

void Model::compute_nodal_forces() {
  const auto cells = static_cast<std::int32_t>(sums_.size());
  CellForceSettings settings{};
  settings.courant = settings_.courant;
  settings.mass_scaling = settings_.mass_scaling;
  settings.bulk_viscosity = settings_.bulk_viscosity;
  settings.gravity = settings_.gravity;
  settings.materials = settings_.materials;
  std::copy_n(settings_.weight_ratio, most_materials, settings.weight_ratio);
  settings.partial_cells = settings_.partial_cells;
  const CellArrays arrays = {sums_.data(),       shapes_.data(),     modulus_.data(),
                             divergence_.data(), least_step_.data(), forces_.data()};
  if (levels_.all_meet()) std::ranges::fill(least_step_, 0.0);
  // The cells of a block that stand still get again what they have.
  for_each_index((cells + cells_at_once - 1) / cells_at_once, settings_.threads, [&](std::int32_t block) {
    const std::int32_t first = block * cells_at_once, end = std::min(first + cells_at_once, cells);
    bool any_starts = false;
    for (std::int32_t c = first; c < end; ++c) any_starts = any_starts || levels_.cell_starts(c);
    if (!any_starts) return;
    compute_cell_forces_(settings, arrays, first, end);
    if (settings_.partial_cells)
      for (std::int32_t c = first; c < end; ++c) add_surface_loads(c, forces_[c]);
  });
  if (levels_.all_meet()) begin_cycle();
  for_each_index(mesh_.node_count(), settings_.threads, [this](std::int32_t n) {
    if (levels_.node_starts(n)) assemble_node(n);
  });
  condense({&nodes_.inertia, &nodes_.mass, &nodes_.force.r, &nodes_.force.z, &p_r_, &p_z_});
  for_each_index(mesh_.node_count(), settings_.threads, [this](std::int32_t n) {
    if (!levels_.node_starts(n)) return;
    const double inverse = nodes_.mass[n] > 0.0 ? 1.0 / nodes_.mass[n] : 0.0;
    nodes_.velocity.r[n] = p_r_[n] * inverse;
    nodes_.velocity.z[n] = p_z_[n] * inverse;
  });
}

void Model::follow_every_step(std::int32_t node) {
  const NodeCells& around = mesh_.node_cells()[node];
  for (int i = 0; i < 4 && around.cell[i] >= 0; ++i) every_step_[around.cell[i]] = 1;
}

// All cells meet: the next time step and the levels for it. Until they meet again a cell that stiffens gets
// the inertia that its level needs.
void Model::begin_cycle() {
  const auto cells = static_cast<std::int32_t>(forces_.size());
  time_step_ = settings_.longest_step;
  for (const CellForces& f : forces_) time_step_ = std::min(time_step_, f.time_step);
  if (settings_.most_level == 0) return;
  for (std::int32_t c = 0; c < cells; ++c) stable_[c] = every_step_[c] ? time_step_ : forces_[c].time_step;
  int most = settings_.most_level;
  while (most > 0 && time_step_ * static_cast<double>(1 << most) > settings_.longest_step) --most;
  levels_.assign(mesh_, stable_, time_step_, most);
  const double b = settings_.bulk_viscosity;
  const double inertial = time_step_ / (settings_.courant * (std::sqrt(1.0 + b * b) - b));
  for (std::int32_t c = 0; c < cells; ++c)
    least_step_[c] = inertial * static_cast<double>(1 << levels_.of_cell(c));
}

// A traction at the soil's top rides on the topmost material points.
void Model::add_surface_loads(std::int32_t c, CellForces& forces) const {
  for (std::int32_t m = 0; m < settings_.materials; ++m) {
    const Bucket& bucket = points_.bucket(c * settings_.materials + m);
    const PointFields p = points_.fields(bucket);
    for (std::int32_t i = 0; i < bucket.count; ++i) {
      if (p.load[i] == 0.0) continue;
      for (int k = 0; k < 4; ++k)
        forces.f_z[k] -= p.load[i] * 0.25 * (1.0 + corner_xi[k] * p.xi[i]) * (1.0 + corner_eta[k] * p.eta[i]);
    }
  }
}

void Model::assemble_node(std::int32_t n) {
  const NodeCells& around = mesh_.node_cells()[n];
  double inertia = 0.0, mass = 0.0, p_r = 0.0, p_z = 0.0, f_r = 0.0, f_z = 0.0;
  for (int i = 0; i < 4 && around.cell[i] >= 0; ++i) {
    const CellForces& forces = forces_[around.cell[i]];
    const CellSums& sums = sums_[around.cell[i]];
    const std::int32_t k = around.corner[i];
    inertia += forces.inertia[k];
    f_r += forces.f_r[k];
    f_z += forces.f_z[k];
    mass += corner_mass(sums, k);
    p_r += sums.p_r[k];
    p_z += sums.p_z[k];
  }
  nodes_.inertia[n] = inertia;
  nodes_.mass[n] = mass;
  nodes_.force.r[n] = f_r;
  nodes_.force.z[n] = f_z;
  p_r_[n] = p_r;
  p_z_[n] = p_z;
}

void Model::accelerate(double dt) {
  const double damping = settings_.local_damping;
  holds_.clear();
  for_each_index(mesh_.node_count(), settings_.threads, [&](std::int32_t n) {
    if (!levels_.node_starts(n)) {
      nodes_.change.r[n] = nodes_.change.z[n] = 0.0;
      return;
    }
    double f_r = nodes_.force.r[n], f_z = nodes_.force.z[n];
    if (damping > 0.0) {
      f_r -= damping * std::copysign(std::abs(f_r), nodes_.velocity.r[n]);
      f_z -= damping * std::copysign(std::abs(f_z), nodes_.velocity.z[n]);
    }
    const double factor = nodes_.inertia[n] > 0.0 ? step_of_node(n, dt) / nodes_.inertia[n] : 0.0;
    nodes_.change.r[n] = f_r * factor;
    nodes_.change.z[n] = f_z * factor;
    nodes_.velocity.r[n] += nodes_.change.r[n];
    nodes_.velocity.z[n] += nodes_.change.z[n];
  });
}

void Model::set_velocity(std::int32_t node, double v_r, double v_z) {
  nodes_.change.r[node] += v_r - nodes_.velocity.r[node];
  nodes_.change.z[node] += v_z - nodes_.velocity.z[node];
  nodes_.velocity.r[node] = v_r;
  nodes_.velocity.z[node] = v_z;
}

}  // namespace cpt::solver
