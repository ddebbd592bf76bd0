// What this machine can do, for shares: memory bandwidth and arithmetic of `threads` cores together.
#pragma once

namespace cpt::benchmarks {

/// Memory bandwidth [bytes/s] of the triad a = b + s c of STREAM (McCalpin 1995) on arrays beyond all caches,
/// counted as STREAM does: 24 bytes an element.
[[nodiscard]] double triad_bandwidth(int threads);

/// Rate of multiply-adds in double precision [flops/s], two a lane, with the widest vectors the machine has.
[[nodiscard]] double peak_flops(int threads);

}  // namespace cpt::benchmarks
