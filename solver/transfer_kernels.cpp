// Compiled once for each instruction set, with CPT_PACK_BYTES and CPT_KERNEL_NAMESPACE. Nothing but plain
// arithmetic on arrays here: an inline library function compiled for a newer processor could be linked into
// the rest.
#include <cstddef>

#include "solver/constitutive/pack_lanes.hpp"
#include "solver/transfer.hpp"

namespace cpt::solver::CPT_KERNEL_NAMESPACE {
namespace {

/// Lanes at `k` that hold a point.
CPT_INLINE Mask used_lanes(std::size_t k, std::int32_t count) {
  Pack number = splat(0.0);
  for (int l = 0; l < lanes; ++l) number[l] = l;
  return less(number, splat(static_cast<double>(count) - static_cast<double>(k)));
}

CPT_INLINE Pack limited(Pack x) {
  const Pack low = select(greater(x, splat(-1.0)), x, splat(-1.0));
  return select(less(low, splat(1.0)), low, splat(1.0));
}

// A quantity of the four quadrants: c0 + c1 right + c2 upper + c3 right upper, with `right` and `upper` 0 or
// 1; without branches.
struct QuadrantMeans {
  double c0, c1, c2, c3;
};

CPT_INLINE QuadrantMeans quadrant_means(const double* m) {
  return {m[0], m[1] - m[0], m[2] - m[0], (m[3] - m[2]) - (m[1] - m[0])};
}

CPT_INLINE Pack smoothed(Pack stress, const QuadrantMeans& m, double beta, Pack right, Pack upper,
                         Pack both) {
  return stress + beta * (m.c0 + m.c1 * right + m.c2 * upper + m.c3 * both - stress);
}

template <bool smooth, bool mixed>
CPT_INLINE double move(std::int32_t count, std::size_t padded, const PointFields& points,
                       const CellMotion& motion, const StrainScratch& strain) {
  const CellShape& shape = motion.shape;
  const double inverse_a = 1.0 / shape.a;
  const double dt = motion.dt, pic = motion.pic_fraction, divergence = motion.divergence;
  const PlaneGradient& jump = motion.jump;
  const double dilation = mixed ? divergence + jump.rr + jump.zz : divergence;
  const double *R = motion.v_r.c, *Z = motion.v_z.c, *dR = motion.dv_r.c, *dZ = motion.dv_z.c;
  const double *sR = motion.smooth_r.c, *sZ = motion.smooth_z.c;
  const double r_first = shape.r_c - shape.a, r_last = shape.r_c + shape.a;
  const double beta = motion.smoothing;
  const QuadrantMeans m_rr = quadrant_means(motion.mean_stress[0]),
                      m_zz = quadrant_means(motion.mean_stress[1]),
                      m_tt = quadrant_means(motion.mean_stress[2]),
                      m_rz = quadrant_means(motion.mean_stress[3]);
  const Pack zero = splat(0.0);

  Pack work = zero;
  for (std::size_t k = 0; k < padded; k += lanes) {
    const Pack x = load(points.xi + k), y = load(points.eta + k), xy = x * y;
    Pack s_rr = load(points.s_rr + k), s_zz = load(points.s_zz + k), s_tt = load(points.s_tt + k),
         s_rz = load(points.s_rz + k);
    // Averages go back to the points (only where the caller says so): stress += beta (mean of its quadrant -
    // stress).
    if constexpr (smooth) {
      const Pack right = select(greater(x, zero), splat(1.0), zero);
      const Pack upper = select(greater(y, zero), splat(1.0), zero);
      const Pack both = right * upper;
      s_rr = smoothed(s_rr, m_rr, beta, right, upper, both);
      s_zz = smoothed(s_zz, m_zz, beta, right, upper, both);
      s_tt = smoothed(s_tt, m_tt, beta, right, upper, both);
      s_rz = smoothed(s_rz, m_rz, beta, right, upper, both);
      store(points.s_tt + k, s_tt);
    }

    // FLIP, with a share of PIC of second order.
    const Pack vr = R[0] + R[1] * x + R[2] * y + R[3] * xy;
    const Pack vz = Z[0] + Z[1] * x + Z[2] * y + Z[3] * xy;
    const Pack flip_r = load(points.v_r + k) + (dR[0] + dR[1] * x + dR[2] * y + dR[3] * xy);
    const Pack flip_z = load(points.v_z + k) + (dZ[0] + dZ[1] * x + dZ[2] * y + dZ[3] * xy);
    store(points.v_r + k, flip_r + pic * (sR[0] + sR[1] * x + sR[2] * y + sR[3] * xy - flip_r));
    store(points.v_z + k, flip_z + pic * (sZ[0] + sZ[1] * x + sZ[2] * y + sZ[3] * xy - flip_z));

    // Velocity gradient on the sheared cell: z_eta is half its height at xi, z_xi the slope of the row at
    // eta.
    const Pack z_eta = 0.5 * ((shape.zt0 - shape.zb0) + (shape.zt1 - shape.zb1) * x);
    const Pack z_xi = 0.5 * ((shape.zb1 + shape.zt1) + (shape.zt1 - shape.zb1) * y);
    const Pack inverse_height = 1.0 / z_eta;
    Pack vr_z = (R[2] + R[3] * x) * inverse_height;
    Pack vz_z = (Z[2] + Z[3] * x) * inverse_height;
    Pack vr_r = ((R[1] + R[3] * y) - vr_z * z_xi) * inverse_a;
    Pack vz_r = ((Z[1] + Z[3] * y) - vz_z * z_xi) * inverse_a;
    // Points beyond the wall or inside the shaft are clamped to the cell, their hoop strain too.
    const Pack r = load(points.r + k);
    Pack r_in = select(less(r, splat(r_first)), splat(r_first), r);
    r_in = select(greater(r_in, splat(r_last)), splat(r_last), r_in);
    r_in = select(greater(r_in, splat(1e-12)), r_in, splat(1e-12));
    const Pack hoop = vr / r_in;

    // B-bar (Hughes 2000): the local volumetric rate is replaced by the cell's mean.
    const Pack correction = (divergence - (vr_r + vz_z + hoop)) * (1.0 / 3.0);
    if constexpr (mixed) {
      vr_r += jump.rr;
      vr_z += jump.rz;
      vz_r += jump.zr;
      vz_z += jump.zz;
    }
    const Mask used = used_lanes(k, count);
    const Pack d_rr = select(used, dt * (vr_r + correction), zero);
    const Pack d_zz = select(used, dt * (vz_z + correction), zero);
    const Pack d_tt = select(used, dt * (hoop + correction), zero);
    const Pack d_rz = select(used, dt * 0.5 * (vr_z + vz_r), zero);
    store(strain.d_rr + k, d_rr);
    store(strain.d_zz + k, d_zz);
    store(strain.d_tt + k, d_tt);
    store(strain.d_rz + k, d_rz);

    // Jaumann rate: the in-plane deviator turns by twice the spin; Cayley form, so that its length is kept.
    const Pack w = dt * 0.5 * (vr_z - vz_r);
    const Pack inverse = 1.0 / (1.0 + w * w);
    const Pack cosine = (1.0 - w * w) * inverse, sine = 2.0 * w * inverse;
    const Pack mean = 0.5 * (s_rr + s_zz), half = 0.5 * (s_rr - s_zz), shear = s_rz;
    const Pack half_new = cosine * half + sine * shear;
    s_rr = mean + half_new;
    s_zz = mean - half_new;
    s_rz = cosine * shear - sine * half;
    store(points.s_rr + k, s_rr);
    store(points.s_zz + k, s_zz);
    store(points.s_rz + k, s_rz);

    const Pack volume = load(points.volume + k) * (1.0 + dt * dilation);
    store(points.volume + k, volume);
    store(points.r + k, r + dt * vr);
    store(points.z + k, load(points.z + k) + dt * vz);
    work += volume * (s_rr * d_rr + s_zz * d_zz + s_tt * d_tt + 2.0 * s_rz * d_rz);
  }
  return 0.5 * lane_sum(work);
}

double move_points(std::int32_t count, std::size_t padded, const PointFields& points,
                   const CellMotion& motion, const StrainScratch& strain) {
  const bool smooth = motion.smoothing > 0.0;
  if (motion.mixed)
    return smooth ? move<true, true>(count, padded, points, motion, strain)
                  : move<false, true>(count, padded, points, motion, strain);
  return smooth ? move<true, false>(count, padded, points, motion, strain)
                : move<false, false>(count, padded, points, motion, strain);
}

/// Volume and stress of `quadrants` quadrants from `first` on, in the order of CellSums; points that left do
/// not count.
template <int first, int quadrants>
CPT_INLINE void sum_quadrants(std::size_t padded, const PointFields& points, const double* left, Pack* sums) {
  const Pack zero = splat(0.0);
  Pack sum[5][quadrants];
  for (auto& field : sum)
    for (Pack& s : field) s = zero;
  for (std::size_t k = 0; k < padded; k += lanes) {
    const Mask right = greater(load(points.xi + k), zero), upper = greater(load(points.eta + k), zero);
    const Pack volume = select(greater(load(left + k), zero), zero, load(points.volume + k));
    const Pack s_rr = load(points.s_rr + k), s_zz = load(points.s_zz + k), s_tt = load(points.s_tt + k),
               s_rz = load(points.s_rz + k);
    for (int i = 0; i < quadrants; ++i) {
      const int q = first + i;
      const Mask here = (q % 2 == 1 ? right : !right) & (q / 2 == 1 ? upper : !upper);
      const Pack v = select(here, volume, zero);
      sum[0][i] += v;
      sum[1][i] += v * s_rr;
      sum[2][i] += v * s_zz;
      sum[3][i] += v * s_tt;
      sum[4][i] += v * s_rz;
    }
  }
  for (int f = 0; f < 5; ++f)
    for (int i = 0; i < quadrants; ++i) sums[4 * f + first + i] = sum[f][i];
}

/// Momentum at the cell's nodes; points that left do not count.
CPT_INLINE void sum_momentum(std::size_t padded, const PointFields& points, const double* left, Pack* p_r,
                             Pack* p_z) {
  for (int i = 0; i < 4; ++i) p_r[i] = p_z[i] = splat(0.0);
  for (std::size_t k = 0; k < padded; k += lanes) {
    const Pack x = load(points.xi + k), y = load(points.eta + k);
    const Pack m = load(points.mass + k) * (1.0 - load(left + k)) * 0.25;
    const Pack low = m * (1.0 - y), high = m * (1.0 + y);
    const Pack N[4] = {low * (1.0 - x), low * (1.0 + x), high * (1.0 + x), high * (1.0 - x)};
    const Pack vr = load(points.v_r + k), vz = load(points.v_z + k);
    for (int i = 0; i < 4; ++i) {
      p_r[i] += N[i] * vr;
      p_z[i] += N[i] * vz;
    }
  }
}

/// Moments of mass, in the order of CellSums; points that left do not count.
CPT_INLINE void sum_moments(std::size_t padded, const PointFields& points, const double* left, Pack* sums) {
  for (int i = 0; i < 9; ++i) sums[i] = splat(0.0);
  for (std::size_t k = 0; k < padded; k += lanes) {
    const Pack x = load(points.xi + k), y = load(points.eta + k);
    const Pack m = load(points.mass + k) * (1.0 - load(left + k));
    const Pack mx = m * x, my = m * y, mxy = mx * y, mxx = mx * x, myy = my * y;
    sums[0] += m;
    sums[1] += mx;
    sums[2] += my;
    sums[3] += mxy;
    sums[4] += mxx;
    sums[5] += myy;
    sums[6] += mxy * x;
    sums[7] += mxy * y;
    sums[8] += mxy * x * y;
  }
}

double sum_points(std::int32_t count, std::size_t padded, const PointFields& points, const CellShape& shape,
                  const Cell& cell, const StrainScratch& strain, std::int32_t material, CellSums& sums,
                  bool& some_left) {
  const double inverse_a = 1.0 / shape.a;
  const Pack zero = splat(0.0);
  Mask gone = none();
  Pack work = zero;
  for (std::size_t k = 0; k < padded; k += lanes) {
    const Mask used = used_lanes(k, count);
    const Pack r = select(used, load(points.r + k), splat(shape.r_c));
    const Pack z = select(used, load(points.z + k), splat(0.5 * (shape.zb0 + shape.zt0)));
    const Pack x = (r - shape.r_c) * inverse_a;
    const Pack x_in = limited(x);
    const Pack bottom = shape.zb0 + shape.zb1 * x_in, top = shape.zt0 + shape.zt1 * x_in;
    const Pack y = 2.0 * (z - bottom) / (top - bottom) - 1.0;
    const Mask inside = at_most_mask(splat(cell.xi_min), x) & at_most_mask(x, splat(cell.xi_max)) &
                        at_most_mask(splat(cell.eta_min), y) & at_most_mask(y, splat(cell.eta_max));
    store(points.xi + k, x_in);
    store(points.eta + k, limited(y));
    store(strain.left + k, select(inside, zero, splat(1.0)));
    gone = gone | !inside;
    work +=
        load(points.volume + k) *
        (load(points.s_rr + k) * load(strain.d_rr + k) + load(points.s_zz + k) * load(strain.d_zz + k) +
         load(points.s_tt + k) * load(strain.d_tt + k) + 2.0 * load(points.s_rz + k) * load(strain.d_rz + k));
  }
  some_left = any(gone);

  // In parts whose sums stay in the registers.
  constexpr int count_of_sums = sizeof(CellSums) / sizeof(double);
  Pack sum[count_of_sums];
  for (int i = 0; i < most_materials; ++i) sum[CPT_FIELD(CellSums, material_mass) + i] = zero;
  for (int i = 0; i < 3; ++i) sum[CPT_FIELD(CellSums, unused) + i] = zero;
  if constexpr (lanes == 8) {
    sum_quadrants<0, 4>(padded, points, strain.left, sum);
  } else {
    sum_quadrants<0, 2>(padded, points, strain.left, sum);
    sum_quadrants<2, 2>(padded, points, strain.left, sum);
  }
  sum_momentum(padded, points, strain.left, sum + CPT_FIELD(CellSums, p_r), sum + CPT_FIELD(CellSums, p_z));
  sum_moments(padded, points, strain.left, sum + CPT_FIELD(CellSums, moment));
  sum[CPT_FIELD(CellSums, material_mass) + material] = sum[CPT_FIELD(CellSums, moment)];

  auto* const cell_sums = reinterpret_cast<double*>(&sums);
  for (int f = 0; f < count_of_sums; f += lanes) {
    Pack block[lanes];
    for (int l = 0; l < lanes; ++l) block[l] = sum[f + l];
    store(cell_sums + f, load(cell_sums + f) + lane_sums(block));
  }
  return 0.5 * lane_sum(work);
}

}  // namespace

extern const TransferKernels transfer;
const TransferKernels transfer = {move_points, sum_points};

}  // namespace cpt::solver::CPT_KERNEL_NAMESPACE
