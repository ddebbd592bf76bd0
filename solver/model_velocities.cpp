// Which velocity moves and strains the points, and what happens at nodes that hang between two others.
#include "solver/for_each_index.hpp"
#include "solver/model.hpp"

namespace cpt::solver {
namespace {

constexpr double corner_xi[4] = {-1.0, 1.0, 1.0, -1.0};
constexpr double corner_eta[4] = {-1.0, -1.0, 1.0, 1.0};

}  // namespace

// What gathers at a hanging node belongs to its two neighbours, to those whose step begins.
void Model::condense(std::initializer_list<std::vector<double>*> fields) const {
  for (const HangingNode& h : mesh_.hanging_nodes()) {
    const bool to_lower = levels_.node_starts(h.lower), to_upper = levels_.node_starts(h.upper);
    if (!to_lower && !to_upper) continue;
    const double upper = mesh_.hanging_weight(h), lower = 1.0 - upper;
    for (std::vector<double>* field : fields) {
      const double value = (*field)[h.node];
      if (to_lower) (*field)[h.lower] += lower * value;
      if (to_upper) (*field)[h.upper] += upper * value;
      (*field)[h.node] = 0.0;
    }
  }
}

void Model::interpolate(std::initializer_list<NodalVector*> fields) const {
  for (const HangingNode& h : mesh_.hanging_nodes()) {
    if (!levels_.node_starts(h.node)) continue;
    const double upper = mesh_.hanging_weight(h), lower = 1.0 - upper;
    for (NodalVector* field : fields)
      for (std::vector<double>* of : {&field->r, &field->z})
        (*of)[h.node] = lower * (*of)[h.lower] + upper * (*of)[h.upper];
  }
}

// Nodal values as the points would give them back: P times the field, with P the consistent over the lumped
// mass matrix; for the nodes whose step begins, but those that hang.
void Model::gather(const NodalVector& field) {
  for_each_index(static_cast<std::int32_t>(sums_.size()), settings_.threads, [&](std::int32_t c) {
    if (!levels_.cell_feels(c)) return;
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
    if (!levels_.node_starts(n)) return;
    const NodeCells& around = mesh_.node_cells()[n];
    double r = 0.0, z = 0.0;
    for (int i = 0; i < 4 && around.cell[i] >= 0; ++i) {
      r += impulses_[around.cell[i]].r[around.corner[i]];
      z += impulses_[around.cell[i]].z[around.corner[i]];
    }
    gathered_.r[n] = r;
    gathered_.z[n] = z;
  });
  condense({&gathered_.r, &gathered_.z});
  for_each_index(mesh_.node_count(), settings_.threads, [&](std::int32_t n) {
    if (!levels_.node_starts(n)) return;
    const double inverse = nodes_.mass[n] > 0.0 ? 1.0 / nodes_.mass[n] : 0.0;
    gathered_.r[n] *= inverse;
    gathered_.z[n] *= inverse;
  });
}

// Nearly the velocity that the points themselves have on the nodes at the end of the step, v + P dv. Strains
// from it (as in MUSL: Sulsky, Zhou & Schreyer 1995) allow larger steps than strains from v + dv, whose rest,
// (I - P) dv, damps what no node resolves: some of it stays (docs/numerics.md). What is held keeps its
// velocity.
void Model::filter_velocities() {
  const std::int32_t nodes = mesh_.node_count();
  interpolate({&nodes_.velocity, &nodes_.change});
  gather(nodes_.change);
  // A cell in the midst of its step gives what its nodes gained to its points later, but they have it.
  for_each_index(static_cast<std::int32_t>(sums_.size()), settings_.threads, [&](std::int32_t c) {
    if (levels_.cell_ends(c) || !levels_.cell_feels(c)) return;
    for (int k = 0; k < 4; ++k) {
      sums_[c].p_r[k] += impulses_[c].r[k];
      sums_[c].p_z[k] += impulses_[c].z[k];
    }
  });
  for_each_index(nodes, settings_.threads, [&](std::int32_t n) {
    if (!levels_.node_starts(n)) return;
    const double before_r = nodes_.velocity.r[n] - nodes_.change.r[n],
                 before_z = nodes_.velocity.z[n] - nodes_.change.z[n];
    nodes_.own.r[n] = before_r + gathered_.r[n];
    nodes_.own.z[n] = before_z + gathered_.z[n];
    nodes_.moving.r[n] = nodes_.own.r[n] + unfiltered * (nodes_.change.r[n] - gathered_.r[n]);
    nodes_.moving.z[n] = nodes_.own.z[n] + unfiltered * (nodes_.change.z[n] - gathered_.z[n]);
  });
  for (const Hold& hold : holds_) {
    double &r = nodes_.moving.r[hold.node], &z = nodes_.moving.z[hold.node];
    const double change = hold.velocity - (r * hold.n_r + z * hold.n_z);
    if (hold.or_more && change <= 0.0) continue;
    r += change * hold.n_r;
    z += change * hold.n_z;
  }
  interpolate({&nodes_.own, &nodes_.moving});
  if (!(settings_.pic_fraction > 0.0)) return;
  gather(nodes_.own);
  for_each_index(nodes, settings_.threads, [&](std::int32_t n) {
    if (!levels_.node_starts(n)) return;
    nodes_.smooth.r[n] = 2.0 * nodes_.own.r[n] - gathered_.r[n];
    nodes_.smooth.z[n] = 2.0 * nodes_.own.z[n] - gathered_.z[n];
  });
  interpolate({&nodes_.smooth});
}

// What the nodes gain in this step, for the points of the cells around them.
void Model::add_changes() {
  for_each_index(mesh_.node_count(), settings_.threads, [&](std::int32_t n) {
    if (!levels_.node_starts(n)) return;
    for (int level = levels_.of_node(n); level <= levels_.highest_around(n); ++level) {
      NodalVector& changed = changed_[level];
      const double kept = levels_.level_starts(level) ? 0.0 : 1.0;
      changed.r[n] = kept * changed.r[n] + nodes_.change.r[n];
      changed.z[n] = kept * changed.z[n] + nodes_.change.z[n];
    }
  });
}

}  // namespace cpt::solver
