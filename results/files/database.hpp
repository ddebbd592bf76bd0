// A thin, safe hold on one SQLite connection. The only file that knows SQLite is database.cpp.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "results/files/error.hpp"

struct sqlite3;
struct sqlite3_stmt;

namespace cpt::results {

/// A statement that SQLite does not understand; the message is SQLite's.
struct BadStatement : Error {
  BadStatement(const std::string& message, int place) : Error(message), byte(place) {}
  int byte;  ///< of the statement, where that is known, else -1
};

/// A row that the schema refuses; `what()` is SQLite's message alone.
struct ConstraintViolation : Error {
  using Error::Error;
};

/// Throws Damaged, with what to do about it.
[[noreturn]] void fail_damaged(const std::filesystem::path& file, std::string_view detail);

/// Compiled statements that nobody uses just now, by their text: to compile one costs more than to run it.
using IdleStatements = std::map<std::string, std::vector<sqlite3_stmt*>, std::less<>>;

/// A statement with its parameters bound in order; steps through its rows. Numbers that are not finite are
/// stored as NULL, and NULL reads back as NaN, 0 or "".
class Statement {
 public:
  /// Takes the compiled statement from `idle` if it is there, and leaves it there in the end.
  Statement(sqlite3* connection, IdleStatements& idle, std::string_view sql, const std::string& file);
  ~Statement();
  Statement(Statement&&) noexcept;
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;
  Statement& operator=(Statement&&) = delete;

  Statement& bind(std::int64_t value);
  Statement& bind(int value) { return bind(static_cast<std::int64_t>(value)); }
  Statement& bind(double value);
  Statement& bind(std::string_view value);
  Statement& bind(const std::string& value) { return bind(std::string_view(value)); }
  Statement& bind(const char* value) { return bind(std::string_view(value)); }
  Statement& bind_or_null(std::string_view value);  ///< empty text as NULL
  /// Doubles as little-endian bytes.
  Statement& bind(const std::vector<double>& values);

  /// Next row; false at the end.
  bool step();
  /// Runs a statement that returns no row.
  void run();
  /// True if the statement can change nothing.
  [[nodiscard]] bool read_only() const;

  [[nodiscard]] int columns() const;
  [[nodiscard]] std::string column_name(int column) const;
  [[nodiscard]] bool is_null(int column) const;
  [[nodiscard]] std::int64_t integer(int column) const;
  [[nodiscard]] double number(int column) const;
  [[nodiscard]] std::string text(int column) const;
  [[nodiscard]] std::vector<double> doubles(int column) const;
  /// The value as it is stored; bytes as "(N bytes)".
  [[nodiscard]] std::variant<std::monostate, std::int64_t, double, std::string> cell(int column) const;

 private:
  void check(int code) const;
  void compile(std::string_view sql);
  sqlite3* connection_;
  std::vector<sqlite3_stmt*>* idle_;  // of the same text
  sqlite3_stmt* statement_ = nullptr;
  std::string file_;
  int next_parameter_ = 1;
};

/// One connection. Throws Error, with the file's name and SQLite's message, on anything SQLite refuses.
class Database {
 public:
  enum class Mode { read_only, read_write, salvage };
  /// read_only: the file must exist. read_write: it is created if missing. salvage: as read_only, and what
  /// can be read of a damaged file is read.
  Database(const std::filesystem::path& file, Mode mode);
  Database(Database&&) noexcept;
  Database& operator=(Database&&) noexcept;
  ~Database();
  /// A copy in memory that may be written, whatever becomes of the file; messages name the file.
  [[nodiscard]] Database copy_in_memory() const;

  [[nodiscard]] Statement prepare(std::string_view sql) const;
  /// Runs all statements of a text.
  void execute(std::string_view sql) const;
  /// First column of the first row of a query that has one.
  [[nodiscard]] std::int64_t integer(std::string_view sql) const;
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

 private:
  void close();
  std::filesystem::path file_;
  sqlite3* connection_ = nullptr;
  std::unique_ptr<IdleStatements> idle_ = std::make_unique<IdleStatements>();  // stays where it is in a move
};

/// Begins on construction; rolled back unless committed.
class Transaction {
 public:
  enum class Kind { read, write };
  Transaction(const Database& database, Kind kind);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  const Database& database_;
  bool open_ = true;
};

}  // namespace cpt::results
