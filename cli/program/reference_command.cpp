// campaign reference
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/command.hpp"
#include "cli/exit_codes.hpp"
#include "cli/program/reference_page.hpp"

namespace cpt::cli {

void add_reference(CLI::App& program, Action& action) {
  auto man = std::make_shared<bool>(false);
  CLI::App* command = program.add_subcommand(
      "reference", "Print the reference as Markdown: commands, keys, quantities and all other lists");
  command->add_flag("--man", *man, "Print the man page in its place");
  command->footer(R"(Examples:
  campaign reference > docs/reference.md     after a change of any list, option or help text
  campaign reference --man | man -l -)");
  command->callback([man, &program, &action] {
    action = [man, &program] {
      const CommandEntry tree = command_tree(program);
      fmt::print("{}", *man ? man_page(tree) : reference_page(tree));
      return static_cast<int>(all_well);
    };
  });
}

}  // namespace cpt::cli
