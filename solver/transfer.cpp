#include "solver/transfer.hpp"

#include "solver/instruction_set.hpp"

namespace cpt::solver {

namespace kernels_for_baseline {
extern const TransferKernels transfer;
}
#if defined(__x86_64__)
namespace kernels_for_avx2 {
extern const TransferKernels transfer;
}
namespace kernels_for_avx512 {
extern const TransferKernels transfer;
}
#endif

const TransferKernels& transfer_kernels() {
#if defined(__x86_64__)
  if (instruction_set() == InstructionSet::avx512) return kernels_for_avx512::transfer;
  if (instruction_set() == InstructionSet::avx2) return kernels_for_avx2::transfer;
#endif
  return kernels_for_baseline::transfer;
}

double corner_mass(const CellSums& sums, int k) {
  constexpr double xi[4] = {-1.0, 1.0, 1.0, -1.0}, eta[4] = {-1.0, -1.0, 1.0, 1.0};
  return 0.25 * (sums.moment[0] + xi[k] * sums.moment[1] + eta[k] * sums.moment[2] +
                 xi[k] * eta[k] * sums.moment[3]);
}

void add_to_sums(CellSums& sums, const PointFields& points, std::size_t k, std::int32_t material) {
  const double x = points.xi[k], y = points.eta[k], v = points.volume[k], m = points.mass[k];
  const int q = (x > 0.0 ? 1 : 0) + (y > 0.0 ? 2 : 0);
  sums.volume[q] += v;
  sums.s_rr[q] += v * points.s_rr[k];
  sums.s_zz[q] += v * points.s_zz[k];
  sums.s_tt[q] += v * points.s_tt[k];
  sums.s_rz[q] += v * points.s_rz[k];
  const double of[9] = {1.0, x, y, x * y, x * x, y * y, x * x * y, x * y * y, x * x * y * y};
  for (int i = 0; i < 9; ++i) sums.moment[i] += m * of[i];
  const double N[4] = {0.25 * (1 - x) * (1 - y), 0.25 * (1 + x) * (1 - y), 0.25 * (1 + x) * (1 + y),
                       0.25 * (1 - x) * (1 + y)};
  for (int i = 0; i < 4; ++i) {
    sums.p_r[i] += N[i] * m * points.v_r[k];
    sums.p_z[i] += N[i] * m * points.v_z[k];
  }
  sums.material_mass[material] += m;
}

}  // namespace cpt::solver
