// The proof that needs no prior: does a mechanism predict the part of the recording that it has not seen?
//
// Each block of cells is left out in turn. Null and mechanism are fitted to the rest, the soil parameters of
// both as freely, and predict the block.
#pragma once

#include <cstdint>

#include "diagnosis/evidence.hpp"
#include "diagnosis/parameters_prior.hpp"

namespace cpt::diagnosis {

/// Contiguous rows of one sounding each, at least `length` [m] long where the sounding is; a rest too short
/// joins the last. Choose them longer than the noise's correlation length.
[[nodiscard]] std::vector<std::vector<Index>> depth_blocks(const std::vector<Cell>& cells, double length);

/// Whole soundings.
[[nodiscard]] std::vector<std::vector<Index>> sounding_blocks(const std::vector<Cell>& cells);

/// What was predicted of each cell while its block was left out.
struct Prediction {
  VectorXd mean;       // n [ln q_c]
  VectorXd variance;   // n [ln^2]
  VectorXd log_score;  // blocks: ln of the density of the block's cells together
  double rmse;         // [ln q_c]
};

/// Throws std::invalid_argument for fewer than two blocks, as does the next.
[[nodiscard]] Prediction predict_null(const NullModel& null, const VectorXd& recorded,
                                      const std::vector<std::vector<Index>>& blocks);

[[nodiscard]] Prediction predict_mechanism(const NullModel& null, const CurveEmulator& emulator,
                                           const VectorXd& recorded,
                                           const std::vector<std::vector<Index>>& blocks,
                                           const GridOptions& options = {});

/// How much better than the null.
struct HeldOutGain {
  double rmse_null, rmse;  // [ln q_c]
  double log_score;        // [-] gain of all blocks' log scores together
  double per_cell;         // [-] mean gain of the cells' own log densities (normal, of equal moments)
  double lower, upper;     // of per_cell, 90 %, circular block bootstrap (Politis and Romano 1992)
};

/// `block_cells` is the bootstrap's block length, as long as a held-out block.
[[nodiscard]] HeldOutGain held_out_gain(const VectorXd& recorded, const Prediction& null,
                                        const Prediction& mechanism, int block_cells, std::uint64_t seed,
                                        int resamples = 2000);

}  // namespace cpt::diagnosis
