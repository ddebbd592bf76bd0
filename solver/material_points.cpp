#include "solver/material_points.hpp"

#include <algorithm>
#include <cstdlib>
#include <new>

namespace cpt::solver {
namespace {

constexpr std::size_t alignment = 64;
constexpr std::int32_t lanes = 8;

std::int32_t round_up(std::int32_t n) { return (n + lanes - 1) / lanes * lanes; }

// Room for a quarter more points than there are now.
std::int32_t capacity_for(std::int32_t count) { return round_up(count + std::max(2, count / 4)); }

// A massless point in a state that every law accepts: 10 kPa isotropic compression.
constexpr Point dummy = {{1.0, 0.0, 0.0, 0.0, -1e4, -1e4, -1e4, 0.0, 0.0, 0.0, 0.7, 5e3, 0.0, 0.0, 0.0},
                         0xffffffffU};

}  // namespace

void MaterialPoints::Free::operator()(double* p) const { std::free(p); }

MaterialPoints::MaterialPoints(const std::vector<Point>& points, const std::vector<std::int32_t>& bucket_of,
                               std::int32_t cells) {
  std::vector<std::int32_t> counts(static_cast<std::size_t>(cells) * material_count, 0);
  for (const std::int32_t b : bucket_of) ++counts[b];
  size_ = static_cast<std::int64_t>(points.size());
  allocate(counts);
  for (std::size_t k = 0; k < points.size(); ++k) {
    Bucket& bucket = buckets_[bucket_of[k]];
    const std::size_t slot = bucket.begin + static_cast<std::size_t>(bucket.count++);
    for (std::int32_t f = 0; f < field_count; ++f) field(f)[slot] = points[k].field[f];
    ids_[slot] = points[k].id;
  }
}

// Lays out empty buckets with room for `counts` points each. An empty bucket above or below one of the same
// material gets room too, because points will soon enter it.
void MaterialPoints::allocate(const std::vector<std::int32_t>& counts) {
  const auto n = static_cast<std::int32_t>(counts.size());
  buckets_.assign(counts.size(), Bucket{});
  slots_ = 0;
  for (std::int32_t b = 0; b < n; ++b) {
    const bool neighbour = (b >= material_count && counts[b - material_count] > 0) ||
                           (b + material_count < n && counts[b + material_count] > 0);
    buckets_[b].begin = slots_;
    buckets_[b].capacity = counts[b] > 0 ? capacity_for(counts[b]) : (neighbour ? lanes : 0);
    slots_ += static_cast<std::size_t>(buckets_[b].capacity);
  }
  const std::size_t bytes = slots_ * field_count * sizeof(double);
  data_.reset(static_cast<double*>(std::aligned_alloc(alignment, std::max(bytes, alignment))));
  if (!data_) throw std::bad_alloc();
  ids_.assign(slots_, dummy.id);
  for (std::size_t slot = 0; slot < slots_; ++slot) make_dummy(slot);
}

void MaterialPoints::make_dummy(std::size_t slot) {
  for (std::int32_t f = 0; f < field_count; ++f) field(f)[slot] = dummy.field[f];
  ids_[slot] = dummy.id;
}

void MaterialPoints::grow(std::int32_t full_bucket) {
  const std::vector<Bucket> old = buckets_;
  const std::size_t old_slots = slots_;
  const auto old_data = std::move(data_);
  const auto old_ids = std::move(ids_);
  std::vector<std::int32_t> counts(old.size());
  for (std::size_t b = 0; b < old.size(); ++b) counts[b] = old[b].count;
  ++counts[full_bucket];
  allocate(counts);
  for (std::size_t b = 0; b < old.size(); ++b) {
    const auto count = static_cast<std::size_t>(old[b].count);
    buckets_[b].count = old[b].count;
    for (std::int32_t f = 0; f < field_count; ++f)
      std::copy_n(old_data.get() + static_cast<std::size_t>(f) * old_slots + old[b].begin, count,
                  field(f) + buckets_[b].begin);
    std::copy_n(old_ids.begin() + static_cast<std::ptrdiff_t>(old[b].begin), count,
                ids_.begin() + static_cast<std::ptrdiff_t>(buckets_[b].begin));
  }
}

void MaterialPoints::move(std::int32_t from, std::int32_t slot_in_bucket, std::int32_t to) {
  if (buckets_[to].count == buckets_[to].capacity) grow(to);
  const std::size_t source = buckets_[from].begin + static_cast<std::size_t>(slot_in_bucket);
  const std::size_t target = buckets_[to].begin + static_cast<std::size_t>(buckets_[to].count++);
  const std::size_t last = buckets_[from].begin + static_cast<std::size_t>(--buckets_[from].count);
  for (std::int32_t f = 0; f < field_count; ++f) {
    double* values = field(f);
    values[target] = values[source];
    values[source] = values[last];
  }
  ids_[target] = ids_[source];
  ids_[source] = ids_[last];
  make_dummy(last);
}

PointFields MaterialPoints::fields(const Bucket& bucket) const {
  PointFields p{};
  auto** pointer = reinterpret_cast<double**>(&p);
  for (std::int32_t f = 0; f < field_count; ++f) pointer[f] = field(f) + bucket.begin;
  return p;
}

}  // namespace cpt::solver
