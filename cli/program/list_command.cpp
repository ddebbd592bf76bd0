// campaign list WHAT
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/command.hpp"
#include "cli/common/format_option.hpp"
#include "cli/exit_codes.hpp"
#include "cli/program/listings.hpp"

namespace cpt::cli {
namespace {

using results::Format;

struct ListArguments {
  std::string what;
  Format format = Format::table;
};

int list(const ListArguments& arguments) {
  for (const Listing& listing : listings())
    if (arguments.what == listing.name)
      fmt::print("{}", results::format(listing.make(arguments.format != Format::table), arguments.format));
  return all_well;
}

}  // namespace

void add_list(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<ListArguments>();
  CLI::App* command = program.add_subcommand("list", "Print what there is to choose from");
  std::vector<std::string> names;
  std::string help = "WHAT is one of\n";
  for (const Listing& listing : listings()) {
    names.emplace_back(listing.name);
    help += fmt::format("  {:<14}{}\n", listing.name, listing.meaning);
  }
  command->add_option("WHAT", arguments->what, "What to list")
      ->type_name("")
      ->required()
      ->check(CLI::IsMember(names).description(""));
  add_format_option(*command, arguments->format);
  help += "\nFor quantities and mechanisms, csv and json also give symbol, equation and source.";
  command->footer(help);
  command->callback([arguments, &action] { action = [arguments] { return list(*arguments); }; });
}

}  // namespace cpt::cli
