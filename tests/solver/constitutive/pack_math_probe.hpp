// Logarithm and exponential of eight numbers (64-byte aligned) with the packs of one instruction set.
#pragma once

namespace cpt::solver {
void probe_baseline(const double* x, double* logarithm, double* exponential);
void probe_avx2(const double* x, double* logarithm, double* exponential);
void probe_avx512(const double* x, double* logarithm, double* exponential);
}  // namespace cpt::solver
