#include "results/tables/import_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "parameters/all_realizations.hpp"
#include "parameters/fields.hpp"
#include "parameters/nearest_name.hpp"
#include "parameters/written_number.hpp"
#include "results/files/atomic_file.hpp"
#include "results/files/database.hpp"
#include "results/ledger/ledger_rows.hpp"
#include "results/ledger/provenance.hpp"
#include "results/ledger/schema.hpp"
#include "results/tables/campaign_tables.hpp"
#include "results/tables/count_of.hpp"
#include "solver/quantities.hpp"

namespace cpt::results {
namespace {

using parameters::ErrorList;
using parameters::Field;
using parameters::FieldTable;
using parameters::most_errors;

constexpr double null = std::numeric_limits<double>::quiet_NaN();
constexpr std::int64_t largest_id = std::numeric_limits<std::int32_t>::max();

template <class T>
std::optional<T> parsed_number(const std::string& text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Fills a new database in one transaction under another name; `fill` says whether it is to be kept.
void make_database(const std::filesystem::path& file, const std::function<bool(const Database&)>& fill) {
  std::error_code ignored;
  if (std::filesystem::exists(file, ignored))
    throw Error(fmt::format("{}: exists; an import makes a new database", file.string()));
  const std::filesystem::path temporary = file.string() + ".tmp";
  std::filesystem::remove(temporary, ignored);
  bool keep = false;
  try {
    const Database database(temporary, Database::Mode::read_write);
    database.execute("PRAGMA journal_mode = MEMORY; PRAGMA synchronous = FULL");
    Transaction transaction(database, Transaction::Kind::write);
    create_schema(database);
    keep = fill(database);
    if (keep) transaction.commit();
  } catch (...) {
    std::filesystem::remove(temporary, ignored);
    throw;
  }
  if (keep)
    move_into_place(temporary, file);
  else
    std::filesystem::remove(temporary, ignored);
}

void write_imports(const Database& database, std::span<const ImportedFile> files) {
  const std::string now = utc_now();
  for (const ImportedFile& file : files)
    database.prepare("INSERT INTO import SELECT coalesce(max(position), 0) + 1, ?, ?, ?, ? FROM import")
        .bind(file.name)
        .bind(file.sha256)
        .bind(now)
        .bind(program_version())
        .run();
}

/// A table of the ledger in the file's order of columns, with its place there.
struct Given {
  const LedgerTable* definition;
  const FieldTable* fields;
  std::vector<std::size_t> at;  // where each of the definition's columns is
  [[nodiscard]] const Field& field(std::size_t row, std::size_t column) const {
    return fields->rows[row][at[column]];
  }
};

class TableImport {
 public:
  TableImport(std::span<const FieldTable> tables, std::span<const ImportedFile> files)
      : tables_(tables), files_(files) {}

  RemarksOrErrors into(const std::filesystem::path& file) {
    refuse_strangers();
    if (!sound()) return errors_;
    make_database(file, [&](const Database& database) {
      for (const LedgerTable& definition : ledger_tables())
        // The noise of repeats follows from the averages; a table's errors would be those of others too.
        if (definition.name != "repeat_noise" && sound()) add_table(database, definition);
      if (sound()) check_whole(database);
      if (!sound()) return false;
      recompute_repeat_noise(database);
      write_imports(database, files_);
      return true;
    });
    if (!sound()) return errors_;
    return remarks_;
  }

 private:
  [[nodiscard]] bool sound() const { return errors_.empty(); }
  [[nodiscard]] bool full() const { return errors_.size() >= most_errors; }

  void problem(const std::string& file, parameters::Place place, std::string key, std::string message,
               std::string hint = "") {
    if (!full())
      errors_.push_back(
          {file, place.line, place.column, std::move(key), std::move(message), std::move(hint)});
  }
  void problem(const Given& given, std::size_t row, std::size_t column, std::string message,
               std::string hint = "") {
    const parameters::Place place = given.field(row, column).place;
    const std::string& name = given.definition->columns[column].name;
    // Where a document does not know its lines, the row tells the place.
    problem(given.fields->file, place,
            place.line > 0 ? name : fmt::format("{}, row {}, {}", given.definition->name, row + 1, name),
            std::move(message), std::move(hint));
  }

  /// A table under a wrong name would be left out in silence.
  void refuse_strangers() {
    std::vector<std::string_view> known(derived_tables().begin(), derived_tables().end());
    for (const LedgerTable& definition : ledger_tables()) known.push_back(definition.name);
    std::set<std::string> seen;
    for (const FieldTable& table : tables_) {
      if (!seen.insert(table.name).second) problem(table.file, {}, table.name, "this table is there twice");
      if (std::ranges::find(known, table.name) != known.end()) continue;
      const std::string_view near = parameters::nearest_name(table.name, known);
      problem(table.file, {}, table.name, "is no table of an export",
              near.empty() ? "" : fmt::format("did you mean {}?", near));
    }
  }

  void add_table(const Database& database, const LedgerTable& definition) {
    if (definition.name == "window_mean") average_curves(database);
    const auto found = std::find_if(tables_.begin(), tables_.end(),
                                    [&](const FieldTable& t) { return t.name == definition.name; });
    if (found == tables_.end()) {
      for (const char* needed : {"campaign", "realization", "depth_window"})
        if (definition.name == needed)
          problem(tables_.empty() ? std::string() : tables_.front().file, {}, definition.name,
                  "this table of the export is missing");
      return;
    }
    if (found->rows.empty()) return;
    const std::optional<Given> given = columns_of(definition, *found);
    if (!given) return;
    if (definition.name == "curve")
      add_curves(database, *given);
    else if (definition.name == "window_mean")
      add_means(database, *given);
    else
      add_rows(database, *given);
  }

  std::optional<Given> columns_of(const LedgerTable& definition, const FieldTable& table) {
    std::vector<std::string_view> known;
    for (const LedgerTable::Column& column : definition.columns) known.push_back(column.name);
    std::map<std::string, std::size_t> at;
    bool good = true;
    for (std::size_t i = 0; i < table.names.size(); ++i) {
      const Field& name = table.names[i];
      at[name.text] = i;
      if (std::find(known.begin(), known.end(), name.text) != known.end()) continue;
      good = false;
      const std::string_view near = parameters::nearest_name(name.text, known);
      problem(table.file, name.place, name.text,
              fmt::format("is no column of {}; there are {}", definition.name, fmt::join(known, ", ")),
              near.empty() ? "" : fmt::format("did you mean {}?", near));
    }
    Given given{&definition, &table, {}};
    for (const std::string_view column : known) {
      const auto found = at.find(std::string(column));
      if (found != at.end()) {
        given.at.push_back(found->second);
        continue;
      }
      good = false;
      problem(table.file, {1, 1}, definition.name, fmt::format("the column {} is missing", column));
    }
    if (good) return given;
    return std::nullopt;
  }

  /// Binds one field by its column's type; false after a problem.
  bool bind(Statement& statement, const Given& given, std::size_t row, std::size_t column) {
    const LedgerTable::Column& wanted = given.definition->columns[column];
    const std::string& text = given.field(row, column).text;
    if (wanted.type == "TEXT") {
      wanted.required ? statement.bind(text) : statement.bind_or_null(text);
      return true;
    }
    if (text.empty() && !wanted.required) {
      statement.bind(null);
      return true;
    }
    if (wanted.type == "INTEGER") {
      const auto value = parsed_number<std::int64_t>(text);
      if (value && *value >= 0) {
        statement.bind(*value);
        return true;
      }
      problem(given, row, column, fmt::format("\"{}\" is not a whole number from 0", text));
      return false;
    }
    const auto value = real(given, row, column);
    if (value) statement.bind(*value);
    return value.has_value();
  }

  /// A finite number, or what is stored as NaN; nothing after a problem.
  std::optional<double> real(const Given& given, std::size_t row, std::size_t column) {
    const std::string& text = given.field(row, column).text;
    if (text.empty() && !given.definition->columns[column].required) return null;
    const auto value = parsed_number<double>(text);
    if (value && std::isfinite(*value)) return value;
    problem(given, row, column, fmt::format("\"{}\" is not a finite number", text),
            parameters::number_hint(text));
    return std::nullopt;
  }

  /// The realization that a row belongs to.
  std::optional<int> id(const Given& given, std::size_t row, std::size_t column) {
    const auto value = parsed_number<std::int64_t>(given.field(row, column).text);
    if (value && *value >= 1 && *value <= largest_id) return static_cast<int>(*value);
    problem(
        given, row, column,
        fmt::format("\"{}\" is not a whole number from 1 to {}", given.field(row, column).text, largest_id));
    return std::nullopt;
  }

  void add_rows(const Database& database, const Given& given) {
    for (std::size_t row = 0; row < given.fields->rows.size() && !full(); ++row)
      add_row(database, given, row);
  }

  void add_row(const Database& database, const Given& given, std::size_t row) {
    const LedgerTable& table = *given.definition;
    std::string columns, values;
    for (const LedgerTable::Column& column : table.columns) {
      columns += (columns.empty() ? "" : ", ") + column.name;
      values += values.empty() ? "?" : ", ?";
    }
    if (table.name == "campaign") {
      columns += ", one";
      values += ", 1";
    }
    Statement statement =
        database.prepare(fmt::format("INSERT INTO {} ({}) VALUES ({})", table.name, columns, values));
    bool good = true;
    for (std::size_t column = 0; column < table.columns.size(); ++column)
      good = bind(statement, given, row, column) && good;
    if (table.name == "realization") good = id(given, row, 0).has_value() && good;
    if (good) insert(statement, given, row);
  }

  /// What the schema refuses (a number twice, an unknown status, a realization that is not there) is told
  /// with its place.
  void insert(Statement& statement, const Given& given, std::size_t row) {
    try {
      statement.run();
    } catch (const ConstraintViolation& refused) {
      const Field& first = given.fields->rows[row].front();
      problem(given.fields->file, first.place, fmt::format("{}, row {}", given.definition->name, row + 1),
              refused.what());
    }
  }

  void add_curves(const Database& database, const Given& given) {
    const std::size_t rows = given.fields->rows.size();
    for (std::size_t row = 0; row < rows && !full();) {
      const std::size_t first = row;
      const auto realization = id(given, row, 0);
      if (!realization) return;
      solver::DepthProfile profile;
      for (; row < rows && given.field(row, 0).text == given.field(first, 0).text && !full(); ++row) {
        const auto depth = real(given, row, 1), q_c = real(given, row, 2), f_s = real(given, row, 3);
        if (depth && !profile.depth.empty() && !(*depth > profile.depth.back()))
          problem(given, row, 1,
                  fmt::format("{} is not below the depth before it, {}", *depth, profile.depth.back()));
        profile.depth.push_back(depth.value_or(null));
        profile.q_c.push_back(q_c.value_or(null));
        profile.f_s.push_back(f_s.value_or(null));
      }
      if (!sound()) continue;
      Statement statement = database.prepare("INSERT INTO curve VALUES (?, ?, ?, ?, ?)");
      statement.bind(*realization)
          .bind(static_cast<std::int64_t>(profile.depth.size()))
          .bind(profile.depth)
          .bind(profile.q_c)
          .bind(profile.f_s);
      insert(statement, given, first);
    }
  }

  /// Averages of completed realizations follow from their curves.
  void average_curves(const Database& database) {
    Statement curves = database.prepare(
        "SELECT id FROM curve JOIN realization ON id = realization WHERE status = 'completed'");
    while (curves.step()) with_curve_.insert(static_cast<int>(curves.integer(0)));
    for (const int realization : with_curve_)
      write_window_means(database, realization, read_profile(database, realization));
  }

  /// Those of realizations without a curve are taken as given.
  void add_means(const Database& database, const Given& given) {
    int changed = 0;
    for (std::size_t row = 0; row < given.fields->rows.size() && !full(); ++row) {
      const auto realization = id(given, row, 0);
      if (!realization) continue;
      if (with_curve_.contains(*realization))
        changed += differs(database, given, row, *realization);
      else
        add_row(database, given, row);
    }
    if (changed > 0)
      remarks_.push_back(
          fmt::format("{} of the averages given differ from what their curves give; those of the curves are "
                      "stored",
                      changed));
  }

  /// Whether a given average is another than that of the stored curve.
  int differs(const Database& database, const Given& given, std::size_t row, int realization) {
    constexpr std::size_t window = 1, mean = 5;
    Statement stored =
        database.prepare("SELECT q_c_mean_kPa FROM window_mean WHERE realization = ? AND window = ?");
    stored.bind(realization).bind(given.field(row, window).text);
    return !stored.step() ||
                   parsed_number<double>(given.field(row, mean).text) != std::optional(stored.number(0))
               ? 1
               : 0;
  }

  /// What no single row tells.
  void check_whole(const Database& database) {
    const std::string& file = tables_.front().file;
    if (const auto n = database.integer("SELECT count(*) FROM campaign"); n != 1)
      problem(file, {}, "campaign", fmt::format("has {} rows; there must be one", n));
    if (const auto n = database.integer("SELECT count(*) FROM realization WHERE side = 'baseline'"); n != 1)
      problem(file, {}, "realization", fmt::format("has {} baselines; there must be one", n));
    Statement strays = database.prepare(
        "SELECT id, parameter FROM realization WHERE side IN ('lower', 'upper') AND parameter NOT IN "
        "(SELECT name FROM parameter)");
    while (strays.step())
      problem(file, {}, "realization",
              fmt::format("realization {} has parameter '{}', which is not in parameter", strays.integer(0),
                          strays.text(1)));
    Statement failed = database.prepare(
        "SELECT id, status FROM realization JOIN window_mean ON realization = id WHERE status <> "
        "'completed'");
    while (failed.step())
      problem(file, {}, "window_mean",
              fmt::format("realization {} is {} and has an average: only a completed one has",
                          failed.integer(0), failed.text(1)));
    Statement sums = database.prepare("SELECT realization FROM checksum ORDER BY realization");
    while (sums.step())
      if (const int realization = static_cast<int>(sums.integer(0));
          matches_checksum(database, realization) == std::optional(false))
        problem(file, {}, "checksum",
                fmt::format("realization {} is not what was recorded: its status, audit or curve was changed",
                            realization),
                "take its row out of checksum to import the changed numbers as they are");
  }

  std::span<const FieldTable> tables_;
  std::span<const ImportedFile> files_;
  std::set<int> with_curve_;  // completed realizations that have one
  std::vector<parameters::StudyError> errors_;
  Remarks remarks_;
};

}  // namespace

RemarksOrErrors import_tables(std::span<const FieldTable> tables, std::span<const ImportedFile> files,
                              const std::filesystem::path& database) {
  return TableImport(tables, files).into(database);
}

Remarks import_samples(const parameters::Study& asked, const std::string& study_text,
                       std::span<const parameters::Sample> samples, const ImportedFile& file,
                       const std::filesystem::path& target) {
  parameters::Study study = asked;  // with the samples that are none of its realizations
  std::vector<parameters::Realization> realizations = parameters::all_realizations(study);
  std::map<std::string, int> free;  // realizations without a sample, by their settings
  for (const parameters::Realization& r : realizations) free.try_emplace(settings_text(study, r), r.id);
  std::map<int, const parameters::Sample*> sample_of;
  for (const parameters::Sample& sample : samples) {
    solver::Setup setup = study.baseline;
    parameters::DesignPoint point{sample.name, {}};
    for (const parameters::Change& change : sample.changes) {
      if (change.quantity->value(setup) != change.value) point.changes.push_back(change);
      change.quantity->set_value(setup, change.value);
    }
    const auto found = free.find(solver::canonical_text(setup));
    if (found != free.end()) {
      sample_of[found->second] = &sample;
      free.erase(found);
      continue;
    }
    const int id = static_cast<int>(realizations.size()) + 1;
    realizations.push_back({id, -1, parameters::Side::point, static_cast<int>(study.points.size())});
    study.points.push_back(std::move(point));
    sample_of[id] = &sample;
  }

  make_database(target, [&](const Database& database) {
    write_study(database, study, study_text);
    for (const parameters::Realization& r : realizations)
      insert_pending(database, r.id, describe_input(study, r));
    // Not runs of this program.
    database.execute(
        "UPDATE realization SET settings_hash = '', solver_version = ''; "
        "UPDATE campaign SET program_version = '', solver_version = ''");
    recompute_windows(database, study);
    for (const auto& [id, sample] : sample_of) {
      database.prepare("UPDATE realization SET status = ?, reason = ? WHERE id = ?")
          .bind(sample->status)
          .bind(sample->reason)
          .bind(id)
          .run();
      for (std::size_t w = 0; w < study.windows.size(); ++w)
        if (const parameters::WindowResponse& r = sample->responses[w]; !std::isnan(r.mean))
          database.prepare("INSERT INTO window_mean VALUES (?, ?, ?, ?, NULL, ?, ?, ?)")
              .bind(id)
              .bind(study.windows[w].name)
              .bind(study.windows[w].from)
              .bind(study.windows[w].to)
              .bind(r.mean)
              .bind(r.min)
              .bind(r.max)
              .run();
    }
    recompute_repeat_noise(database);
    write_imports(database, {&file, 1});
    return true;
  });
  Remarks remarks;
  const std::size_t points = study.points.size() - asked.points.size();
  if (points > 0)
    remarks.push_back(count_of(points, "row") + " with inputs that the study does not ask for: points");
  if (!free.empty())
    remarks.push_back(count_of(free.size(), "realization") + " of the study without a row: pending");
  return remarks;
}

}  // namespace cpt::results
