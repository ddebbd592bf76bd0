#include "recordings/gef.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "recordings/decimal_mark.hpp"
#include "recordings/gef_entries.hpp"
#include "recordings/gef_header.hpp"
#include "recordings/inclination.hpp"
#include "recordings/units.hpp"

namespace cpt::recordings {
namespace {

// Where a quantity goes; x and y are the inclination's two components.
enum class Part { value, x, y };
struct GefQuantity {
  int number;
  const char* name;
  Dimension dimension;
  const char* unit;  // the format's
  double Reading::*place;
  Part part = Part::value;
};
constexpr std::array gef_quantities = {
    GefQuantity{1, "length", Dimension::length, "m", &Reading::length},
    GefQuantity{2, "q_c", Dimension::pressure, "MPa", &Reading::q_c},
    GefQuantity{3, "f_s", Dimension::pressure, "MPa", &Reading::f_s},
    GefQuantity{6, "u_2", Dimension::pressure, "MPa", &Reading::u_2},
    GefQuantity{8, "inclination", Dimension::angle, "degrees", &Reading::inclination},
    GefQuantity{9, "inclination N-S", Dimension::angle, "degrees", &Reading::inclination, Part::x},
    GefQuantity{10, "inclination E-W", Dimension::angle, "degrees", &Reading::inclination, Part::y},
    GefQuantity{11, "corrected depth", Dimension::length, "m", &Reading::depth},
    GefQuantity{12, "time", Dimension::time, "s", &Reading::time},
    GefQuantity{21, "inclination x", Dimension::angle, "degrees", &Reading::inclination, Part::x},
    GefQuantity{22, "inclination y", Dimension::angle, "degrees", &Reading::inclination, Part::y},
};

struct TakenGefColumn {
  std::size_t index;  // of the column, from 0
  const GefQuantity* quantity;
  double scale;
};

class DataReader {
 public:
  DataReader(GefHeader header, Recording& recording, Problems& problems)
      : header_(std::move(header)), recording_(recording), problems_(problems) {}

  void read(const std::vector<Line>& lines) {
    take_columns();
    if (problems_.any()) return;
    look_for_separators(lines);
    if (header_.column_separator != ',' && anywhere(lines, ',')) {
      listening_ = true;
      read_lines(lines);
      listening_ = false;
    }
    read_lines(lines);
    mark_.tell(recording_);
    tell_texts();
    if (undeclared_blank_.rows > 0)
      recording_.remarks.push_back({undeclared_blank_, "empty fields", "read as void", "there is no value"});
    if (header_.last_scan && *header_.last_scan != recording_.rows_read)
      recording_.remarks.push_back({{},
                                    fmt::format("the header promises {} rows (#LASTSCAN), the file has {}",
                                                *header_.last_scan, recording_.rows_read),
                                    "all rows of the file are read",
                                    "rows may be missing, or the header was not brought up to date"});
  }

 private:
  void take_columns() {
    std::string left;
    for (std::size_t i = 0; i < header_.columns.size(); ++i) {
      const GefColumn& column = header_.columns[i];
      const auto* quantity = std::find_if(gef_quantities.begin(), gef_quantities.end(),
                                          [&](const GefQuantity& q) { return q.number == column.quantity; });
      const bool twice = std::any_of(taken_.begin(), taken_.end(),
                                     [&](const TakenGefColumn& taken) { return taken.quantity == quantity; });
      if (quantity == gef_quantities.end() || twice) {
        left += fmt::format("{}{} ({})", left.empty() ? "" : ", ", column.name.empty() ? "?" : column.name,
                            twice ? fmt::format("quantity {} again", column.quantity)
                                  : fmt::format("quantity {}", column.quantity));
        continue;
      }
      const auto scale = unit_of({fmt::format("{} (column {})", quantity->name, i + 1), quantity->dimension,
                                  column.unit, quantity->unit, column.line},
                                 recording_);
      const bool needed =
          quantity->dimension == Dimension::pressure || quantity->dimension == Dimension::length;
      if (scale)
        taken_.push_back({i, quantity, *scale});
      else if (needed)
        problems_.add(column.line, column.unit_column, in_quotes(column.unit),
                      fmt::format("the unit of {}: {}", quantity->name, known_units(quantity->dimension)));
      else
        left +=
            fmt::format("{}{} (unit {})", left.empty() ? "" : ", ", quantity->name, in_quotes(column.unit));
    }
    if (!left.empty())
      recording_.remarks.push_back(
          {{},
           "columns: " + left,
           "not read",
           "a recording has no place for these quantities, or their unit is not known"});
    if (problems_.any()) return;
    require(&Reading::q_c, nullptr, "a column of q_c: #COLUMNINFO= column, MPa, name, 2");
    require(&Reading::length, &Reading::depth,
            "a column of length or depth: #COLUMNINFO= column, m, name, 1 (or 11)");
  }

