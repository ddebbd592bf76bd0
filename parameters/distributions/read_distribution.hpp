// A row's `distribution = { kind = ..., ... }`: by parameters, by moments or by quantiles.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "parameters/distributions/distribution.hpp"
#include "parameters/document.hpp"
#include "parameters/fields.hpp"
#include "parameters/keys.hpp"
#include "solver/quantities.hpp"

namespace cpt::parameters {

/// The keys that a distribution may have, one table a kind, in the study's words.
[[nodiscard]] std::span<const KeyTable> distribution_kinds();

/// The distribution of `quantity`, in its study unit; a choice's values are their indices. `key` is what
/// errors name. Cut off at the ends of the quantity's valid range, beyond which at most one part in a
/// thousand may lie. Nothing after an error. An empirical one has its values in the section [data] of `root`.
[[nodiscard]] std::optional<Distribution> read_distribution(const Value& value,
                                                            const solver::Quantity& quantity,
                                                            const std::string& key, const Value& root,
                                                            ErrorList& errors);

}  // namespace cpt::parameters
