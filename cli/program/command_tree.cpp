#include "cli/program/command_tree.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

namespace cpt::cli {
namespace {

// CLI11 keeps the choices and the range of an option inside its validators, which tell them only to a value
// that is none: "X not in {a,b}", "Value X not in range 1 to 9". (Their descriptions are for --help, and are
// often emptied.)
std::string complaint(CLI::Option& option) {
  std::string text;
  for (int i = 0;; ++i) {
    std::string impossible = "-987654321";  // reads as a number too
    try {
      text += (*option.get_validator(i))(impossible);
    } catch (const CLI::OptionNotFound&) {
      return text;
    }
  }
}

std::vector<std::string> choices_of(const std::string& complaint) {
  const auto open = complaint.find('{'), close = complaint.find('}');
  if (open == std::string::npos || close == std::string::npos) return {};
  std::vector<std::string> choices;
  for (const std::string& item : CLI::detail::split(complaint.substr(open + 1, close - open - 1), ','))
    choices.push_back(item.substr(0, item.find("->")));  // "name->value" of a transformer
  return choices;
}

// With the digits of std::to_string taken away: "0.100000" is 0.1.
std::string range_of(const std::string& complaint) {
  constexpr std::string_view before = "not in range ";
  const auto at = complaint.find(before);
  if (at == std::string::npos) return "";
  const auto words = CLI::detail::split(complaint.substr(at + before.size()), ' ');
  return fmt::format("{} to {}", std::stod(words.at(0)), std::stod(words.at(2)));
}

std::string value_of(const CLI::Option& option, const std::vector<std::string>& choices) {
  if (option.get_positional() || option.get_items_expected_max() == 0) return "";
  const std::string type = option.get_type_name();
  const std::string name = type.substr(0, type.find(':'));
  if (name == "TEXT" && !choices.empty()) return fmt::format("{}", fmt::join(choices, "|"));
  return name;
}

OptionEntry entry_of(CLI::Option& option) {
  const std::string said = complaint(option);
  OptionEntry entry;
  entry.argument = option.get_positional();
  if (entry.argument) entry.names.push_back(option.get_name(true, false));
  for (const std::string& name : option.get_snames()) entry.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) entry.names.push_back("--" + name);
  entry.choices = choices_of(said);
  entry.range = range_of(said);
  entry.value = value_of(option, entry.choices);
  entry.meaning = option.get_description();
  if (const std::string usual = option.get_default_str(); !usual.empty())
    entry.meaning += fmt::format(" [{}]", usual);
  entry.required = option.get_required();
  entry.several = option.get_items_expected_max() > 1;
  return entry;
}

CommandEntry entry_of(CLI::App& app, const std::string& before) {
  CommandEntry command{before + app.get_name(), app.get_description(), {}, app.get_footer(), {}};
  for (const bool argument : {true, false})
    for (CLI::Option* option : app.get_options([](CLI::Option*) { return true; }))
      if (option->get_positional() == argument && !option->get_group().empty())
        command.options.push_back(entry_of(*option));
  for (CLI::App* sub : app.get_subcommands([](CLI::App* any) { return !any->get_group().empty(); }))
    command.commands.push_back(entry_of(*sub, command.name + " "));
  return command;
}

}  // namespace

CommandEntry command_tree(CLI::App& program) { return entry_of(program, ""); }

std::string usage(const CommandEntry& command) {
  std::string text = command.name + " [OPTIONS]";
  for (const OptionEntry& option : command.options) {
    if (!option.argument) continue;
    const std::string name = option.names.front() + (option.several ? "..." : "");
    text += option.required ? fmt::format(" {}", name) : fmt::format(" [{}]", name);
  }
  return text + (command.commands.empty() ? "" : " COMMAND ...");
}

std::string spelling(const OptionEntry& option) {
  return fmt::format("{}{}{}{}", fmt::join(option.names, ", "), option.value.empty() ? "" : " ", option.value,
                     option.several && !option.argument ? "..." : "");
}

std::vector<const CommandEntry*> flattened(const CommandEntry& command) {
  std::vector<const CommandEntry*> all{&command};
  for (const CommandEntry& sub : command.commands)
    for (const CommandEntry* one : flattened(sub)) all.push_back(one);
  return all;
}

}  // namespace cpt::cli