  void require(double Reading::*one, double Reading::*other, const char* what) {
    if (std::none_of(taken_.begin(), taken_.end(), [&](const TakenGefColumn& t) {
          return t.quantity->place == one || (other != nullptr && t.quantity->place == other);
        }))
      problems_.add(static_cast<int>(header_.data), 1, "a header without it", what,
                    "columns are told apart by the quantity number, not by name");
  }

  [[nodiscard]] bool anywhere(const std::vector<Line>& lines, char c) const {
    return std::any_of(lines.begin() + static_cast<std::ptrdiff_t>(header_.data), lines.end(),
                       [&](const Line& line) { return line.text.find(c) != line.text.npos; });
  }

  // Separators that are declared but never used are not those of the data.
  void look_for_separators(const std::vector<Line>& lines) {
    const auto fall_back = [&](char& separator, char usual, const char* what, const char* instead) {
      if (separator == usual || anywhere(lines, separator)) return;
      recording_.remarks.push_back(
          {{},
           fmt::format("the header declares '{}' between {}, the data have none", separator, what),
           fmt::format("{} taken", instead),
           "these are the format's own"});
      separator = usual;
    };
    fall_back(header_.column_separator, ' ', "columns", "blanks");
    fall_back(header_.record_separator, '\n', "rows", "line ends");
  }

  void read_lines(const std::vector<Line>& lines) {
    for (std::size_t i = header_.data; i < lines.size() && !problems_.full(); ++i) {
      if (trimmed(lines[i].text).starts_with('#')) {
        if (!listening_)
          problems_.add(lines[i].number, column_of(lines[i].text, trimmed(lines[i].text)),
                        in_quotes(trimmed(lines[i].text)) + " among the rows", "one header above the rows",
                        "were two files joined? take them apart");
        return;
      }
      read_line(lines[i]);
    }
    flush();
  }

  void read_line(const Line& line) {
    std::string_view rest = line.text;
    while (true) {
      const std::size_t end =
          header_.record_separator == '\n' ? rest.npos : rest.find(header_.record_separator);
      for (Field field : split(rest.substr(0, end), header_.column_separator)) {
        // Of a line without any text there is one empty piece.
        if (field.text.empty() && trimmed(rest.substr(0, end)).empty()) continue;
        if (record_.empty()) record_line_ = line.number;
        field.column += column_of(line.text, rest) - 1;
        record_.push_back({field.text, field.column});
      }
      if (end == rest.npos) break;
      flush();
      rest.remove_prefix(end + 1);
    }
    if (header_.record_separator == '\n') flush();
  }

  void flush() {
    const std::size_t columns = header_.columns.size();
    while (record_.size() > columns && record_.back().text.empty() &&
           (header_.texts || record_.size() == columns + 1))
      record_.pop_back();
    if (record_.empty()) return;
    const std::string_view text = take_text();
    if (listening_) {
      if (record_.size() == columns)
        for (const TakenGefColumn& taken : taken_) mark_.hear(record_[taken.index].text);
    } else {
      ++recording_.rows_read;
      if (!text.empty()) keep_text(text);
      if (record_.size() != columns)
        problems_.add(record_line_, record_.front().column, fmt::format("a row of {} values", record_.size()),
                      fmt::format("{}, one for each column", columns), wrong_length_hint());
      else
        read_record();
    }
    record_.clear();
  }

