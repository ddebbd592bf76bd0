// Which velocity moves and strains the points, and what happens at nodes that hang between two others.
#include <tuple>
#include <utility>

#include "solver/for_each_index.hpp"
#include "solver/model.hpp"

namespace cpt::solver {
namespace {

constexpr double corner_xi[4] = {-1.0, 1.0, 1.0, -1.0};
constexpr double corner_eta[4] = {-1.0, -1.0, 1.0, 1.0};

}  // namespace

// What gathers at a hanging node belongs to its two neighbours.
void Model::condense(std::initializer_list<std::vector<double>*> fields) const {
  for (const HangingNode& h : mesh_.hanging_nodes()) {
    const double upper = mesh_.hanging_weight(h), lower = 1.0 - upper;
    for (std::vector<double>* field : fields) {
      const double value = (*field)[h.node];
      (*field)[h.lower] += lower * value;
      (*field)[h.upper] += upper * value;
      (*field)[h.node] = 0.0;
    }
  }
}

void Model::interpolate(std::initializer_list<std::vector<double>*> fields) const {
  for (const HangingNode& h : mesh_.hanging_nodes()) {
    const double upper = mesh_.hanging_weight(h), lower = 1.0 - upper;
    for (std::vector<double>* field : fields)
      (*field)[h.node] = lower * (*field)[h.lower] + upper * (*field)[h.upper];
  }
}

// Nodal values as the points would give them back: P times the field, with P the consistent over the lumped
// mass matrix.
void Model::gather(const NodalVector& field, NodalVector& gathered) {
  for_each_index(static_cast<std::int32_t>(sums_.size()), settings_.threads, [&](std::int32_t c) {
    const double* m = sums_[c].moment;
    const std::int32_t* node = mesh_.cells()[c].node;
    CornerImpulse& impulse = impulses_[c];
    const auto corners = [&](const std::vector<double>& values, double(&of)[4]) {
      const Bilinear v = bilinear(values[node[0]], values[node[1]], values[node[2]], values[node[3]]);
      const double* b = v.c;
      const double sum = b[0] * m[0] + b[1] * m[1] + b[2] * m[2] + b[3] * m[3];
      const double xi = b[0] * m[1] + b[1] * m[4] + b[2] * m[3] + b[3] * m[6];
      const double eta = b[0] * m[2] + b[1] * m[3] + b[2] * m[5] + b[3] * m[7];
      const double both = b[0] * m[3] + b[1] * m[6] + b[2] * m[7] + b[3] * m[8];
      for (int k = 0; k < 4; ++k)
        of[k] = 0.25 * (sum + corner_xi[k] * xi + corner_eta[k] * eta + corner_xi[k] * corner_eta[k] * both);
    };
    corners(field.r, impulse.r);
    corners(field.z, impulse.z);
  });
  for_each_index(mesh_.node_count(), settings_.threads, [&](std::int32_t n) {
    const NodeCells& around = mesh_.node_cells()[n];
    double r = 0.0, z = 0.0;
    for (int i = 0; i < 4 && around.cell[i] >= 0; ++i) {
      r += impulses_[around.cell[i]].r[around.corner[i]];
      z += impulses_[around.cell[i]].z[around.corner[i]];
    }
    gathered.r[n] = r;
    gathered.z[n] = z;
  });
  condense({&gathered.r, &gathered.z});
  for_each_index(mesh_.node_count(), settings_.threads, [&](std::int32_t n) {
    const double inverse = nodes_.mass[n] > 0.0 ? 1.0 / nodes_.mass[n] : 0.0;
    gathered.r[n] *= inverse;
    gathered.z[n] *= inverse;
  });
  interpolate({&gathered.r, &gathered.z});
}

// Nearly the velocity that the points themselves have on the nodes at the end of the step, v + P dv. Strains
// from it (as in MUSL: Sulsky, Zhou & Schreyer 1995) allow larger steps than strains from v + dv, whose rest,
// (I - P) dv, damps what no node resolves: some of it stays (docs/numerics.md). What is held keeps its
// velocity.
void Model::filter_velocities() {
  gather(nodes_.change, nodes_.moving);
  const auto of_points = [this](std::int32_t n) {
    return std::pair{nodes_.velocity.r[n] - nodes_.change.r[n] + nodes_.moving.r[n],
                     nodes_.velocity.z[n] - nodes_.change.z[n] + nodes_.moving.z[n]};
  };
  if (settings_.pic_fraction > 0.0) {
    NodalVector& own = nodes_.force;  // not needed any more in this step
    for_each_index(mesh_.node_count(), settings_.threads,
                   [&](std::int32_t n) { std::tie(own.r[n], own.z[n]) = of_points(n); });
    gather(own, nodes_.smooth);
    for_each_index(mesh_.node_count(), settings_.threads, [&](std::int32_t n) {
      nodes_.smooth.r[n] = 2.0 * own.r[n] - nodes_.smooth.r[n];
      nodes_.smooth.z[n] = 2.0 * own.z[n] - nodes_.smooth.z[n];
    });
  }
  for_each_index(mesh_.node_count(), settings_.threads, [&](std::int32_t n) {
    const auto [r, z] = of_points(n);
    nodes_.moving.r[n] = r + unfiltered * (nodes_.change.r[n] - nodes_.moving.r[n]);
    nodes_.moving.z[n] = z + unfiltered * (nodes_.change.z[n] - nodes_.moving.z[n]);
  });
  for (const Hold& hold : holds_) {
    double &r = nodes_.moving.r[hold.node], &z = nodes_.moving.z[hold.node];
    const double change = hold.velocity - (r * hold.n_r + z * hold.n_z);
    if (hold.or_more && change <= 0.0) continue;
    r += change * hold.n_r;
    z += change * hold.n_z;
  }
  interpolate({&nodes_.moving.r, &nodes_.moving.z});
}

}  // namespace cpt::solver
