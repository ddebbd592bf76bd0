// A thin, safe hold on one SQLite connection. The only file that knows SQLite is database.cpp.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "results/error.hpp"

struct sqlite3;
struct sqlite3_stmt;

namespace cpt::results {

/// Throws Damaged, with what to do about it.
[[noreturn]] void fail_damaged(const std::filesystem::path& file, std::string_view detail);

/// A statement with its parameters bound in order; steps through its rows. Numbers that are not finite are
/// stored as NULL, and NULL reads back as NaN, 0 or "".
class Statement {
 public:
  Statement(sqlite3* connection, std::string_view sql, const std::string& file);
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
  sqlite3* connection_;
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

  [[nodiscard]] Statement prepare(std::string_view sql) const;
  /// Runs all statements of a text.
  void execute(std::string_view sql) const;
  /// First column of the first row of a query that has one.
  [[nodiscard]] std::int64_t integer(std::string_view sql) const;
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

 private:
  std::filesystem::path file_;
  sqlite3* connection_ = nullptr;
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
