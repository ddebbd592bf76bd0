#include "tests/fuzz/targets/hdf5.hpp"

namespace cpt::fuzz {

Fate hdf5_file(std::string_view bytes) { return use_hdf5(bytes); }

}  // namespace cpt::fuzz
