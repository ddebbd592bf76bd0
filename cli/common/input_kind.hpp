// The text files that commands take: a study, a request, a plan, measured data.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace cpt::cli {

enum class InputKind { study, request, plan, recording, triaxial_test, table, database, other };

/// By what it holds, not by its name; `other` also where it cannot be told, as of measured data.
[[nodiscard]] InputKind kind_of(std::string_view content);

/// The text of a file of the kind that a command takes, or of a pipe that somebody writes to. Throws BadInput
/// with the cause if it cannot be read, and with the commands that take the file if it is known to be of
/// another kind; results::Interrupted if a signal ends the wait for a pipe.
[[nodiscard]] std::string read_input(InputKind wanted, const std::filesystem::path& file);

}  // namespace cpt::cli
