#include "tests/faults/faults.hpp"

namespace cpt::tests {

const std::vector<Fault>& all_faults() {
  static const std::vector<Fault> all = [] {
    std::vector<Fault> list = kills();
    for (Fault& fault : storage_faults()) list.push_back(std::move(fault));
    for (Fault& fault : refusal_faults()) list.push_back(std::move(fault));
    for (Fault& fault : other_faults()) list.push_back(std::move(fault));
    return list;
  }();
  return all;
}

}  // namespace cpt::tests
