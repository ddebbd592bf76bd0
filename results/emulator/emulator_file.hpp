// An emulator as an HDF5 file, NAME-emulator.h5 beside the ledger: what it was made of, the places of its
// runs, and of each output shapes, scores, lengths and nugget. Processes are solved anew when it is read, to
// the same bits.
#pragma once

#include <filesystem>

#include "results/emulator/emulator.hpp"
#include "results/files/error.hpp"

namespace cpt::results {

/// NAME-emulator.h5 beside NAME.sqlite.
[[nodiscard]] std::filesystem::path emulator_file_of(const std::filesystem::path& database);

/// Writes the file whole. Throws Error if it cannot be written.
void write_emulator(const std::filesystem::path& file, const Emulator& emulator);

/// Throws Error, naming the file, if it is missing, damaged or no emulator.
[[nodiscard]] Emulator read_emulator(const std::filesystem::path& file);

}  // namespace cpt::results
