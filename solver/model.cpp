#include "solver/model.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "solver/for_each_index.hpp"

namespace cpt::solver {
namespace {

constexpr std::int64_t steps_between_splits = 500;

}  // namespace

Model::Model(Mesh mesh, const std::vector<Point>& points, const std::vector<std::int32_t>& material_of,
             SoilModels soils, const ModelSettings& settings)
    : mesh_(std::move(mesh)),
      points_([&] {
        std::vector<Point> located = points;
        std::vector<std::int32_t> bucket_of(points.size());
        for (std::size_t k = 0; k < points.size(); ++k) {
          const Location at = mesh_.locate(points[k].r, points[k].z);
          bucket_of[k] = at.cell * settings.materials + material_of[k];
        }
        return MaterialPoints(located, bucket_of, static_cast<std::int32_t>(mesh_.cells().size()),
                              settings.materials);
      }()),
      soils_(std::move(soils)),
      settings_(settings),
      kernels_(transfer_kernels()),
      compute_cell_forces_(cell_force_kernel()),
      levels_(mesh_) {
  const std::size_t cells = mesh_.cells().size(), nodes = static_cast<std::size_t>(mesh_.node_count());
  sums_.resize(cells);
  forces_.resize(cells);
  shapes_.resize(cells);
  modulus_.assign(cells, 0.0);
  bucket_modulus_.assign(cells * static_cast<std::size_t>(settings_.materials), 0.0);
  soils_in_.assign(cells, 0);
  normals_.resize(cells);
  sharing_.resize(static_cast<std::size_t>(settings_.threads) * most_materials);
  mixed_steps_.assign(cells, 0.0);
  limited_steps_.assign(cells, 0.0);
  work_.assign(cells, 0.0);
  divergence_.assign(cells, 0.0);
  filled_at_start_.assign(cells, 0);
  every_step_.assign(cells, 0);
  stable_.assign(cells, INFINITY);
  least_step_.assign(cells, 0.0);
  for (auto* field : {&nodes_.inertia, &nodes_.mass, &p_r_, &p_z_}) field->assign(nodes, 0.0);
  const auto make = [nodes](NodalVector& field) {
    field.r.assign(nodes, 0.0);
    field.z.assign(nodes, 0.0);
  };
  for (NodalVector* field : {&nodes_.velocity, &nodes_.change, &nodes_.force, &nodes_.own, &nodes_.moving,
                             &nodes_.smooth, &gathered_})
    make(*field);
  for (int level = 0; level <= settings.most_level; ++level) make(changed_[level]);
  impulses_.resize(cells);
  holds_.reserve(nodes);
  leavers_.resize(static_cast<std::size_t>(settings_.threads));
  for (auto& list : leavers_) list.reserve(4096);
  split_cells();
  make_scratch();
  sum_all_points();
}

StrainScratch Model::scratch(int thread) {
  double* base = scratch_.data() + static_cast<std::size_t>(thread) * 5 * scratch_stride_;
  base += (8 - (reinterpret_cast<std::uintptr_t>(base) / sizeof(double)) % 8) % 8;  // to a 64-byte boundary
  return {base, base + scratch_stride_, base + 2 * scratch_stride_, base + 3 * scratch_stride_,
          base + 4 * scratch_stride_};
}

// Shares the cells out to threads by how many points they move in a cycle.
void Model::split_cells() {
  const auto cells = static_cast<std::int32_t>(mesh_.cells().size());
  split_.assign(static_cast<std::size_t>(settings_.threads) + 1, cells);
  split_[0] = 0;
  const auto work = [this](std::int32_t b) {
    return static_cast<std::int64_t>(points_.bucket(b).count)
           << (highest_level - levels_.of_cell(b / settings_.materials));
  };
  std::int64_t all = 0, seen = 0;
  for (std::int32_t b = 0; b < points_.bucket_count(); ++b) all += work(b);
  std::size_t next = 1;
  for (std::int32_t b = 0; b < points_.bucket_count(); ++b) {
    seen += work(b);
    while (next < split_.size() - 1 && seen * settings_.threads >= all * static_cast<std::int64_t>(next))
      split_[next++] = b / settings_.materials + 1;
  }
}

// Room for the strains of the largest bucket, and more for its growth.
void Model::make_scratch() {
  if (static_cast<std::size_t>(points_.largest_capacity()) <= scratch_stride_) return;
  scratch_stride_ = static_cast<std::size_t>(points_.largest_capacity()) + 64;
  scratch_.assign(static_cast<std::size_t>(settings_.threads) * 5 * scratch_stride_ + 64, 0.0);
}

// Start: natural coordinates, sums and stiffness, without moving anything.
void Model::sum_all_points() {
  const StrainScratch strain = scratch(0);
  std::fill(scratch_.begin(), scratch_.end(), 0.0);
  for (std::size_t c = 0; c < sums_.size(); ++c) {
    const auto cell = static_cast<std::int32_t>(c);
    shapes_[c] = mesh_.shape(mesh_.cells()[c]);
    std::memset(&sums_[c], 0, sizeof(CellSums));
    for (std::int32_t m = 0; m < settings_.materials; ++m) {
      const Bucket& bucket = points_.bucket(cell * settings_.materials + m);
      if (bucket.count == 0) continue;
      const PointFields p = points_.fields(bucket);
      const Batch batch{bucket.padded(), p.s_rr,      p.s_zz,      p.s_tt,      p.s_rz,      p.e,
                        p.h_0,           strain.d_rr, strain.d_zz, strain.d_tt, strain.d_rz, p.h_1};
      double& modulus = bucket_modulus_[static_cast<std::size_t>(cell * settings_.materials + m)];
      modulus = soils_[static_cast<std::size_t>(m)]->update(batch);
      modulus_[c] = std::max(modulus_[c], modulus);
      for (std::int32_t k = 0; k < bucket.count; ++k) {
        const Location at = mesh_.locate(p.r[k], p.z[k]);
        p.xi[k] = at.xi;
        p.eta[k] = at.eta;
        add_to_sums(sums_[c], p, static_cast<std::size_t>(k), m);
      }
      filled_at_start_[c] = 1;
    }
  }
}

// From the gradient of the soils' shares of mass at the cell's nodes; of the soil where it is largest.
InterfaceNormal Model::interface_normal(std::int32_t c) const {
  const Cell& cell = mesh_.cells()[c];
  double at_node[4][most_materials] = {}, mass[4] = {};
  for (int k = 0; k < 4; ++k) {
    const NodeCells& around = mesh_.node_cells()[cell.node[k]];
    for (int i = 0; i < 4 && around.cell[i] >= 0; ++i)
      for (std::int32_t m = 0; m < settings_.materials; ++m) {
        at_node[k][m] += sums_[around.cell[i]].material_mass[m];
        mass[k] += sums_[around.cell[i]].material_mass[m];
      }
  }
  const CellShape& shape = shapes_[c];
  const double z_eta = 0.5 * (shape.zt0 - shape.zb0), z_xi = 0.5 * (shape.zb1 + shape.zt1);
  InterfaceNormal normal;
  double largest = 0.0;
  for (std::int32_t m = 0; m < settings_.materials; ++m) {
    double f[4];
    for (int k = 0; k < 4; ++k) f[k] = at_node[k][m] / mass[k];
    const Bilinear share = bilinear(f[0], f[1], f[2], f[3]);
    const double d_z = share.c[2] / z_eta, d_r = (share.c[1] - d_z * z_xi) / shape.a,
                 size = std::hypot(d_r, d_z);
    if (!(size > largest)) continue;
    largest = size;
    normal = {d_r / size, d_z / size};
  }
  return normal;
}

const SoilInCell* Model::share_cell_motion(std::int32_t c, const CellMotion& motion, int thread) {
  SoilInCell* const soils = &sharing_[static_cast<std::size_t>(thread) * most_materials];
  std::size_t count = 0;
  double all = 0.0;
  for (std::int32_t m = 0; m < settings_.materials; ++m) {
    const std::int32_t b = c * settings_.materials + m;
    const Bucket& bucket = points_.bucket(b);
    if (bucket.count == 0) continue;
    const PointFields p = points_.fields(bucket);
    SoilInCell& soil = soils[count++] = {};
    for (std::int32_t k = 0; k < bucket.count; ++k) {
      soil.share += p.volume[k];
      soil.s_rr += p.volume[k] * p.s_rr[k];
      soil.s_zz += p.volume[k] * p.s_zz[k];
      soil.s_tt += p.volume[k] * p.s_tt[k];
      soil.s_rz += p.volume[k] * p.s_rz[k];
    }
    soil.s_rr /= soil.share;
    soil.s_zz /= soil.share;
    soil.s_tt /= soil.share;
    soil.s_rz /= soil.share;
    all += soil.share;
    const double nu = soils_[static_cast<std::size_t>(m)]->poissons_ratio();
    soil.modulus = bucket_modulus_[static_cast<std::size_t>(b)];
    soil.shear_modulus = soil.modulus * (1.0 - 2.0 * nu) / (2.0 * (1.0 - nu));
  }
  for (std::size_t i = 0; i < count; ++i) soils[i].share /= all;

  // At the cell's centre, the volume's part as everywhere in the cell.
  const double inverse_height = 2.0 / (motion.shape.zt0 - motion.shape.zb0);
  const double z_xi = 0.5 * (motion.shape.zb1 + motion.shape.zt1);
  CellStrainRate rate;
  rate.plane.rz = motion.v_r.c[2] * inverse_height;
  rate.plane.zz = motion.v_z.c[2] * inverse_height;
  rate.plane.rr = (motion.v_r.c[1] - rate.plane.rz * z_xi) / motion.shape.a;
  rate.plane.zr = (motion.v_z.c[1] - rate.plane.zz * z_xi) / motion.shape.a;
  rate.hoop = motion.v_r.c[0] / motion.shape.r_c;
  const double correction = (motion.divergence - (rate.plane.rr + rate.plane.zz + rate.hoop)) / 3.0;
  rate.plane.rr += correction;
  rate.plane.zz += correction;
  rate.hoop += correction;

  const double steps = static_cast<double>(1 << levels_.of_cell(c));  // of the smallest
  mixed_steps_[c] += steps;
  if (share_motion({soils, count}, normals_[c], rate, motion.dt)) limited_steps_[c] += steps;
  return soils;
}

void Model::move_points(double dt) {
  filter_velocities();
  add_changes();
  for_each_index(static_cast<std::int32_t>(sums_.size()), settings_.threads, [this](std::int32_t c) {
    if (!levels_.cell_ends(c)) return;
    soils_in_[c] = static_cast<std::int32_t>(
        std::ranges::count_if(sums_[c].material_mass, [](double m) { return m > 0.0; }));
    if (soils_in_[c] > 1) normals_[c] = interface_normal(c);
  });
#pragma omp parallel for schedule(static, 1) num_threads(settings_.threads) if (settings_.threads > 1)
  for (int t = 0; t < settings_.threads; ++t) {
    leavers_[t].clear();
    for (std::int32_t c = split_[t]; c < split_[t + 1]; ++c) {
      if (!levels_.cell_ends(c)) continue;
      const Cell& cell = mesh_.cells()[c];
      move_cell(c, dt * static_cast<double>(1 << levels_.of_cell(c)), t, cell, mesh_.shape(cell));
    }
  }
  rehome_leavers();
  levels_.advance();
  if (settings_.threads > 1 && ++steps_ % steps_between_splits == 0) split_cells();
}

void Model::move_cell(std::int32_t c, double dt, int thread, const Cell& cell, const CellShape& new_shape) {
  CellSums& sums = sums_[c];
  const CellForces& forces = forces_[c];
  const double volume = sums.volume[0] + sums.volume[1] + sums.volume[2] + sums.volume[3];
  std::memset(&sums, 0, sizeof(CellSums));
  modulus_[c] = 0.0;
  if (soils_in_[c] == 0) {
    shapes_[c] = new_shape;
    return;
  }

  const auto field = [&](const std::vector<double>& values) {
    return bilinear(values[cell.node[0]], values[cell.node[1]], values[cell.node[2]], values[cell.node[3]]);
  };
  const int level = levels_.of_cell(c);
  CellMotion motion;
  motion.shape = shapes_[c];
  motion.v_r = field(nodes_.moving.r);
  motion.v_z = field(nodes_.moving.z);
  motion.smooth_r = field(nodes_.smooth.r);
  motion.smooth_z = field(nodes_.smooth.z);
  motion.dv_r = field(changed_[level].r);
  motion.dv_z = field(changed_[level].z);
  motion.divergence = 0.0;
  for (int k = 0; k < 4; ++k)
    motion.divergence +=
        forces.mean_r[k] * nodes_.moving.r[cell.node[k]] + forces.mean_z[k] * nodes_.moving.z[cell.node[k]];
  divergence_[c] = motion.divergence;
  work_[c] += forces.viscous * motion.divergence * dt * volume;
  motion.dt = dt;
  motion.pic_fraction = std::min(1.0, settings_.pic_fraction * static_cast<double>(1 << levels_.of_cell(c)));
  motion.mean_stress[0] = forces.s_rr;
  motion.mean_stress[1] = forces.s_zz;
  motion.mean_stress[2] = forces.s_tt;
  motion.mean_stress[3] = forces.s_rz;

  motion.mixed = soils_in_[c] > 1;
  const SoilInCell* soil = motion.mixed ? share_cell_motion(c, motion, thread) : nullptr;

  const StrainScratch strain = scratch(thread);
  for (std::int32_t m = 0; m < settings_.materials; ++m) {
    const std::int32_t b = c * settings_.materials + m;
    const Bucket& bucket = points_.bucket(b);
    if (bucket.count == 0) continue;
    const PointFields p = points_.fields(bucket);
    const std::size_t padded = bucket.padded();
    motion.smoothing = settings_.stress_smoothing[m];
    double own[4][4];  // averages across soils would mix their stresses: the soil's own, in every quadrant
    if (motion.mixed) {
      const double means[4] = {soil->s_rr, soil->s_zz, soil->s_tt, soil->s_rz};
      for (int i = 0; i < 4; ++i) motion.mean_stress[i] = std::fill_n(own[i], 4, means[i]) - 4;
      motion.jump = (soil++)->jump;
    }
    double work = kernels_.move_points(bucket.count, padded, p, motion, strain);
    // The next cell's points arrive while the law computes.
    const std::int32_t next = b + settings_.materials;
    if (next < points_.bucket_count()) points_.prefetch(points_.bucket(next));
    const Batch batch{padded,      p.s_rr,      p.s_zz,      p.s_tt,      p.s_rz, p.e, p.h_0,
                      strain.d_rr, strain.d_zz, strain.d_tt, strain.d_rz, p.h_1,  dt};
    bucket_modulus_[static_cast<std::size_t>(b)] = soils_[static_cast<std::size_t>(m)]->update(batch);
    modulus_[c] = std::max(modulus_[c], bucket_modulus_[static_cast<std::size_t>(b)]);
    bool some_left = false;
    work += kernels_.sum_points(bucket.count, padded, p, new_shape, cell, strain, m, sums, some_left);
    work_[c] += work;
    if (some_left)
      for (std::int32_t k = bucket.count; k-- > 0;)
        if (strain.left[k] > 0.0) leavers_[thread].push_back({b, k});
  }
  shapes_[c] = new_shape;
}

// Points that left their cell find their new one, in the order of cells: the same for any number of threads.
// Into a cell in the midst of its step none can go: until that ends they stay where they were, at its edge.
void Model::rehome_leavers() {
  for (const auto& list : leavers_)
    for (const Leaver& leaver : list) {
      const PointFields p = points_.fields(points_.bucket(leaver.bucket));
      mesh_.move_outside(p.r[leaver.slot], p.z[leaver.slot]);
      const Location at = mesh_.locate(p.r[leaver.slot], p.z[leaver.slot]);
      const std::int32_t material = leaver.bucket % settings_.materials;
      if (!levels_.cell_ends(at.cell)) {
        add_to_sums(sums_[leaver.bucket / settings_.materials], p, static_cast<std::size_t>(leaver.slot),
                    material);
        continue;
      }
      p.xi[leaver.slot] = at.xi;
      p.eta[leaver.slot] = at.eta;
      const std::int32_t to = at.cell * settings_.materials + material;
      std::int32_t k = leaver.slot;
      const double modulus = modulus_[leaver.bucket / settings_.materials];
      if (to != leaver.bucket) {
        points_.move(leaver.bucket, leaver.slot, to);
        k = points_.bucket(to).count - 1;
        double& there = bucket_modulus_[static_cast<std::size_t>(to)];
        const double here = bucket_modulus_[static_cast<std::size_t>(leaver.bucket)];
        there = k == 0 ? here : std::max(there, here);
      }
      add_to_sums(sums_[at.cell], points_.fields(points_.bucket(to)), static_cast<std::size_t>(k), material);
      modulus_[at.cell] = std::max(modulus_[at.cell], modulus);
    }
  make_scratch();
}

int Model::empty_cells() const {
  int count = 0;
  for (std::size_t c = 0; c < sums_.size(); ++c) {
    const CellSums& s = sums_[c];
    if (filled_at_start_[c] && s.volume[0] + s.volume[1] + s.volume[2] + s.volume[3] <= 0.0) ++count;
  }
  return count;
}

double Model::safeguarded_share() const {
  std::int64_t held = 0, all = 0;
  for (std::int32_t b = 0; b < points_.bucket_count(); ++b) {
    const std::int32_t soil = b % settings_.materials, count = points_.bucket(b).count;
    if (count == 0 || soil + 1 == settings_.materials) continue;
    const PointFields p = points_.fields(points_.bucket(b));
    const Batch batch{points_.bucket(b).padded(),
                      p.s_rr,
                      p.s_zz,
                      p.s_tt,
                      p.s_rz,
                      p.e,
                      p.h_0,
                      nullptr,
                      nullptr,
                      nullptr,
                      nullptr,
                      p.h_1};
    held += soils_[static_cast<std::size_t>(soil)]->safeguarded(batch, count);
    all += count;
  }
  return all > 0 ? static_cast<double>(held) / static_cast<double>(all) : 0.0;
}

double Model::limited_share() const {
  double mixed = 0.0, limited = 0.0;
  for (const double steps : mixed_steps_) mixed += steps;
  for (const double steps : limited_steps_) limited += steps;
  return mixed > 0.0 ? limited / mixed : 0.0;
}

double Model::internal_work() const {
  double work = 0.0;
  for (const double w : work_) work += w;
  return work;
}

}  // namespace cpt::solver