  /// Takes what stands behind the last column off the record, where the header allows a text there. Numbers
  /// are none: the row may have another number of columns, or decimal commas.
  std::string_view take_text() {
    const std::size_t columns = header_.columns.size();
    if (!header_.texts || record_.size() <= columns) return {};
    const auto first = record_.begin() + static_cast<std::ptrdiff_t>(columns);
    if (std::all_of(first, record_.end(), [](const Field& field) {
          return field.text.empty() || number_of_any_size(field.text) || certain_decimal_comma(field.text);
        }))
      return {};
    const std::string_view text = joined(*first, record_.back());
    record_.erase(first, record_.end());
    return text;
  }

  void keep_text(std::string_view text) {
    texts_.add(record_line_);
    recording_.facts.push_back({fmt::format("text of line {}", record_line_), std::string(text), ""});
    if (first_text_.empty()) first_text_ = in_quotes(text);
  }

  void tell_texts() {
    if (texts_.rows > 0)
      recording_.remarks.push_back({texts_, "texts behind the last column, the first " + first_text_,
                                    "kept among the entries of the header", "they are no readings"});
  }

  [[nodiscard]] std::string wrong_length_hint() const {
    const bool commas = std::any_of(record_.begin(), record_.end(), [](const Field& field) {
      return field.text.find(',') != field.text.npos;
    });
    if (header_.column_separator == ',')
      return "is the file cut off here, #COLUMN wrong, or do its numbers have decimal commas?";
    if (commas) return "do its numbers have separators of thousands, or commas between columns?";
    return "is the file cut off here, or #COLUMN, #COLUMNSEPARATOR or #RECORDSEPARATOR wrong? Texts behind "
           "the "
           "last column need #COLUMNTEXT";
  }

  /// Whether a field means "not measured" in its column.
  [[nodiscard]] bool is_void(const GefColumn& column, const Field& field) const {
    if (field.text.empty()) return true;
    const auto value = mark_.number_of_any_size(field.text);
    if (value)
      return std::any_of(column.void_values.begin(), column.void_values.end(),
                         [&](double declared) { return same_void(*value, declared); });
    return std::find(column.void_texts.begin(), column.void_texts.end(), lower_case(field.text)) !=
           column.void_texts.end();
  }

  void read_record() {
    Reading reading;
    reading.line = record_line_;
    double x = not_given, y = not_given;
    bool blank = false;
    for (const TakenGefColumn& taken : taken_) {
      const Field& field = record_[taken.index];
      blank = blank || field.text.empty();
      double si = not_given;
      if (!is_void(header_.columns[taken.index], field)) {
        const auto value = mark_.number(field.text);
        if (!value) {
          problems_.add(record_line_, field.column, in_quotes(field.text),
                        fmt::format("a number ({})", taken.quantity->name), number_hint(field.text));
          return;
        }
        si = *value * taken.scale;
      }
      if (taken.quantity->part == Part::x) x = si;
      if (taken.quantity->part == Part::y) y = si;
      if (taken.quantity->part == Part::value) reading.*(taken.quantity->place) = si;
    }
    if (blank) undeclared_blank_.add(record_line_);
    if (std::isnan(reading.inclination)) reading.inclination = resultant(x, y);
    recording_.readings.push_back(reading);
  }

  GefHeader header_;
  Recording& recording_;
  Problems& problems_;
  std::vector<TakenGefColumn> taken_;
  std::vector<Field> record_;
  int record_line_ = 0;
  Lines undeclared_blank_, texts_;
  std::string first_text_;
  DecimalMark mark_;
  bool listening_ = false;  // to the numbers, for their decimal mark; nothing is kept
};

}  // namespace

bool is_gef(std::string_view first_line) {
  return first_line.starts_with('#') && lower_case(trimmed(first_line.substr(1))).starts_with("gefid");
}

void read_gef(const std::vector<Line>& lines, const ReadOptions&, Recording& recording, Problems& problems) {
  GefHeader header = read_gef_header(lines, recording, problems);
  if (!problems.any()) DataReader(std::move(header), recording, problems).read(lines);
}

}  // namespace cpt::recordings
