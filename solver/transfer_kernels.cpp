// Compiled once for each instruction set, with CPT_PACK_BYTES and CPT_KERNEL_NAMESPACE. Nothing but plain
// arithmetic on arrays here: an inline library function compiled for a newer processor could be linked into
// the rest.
#include "solver/transfer.hpp"

namespace cpt::solver::CPT_KERNEL_NAMESPACE {
namespace {

inline double select(bool condition, double a, double b) { return condition ? a : b; }

double move_points(std::int32_t count, std::size_t padded, const PointFields& points,
                   const CellMotion& motion, const StrainScratch& strain) {
  double* __restrict__ r = points.r;
  double* __restrict__ z = points.z;
  double* __restrict__ v_r = points.v_r;
  double* __restrict__ v_z = points.v_z;
  double* __restrict__ s_rr = points.s_rr;
  double* __restrict__ s_zz = points.s_zz;
  double* __restrict__ s_tt = points.s_tt;
  double* __restrict__ s_rz = points.s_rz;
  double* __restrict__ volume = points.volume;
  const double* __restrict__ xi = points.xi;
  const double* __restrict__ eta = points.eta;
  double* __restrict__ d_rr = strain.d_rr;
  double* __restrict__ d_zz = strain.d_zz;
  double* __restrict__ d_tt = strain.d_tt;
  double* __restrict__ d_rz = strain.d_rz;

  const CellShape& shape = motion.shape;
  const double inverse_a = 1.0 / shape.a;
  const double dt = motion.dt, pic = motion.pic_fraction, divergence = motion.divergence;
  const double *R = motion.v_r.c, *Z = motion.v_z.c, *dR = motion.dv_r.c, *dZ = motion.dv_z.c;
  const double r_first = shape.r_c - shape.a, r_last = shape.r_c + shape.a;

  // Averages go back to the points (only where the caller says so): stress += beta (mean of its quadrant -
  // stress).
  if (motion.smoothing > 0.0) {
    const double beta = motion.smoothing;
    double c[4][4];  // mean = c0 + c1 right + c2 upper + c3 right upper, without branches
    for (int i = 0; i < 4; ++i) {
      const double m0 = motion.mean_stress[i][0], m1 = motion.mean_stress[i][1],
                   m2 = motion.mean_stress[i][2], m3 = motion.mean_stress[i][3];
      c[i][0] = m0, c[i][1] = m1 - m0, c[i][2] = m2 - m0, c[i][3] = (m3 - m2) - (m1 - m0);
    }
#pragma omp simd
    for (std::size_t k = 0; k < padded; ++k) {
      const double right = select(xi[k] > 0.0, 1.0, 0.0), upper = select(eta[k] > 0.0, 1.0, 0.0);
      const double both = right * upper;
      s_rr[k] += beta * (c[0][0] + c[0][1] * right + c[0][2] * upper + c[0][3] * both - s_rr[k]);
      s_zz[k] += beta * (c[1][0] + c[1][1] * right + c[1][2] * upper + c[1][3] * both - s_zz[k]);
      s_tt[k] += beta * (c[2][0] + c[2][1] * right + c[2][2] * upper + c[2][3] * both - s_tt[k]);
      s_rz[k] += beta * (c[3][0] + c[3][1] * right + c[3][2] * upper + c[3][3] * both - s_rz[k]);
    }
  }

#pragma omp simd
  for (std::size_t k = 0; k < padded; ++k) {
    const double x = xi[k], y = eta[k], xy = x * y;
    // Nodal velocity and its increment at the point: FLIP, with a share of PIC.
    const double vr = R[0] + R[1] * x + R[2] * y + R[3] * xy;
    const double vz = Z[0] + Z[1] * x + Z[2] * y + Z[3] * xy;
    const double flip_r = v_r[k] + (dR[0] + dR[1] * x + dR[2] * y + dR[3] * xy);
    const double flip_z = v_z[k] + (dZ[0] + dZ[1] * x + dZ[2] * y + dZ[3] * xy);
    v_r[k] = flip_r + pic * (vr - flip_r);
    v_z[k] = flip_z + pic * (vz - flip_z);

    // Velocity gradient on the sheared cell: z_eta is half its height at xi, z_xi the slope of the row at
    // eta.
    const double z_eta = 0.5 * ((shape.zt0 - shape.zb0) + (shape.zt1 - shape.zb1) * x);
    const double z_xi = 0.5 * ((shape.zb1 + shape.zt1) + (shape.zt1 - shape.zb1) * y);
    const double inverse_height = 1.0 / z_eta;
    const double vr_z = (R[2] + R[3] * x) * inverse_height;
    const double vz_z = (Z[2] + Z[3] * x) * inverse_height;
    const double vr_r = ((R[1] + R[3] * y) - vr_z * z_xi) * inverse_a;
    const double vz_r = ((Z[1] + Z[3] * y) - vz_z * z_xi) * inverse_a;
    // Points beyond the wall or inside the shaft are clamped to the cell, their hoop strain too.
    double r_in = r[k];
    r_in = select(r_in < r_first, r_first, r_in);
    r_in = select(r_in > r_last, r_last, r_in);
    r_in = select(r_in > 1e-12, r_in, 1e-12);
    const double hoop = vr / r_in;

    // B-bar (Hughes 2000): the local volumetric rate is replaced by the cell's mean.
    const double correction = (divergence - (vr_r + vz_z + hoop)) * (1.0 / 3.0);
    d_rr[k] = dt * (vr_r + correction);
    d_zz[k] = dt * (vz_z + correction);
    d_tt[k] = dt * (hoop + correction);
    d_rz[k] = dt * 0.5 * (vr_z + vz_r);

    // Jaumann rate: the in-plane deviator turns by twice the spin; Cayley form, so that its length is kept.
    const double w = dt * 0.5 * (vr_z - vz_r);
    const double inverse = 1.0 / (1.0 + w * w);
    const double cosine = (1.0 - w * w) * inverse, sine = 2.0 * w * inverse;
    const double mean = 0.5 * (s_rr[k] + s_zz[k]), half = 0.5 * (s_rr[k] - s_zz[k]), shear = s_rz[k];
    const double half_new = cosine * half + sine * shear;
    s_rr[k] = mean + half_new;
    s_zz[k] = mean - half_new;
    s_rz[k] = cosine * shear - sine * half;

    volume[k] *= 1.0 + dt * divergence;
    r[k] += dt * vr;
    z[k] += dt * vz;
  }

  for (std::size_t k = static_cast<std::size_t>(count); k < padded; ++k)
    d_rr[k] = d_zz[k] = d_tt[k] = d_rz[k] = 0.0;

  double work = 0.0;
#pragma omp simd reduction(+ : work)
  for (std::size_t k = 0; k < padded; ++k)
    work += volume[k] * (s_rr[k] * d_rr[k] + s_zz[k] * d_zz[k] + s_tt[k] * d_tt[k] + 2.0 * s_rz[k] * d_rz[k]);
  return 0.5 * work;
}

// Volume and stress of the two quadrants below or above eta = 0; in halves, so that the sums stay in
// registers.
template <bool upper>
inline void sum_half(std::size_t padded, const PointFields& points, const double* __restrict__ left,
                     CellSums& sums) {
  const double* __restrict__ xi = points.xi;
  const double* __restrict__ eta = points.eta;
  const double* __restrict__ volume = points.volume;
  const double* __restrict__ s_rr = points.s_rr;
  const double* __restrict__ s_zz = points.s_zz;
  const double* __restrict__ s_tt = points.s_tt;
  const double* __restrict__ s_rz = points.s_rz;
  double v0 = 0, r0 = 0, z0 = 0, t0 = 0, s0 = 0, v1 = 0, r1 = 0, z1 = 0, t1 = 0, s1 = 0;
#pragma omp simd reduction(+ : v0, r0, z0, t0, s0, v1, r1, z1, t1, s1)
  for (std::size_t k = 0; k < padded; ++k) {
    const double here = upper ? select(eta[k] > 0.0, 1.0, 0.0) : select(eta[k] > 0.0, 0.0, 1.0);
    const double v = volume[k] * (1.0 - left[k]) * here;
    const double w1 = select(xi[k] > 0.0, v, 0.0), w0 = v - w1;
    v0 += w0, r0 += w0 * s_rr[k], z0 += w0 * s_zz[k], t0 += w0 * s_tt[k], s0 += w0 * s_rz[k];
    v1 += w1, r1 += w1 * s_rr[k], z1 += w1 * s_zz[k], t1 += w1 * s_tt[k], s1 += w1 * s_rz[k];
  }
  const int q = upper ? 2 : 0;
  sums.volume[q] += v0, sums.s_rr[q] += r0, sums.s_zz[q] += z0, sums.s_tt[q] += t0, sums.s_rz[q] += s0;
  sums.volume[q + 1] += v1, sums.s_rr[q + 1] += r1, sums.s_zz[q + 1] += z1, sums.s_tt[q + 1] += t1,
      sums.s_rz[q + 1] += s1;
}

double sum_points(std::int32_t count, std::size_t padded, const PointFields& points, const CellShape& shape,
                  const Cell& cell, const StrainScratch& strain, Material material, CellSums& sums,
                  std::int32_t& left_count) {
  double* __restrict__ r = points.r;
  double* __restrict__ z = points.z;
  double* __restrict__ xi = points.xi;
  double* __restrict__ eta = points.eta;
  const double* __restrict__ v_r = points.v_r;
  const double* __restrict__ v_z = points.v_z;
  const double* __restrict__ mass = points.mass;
  const double* __restrict__ volume = points.volume;
  const double* __restrict__ s_rr = points.s_rr;
  const double* __restrict__ s_zz = points.s_zz;
  const double* __restrict__ s_tt = points.s_tt;
  const double* __restrict__ s_rz = points.s_rz;
  const double* __restrict__ d_rr = strain.d_rr;
  const double* __restrict__ d_zz = strain.d_zz;
  const double* __restrict__ d_tt = strain.d_tt;
  const double* __restrict__ d_rz = strain.d_rz;
  double* __restrict__ left = strain.left;

  for (std::size_t k = static_cast<std::size_t>(count); k < padded; ++k) {
    r[k] = shape.r_c;
    z[k] = 0.5 * (shape.zb0 + shape.zt0);
  }

  const double inverse_a = 1.0 / shape.a;
  double gone = 0.0, work = 0.0;
#pragma omp simd reduction(+ : gone, work)
  for (std::size_t k = 0; k < padded; ++k) {
    const double x = (r[k] - shape.r_c) * inverse_a;
    double x_in = select(x > -1.0, x, -1.0);
    x_in = select(x_in < 1.0, x_in, 1.0);
    const double bottom = shape.zb0 + shape.zb1 * x_in, top = shape.zt0 + shape.zt1 * x_in;
    const double y = 2.0 * (z[k] - bottom) / (top - bottom) - 1.0;
    double y_in = select(y > -1.0, y, -1.0);
    y_in = select(y_in < 1.0, y_in, 1.0);
    const bool inside = (x >= cell.xi_min) & (x <= cell.xi_max) & (y >= cell.eta_min) & (y <= cell.eta_max);
    xi[k] = x_in;
    eta[k] = y_in;
    left[k] = select(inside, 0.0, 1.0);
    gone += left[k];
    work += volume[k] * (s_rr[k] * d_rr[k] + s_zz[k] * d_zz[k] + s_tt[k] * d_tt[k] + 2.0 * s_rz[k] * d_rz[k]);
  }
  left_count = static_cast<std::int32_t>(gone);

  double m0 = 0, m1 = 0, m2 = 0, m3 = 0, r0 = 0, r1 = 0, r2 = 0, r3 = 0, z0 = 0, z1 = 0, z2 = 0, z3 = 0;
#pragma omp simd reduction(+ : m0, m1, m2, m3, r0, r1, r2, r3, z0, z1, z2, z3)
  for (std::size_t k = 0; k < padded; ++k) {
    const double m = mass[k] * (1.0 - left[k]) * 0.25;
    const double low = m * (1.0 - eta[k]), high = m * (1.0 + eta[k]);
    const double n0 = low * (1.0 - xi[k]), n1 = low * (1.0 + xi[k]);
    const double n2 = high * (1.0 + xi[k]), n3 = high * (1.0 - xi[k]);
    const double vr = v_r[k], vz = v_z[k];
    m0 += n0, m1 += n1, m2 += n2, m3 += n3;
    r0 += n0 * vr, r1 += n1 * vr, r2 += n2 * vr, r3 += n3 * vr;
    z0 += n0 * vz, z1 += n1 * vz, z2 += n2 * vz, z3 += n3 * vz;
  }
  sums.mass[0] += m0, sums.mass[1] += m1, sums.mass[2] += m2, sums.mass[3] += m3;
  sums.p_r[0] += r0, sums.p_r[1] += r1, sums.p_r[2] += r2, sums.p_r[3] += r3;
  sums.p_z[0] += z0, sums.p_z[1] += z1, sums.p_z[2] += z2, sums.p_z[3] += z3;
  sums.material_mass[static_cast<std::int32_t>(material)] += m0 + m1 + m2 + m3;

  sum_half<false>(padded, points, left, sums);
  sum_half<true>(padded, points, left, sums);
  return 0.5 * work;
}

}  // namespace

extern const TransferKernels transfer;
const TransferKernels transfer = {move_points, sum_points};

}  // namespace cpt::solver::CPT_KERNEL_NAMESPACE
