// campaign query STUDY|DB WHAT
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/command.hpp"
#include "cli/common/format_option.hpp"
#include "cli/common/ledger_argument.hpp"
#include "cli/common/study_argument.hpp"
#include "cli/exit_codes.hpp"
#include "results/tables/query.hpp"

namespace cpt::cli {
namespace {

struct QueryArguments {
  std::filesystem::path source;
  std::string what;
  std::string sql;
  results::Format format = results::Format::table;
};

std::string what_help() {
  std::string help = "WHAT is one of\n";
  for (const results::NamedQuery& query : results::named_queries())
    help += fmt::format("  {:<14}{}\n", query.name, query.meaning);
  help +=
      fmt::format("  {:<14}{}\n", "sql \"...\"", "one read-only SQL statement of your own (docs/schema.md)");
  help += R"(
Examples:
  campaign query sens.toml sensitivity
  campaign query sens.sqlite realizations --format csv > realizations.csv
  campaign query sens.toml sql "select parameter, si from sensitivity where above_noise")";
  return help;
}

// Where the study has repeats the noise is theirs, else the spread inside the window.
void tell_which_noise(const results::LedgerView& ledger) {
  const results::Table judged = results::query_sql(ledger.database, R"sql(
SELECT repeated, group_concat(window, ', ') FROM (
  SELECT s.window AS window, max(si_half_width IS NOT NULL) AS repeated
  FROM sensitivity AS s JOIN depth_window AS w ON w.name = s.window
  WHERE above_noise IS NOT NULL GROUP BY s.window ORDER BY w.position)
GROUP BY repeated ORDER BY repeated DESC)sql");
  for (const auto& row : judged.rows)
    fmt::print(
        stderr, "note: above_noise in {}: |si| {}\n", std::get<std::string>(row[1]),
        std::get<std::int64_t>(row[0]) != 0
            ? "> si_half_width, half the 95 % interval from the repeats"
            : "> si_noise, the spread of the baseline inside the window, as there are no results of repeats");
}

int query(const QueryArguments& arguments) {
  const bool sql = arguments.what == "sql";
  if (sql == arguments.sql.empty())
    throw BadInput(sql ? "query sql needs a statement: campaign query STUDY sql \"select ...\""
                       : fmt::format("unexpected '{}' after {}", arguments.sql, arguments.what));
  const results::LedgerView ledger = open_ledger(arguments.source);
  const results::Table table = sql ? results::query_sql(ledger.database, arguments.sql)
                                   : results::query(ledger.database, arguments.what);
  if (arguments.what == "effects" && table.rows.empty())
    throw BadInput(
        "the study has no [design]; of one-at-a-time runs, campaign query STUDY sensitivity tells");
  if (arguments.what == "bands" && table.rows.empty())
    throw BadInput("no bands: they come from the runs of a [design] with kind = \"propagation\"");
  fmt::print("{}", results::format(table, arguments.format));
  if (arguments.what == "sensitivity" || arguments.what == "tornado") tell_which_noise(ledger);
  // They have no rows: what is missing must not be missed.
  if (arguments.what == "windows")
    for (const auto& row :
         results::query_sql(ledger.database, "SELECT name, problem FROM depth_window WHERE problem <> ''")
             .rows)
      fmt::print(stderr, "note: window {} is undefined: {}\n", std::get<std::string>(row[0]),
                 std::get<std::string>(row[1]));
  return all_well;
}

}  // namespace

void add_query(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<QueryArguments>();
  CLI::App* command = program.add_subcommand("query", "Print results from a campaign's database");
  command->add_option("STUDY|DB", arguments->source, "Study file or database")->type_name("")->required();
  std::vector<std::string> names{"sql"};
  for (const results::NamedQuery& query : results::named_queries()) names.emplace_back(query.name);
  command->add_option("WHAT", arguments->what, "What to print")
      ->type_name("")
      ->required()
      ->check(CLI::IsMember(names).description(""));
  command->add_option("SQL", arguments->sql, "Statement, after sql")->type_name("");
  add_format_option(*command, arguments->format);
  command->footer(what_help() + R"(

Of a study that was edited since its campaign last ran, what the file says now is answered, with averages from the
stored curves; of a database, what is stored.)");
  command->callback([arguments, &action] { action = [arguments] { return query(*arguments); }; });
}

}  // namespace cpt::cli
