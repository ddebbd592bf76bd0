// Small sound HDF5 files of the kinds that the program reads, and the reading of them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/fuzz/targets.hpp"

namespace cpt::fuzz {

/// Bytes of a curve file, of a checkpoint, of histories and of an emulator, in this order.
[[nodiscard]] const std::vector<std::string>& sound_hdf5_files();

/// Reads the bytes as each of the four kinds, whatever they are; each is read or refused with a
/// results::Error. Sound if one is read.
[[nodiscard]] Fate use_hdf5(std::string_view bytes);

}  // namespace cpt::fuzz
