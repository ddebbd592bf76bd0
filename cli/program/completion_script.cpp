#include "cli/program/completion_script.hpp"

#include <fmt/format.h>

#include <map>

#include "solver/quantities.hpp"

namespace cpt::cli {
namespace {

// What may follow on the command line, by the words before it: "campaign query --format" -> "table csv json".
using Cases = std::map<std::string, std::string>;

struct Script {
  std::vector<std::string> commands;                                   // all but the program itself
  std::vector<std::string> with_value, with_free_text, with_quantity;  // "campaign run --slots"
  Cases values, options, arguments;
};

std::string spaced(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, " ")); }

bool is_path(const std::string& value) {
  for (const char* part : {"FILE", "FOLDER", "TEXT"})
    if (value.find(part) != std::string::npos) return true;
  return false;
}

void add_value(const std::string& place, const OptionEntry& option, Script& script) {
  script.with_value.push_back(place);
  if (!option.choices.empty())
    script.values[place] = spaced(option.choices);
  else if (option.value == "NAME=VALUE")
    script.with_quantity.push_back(place);
  else if (!is_path(option.value))
    script.with_free_text.push_back(place);
}

void add_command(const CommandEntry& command, Script& script) {
  int place = 0;
  std::vector<std::string> names, subcommands;
  for (const OptionEntry& option : command.options) {
    if (option.argument) {
      if (!option.choices.empty())
        script.arguments[fmt::format("{} {}", command.name, place)] = spaced(option.choices);
      ++place;
      continue;
    }
    names.insert(names.end(), option.names.begin(), option.names.end());
    if (!option.takes_value()) continue;
    for (const std::string& name : option.names)
      add_value(fmt::format("{} {}", command.name, name), option, script);
  }
  for (const CommandEntry& sub : command.commands) {
    script.commands.push_back(sub.name);
    subcommands.push_back(sub.name.substr(command.name.size() + 1));
  }
  script.options[command.name + " -"] = spaced(names);
  if (!subcommands.empty()) script.arguments[command.name + " 0"] = spaced(subcommands);
}

// The patterns of one branch of a case.
std::string any_of(const std::vector<std::string>& words) {
  return fmt::format("\"{}\"", fmt::join(words, "\" | \""));
}

std::string branches(const Cases& cases, int indent, std::string_view after = "") {
  std::string text;
  for (const auto& [words, choices] : cases)
    text += fmt::format("{:{}}\"{}\"{}) choices=\"{}\" ;;\n", "", indent, words, after, choices);
  return text;
}

constexpr const char* frame = R"(# Completion of campaign for bash; written by `campaign completion bash`.
_campaign() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} command=campaign place=0 choices="" i
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case "$command ${{COMP_WORDS[i]}}" in
      {commands}) command+=" ${{COMP_WORDS[i]}}" place=0 ;;
      {with_value}) ((++i)) ;;
      "$command -"*) ;;
      *)  # a study alone means run
        [[ $command == campaign ]] && command="campaign run"
        ((++place)) ;;
    esac
  done
  COMPREPLY=()
  case "$command $before" in
    {with_free_text} | *" =")
      compopt +o default 2>/dev/null
      return ;;
    {with_quantity})
      COMPREPLY=($(compgen -S = -W "{quantities}" -- "$word"))
      compopt -o nospace 2>/dev/null
      return ;;
{values}    {with_value}) ;;  # files, which bash completes
    *)
      case "$command $word" in
{options}        *)
          case "$command $place" in
{arguments}          esac ;;
      esac ;;
  esac
  [[ -n $choices ]] && COMPREPLY=($(compgen -W "$choices" -- "$word"))
  [[ $command == campaign && $word != -* ]] && COMPREPLY+=($(compgen -f -X '!*.toml' -- "$word"))
}}
complete -o default -F _campaign campaign
)";

}  // namespace

std::string bash_completion(const CommandEntry& program) {
  Script script;
  for (const CommandEntry* command : flattened(program)) add_command(*command, script);
  std::vector<std::string_view> quantities;
  for (const solver::Quantity& quantity : solver::all_quantities()) quantities.push_back(quantity.name);
  using fmt::arg;
  return fmt::format(
      frame, arg("commands", any_of(script.commands)), arg("with_value", any_of(script.with_value)),
      arg("with_free_text", any_of(script.with_free_text)),
      arg("with_quantity", any_of(script.with_quantity)),
      arg("quantities", fmt::format("{}", fmt::join(quantities, " "))),
      arg("values", branches(script.values, 4)), arg("options", branches(script.options, 8, "*")),
      arg("arguments", branches(script.arguments, 12)));
}

}  // namespace cpt::cli
