#include "solver/penetrometer.hpp"

#include <cmath>
#include <numbers>

namespace cpt::solver {

ContactImpulse resolve_contact(const ContactNode& node, double inertia, double v_r, double v_z, double speed,
                               double dt) {
  const double rel_r = v_r, rel_z = v_z + speed;
  const double approach = rel_r * node.n_r + rel_z * node.n_z;
  if (approach >= 0.0) return {0.0, 0.0, 0.0, v_r, v_z};

  const double J_n = -inertia * approach;
  const double t_r = rel_r - approach * node.n_r, t_z = rel_z - approach * node.n_z;
  const double slip = std::sqrt(t_r * t_r + t_z * t_z);
  const double limit = node.friction * J_n + node.adhesion * node.area * dt;
  const double stick = inertia * slip;
  const double kept = stick > limit ? 1.0 - limit / stick : 0.0;  // share of the sliding that is left
  const double new_r = kept * t_r, new_z = kept * t_z - speed;
  const double J_t = stick > limit ? limit : stick;
  return {inertia * (new_r - v_r), inertia * (new_z - v_z), J_t * kept * slip, new_r, new_z};
}

PenetrometerContact::PenetrometerContact(const Setup& setup) : setup_(setup) {
  for (const Soil& soil : setup.soils)
    of_material_.push_back(law_of(soil).contact(soil.parameters, setup.contact));
  of_material_.emplace_back();
}

double PenetrometerContact::projected_area() const {
  return std::numbers::pi * setup_.penetrometer.diameter * setup_.penetrometer.diameter / 4.0;
}

ContactStrength PenetrometerContact::contact_strength(const Model& model, std::int32_t node) const {
  const NodeCells& around = model.mesh().node_cells()[node];
  double mass = 0.0, friction = 0.0, adhesion = 0.0;
  for (int i = 0; i < 4 && around.cell[i] >= 0; ++i)
    for (std::size_t m = 0; m < of_material_.size(); ++m) {
      const double share = model.sums()[around.cell[i]].material_mass[m];
      mass += share;
      friction += share * of_material_[m].friction;
      adhesion += share * of_material_[m].adhesion;
    }
  if (mass <= 0.0) return {};
  return {friction / mass, adhesion / mass};
}

PenetrometerLoad PenetrometerContact::apply_contact(Model& model, double speed, double dt) {
  const Mesh& mesh = model.mesh();
  const Nodes& nodes = model.nodes();
  const double half_apex = setup_.penetrometer.apex / 2.0;
  const double face_r = std::cos(half_apex), face_z = -std::sin(half_apex);
  const std::vector<std::int32_t>&face = mesh.face_nodes(), &shaft = mesh.shaft_nodes();
  const auto chain = [&](std::size_t k) { return k < face.size() ? face[k] : shaft[k - face.size()]; };
  const std::size_t count = face.size() + shaft.size(), shoulder = face.size() - 1;
  const double z_shoulder = mesh.node_z(face[shoulder]);
  upward_.resize(count);

  PenetrometerLoad load;
  const double two_pi = 2.0 * std::numbers::pi;
  for (std::size_t k = 0; k < count; ++k) {
    const std::int32_t n = chain(k);
    const double r = mesh.node_r(n), z = mesh.node_z(n);
    // Tributary areas towards both neighbours: integral of N r ds along the edge.
    const auto tributary = [&](std::size_t other) {
      const double r_o = mesh.node_r(chain(other)), z_o = mesh.node_z(chain(other));
      return std::hypot(r_o - r, z_o - z) * (2.0 * r + r_o) / 6.0;
    };
    const double before = k > 0 ? tributary(k - 1) : 0.0, after = k + 1 < count ? tributary(k + 1) : 0.0;

    ContactNode contact{face_r, face_z, before + after, 0.0, 0.0};
    if (k == 0) {
      contact.n_r = 0.0;  // on the axis the face's tip can only push straight down
      contact.n_z = -1.0;
    } else if (k > shoulder) {
      contact.n_r = 1.0;
      contact.n_z = 0.0;
    } else if (k == shoulder) {
      // The edge between face and shaft has no normal of its own: the area-weighted bisector is the default.
      double w_face = before, w_shaft = after;
      if (setup_.contact.shoulder_normal == ShoulderNormal::face) w_shaft = 0.0;
      if (setup_.contact.shoulder_normal == ShoulderNormal::shaft) w_face = 0.0;
      const double n_r = w_face * face_r + w_shaft, n_z = w_face * face_z;
      const double length = std::hypot(n_r, n_z);
      contact.n_r = n_r / length;
      contact.n_z = n_z / length;
    }
    if (model.levels().node_starts(n)) {
      const ContactStrength strength = contact_strength(model, n);
      contact.friction = strength.friction;
      contact.adhesion = strength.adhesion;
      const double step = model.step_of_node(n, dt);
      const ContactImpulse impulse =
          resolve_contact(contact, nodes.inertia[n], nodes.velocity.r[n], nodes.velocity.z[n], speed, step);
      model.set_velocity(n, k == 0 ? 0.0 : impulse.v_r, impulse.v_z);
      model.hold(
          {n, contact.n_r, contact.n_z, -speed * contact.n_z, impulse.J_r == 0.0 && impulse.J_z == 0.0});
      upward_[k] = -impulse.J_z / step * two_pi;
      load.dissipation += impulse.dissipation * two_pi;
    }
    (k <= shoulder ? load.cone_force : load.shaft_force) += upward_[k];
    if (k > shoulder && z <= z_shoulder + setup_.penetrometer.sleeve_length) {
      load.sleeve_force += upward_[k];
      load.sleeve_area += contact.area * two_pi;
    }
  }
  return load;
}

}  // namespace cpt::solver
