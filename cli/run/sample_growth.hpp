// A Latin hypercube that grows: what the user is told of it.
#pragma once

#include <string>

#include "parameters/study.hpp"
#include "results/ledger/matching.hpp"

namespace cpt::cli {

/// How even the grown sample is, beside a fresh one of its size; empty where the study's sample did not grow.
[[nodiscard]] std::string growth_note(const parameters::Study& study);

/// Where the study's sample is larger than the one that is stored and keeps fewer of its runs than it could:
/// what to write to keep them. Else empty.
[[nodiscard]] std::string growth_advice(const parameters::Study& study, const results::Prospect& stored);

/// Throws BadInput with the advice: a fresh sample is run only where the study says so.
void refuse_forgotten_growth(const parameters::Study& study);

}  // namespace cpt::cli
