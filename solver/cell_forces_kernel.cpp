// Compiled once for each instruction set, with CPT_PACK_BYTES and CPT_KERNEL_NAMESPACE. A lane is a cell.
#include <cstddef>

#include "solver/cell_forces.hpp"
#include "solver/constitutive/pack_lanes.hpp"

namespace cpt::solver::CPT_KERNEL_NAMESPACE {
namespace {

static_assert(cells_at_once % lanes == 0);

constexpr double gauss = 0.57735026918962576;  // 1/sqrt(3)
// Signs of the natural coordinates of the Gauss points, by quadrant, and of the nodes.
constexpr int quadrant_xi[4] = {-1, 1, -1, 1}, quadrant_eta[4] = {-1, -1, 1, 1};
constexpr int corner_xi[4] = {-1, 1, 1, -1}, corner_eta[4] = {-1, -1, 1, 1};
// 1 + xi_corner xi at a Gauss point on the other side of the cell's middle, and on the corner's own side.
constexpr double beside[2] = {1.0 - gauss, 1.0 + gauss};

constexpr double infinity = __builtin_inf();

/// Fields `first` to before `first + count` of the structs that begin at `rows`, a pack each.
template <int first, int count>
CPT_INLINE void load_fields(const double* const (&rows)[lanes], Pack* field) {
  for (int f = first; f < first + count; f += lanes) {
    Pack block[lanes];
    for (int l = 0; l < lanes; ++l) block[l] = load(rows[l] + f);
    transpose(block);
    for (int l = 0; l < lanes; ++l) field[f + l] = block[l];
  }
}

/// The reverse, for the first `used` structs.
template <int count>
CPT_INLINE void store_fields(const Pack* field, double* const (&rows)[lanes], int used) {
  for (int f = 0; f < count; f += lanes) {
    Pack block[lanes];
    for (int l = 0; l < lanes; ++l) block[l] = field[f + l];
    transpose(block);
    for (int l = 0; l < used; ++l) store(rows[l] + f, block[l]);
  }
}

CPT_INLINE Pack smaller(Pack a, Pack b) { return select(less(b, a), b, a); }
CPT_INLINE Pack signed_as(int sign, Pack x) { return sign < 0 ? -x : x; }

struct Shapes {
  Pack r_c, a, zb0, zb1, zt0, zt1;
};

// What limits the time step: dt <= 1 / (c sqrt(rate)) with c the speed of P-waves; the rate in 1/m2.
//
// A cell of width w and height h whose rows have the slope s has at most omega2 = 4 c2 (x + y) with x = 1 /
// w2 and y = (1 + s2) / h2 (mean dilatation; Flanagan & Belytschko 1984). With strains from v + Q
// dv and new velocities v + P dv on the nodes a wave is stable while (2 Q - P) omega2 dt2 <= 4. Points that
// lie evenly make P = (1 - a X) (1 - a Y), a = 2/3, for a wave that has the shares X and Y of the largest
// omega2 along and across the rows, and Q = P + unfiltered (1 - P); the largest (x X + y Y) (2 Q - P) is at
// most this (tests/solver/time_step_test).
template <bool sheared>
CPT_INLINE Pack limiting_rate(const Shapes& s) {
  const Pack left = (s.zt0 - s.zt1) - (s.zb0 - s.zb1), right = (s.zt0 + s.zt1) - (s.zb0 + s.zb1);
  const Pack height = smaller(left, right);
  const Pack x = 0.25 / (s.a * s.a);
  Pack y = 1.0 / (height * height);
  if constexpr (sheared) {
    const Pack slope = at_least(abs(s.zb1), abs(s.zt1)) / s.a;
    y *= 1.0 + slope * slope;
  }
  return at_least(largest_of_one * at_least(x, y), largest_of_both * (x + y));
}

// Gauss integration with quadrant averages of the material points' stresses (mixed integration, Al-Kafaji
// 2013; Martinelli & Galavi 2022) and B-bar in its mean-dilatation form (Hughes 2000, sec. 4.5): unlike the
// value at the centre, the cell's mean passes the patch test on sheared axisymmetric cells. `sums` and `out`
// hold CellSums and CellForces as packs.
template <bool sheared>
CPT_INLINE void compute(const CellForceSettings& settings, const Pack* sums, const Shapes& s, Pack modulus,
                        Pack divergence, Pack least_step, Pack* out) {
  const Pack zero = splat(0.0);
  const Pack* volumes = sums + CPT_FIELD(CellSums, volume);
  const Pack* sum_of[4] = {sums + CPT_FIELD(CellSums, s_rr), sums + CPT_FIELD(CellSums, s_zz),
                           sums + CPT_FIELD(CellSums, s_tt), sums + CPT_FIELD(CellSums, s_rz)};
  Pack* stress_of[4] = {out + CPT_FIELD(CellForces, s_rr), out + CPT_FIELD(CellForces, s_zz),
                        out + CPT_FIELD(CellForces, s_tt), out + CPT_FIELD(CellForces, s_rz)};
  const Pack volume = volumes[0] + volumes[1] + volumes[2] + volumes[3];
  const Mask filled = greater(volume, zero);

  Pack cell_mean[4] = {zero, zero, zero, zero};
  Mask lacking = none();
  for (int q = 0; q < 4; ++q) lacking = lacking | !greater(volumes[q], zero);
  if (any(lacking)) {
    const Pack inverse = 1.0 / volume;
    for (int i = 0; i < 4; ++i) {
      for (int q = 0; q < 4; ++q) cell_mean[i] += sum_of[i][q] * inverse;
      cell_mean[i] = select(filled, cell_mean[i], zero);
    }
  }

  // What the Gauss points on one side share: z_eta is half the cell's height there.
  Pack z_eta[2], r[2], N_z_size[2][2], N_over_r[2][2][2], N_r_size[2];
  for (int side = 0; side < 2; ++side) {
    const double xi = side == 0 ? -gauss : gauss;
    z_eta[side] = 0.5 * ((s.zt0 - s.zb0) + (s.zt1 - s.zb1) * xi);
    r[side] = s.r_c + s.a * xi;
    N_r_size[side] = splat(0.25 * beside[side]) / s.a;
    for (int x = 0; x < 2; ++x) {
      N_z_size[side][x] = splat(0.25 * beside[x]) / z_eta[side];
      for (int y = x; y < 2; ++y) {
        N_over_r[side][x][y] = splat(0.25 * beside[x] * beside[y]) / r[side];
        N_over_r[side][y][x] = N_over_r[side][x][y];
      }
    }
  }

  Pack f_r[4] = {zero, zero, zero, zero}, f_z[4] = {zero, zero, zero, zero};
  Pack mean_r[4] = {zero, zero, zero, zero}, mean_z[4] = {zero, zero, zero, zero};
  Pack integral_N[4] = {zero, zero, zero, zero}, mean_pressure_volume = zero, cell_volume = zero;
  for (int q = 0; q < 4; ++q) {
    // A quadrant without points takes the cell's mean.
    const Mask own = greater(volumes[q], zero);
    const Pack inverse = 1.0 / volumes[q];
    Pack stress[4];
    for (int i = 0; i < 4; ++i)
      stress_of[i][q] = stress[i] = select(own, sum_of[i][q] * inverse, cell_mean[i]);

    const int side = quadrant_xi[q] > 0;
    const double eta = quadrant_eta[q] * gauss;
    const Pack z_xi = 0.5 * ((s.zb1 + s.zt1) + (s.zt1 - s.zb1) * eta);
    const Pack V = r[side] * s.a * z_eta[side];  // [m3/rad] of the Gauss point
    const Pack p = (stress[0] + stress[1] + stress[2]) / 3.0;
    const Pack d_rr = stress[0] - p, d_zz = stress[1] - p, d_tt = stress[2] - p, d_rz = stress[3];
    cell_volume += V;
    mean_pressure_volume += V * p;
    const Pack d_tt_N_over_r[2][2] = {
        {d_tt * (0.25 * beside[0] * beside[0]) / r[side], d_tt * (0.25 * beside[0] * beside[1]) / r[side]},
        {zero, d_tt * (0.25 * beside[1] * beside[1]) / r[side]}};
    for (int k = 0; k < 4; ++k) {
      const int x = corner_xi[k] == quadrant_xi[q], y = corner_eta[k] == quadrant_eta[q];
      const double N = 0.25 * beside[x] * beside[y];
      const Pack N_z = signed_as(corner_eta[k], N_z_size[side][x]);
      Pack N_r;
      if constexpr (sheared)
        N_r = (0.25 * corner_xi[k] * beside[y] - N_z * z_xi) / s.a;
      else
        N_r = signed_as(corner_xi[k], N_r_size[y]);
      const Pack hoop = d_tt_N_over_r[x < y ? x : y][x < y ? y : x];
      f_r[k] -= V * (d_rr * N_r + d_rz * N_z + hoop);
      f_z[k] -= V * (d_zz * N_z + d_rz * N_r);
      mean_r[k] += V * (N_r + N_over_r[side][x][y]);
      mean_z[k] += V * N_z;
      integral_N[k] += V * N;
    }
  }

  Pack p = mean_pressure_volume / cell_volume;
  Pack mass = zero, weight = zero;
  for (std::int32_t m = 0; m < settings.materials; ++m) {
    const Pack part = sums[CPT_FIELD(CellSums, material_mass) + m];
    mass += part;
    weight += part * settings.weight_ratio[m] * settings.gravity;
  }
  const Pack density = select(filled, mass / volume, zero);
  const Pack unit_weight = select(filled, weight / volume, zero);
  // Selective mass scaling (Olovsson, Simonsson & Unosson 2005): small and stiff cells get the inertia that
  // their time step needs.
  Pack inertia = density * settings.mass_scaling;  // [kg/m3]
  const Pack stiffness = modulus * limiting_rate<sheared>(s);
  inertia = select(filled, at_least(inertia, least_step * least_step * stiffness), inertia);
  // Linear bulk viscosity (Landshoff 1955), as explicit codes have it against the ringing of pressure waves;
  // it follows the last step's rate of dilatation.
  const double b = settings.bulk_viscosity;
  const Pack time = exact_sqrt(inertia / stiffness);  // [s] the largest stable step
  const Pack viscous = b * modulus * time * divergence;
  p = select(filled, p + viscous, p);
  out[CPT_FIELD(CellForces, viscous)] = select(filled, viscous, zero);
  out[CPT_FIELD(CellForces, time_step)] =
      select(filled, settings.courant * time * (__builtin_sqrt(1.0 + b * b) - b), splat(infinity));

  const Pack fill = settings.partial_cells ? smaller(splat(1.0), volume / cell_volume) : splat(1.0);
  for (int k = 0; k < 4; ++k) {
    out[CPT_FIELD(CellForces, f_r) + k] = fill * (f_r[k] - p * mean_r[k]);
    out[CPT_FIELD(CellForces, f_z) + k] = fill * (f_z[k] - p * mean_z[k] - unit_weight * integral_N[k]);
    out[CPT_FIELD(CellForces, inertia) + k] = fill * inertia * integral_N[k];
    out[CPT_FIELD(CellForces, mean_r) + k] = mean_r[k] / cell_volume;
    out[CPT_FIELD(CellForces, mean_z) + k] = mean_z[k] / cell_volume;
  }
}

void compute_cells(const CellForceSettings& settings, const CellArrays& cells, std::int32_t first,
                   std::int32_t end) {
  for (std::int32_t c = first; c < end; c += lanes) {
    const int used = end - c < lanes ? end - c : lanes;
    const double* sums_rows[lanes] = {};
    double* force_rows[lanes] = {};
    alignas(64) double scalars[9][lanes];
    for (int l = 0; l < lanes; ++l) {
      const std::int32_t cell = c + (l < used ? l : used - 1);  // lanes without a cell repeat the last one
      const CellShape& shape = cells.shapes[cell];
      const double values[9] = {shape.r_c,
                                shape.a,
                                shape.zb0,
                                shape.zb1,
                                shape.zt0,
                                shape.zt1,
                                cells.modulus[cell],
                                cells.divergence[cell],
                                cells.least_step[cell]};
      for (int i = 0; i < 9; ++i) scalars[i][l] = values[i];
      sums_rows[l] = reinterpret_cast<const double*>(cells.sums + cell);
      force_rows[l] = reinterpret_cast<double*>(cells.forces + cell);
    }
    const Shapes s = {load(scalars[0]), load(scalars[1]), load(scalars[2]),
                      load(scalars[3]), load(scalars[4]), load(scalars[5])};
    const Pack modulus = load(scalars[6]), divergence = load(scalars[7]), least_step = load(scalars[8]);
    Pack sums[sizeof(CellSums) / sizeof(double)], out[sizeof(CellForces) / sizeof(double)];
    load_fields<CPT_FIELD(CellSums, volume), 32>(sums_rows, sums);
    for (int i = 0; i < 2; ++i) out[CPT_FIELD(CellForces, unused) + i] = splat(0.0);
    const Mask slanted = greater(abs(s.zb1) + abs(s.zt1), splat(0.0));
    if (any(slanted))
      compute<true>(settings, sums, s, modulus, divergence, least_step, out);
    else
      compute<false>(settings, sums, s, modulus, divergence, least_step, out);
    store_fields<sizeof(CellForces) / sizeof(double)>(out, force_rows, used);
  }
}

}  // namespace

extern const CellForceKernel cell_forces;
const CellForceKernel cell_forces = compute_cells;

}  // namespace cpt::solver::CPT_KERNEL_NAMESPACE
