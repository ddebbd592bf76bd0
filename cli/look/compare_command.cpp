// campaign compare A B
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/command.hpp"
#include "cli/common/format_option.hpp"
#include "cli/common/ledger_argument.hpp"
#include "cli/exit_codes.hpp"
#include "results/tables/compare.hpp"

namespace cpt::cli {
namespace {

struct CompareArguments {
  std::filesystem::path a, b;
  std::string what = "means";
  results::Format format = results::Format::table;
};

int compare_campaigns(const CompareArguments& arguments) {
  const results::Snapshot a = results::read_snapshot(open_ledger(arguments.a)),
                          b = results::read_snapshot(open_ledger(arguments.b));
  const results::Table table = arguments.what == "settings"      ? results::compare_settings(a, b)
                               : arguments.what == "sensitivity" ? results::compare_sensitivity(a, b)
                                                                 : results::compare_means(a, b);
  fmt::print("{}", results::format(table, arguments.format));
  if (const std::string apart = results::windows_apart(a, b); !apart.empty() && arguments.what != "settings")
    fmt::print(stderr, "note: {}\n", apart);
  return all_well;
}

}  // namespace

void add_compare(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command = program.add_subcommand("compare", "Two campaigns side by side");
  command->add_option("A", arguments->a, "Study file or database")->type_name("")->required();
  command->add_option("B", arguments->b, "Study file or database")->type_name("")->required();
  command->add_option("WHAT", arguments->what, "What to compare [means]")
      ->type_name("")
      ->check(CLI::IsMember({"means", "sensitivity", "settings"}).description(""));
  add_format_option(*command, arguments->format);
  command->footer(R"(WHAT is one of
  means        average q_c in every window of the realizations that change the same input to the same value
  sensitivity  sensitivity indices and their noise
  settings     inputs of the baselines, and bounds, that are not the same

Examples:
  campaign compare loose.toml dense.toml
  campaign compare quick.sqlite paper.sqlite sensitivity
  campaign compare before.sqlite after.sqlite settings --format csv)");
  command->callback([arguments, &action] { action = [arguments] { return compare_campaigns(*arguments); }; });
}

}  // namespace cpt::cli
