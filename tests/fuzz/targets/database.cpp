#include <fstream>

#include "tests/fuzz/targets/use_ledger.hpp"

namespace cpt::fuzz {

Fate database(std::string_view bytes) {
  const std::filesystem::path file = scratch("fuzzed.sqlite");
  std::ofstream(file, std::ios::binary) << bytes;
  return use_ledger(file);
}

}  // namespace cpt::fuzz
