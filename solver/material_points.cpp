#include "solver/material_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <new>

namespace cpt::solver {
namespace {

constexpr std::size_t alignment = 64;
constexpr std::int32_t lanes = 8;
constexpr std::size_t arena_doubles = std::size_t{1} << 17;  // 1 MiB

// Room for a quarter more points than there are now.
std::int32_t capacity_for(std::int32_t count) {
  const std::int32_t wanted = count + std::max(2, count / 4);
  return (wanted + lanes - 1) / lanes * lanes;
}

// A massless point in a state that every law accepts: 10 kPa isotropic compression.
constexpr PointValues dummy = values_of({.r = 1.0,
                                         .z = 0.0,
                                         .v_r = 0.0,
                                         .v_z = 0.0,
                                         .s_rr = -1e4,
                                         .s_zz = -1e4,
                                         .s_tt = -1e4,
                                         .s_rz = 0.0,
                                         .mass = 0.0,
                                         .volume = 0.0,
                                         .e = 0.7,
                                         .h_0 = 5e3,
                                         .xi = 0.0,
                                         .eta = 0.0,
                                         .load = 0.0,
                                         .id = -1.0,
                                         .h_1 = 0.0});

double& at(const Bucket& bucket, std::int32_t field, std::int32_t slot) {
  return bucket.data[static_cast<std::ptrdiff_t>(field) * bucket.capacity + slot];
}

void make_dummy(const Bucket& bucket, std::int32_t slot) {
  for (std::int32_t f = 0; f < field_count; ++f) at(bucket, f, slot) = dummy[static_cast<std::size_t>(f)];
}

}  // namespace

void MaterialPoints::Free::operator()(double* p) const { std::free(p); }

MaterialPoints::MaterialPoints(const std::vector<Point>& points, const std::vector<std::int32_t>& bucket_of,
                               std::int32_t cells, std::int32_t materials)
    : size_(static_cast<std::int64_t>(points.size())), materials_(materials) {
  std::vector<std::int32_t> counts(static_cast<std::size_t>(cells) * static_cast<std::size_t>(materials), 0);
  for (const std::int32_t b : bucket_of) ++counts[b];
  buckets_.resize(counts.size());
  for (std::size_t b = 0; b < counts.size(); ++b) {
    if (counts[b] == 0) continue;
    buckets_[b].capacity = capacity_for(counts[b]);
    buckets_[b].data = take_block(buckets_[b].capacity);
    for (std::int32_t slot = 0; slot < buckets_[b].capacity; ++slot) make_dummy(buckets_[b], slot);
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    Bucket& bucket = buckets_[bucket_of[k]];
    const PointValues values = values_of(points[k]);
    for (std::int32_t f = 0; f < field_count; ++f)
      at(bucket, f, bucket.count) = values[static_cast<std::size_t>(f)];
    ++bucket.count;
  }
}

double* MaterialPoints::take_block(std::int32_t capacity) {
  largest_capacity_ = std::max(largest_capacity_, capacity);
  const auto size_class = static_cast<std::size_t>(capacity / lanes);
  if (free_blocks_.size() <= size_class) free_blocks_.resize(size_class + 1);
  std::vector<double*>& free = free_blocks_[size_class];
  if (!free.empty()) {
    double* block = free.back();
    free.pop_back();
    return block;
  }
  const std::size_t doubles = static_cast<std::size_t>(capacity) * field_count;
  if (arena_left_ < doubles) {
    arena_left_ = std::max(arena_doubles, doubles);
    arenas_.emplace_back(static_cast<double*>(std::aligned_alloc(alignment, arena_left_ * sizeof(double))));
    if (!arenas_.back()) throw std::bad_alloc();
    arena_next_ = arenas_.back().get();
  }
  double* block = arena_next_;
  arena_next_ += doubles;
  arena_left_ -= doubles;
  return block;
}

void MaterialPoints::return_block(const Bucket& bucket) {
  if (bucket.capacity > 0)
    free_blocks_[static_cast<std::size_t>(bucket.capacity / lanes)].push_back(bucket.data);
}

void MaterialPoints::grow(Bucket& bucket) {
  Bucket larger;
  larger.capacity = capacity_for(bucket.count + 1);
  larger.data = take_block(larger.capacity);
  larger.count = bucket.count;
  for (std::int32_t f = 0; f < field_count; ++f)
    for (std::int32_t slot = 0; slot < larger.capacity; ++slot)
      at(larger, f, slot) = slot < bucket.count ? at(bucket, f, slot) : dummy[static_cast<std::size_t>(f)];
  return_block(bucket);
  bucket = larger;
}

void MaterialPoints::move(std::int32_t from, std::int32_t slot_in_bucket, std::int32_t to) {
  Bucket &source = buckets_[from], &target = buckets_[to];
  if (target.count == target.capacity) grow(target);
  const std::int32_t last = source.count - 1;
  for (std::int32_t f = 0; f < field_count; ++f) {
    at(target, f, target.count) = at(source, f, slot_in_bucket);
    at(source, f, slot_in_bucket) = at(source, f, last);
  }
  make_dummy(source, last);
  ++target.count;
  if (--source.count == 0) {
    return_block(source);
    source = Bucket{};
  }
}

void MaterialPoints::exchange(StateWriter& state) const {
  std::vector<double> counts, capacities, slots;
  for (const Bucket& bucket : buckets_) {
    counts.push_back(bucket.count);
    capacities.push_back(bucket.capacity);
    slots.insert(slots.end(), bucket.data,
                 bucket.data + static_cast<std::ptrdiff_t>(bucket.capacity) * field_count);
  }
  state("points.counts", counts);
  state("points.capacities", capacities);
  state("points.slots", slots);
}

void MaterialPoints::exchange(StateReader& state) {
  std::vector<double> counts(buckets_.size()), capacities(buckets_.size());
  state("points.counts", counts);
  state("points.capacities", capacities);
  const std::vector<double>& slots = state.find("points.slots");
  double points = 0.0, all_slots = 0.0;
  for (std::size_t b = 0; b < buckets_.size(); ++b) {
    points += counts[b];
    all_slots += capacities[b];
    if (!(counts[b] >= 0.0 && counts[b] <= capacities[b]) || std::fmod(capacities[b], lanes) != 0.0)
      throw StateMismatch("the state of the push has broken buckets");
  }
  if (points != static_cast<double>(size_) || all_slots * field_count != static_cast<double>(slots.size()))
    throw StateMismatch("the state of the push has another number of material points");

  arenas_.clear();
  arena_left_ = 0;
  free_blocks_.clear();
  const double* next = slots.data();
  for (std::size_t b = 0; b < buckets_.size(); ++b) {
    buckets_[b] = {nullptr, static_cast<std::int32_t>(counts[b]), static_cast<std::int32_t>(capacities[b])};
    if (buckets_[b].capacity == 0) continue;
    buckets_[b].data = take_block(buckets_[b].capacity);
    const std::ptrdiff_t size = static_cast<std::ptrdiff_t>(buckets_[b].capacity) * field_count;
    std::copy_n(next, size, buckets_[b].data);
    next += size;
  }
}

PointFields MaterialPoints::fields(const Bucket& bucket) const {
  PointFields p{};
  auto** pointer = reinterpret_cast<double**>(&p);
  for (std::int32_t f = 0; f < field_count; ++f)
    pointer[f] = bucket.data + static_cast<std::ptrdiff_t>(f) * bucket.capacity;
  return p;
}

}  // namespace cpt::solver
