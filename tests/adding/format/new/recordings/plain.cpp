#include "recordings/plain.hpp"

#include <array>

#include "recordings/units.hpp"

namespace cpt::recordings {
namespace {

constexpr std::string_view plain_mark = "PLAIN CPT";

struct PlainColumn {
  double Reading::*place;
  double scale;
};
constexpr std::array plain_columns = {PlainColumn{&Reading::depth, 1.0}, PlainColumn{&Reading::q_c, MPa},
                                      PlainColumn{&Reading::f_s, kPa}};

void read_plain_row(const Line& line, Recording& recording, Problems& problems) {
  const std::vector<Field> fields = split(line.text, ' ');
  if (fields.size() != plain_columns.size())
    return problems.add(line.number, 1, in_quotes(line.text), "depth (m), q_c (MPa) and f_s (kPa)");
  Reading reading;
  reading.line = line.number;
  for (std::size_t k = 0; k < fields.size(); ++k) {
    const auto value = number(fields[k].text);
    if (!value)
      return problems.add(line.number, fields[k].column, in_quotes(fields[k].text), "a number",
                          number_hint(fields[k].text));
    reading.*plain_columns[k].place = *value * plain_columns[k].scale;
  }
  ++recording.rows_read;
  recording.readings.push_back(reading);
}

}  // namespace

bool is_plain(std::string_view first_line) { return first_line == plain_mark; }

void read_plain(const std::vector<Line>& lines, const ReadOptions&, Recording& recording,
                Problems& problems) {
  bool begun = false;
  for (const Line& line : lines) {
    if (trimmed(line.text).empty()) continue;
    if (begun && !problems.full()) read_plain_row(line, recording, problems);
    begun = true;
  }
}

}  // namespace cpt::recordings
