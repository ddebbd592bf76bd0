// The process of one realization, whatever runs in it: an order comes in; remarks, progress and the outcome
// go out.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>

#include "campaign/messages.hpp"

namespace cpt::campaign {

/// Serves the parent at descriptor 3: receives one order, runs it, sends the outcome, and returns the
/// process's exit code. The process dies with its parent; a stop signal makes `told_to_end` true, and what
/// `run` then has is still sent.
[[nodiscard]] int serve_order(const std::function<solver::Outcome(const Order&)>& run);

// For what runs.
[[nodiscard]] bool told_to_end();
/// False if the parent is gone.
bool send_remark(int realization, std::string text);
/// Left out, rather than waited for, where the parent does not listen just now.
void send_progress(const ProgressReport& report);
/// From here on the parent's death is a stop signal: what runs has something to end itself.
void outlive_parent_to_end();

}  // namespace cpt::campaign
