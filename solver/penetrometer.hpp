// The rigid penetrometer: contact of the nodes on its face and shaft with the soil.
//
// Bardenhagen et al. (2001) contact with Coulomb friction, plus the adhesion of Al-Kafaji (2013): a node that
// moves into the body is stopped in the normal direction; its tangential impulse is limited to mu times the
// normal impulse plus adhesion times tributary area times dt; a node that moves away is free. A node shared
// by several materials averages their contact properties by mass.
#pragma once

#include <vector>

#include "solver/model.hpp"
#include "solver/setup.hpp"

namespace cpt::solver {

/// Contact law of one node for one step.
struct ContactNode {
  double n_r, n_z;  // [-] unit normal, from the penetrometer into the soil
  double area;      // [m2/rad] tributary area
  double friction;  // [-] tangent of the contact friction angle
  double adhesion;  // [Pa]
};

struct ContactImpulse {
  double J_r, J_z;     // [N s/rad] on the soil
  double dissipation;  // [J/rad] lost to sliding
  double v_r, v_z;     // [m/s] velocity after contact
};

/// Contact of one node of mass `inertia` and free velocity (v_r, v_z) with a body that moves at (0, -speed).
[[nodiscard]] ContactImpulse resolve_contact(const ContactNode& node, double inertia, double v_r, double v_z,
                                             double speed, double dt);

/// What the soil does to the penetrometer in one step, over the full circumference.
struct PenetrometerLoad {
  double cone_force = 0.0;    // [N] upward, on face and shoulder
  double sleeve_force = 0.0;  // [N] upward, on the nodes of the friction sleeve
  double sleeve_area = 0.0;   // [m2] tributary area of those nodes
  double shaft_force = 0.0;   // [N] upward, on the whole shaft above the shoulder
  double dissipation = 0.0;   // [J] lost to sliding
};

class PenetrometerContact {
 public:
  explicit PenetrometerContact(const Setup& setup);

  /// Applies contact to the nodes whose step begins, after `accelerate`; the penetrometer moves at `speed`
  /// [m/s]. The others press on as they did.
  PenetrometerLoad apply_contact(Model& model, double speed, double dt);

  [[nodiscard]] double projected_area() const;  // [m2]

 private:
  [[nodiscard]] ContactStrength contact_strength(const Model& model, std::int32_t node) const;

  const Setup& setup_;
  std::vector<ContactStrength> of_material_;  // none for the surcharge
  std::vector<double> upward_;                // [N] on each node's part of the surface, in its last step
};

}  // namespace cpt::solver
