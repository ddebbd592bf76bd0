// What the model of a campaign leaves of what its study asks for.
#pragma once

#include <string>
#include <vector>

#include "results/ledger/snapshot.hpp"

namespace cpt::results {

/// Layers that are made otherwise than asked (solver/thin_layers.hpp), in sentences; empty where all are as
/// asked. Of a study that this version refuses for its layers, why.
[[nodiscard]] std::vector<std::string> model_remarks(const Snapshot& campaign);

}  // namespace cpt::results
