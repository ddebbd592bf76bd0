// The text files that commands take: a study, a request, a plan.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace cpt::cli {

enum class InputKind { study, request, plan, database, other };

/// By what it holds, not by its name; `other` also where it cannot be told.
[[nodiscard]] InputKind kind_of(std::string_view content);

/// The text of a file of the kind that a command takes. Throws BadInput with the cause if it cannot be read,
/// and with the commands that take the file if it is known to be of another kind.
[[nodiscard]] std::string read_input(InputKind wanted, const std::filesystem::path& file);

}  // namespace cpt::cli
