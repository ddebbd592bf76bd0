// The program's commands and options as plain data, read from what the commands themselves declare: the
// shell's completion, the man page and the reference are written from it.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace cpt::cli {

/// An option, a flag or a positional argument.
struct OptionEntry {
  std::vector<std::string> names;    ///< "--quiet", or "-h" and "--help"; of an argument "STUDY"
  std::string value;                 ///< what stands for its value: "SECONDS"; "" for a flag or argument
  std::string meaning;               ///< one line; defaults in brackets
  std::vector<std::string> choices;  ///< valid values; empty where there is no list of them
  std::string range;                 ///< "1 to 4096"; "" if it is no number in a range
  bool argument = false;
  bool required = false;
  bool several = false;  ///< takes more values than one
  [[nodiscard]] bool takes_value() const { return argument || !value.empty(); }
};

struct CommandEntry {
  std::string name;  ///< with all before it: "campaign element triaxial"
  std::string meaning;
  std::vector<OptionEntry> options;  ///< arguments first, each in the order of --help
  std::string footer;
  std::vector<CommandEntry> commands;
};

/// The program's tree; what --help hides is left out.
[[nodiscard]] CommandEntry command_tree(CLI::App& program);

/// "campaign run [OPTIONS] STUDY"
[[nodiscard]] std::string usage(const CommandEntry& command);
/// "--slots N", "--format table|csv|json", "-h, --help", "STUDY"
[[nodiscard]] std::string spelling(const OptionEntry& option);

/// The command and all below it, in the order of --help.
[[nodiscard]] std::vector<const CommandEntry*> flattened(const CommandEntry& command);

}  // namespace cpt::cli
