#include "cli/run/study_remarks.hpp"

#include <fmt/format.h>

#include "solver/thin_layers.hpp"

namespace cpt::cli {

void print_remarks(const parameters::Study& study) {
  for (const std::string& remark : solver::layer_remarks(study.baseline)) fmt::print("note: {}\n", remark);
}

}  // namespace cpt::cli
