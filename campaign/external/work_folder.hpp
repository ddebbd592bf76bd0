// Where external programs work: NAME.work beside the database, a folder a realization.
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <limits>
#include <system_error>

#include "campaign/messages.hpp"
#include "parameters/study.hpp"

namespace cpt::campaign {

[[nodiscard]] inline std::filesystem::path work_folder(const parameters::Study& study) {
  return std::filesystem::path(study.database).replace_extension(".work");
}

/// For an order with an external program: its checkpoint becomes a folder, and its own process looks at what
/// it writes and how long ago.
inline void give_folders(Order& order, const parameters::Study& study) {
  if (order.setup.program == nullptr) return;
  order.work = work_folder(study) / fmt::format("{:04}", order.realization);
  if (!order.checkpoint.empty())
    order.checkpoint = std::filesystem::path(order.checkpoint).replace_extension().string();
  order.hang_limit_seconds = std::numeric_limits<double>::infinity();
}

/// Removes the folder unless something is left in it.
inline void leave_work_folder(const parameters::Study& study) {
  std::error_code not_empty;
  if (study.baseline.program) std::filesystem::remove(work_folder(study), not_empty);
}

}  // namespace cpt::campaign
