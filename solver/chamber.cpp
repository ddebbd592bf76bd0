#include "solver/chamber.hpp"

#include <algorithm>

#include "solver/initial_state.hpp"

namespace cpt::solver {

ChamberBoundary::ChamberBoundary(const Setup& setup, const Mesh&)
    : setup_(setup), flexible_(setup.chamber.wall == Wall::flexible) {}

// The soil's side keeps the radial stress that it had at the start; the surcharge's side stays rigid.
void ChamberBoundary::apply_wall_stress(Model& model) const {
  if (!flexible_) return;
  const Mesh& mesh = model.mesh();
  const std::vector<std::int32_t>& wall = mesh.wall_nodes();
  const double K_0 = setup_.initial.sigma_h0 / setup_.initial.sigma_v0;
  const double R = setup_.chamber.radius;
  for (std::size_t k = 0; k + 1 < wall.size(); ++k) {
    const double z0 = mesh.node_z(wall[k]), z1 = std::min(mesh.node_z(wall[k + 1]), 0.0);
    if (z0 >= 0.0) break;
    // Linear stress on the edge, two Gauss points.
    const double edge = mesh.node_z(wall[k + 1]) - z0;
    for (const double g : {0.21132486540518713, 0.78867513459481287}) {
      const double z = z0 + g * (z1 - z0), N1 = (z - z0) / edge;
      const double force = K_0 * vertical_stress(setup_, z) * R * (z1 - z0) / 2.0;
      model.nodes().f_r[wall[k]] -= (1.0 - N1) * force;
      model.nodes().f_r[wall[k + 1]] -= N1 * force;
    }
  }
}

double ChamberBoundary::fix_boundaries(Model& model) const {
  const Mesh& mesh = model.mesh();
  const Nodes& nodes = model.nodes();
  for (const std::int32_t n : mesh.axis_nodes()) model.set_velocity(n, 0.0, nodes.v_z[n]);
  for (const std::int32_t n : mesh.wall_nodes())
    if (!flexible_ || mesh.node_z(n) > 1e-9) model.set_velocity(n, 0.0, nodes.v_z[n]);
  double impulse = 0.0;
  for (const std::int32_t n : mesh.bottom_nodes()) {
    impulse -= nodes.inertia[n] * nodes.v_z[n];
    model.set_velocity(n, nodes.v_r[n], 0.0);
  }
  return impulse;
}

}  // namespace cpt::solver
