#include "recordings/delimited.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace cpt::recordings {
namespace {

constexpr std::string_view line_ends = "\r\n";

/// A place in a text that only moves on.
class Cursor {
 public:
  Cursor(std::string_view text, int line) : text_(text), line_(line) {}

  [[nodiscard]] bool at_end() const { return at_ == text_.size(); }
  [[nodiscard]] bool at_line_end() const { return at_end() || text_[at_] == '\n' || text_[at_] == '\r'; }
  [[nodiscard]] bool at(char c) const { return !at_end() && text_[at_] == c; }
  [[nodiscard]] std::string_view rest() const { return text_.substr(at_); }
  [[nodiscard]] std::string_view line() const { return rest().substr(0, rest().find_first_of(line_ends)); }
  [[nodiscard]] int line_number() const { return line_; }
  [[nodiscard]] int column() const { return column_; }

  /// Moves over the text up to the first of these characters; returns it.
  std::string_view take_until(std::string_view characters) {
    const std::string_view taken = rest().substr(0, rest().find_first_of(characters));
    for (const char c : taken) step(c);
    return taken;
  }
  void take() { step(text_[at_]); }
  void take_blanks() {
    while (at(' ') || at('\t')) take();
  }
  void take_line_end() {
    if (at('\r')) take();
    if (at('\n')) take();
  }

 private:
  void step(char c) {
    ++at_;
    const bool ends = c == '\n' || (c == '\r' && !at('\n'));
    if ((static_cast<unsigned char>(c) & 0xC0) != 0x80) ++column_;
    if (!ends) return;
    ++line_;
    column_ = 1;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_;
  int column_ = 1;
};

/// A field in quotes; false after a problem.
bool take_quoted(Cursor& cursor, char separator, PlacedText& field, Problems& problems) {
  const int line = cursor.line_number(), column = cursor.column();
  const std::string_view opened = cursor.line();
  cursor.take();
  ++field.column;
  while (true) {
    field.text += cursor.take_until("\"");
    if (cursor.at_end()) {
      problems.add(line, column, in_quotes(opened), "a closing quote",
                   "a field that begins with a quote ends with one; a quote inside is doubled");
      return false;
    }
    cursor.take();
    if (!cursor.at('"')) break;
    field.text += '"';
    cursor.take();
  }
  while (cursor.at(' ') || (separator != '\t' && cursor.at('\t'))) cursor.take();
  if (cursor.at_line_end() || cursor.at(separator)) return true;
  problems.add(cursor.line_number(), cursor.column(), in_quotes(cursor.line()),
               fmt::format("{} behind the closing quote", separator == ','   ? "a comma"
                                                          : separator == ';' ? "a semicolon"
                                                                             : "a tab"));
  return false;
}

/// The fields up to the end of the line, which is not taken.
std::vector<PlacedText> take_record(Cursor& cursor, char separator, Problems& problems) {
  std::vector<PlacedText> fields;
  const std::string stop = std::string(line_ends) + separator;
  while (true) {
    if (separator != '\t') cursor.take_blanks();
    PlacedText field{"", cursor.line_number(), cursor.column()};
    if (cursor.at('"')) {
      if (!take_quoted(cursor, separator, field, problems)) return fields;
    } else {
      field.text = trimmed(cursor.take_until(stop));
    }
    fields.push_back(std::move(field));
    if (cursor.at_line_end()) return fields;
    cursor.take();
  }
}

std::vector<PlacedText> take_words(Cursor& cursor) {
  std::vector<PlacedText> words;
  for (cursor.take_blanks(); !cursor.at_line_end(); cursor.take_blanks()) {
    PlacedText word{"", cursor.line_number(), cursor.column()};
    word.text = cursor.take_until(" \t\r\n");
    words.push_back(std::move(word));
  }
  return words;
}

/// What sets the names apart; a blank where they are words.
char separator_of(std::string_view names) {
  for (const char candidate : {';', ','})
    if (names.find(candidate) != names.npos) return candidate;
  // Dakota's tables are words, though some programs put tabs between them.
  const bool dakota = trimmed(names).starts_with('%') || trimmed(names).starts_with("eval_id");
  return !dakota && trimmed(names).find('\t') != names.npos ? '\t' : ' ';
}

void check_names(std::vector<PlacedText>& names, Problems& problems) {
  if (!names.empty() && names.front().text.starts_with('%')) names.front().text.erase(0, 1);
  std::set<std::string> seen;
  for (const PlacedText& name : names)
    if (name.text.empty())
      problems.add(name.line, name.column, "a column without a name", "a name for each column");
    else if (!seen.insert(name.text).second)
      problems.add(name.line, name.column, "a second column " + in_quotes(name.text), "each name once");
}

}  // namespace

std::vector<PlacedText> fields_of(const Line& line, char separator, Problems& problems) {
  Cursor cursor(line.text, line.number);
  return take_record(cursor, separator, problems);
}

DelimitedTable read_delimited(std::string_view text, Problems& problems) {
  DelimitedTable table;
  char separator = ',';
  Cursor cursor(text, 1);
  for (; !cursor.at_end() && !problems.full(); cursor.take_line_end()) {
    const std::string_view line = trimmed(cursor.line());
    if (line.empty() || (table.names.empty() && line.front() == '#')) {
      cursor.take_until(line_ends);
      continue;
    }
    const bool header = table.names.empty();
    if (header) separator = separator_of(line);
    const int number = cursor.line_number();
    const std::size_t before = problems.errors().size();
    std::vector<PlacedText> fields =
        separator == ' ' ? take_words(cursor) : take_record(cursor, separator, problems);
    if (problems.errors().size() > before) return table;  // where the next record begins is not known
    if (header) {
      table.names = std::move(fields);
      check_names(table.names, problems);
    } else if (fields.size() == table.names.size()) {
      table.rows.push_back(std::move(fields));
    } else {
      problems.add(number, 1, fmt::format("{} fields", fields.size()),
                   fmt::format("{}, as in the line of names", table.names.size()),
                   "is the line cut off, or do its numbers have decimal commas?");
    }
  }
  if (table.names.empty() && !problems.any())
    problems.add(0, 0, "no line of column names", "one before the rows",
                 "lines that start with # do not count");
  return table;
}

}  // namespace cpt::recordings
