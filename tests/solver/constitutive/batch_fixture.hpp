// A batch that owns its arrays.
#pragma once

#include <cstdlib>
#include <cstring>
#include <memory>

#include "solver/constitutive/batch.hpp"

namespace cpt::solver {

class OwnedBatch {
 public:
  static constexpr std::size_t field_count = 10;

  explicit OwnedBatch(std::size_t size)
      : size_(size),
        data_(static_cast<double*>(std::aligned_alloc(64, field_count * size * sizeof(double))), &std::free) {
    std::memset(data_.get(), 0, field_count * size * sizeof(double));
  }

  /// In the order of Batch: s_rr, s_zz, s_tt, s_rz, e, p_i, d_rr, d_zz, d_tt, d_rz.
  [[nodiscard]] double* field(std::size_t i) { return data_.get() + i * size_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] Batch view() {
    return {size_,    field(0), field(1), field(2), field(3), field(4),
            field(5), field(6), field(7), field(8), field(9)};
  }

 private:
  std::size_t size_;
  std::unique_ptr<double[], decltype(&std::free)> data_;
};

}  // namespace cpt::solver
