// man(7), "Fonts" and "Macros".
#include <fmt/format.h>

#include "cli/program/listings.hpp"
#include "cli/program/reference_page.hpp"
#include "results/ledger/provenance.hpp"

namespace cpt::cli {
namespace {

// Text as roff reads it: no requests at the start of a line, and ASCII that stays ASCII.
std::string plain(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '.' && (escaped.empty() || escaped.back() == '\n')) escaped += "\\&";
    switch (c) {
      case '\\':
        escaped += "\\e";
        break;
      case '-':
        escaped += "\\-";
        break;
      case '\'':
        escaped += "\\(aq";
        break;
      case '`':
        escaped += "\\(ga";
        break;
      case '~':
        escaped += "\\(ti";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string item(const std::string& tag, const std::string& text) {
  return fmt::format(".TP\n\\fB{}\\fR\n{}\n", plain(tag), plain(text));
}

std::string verbatim(const std::string& text) { return fmt::format(".PP\n.nf\n{}\n.fi\n", plain(text)); }

std::string subsection(const CommandEntry& command) {
  std::string text = fmt::format(".SS {}\n{}.\n.PP\n\\fB{}\\fR\n", plain(command.name),
                                 plain(command.meaning), plain(usage(command)));
  for (const OptionEntry& option : command.options)
    if (option.names.back() != "--help") text += item(spelling(option), full_meaning(option));
  if (const std::string footer = own_footer(command); !footer.empty()) text += verbatim(footer);
  return text;
}

std::string manual_section(const char* heading, const Listing& listing) {
  std::string text = fmt::format(".SH {}\n", heading);
  for (const auto& row : listing.make(false).rows) text += item(text_of(row.front()), text_of(row.at(1)));
  return text;
}

}  // namespace

std::string man_page(const CommandEntry& program) {
  std::string text = fmt::format(
      ".TH CAMPAIGN 1 \"\" \"campaign {}\" \"User Commands\"\n.SH NAME\ncampaign \\- {}\n.SH SYNOPSIS\n"
      "\\fBcampaign\\fR \\fISTUDY\\fR.toml [OPTIONS]\n.br\n"
      "\\fBmpirun \\-np\\fR \\fIN\\fR \\fBcampaign\\fR \\fISTUDY\\fR.toml [OPTIONS]\n.br\n"
      "\\fBcampaign\\fR \\fICOMMAND\\fR ...\n.SH DESCRIPTION\n"
      "A study names what is uncertain about a cone penetration test. The program pushes the cone in "
      "simulations, once "
      "for a baseline and once for each uncertain input at its lower and at its upper bound, keeps all "
      "results in a "
      "database, and ranks the inputs by what they change. A stopped campaign goes on with the same "
      "command.\n",
      results::program_version(), plain(program.meaning));
  text += verbatim(own_footer(program)) + ".SH COMMANDS\n";
  for (const CommandEntry* command : flattened(program))
    if (command != &program) text += subsection(*command);
  const std::pair<const char*, std::string_view> sections[] = {
      {"EXIT STATUS", "exit-codes"}, {"ENVIRONMENT", "environment"}, {"FILES", "files"}};
  for (const auto& [heading, name] : sections)
    for (const Listing& listing : listings())
      if (listing.name == name) text += manual_section(heading, listing);
  return text +
         ".SH SEE ALSO\n\\fBmpirun\\fR(1); the documentation in share/doc/campaign, where docs/reference.md "
         "has all "
         "keys and quantities and docs/tutorial.md begins.\n";
}

}  // namespace cpt::cli
