#include "cli/program/reference_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/exit_codes.hpp"
#include "cli/program/listings.hpp"
#include "drawing/markdown.hpp"

namespace cpt::cli {
namespace {

using drawing::table_head;
using drawing::table_line;

std::string code(const std::string& text) { return fmt::format("`{}`", text); }

std::string indented(const std::string& text) {
  std::string lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    if (end > at) lines += fmt::format("    {}", text.substr(at, end - at));
    lines += '\n';
    at = end + 1;
  }
  return lines;
}

std::string section(const CommandEntry& command) {
  std::string text =
      fmt::format("### {}\n\n{}.\n\n{}", command.name, command.meaning, indented(usage(command)));
  std::string rows;
  for (const OptionEntry& option : command.options)
    if (option.names.back() != "--help") rows += table_line({code(spelling(option)), full_meaning(option)});
  if (!rows.empty()) text += fmt::format("\n{}{}", table_head({"argument or option", "meaning"}), rows);
  if (!command.commands.empty()) text += fmt::format("\n{}", table_head({"command", "does"}));
  for (const CommandEntry& sub : command.commands) text += table_line({code(sub.name), sub.meaning});
  if (const std::string footer = own_footer(command); !footer.empty())
    text += fmt::format("\n{}", indented(footer));
  return text + "\n";
}

std::string section(const Listing& listing) {
  const results::Table table = listing.make(true);
  std::string text =
      fmt::format("## {}\n\n`campaign list {}`: {}.\n\n", listing.title, listing.name, listing.meaning);
  text += table_head(table.columns);
  for (const auto& row : table.rows) {
    std::vector<std::string> cells;
    for (const results::Cell& cell : row) cells.push_back(text_of(cell));
    if (!cells.front().empty()) cells.front() = code(cells.front());
    text += table_line(cells);
  }
  return text + "\n";
}

}  // namespace

std::string text_of(const results::Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return std::to_string(*whole);
  if (const auto* number = std::get_if<double>(&cell)) return fmt::format("{}", *number);
  return "";
}

std::string own_footer(const CommandEntry& command) {
  std::string text = command.footer;
  if (const auto at = text.find(exit_code_help); at != std::string::npos)
    text.erase(at, exit_code_help.size());
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

std::string full_meaning(const OptionEntry& option) {
  std::string text = option.meaning;
  const bool told = std::ranges::all_of(option.choices, [&](const std::string& choice) {
    return spelling(option).find(choice) != std::string::npos || text.find(choice) != std::string::npos;
  });
  if (!told) text += fmt::format("{}one of {}", text.empty() ? "" : "; ", fmt::join(option.choices, ", "));
  if (!option.range.empty()) text += fmt::format("; {}", option.range);
  return text;
}

std::string reference_page(const CommandEntry& program) {
  std::string text =
      "# Reference\n\nWritten by the program itself: `campaign reference > docs/reference.md` refreshes it, "
      "and a test "
      "holds it\nagainst the code. Every command has `--help` too.\n\n## Commands\n\n";
  for (const CommandEntry* command : flattened(program)) text += section(*command);
  for (const Listing& listing : listings()) text += section(listing);
  text.pop_back();  // one line end at the end
  return text;
}

}  // namespace cpt::cli
