// One realization of a study whose solver is an external program: its folder, its files, its run and what it
// gave. docs/external-solvers.md has what the program finds and may leave.
#pragma once

#include <functional>
#include <string>

#include "campaign/messages.hpp"

namespace cpt::campaign {

struct ProgramWatch {
  std::function<bool()> told_to_end;        ///< polled some times a second
  std::function<void(std::string)> remark;  ///< what the user should know
};

/// Runs the setup's program in the order's work folder, anew after a crash as often as its limits say. All it
/// does wrong is an outcome; told to end, the outcome is a time limit. The work folder stays where the run
/// failed, and where the limits say so. Nothing that it has started outlives the call.
[[nodiscard]] solver::Outcome run_program(const Order& order, const ProgramWatch& watch);

/// The same within the realization's own process (order_server.hpp), told to end by its signals. A program
/// outlives its starter, so that this process stays to end it when its own parent has gone.
[[nodiscard]] solver::Outcome run_ordered_program(const Order& order);

/// The command's words with the paths of files that lie in the folder; others as they are, and so is
/// `template_name`, which is the filled copy in the work folder.
[[nodiscard]] std::vector<std::string> resolved_command(const std::vector<std::string>& command,
                                                        const std::string& folder,
                                                        const std::string& template_name = "");
/// Whether that first word of a command can be started: a path, or found in PATH.
[[nodiscard]] bool is_there(const std::string& program);

}  // namespace cpt::campaign
