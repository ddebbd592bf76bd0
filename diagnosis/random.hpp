// Random numbers that are the same with every standard library: the generator is the standard's, which fixes
// its output, the transforms are written out here.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace cpt::diagnosis {

/// One of many independent streams of a seed; the same seed and stream give the same numbers.
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t stream) : bits_(mixed(seed + mixed(stream))) {}

  /// In (0, 1), never either end.
  [[nodiscard]] double uniform() { return (static_cast<double>(bits_() >> 11) + 0.5) * 0x1p-53; }

  /// Standard normal (Box and Muller 1958).
  [[nodiscard]] double normal() {
    if (spare_ready_) {
      spare_ready_ = false;
      return spare_;
    }
    const double radius = std::sqrt(-2.0 * std::log(uniform()));
    const double angle = 2.0 * std::numbers::pi * uniform();
    spare_ = radius * std::sin(angle);
    spare_ready_ = true;
    return radius * std::cos(angle);
  }

  [[nodiscard]] Eigen::VectorXd normals(Eigen::Index count) {
    Eigen::VectorXd z(count);
    for (Eigen::Index i = 0; i < count; ++i) z(i) = normal();
    return z;
  }

  /// An index in [0, count).
  [[nodiscard]] Eigen::Index below(Eigen::Index count) {
    return static_cast<Eigen::Index>(uniform() * static_cast<double>(count));
  }

 private:
  // SplitMix64 (Steele, Lea and Flood 2014): neighbouring seeds start far apart.
  static std::uint64_t mixed(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15ULL;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31);
  }

  std::mt19937_64 bits_;
  double spare_ = 0.0;
  bool spare_ready_ = false;
};

}  // namespace cpt::diagnosis
