// Plans of concealed benchmarks as files.
#pragma once

#include <filesystem>

#include "validation/concealed/plan.hpp"

namespace cpt::cli {

/// A plan and its study, as written.
struct PlanFile {
  parameters::Study study;
  std::string study_text;
  validation::concealed::Plan plan;
};

/// Throws BadInput with all that is wrong in plan and study.
[[nodiscard]] PlanFile read_plan_file(const std::filesystem::path& file);

}  // namespace cpt::cli
