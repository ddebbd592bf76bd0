// The curves as an HDF5 file, for HDFView, h5py and pandas.
//
// The ledger's `curve` table is the source of truth: a curve is part of the transaction that records its
// realization. The HDF5 file mirrors it. It is written whole to a temporary file and renamed into place, so
// it is always complete, and is rebuilt from the ledger whenever it is missing, damaged or behind.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "results/files/error.hpp"
#include "results/ledger/snapshot.hpp"

namespace cpt::results {

/// One group of the file, `/realizations/0001`: these attributes, and the datasets depth_m and NAME_kPa of
/// each channel that was recorded. Of an external program the datasets NAME of each output, a scalar's with
/// one number, and NAME.x of a curve's abscissa.
struct StoredCurve {
  int realization = 0;
  std::string parameter, side, value_text, unit, status, settings_hash;
  std::optional<double> value;  ///< study unit; none for the baseline
  std::vector<double> depth_m;
  std::map<std::string, std::vector<double>> channels_kPa;  ///< by the name of the channel
  std::vector<solver::ProgramResult> declared = {};         ///< by name
  bool operator==(const StoredCurve&) const = default;
};

/// Writes `file` from the ledger at `database`: some 0.4 ms a curve. Throws Error if it cannot be written.
void write_curves(const std::filesystem::path& file, const std::filesystem::path& database);

/// The same if what is in `file` is something else; true if it had to be written.
bool sync_curves(const std::filesystem::path& file, const std::filesystem::path& database);

/// Reads all curves of a file; throws Error if it is missing or damaged.
[[nodiscard]] std::vector<StoredCurve> read_curves(const std::filesystem::path& file);

}  // namespace cpt::results
