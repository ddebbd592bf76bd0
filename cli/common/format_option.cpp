#include "cli/common/format_option.hpp"

#include <CLI/CLI.hpp>

namespace cpt::cli {

void add_format_option(CLI::App& command, results::Format& format) {
  command
      .add_option_function<std::string>(
          "--format",
          [&format](const std::string& name) { format = results::format_from_string(name).value(); },
          "table (to read), csv or json (all digits)")
      ->check(CLI::IsMember({"table", "csv", "json"}))
      ->default_str("table");
}

}  // namespace cpt::cli
