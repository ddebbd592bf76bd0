#include "solver/chamber.hpp"

#include <algorithm>
#include <cmath>

#include "solver/initial_state.hpp"

namespace cpt::solver {

ChamberBoundary::ChamberBoundary(const Setup& setup, const Mesh& mesh, const LeftBehind& left)
    : setup_(setup),
      left_(left),
      free_wall_(setup.chamber.wall == Wall::flexible || setup.mechanisms.compliant_wall.on()),
      friction_(setup.mechanisms.wall_friction.on()),
      applied_(mesh.wall_nodes().size()),
      reaction_(mesh.wall_nodes().size()),
      displacement_(setup.chamber.soil_height) {
  z_.reserve(mesh.wall_nodes().size());
  v_r_.reserve(mesh.wall_nodes().size());
}

// The soil's side has the radial stress of its start, and more where a compliant wall resists; the
// surcharge's side stays rigid.
void ChamberBoundary::apply_wall_stress(Model& model) {
  wall_force_ = 0.0;
  std::ranges::fill(applied_, 0.0);
  if (!free_wall_ && !friction_) return;
  const CompliantWall& compliant = setup_.mechanisms.compliant_wall;
  const Mesh& mesh = model.mesh();
  const std::vector<std::int32_t>& wall = mesh.wall_nodes();
  const double R = setup_.chamber.radius;
  for (std::size_t k = 0; k + 1 < wall.size(); ++k) {
    const double z0 = mesh.node_z(wall[k]), z1 = std::min(mesh.node_z(wall[k + 1]), 0.0);
    if (z0 >= 0.0) break;
    // Linear stress on the edge, two Gauss points.
    const double edge = mesh.node_z(wall[k + 1]) - z0;
    for (const double g : {0.21132486540518713, 0.78867513459481287}) {
      const double z = z0 + g * (z1 - z0), N1 = (z - z0) / edge;
      if (free_wall_) {
        double stress = horizontal_stress(setup_, left_, z);
        if (compliant.on()) stress += compliant.stress(displacement_.at(z));
        const double force = stress * R * (z1 - z0) / 2.0;
        model.nodes().force.r[wall[k]] -= (1.0 - N1) * force;
        model.nodes().force.r[wall[k + 1]] -= N1 * force;
        applied_[k] += (1.0 - N1) * force;
        applied_[k + 1] += N1 * force;
      }
      if (friction_) {
        const double force = wall_shear(setup_, left_, z) * R * (z1 - z0) / 2.0;
        model.nodes().force.z[wall[k]] += (1.0 - N1) * force;
        model.nodes().force.z[wall[k + 1]] += N1 * force;
        wall_force_ += force;
      }
    }
  }
}

double ChamberBoundary::fix_boundaries(Model& model, double dt) {
  const Mesh& mesh = model.mesh();
  const Nodes& nodes = model.nodes();
  const auto fix = [&model, &nodes](std::int32_t n, bool in_r) {
    model.set_velocity(n, in_r ? 0.0 : nodes.velocity.r[n], in_r ? nodes.velocity.z[n] : 0.0);
    model.hold({n, in_r ? 1.0 : 0.0, in_r ? 0.0 : 1.0, 0.0, false});
  };
  const auto starts = [&model](std::int32_t n) { return model.levels().node_starts(n); };
  for (const std::int32_t n : mesh.axis_nodes())
    if (starts(n)) fix(n, true);
  const std::vector<std::int32_t>& wall = mesh.wall_nodes();
  for (std::size_t k = 0; k < wall.size(); ++k) {
    const std::int32_t n = wall[k];
    if (free_wall_ && mesh.node_z(n) <= 1e-9) {
      reaction_[k] = 0.0;
    } else if (starts(n)) {
      reaction_[k] = nodes.inertia[n] * nodes.velocity.r[n] / model.step_of_node(n, dt);
      fix(n, true);
    }
  }
  double impulse = wall_force_ * dt;
  for (const std::int32_t n : mesh.bottom_nodes()) {
    if (!starts(n)) continue;
    impulse -= nodes.inertia[n] * nodes.velocity.z[n];
    fix(n, false);
  }
  if (setup_.mechanisms.compliant_wall.on()) follow_wall(model, dt);
  return impulse;
}

double ChamberBoundary::wall_stress(const Mesh& mesh, double depth) const {
  const std::vector<std::int32_t>& wall = mesh.wall_nodes();
  const double reach = setup_.penetrometer.diameter;
  double push = 0.0, height = 0.0;
  for (std::size_t k = 0; k < wall.size(); ++k) {
    const double z = mesh.node_z(wall[k]);
    if (std::abs(z + depth) > reach) continue;
    push += applied_[k] + reaction_[k];
    const double below = k > 0 ? mesh.node_z(wall[k - 1]) : z;
    const double above = k + 1 < wall.size() ? mesh.node_z(wall[k + 1]) : z;
    height += 0.5 * (above - below);
  }
  return height > 0.0 ? push / (setup_.chamber.radius * height) : 0.0;
}

void ChamberBoundary::follow_wall(const Model& model, double dt) {
  z_.clear();
  v_r_.clear();
  for (const std::int32_t n : model.mesh().wall_nodes()) {
    const double z = model.mesh().node_z(n);
    if (z > 1e-9) break;
    z_.push_back(z);
    v_r_.push_back(model.nodes().velocity.r[n]);
  }
  displacement_.add(z_, v_r_, dt);
}

}  // namespace cpt::solver
