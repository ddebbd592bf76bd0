// campaign completion SHELL
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/command.hpp"
#include "cli/exit_codes.hpp"
#include "cli/program/completion_script.hpp"

namespace cpt::cli {

void add_completion(CLI::App& program, Action& action) {
  auto shell = std::make_shared<std::string>();
  CLI::App* command =
      program.add_subcommand("completion", "Print the script that completes the command line");
  command->add_option("SHELL", *shell, "bash; zsh reads the same script")
      ->type_name("")
      ->required()
      ->check(CLI::IsMember({"bash"}).description(""));
  command->footer(R"(An installed program brings it along for bash. Otherwise, in ~/.bashrc:
  source <(campaign completion bash)
or in ~/.zshrc:
  autoload -U +X bashcompinit && bashcompinit
  source <(campaign completion bash))");
  command->callback([shell, &program, &action] {
    action = [shell, &program] {
      fmt::print("{}", bash_completion(command_tree(program)));
      return static_cast<int>(all_well);
    };
  });
}

}  // namespace cpt::cli
