// What files of laboratory tests have in common: facts as comments, a line of column names, readings.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cpt::calibration {

inline constexpr double kPa = 1.0e3;  // [Pa]

/// What is wrong with a file and where; line and column count from 1, 0 is the file as a whole.
struct CurveProblem {
  std::string file;
  int line = 0;
  int column = 0;
  std::string message;
};
/// "dense.csv:7:12: 'abc' is not a number", one line each.
[[nodiscard]] std::string format(const std::vector<CurveProblem>& problems);

/// A number in a comment: "# p0_kPa = 160".
struct Fact {
  std::string_view key;
  double min, max;  ///< valid range in the file's unit, both ends included
  double scale;     ///< SI value = scale * file's value
  double* target;   ///< NaN until it is read
};

struct Column {
  std::string_view name;
  bool required;
};

/// A number of a reading, in the file's unit; NaN where the file has no such column.
struct Entry {
  double value;
  int column;  ///< of the line, where it stands
};

/// Reads one file: fields set apart by commas, semicolons or tabs, whichever the line of names has; other
/// comments and columns are not read. At most 20 problems are told.
class LaboratoryFile {
 public:
  /// `name` takes what "# test = " says. `columns` in words: "sigma_v_kPa and e".
  LaboratoryFile(const std::filesystem::path& file, std::string& name, std::vector<Fact> facts,
                 std::vector<Column> columns, std::string_view columns_in_words);

  /// Hands each line's numbers, in the order of the columns, to `take`, which may add a problem. Never throws
  /// for what the text says.
  void read(std::string_view text, const std::function<void(std::span<const Entry>)>& take);

  /// In the line that is being read, or in the file as a whole once all are.
  void problem(int column, std::string message);
  [[nodiscard]] const std::vector<CurveProblem>& problems() const { return problems_; }

 private:
  void read_line(std::string_view line, const std::function<void(std::span<const Entry>)>& take);
  void read_comment(std::string_view line, std::string_view comment);
  void set(const Fact& fact, std::string_view text, int column);
  void read_names(std::string_view line);
  void read_reading(std::string_view line, const std::function<void(std::span<const Entry>)>& take);

  std::string file_;
  std::string& name_;
  std::vector<Fact> facts_;
  std::vector<std::string_view> keys_;  // of the facts, and "test"
  std::vector<Column> columns_;
  std::string_view in_words_;
  std::vector<CurveProblem> problems_;
  std::vector<std::optional<std::size_t>> place_;  // of each column among the file's
  std::size_t fields_ = 0;                         // of the line of names
  char separator_ = ',';
  bool named_ = false;
  int line_ = 0;
};

}  // namespace cpt::calibration
