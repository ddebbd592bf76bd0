#include "recordings/gef_entries.hpp"

#include <algorithm>

namespace cpt::recordings {
namespace {

bool all_digits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool adjacent(const Field& one, const Field& other) {
  return one.text.data() + one.text.size() + 1 == other.text.data();
}

}  // namespace

GefEntry::GefEntry(const Line& line) : before_(column_of(line.text, trimmed(line.text))) {
  go_on({line.number, trimmed(line.text).substr(1)});
}

void GefEntry::go_on(const Line& line) {
  if (!text_.empty()) text_ += ' ';
  begins_.push_back(text_.size());
  text_ += line.text;
  parts_.push_back(line);
}

std::string GefEntry::key() const {
  return lower_case(trimmed(std::string_view(text_).substr(0, text_.find('='))));
}

std::string_view GefEntry::value() const {
  const std::size_t equals = std::min(text_.find('='), text_.size() - 1);
  return trimmed(std::string_view(text_).substr(std::min(equals + 1, text_.size())));
}

GefEntry::Place GefEntry::place_of(std::string_view text) const {
  const auto offset = std::min(static_cast<std::size_t>(text.data() - text_.data()), text_.size());
  std::size_t part = 0;
  while (part + 1 < parts_.size() && begins_[part + 1] <= offset) ++part;
  const std::string_view before = std::string_view(text_).substr(begins_[part], offset - begins_[part]);
  return {parts_[part].number, column_of(before, before.substr(before.size())) + (part == 0 ? before_ : 0)};
}

void GefEntry::problem(std::string_view at, std::string expected, std::string hint,
                       Problems& problems) const {
  const Place place = place_of(at);
  problems.add(place.line, place.column, in_quotes(at), std::move(expected), std::move(hint));
}

GefEntries read_gef_entries(const std::vector<Line>& lines, Problems& problems) {
  GefEntries header;
  const Line* loose = nullptr;  // behind the last entry
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string_view text = trimmed(lines[i].text);
    if (text.empty()) continue;
    if (text.front() == '#') {
      header.entries.emplace_back(lines[i]);
      loose = nullptr;
      if (header.entries.back().key() != "eoh") continue;
      header.entries.pop_back();
      header.data = i + 1;
      return header;
    }
    if (loose == nullptr) loose = &lines[i];
    if (header.entries.empty()) break;
    header.entries.back().go_on({lines[i].number, lines[i].text});
  }
  if (loose != nullptr)
    problems.add(loose->number, column_of(loose->text, trimmed(loose->text)), in_quotes(trimmed(loose->text)),
                 "a header line that starts with '#', or #EOH= before the data",
                 "does #EOH= end the header?");
  else
    problems.add(std::max(1, static_cast<int>(lines.size())), 1, "the end of the file",
                 "#EOH= at the end of the header", "the file seems to be cut off");
  return header;
}

bool cut_number(const std::vector<Field>& fields, std::size_t at) {
  if (at + 1 >= fields.size() || !adjacent(fields[at], fields[at + 1])) return false;
  std::string_view whole = fields[at].text;
  if (whole.starts_with('-') || whole.starts_with('+')) whole.remove_prefix(1);
  return all_digits(whole) && all_digits(fields[at + 1].text);
}

std::string_view joined(const Field& first, const Field& last) {
  return {first.text.data(),
          static_cast<std::size_t>(last.text.data() + last.text.size() - first.text.data())};
}

std::vector<Field> with_decimal_commas(const std::vector<Field>& fields) {
  bool blanks = false;
  for (std::size_t i = 1; i < fields.size(); ++i) blanks = blanks || !adjacent(fields[i - 1], fields[i]);
  if (!blanks) return fields;
  std::vector<Field> whole;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    whole.push_back(fields[i]);
    if (cut_number(fields, i)) {
      whole.back().text = joined(fields[i], fields[i + 1]);
      ++i;
    }
  }
  return whole;
}

}  // namespace cpt::recordings
