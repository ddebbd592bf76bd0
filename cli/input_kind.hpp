// What a file is that stands where a command takes another kind.
#pragma once

#include <filesystem>
#include <string_view>

namespace cpt::cli {

enum class InputKind { study, request, plan, database, other };

/// By what it holds, not by its name; `other` also where it cannot be told.
[[nodiscard]] InputKind kind_of(std::string_view content);

/// Throws BadInput, with the commands that take the file, if it is known to be of another kind than wanted.
void expect_kind(InputKind wanted, const std::filesystem::path& file, std::string_view content);

}  // namespace cpt::cli
