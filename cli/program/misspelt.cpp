#include "cli/program/misspelt.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

#include "parameters/nearest_name.hpp"
#include "solver/quantities.hpp"

namespace cpt::cli {
namespace {

std::string nearest(std::string_view word, const std::vector<std::string>& names) {
  const std::vector<std::string_view> known(names.begin(), names.end());
  const std::string_view near = parameters::nearest_name(word, known);
  return near.empty() || near == word ? "" : fmt::format("did you mean {}?", near);
}

std::vector<std::string> options_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

std::vector<std::string> commands_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* below : command.get_subcommands({})) names.push_back(below->get_name());
  return names;
}

bool has(const std::vector<std::string>& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

// "tornadoo not in {sql,tornado}", behind "WHAT: ".
std::string nearest_choice(std::string_view complaint) {
  const auto list = complaint.find(" not in {"), end = complaint.rfind('}');
  if (list == complaint.npos || end == complaint.npos) return "";
  const std::string_view before = complaint.substr(0, list);
  const std::string_view word = before.substr(before.rfind(' ') + 1);  // npos + 1 is 0
  const auto first = list + std::string_view(" not in {").size();
  std::vector<std::string> choices;
  for (const std::string& item : CLI::detail::split(std::string(complaint.substr(first, end - first)), ','))
    choices.push_back(item.substr(0, item.find("->")));
  return nearest(word, choices);
}

}  // namespace

std::string misspelt_hint(const CLI::App& program, const std::vector<std::string>& words,
                          const CLI::ParseError& problem) {
  if (std::string hint = nearest_choice(problem.what()); !hint.empty()) return hint;
  const CLI::App* command = &program;
  for (const std::string& word : words) {
    const std::vector<std::string> commands = commands_of(*command);
    if (has(commands, word)) {
      command = command->get_subcommand(word);
    } else if (word.starts_with("--")) {
      const std::string name = word.substr(0, word.find('='));
      if (has(options_of(*command), name)) continue;
      if (std::string hint = nearest(name, options_of(*command)); !hint.empty()) return hint;
    } else if (!commands.empty() && !word.starts_with('-')) {
      return nearest(word, commands);
    }
  }
  return "";
}

}  // namespace cpt::cli
