// The material points, in structure-of-arrays form, kept sorted by cell and soil.
//
// Points of one cell and one soil form a bucket: a block of its own, field after field, a multiple of eight
// slots each, aligned to a vector register, the unused tail holding massless dummies. So every kernel runs
// without gather, scatter, masks or atomics, one bucket lies in a few pages, and sums over it have one fixed
// order whatever the number of threads.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "solver/push_state.hpp"
#include "solver/setup.hpp"

namespace cpt::solver {

/// What material points are made of has a number: the soils of the setup in their order, then the surcharge
/// above them.
inline constexpr std::int32_t most_materials = 8;  // that a cell's sums have room for

/// Pointers to a bucket's first slot in each field.
struct PointFields {
  double* r;     // [m] position
  double* z;     // [m]
  double* v_r;   // [m/s] velocity
  double* v_z;   // [m/s]
  double* s_rr;  // [Pa] Cauchy stress, tension-positive
  double* s_zz;
  double* s_tt;
  double* s_rz;
  double* mass;    // [kg/rad]
  double* volume;  // [m3/rad]
  double* e;       // [-] void ratio
  double* h_0;     // first state variable of the soil's law (soils/law.hpp)
  double* xi;      // [-] natural coordinates in the cell
  double* eta;
  double* load;  // [N/rad] share of a traction at the soil's top, downward
  double* id;    // whole number that follows the point for ever
  double* h_1;   // second state variable of the soil's law
};
inline constexpr std::int32_t field_count = sizeof(PointFields) / sizeof(double*);

struct Bucket {
  double* data = nullptr;     // field f begins at data + f * capacity
  std::int32_t count = 0;     // points
  std::int32_t capacity = 0;  // slots, a multiple of 8
  [[nodiscard]] std::size_t padded() const { return static_cast<std::size_t>((count + 7) / 8 * 8); }
};

/// One point, to be put into a bucket: its fields in the order of PointFields.
struct Point {
  double r, z, v_r, v_z, s_rr, s_zz, s_tt, s_rz, mass, volume, e, h_0, xi, eta, load, id, h_1;
};
using PointValues = std::array<double, field_count>;
static_assert(sizeof(Point) == sizeof(PointValues), "as many as in PointFields");
[[nodiscard]] constexpr PointValues values_of(const Point& point) {
  return std::bit_cast<PointValues>(point);
}

class MaterialPoints {
 public:
  /// Sorts `points` into buckets: bucket_of[k] = cell * materials + material.
  MaterialPoints(const std::vector<Point>& points, const std::vector<std::int32_t>& bucket_of,
                 std::int32_t cells, std::int32_t materials);

  [[nodiscard]] std::int32_t materials() const { return materials_; }

  [[nodiscard]] const Bucket& bucket(std::int32_t index) const { return buckets_[index]; }
  [[nodiscard]] std::int32_t bucket_count() const { return static_cast<std::int32_t>(buckets_.size()); }
  [[nodiscard]] PointFields fields(const Bucket& bucket) const;
  /// Starts to load a bucket's state into the cache.
  static void prefetch(const Bucket& bucket) {
    const auto padded = static_cast<std::int32_t>(bucket.padded());
    const double* field = bucket.data;
    for (std::int32_t f = 0; f < field_count - 3; ++f, field += bucket.capacity)  // all but load, id, h_1
      for (std::int32_t k = 0; k < padded; k += 8) __builtin_prefetch(field + k, 1);
  }
  [[nodiscard]] std::int64_t size() const { return size_; }
  [[nodiscard]] std::int32_t largest_capacity() const { return largest_capacity_; }

  /// Moves a point to the end of another bucket; the source's last point takes its slot. A full bucket moves
  /// to a larger block; blocks are used again, so memory is taken from the system only now and then.
  void move(std::int32_t from, std::int32_t slot_in_bucket, std::int32_t to);

  /// All buckets with all their slots: a law may change the dummies too, and they take part in its stiffness.
  void exchange(StateWriter& state) const;
  void exchange(StateReader& state);

 private:
  [[nodiscard]] double* take_block(std::int32_t capacity);
  void return_block(const Bucket& bucket);
  void grow(Bucket& bucket);

  struct Free {
    void operator()(double* p) const;
  };
  std::vector<std::unique_ptr<double[], Free>> arenas_;
  std::size_t arena_left_ = 0;  // doubles
  double* arena_next_ = nullptr;
  std::vector<std::vector<double*>> free_blocks_;  // by capacity / 8
  std::vector<Bucket> buckets_;
  std::int32_t largest_capacity_ = 0;
  std::int64_t size_ = 0;
  std::int32_t materials_;
};

}  // namespace cpt::solver
