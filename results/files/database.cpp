#include "results/files/database.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <bit>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <thread>
#include <utility>

#include "results/files/file_bytes.hpp"
#include "results/files/patience.hpp"
#include "results/files/refusal.hpp"

namespace cpt::results {
namespace {

static_assert(std::endian::native == std::endian::little, "curves are stored as little-endian doubles");

constexpr std::size_t longest_path = 504;  // [bytes] that SQLite takes; room for "-journal" is left

std::string system_cause(sqlite3* connection) {
  const int why = connection != nullptr ? sqlite3_system_errno(connection) : 0;
  return why != 0 ? fmt::format(": {}", std::strerror(why)) : "";
}

/// SQLite's own message says no more than "unable to open database file".
[[noreturn]] void fail_to_open(const std::string& file, sqlite3* connection, const std::string& detail) {
  std::error_code unknown;
  const std::size_t length = std::filesystem::weakly_canonical(file, unknown).native().size();
  if (!unknown && length > longest_path)
    throw Error(
        fmt::format("{}: cannot be opened (its path has {} bytes, and SQLite takes {}); move the study to a "
                    "folder with a "
                    "shorter path, or name a database elsewhere: [output] database = ...",
                    file, length, longest_path));
  if (const int why = connection != nullptr ? sqlite3_system_errno(connection) : 0; why != 0)
    throw Error(refusal(file, "cannot be opened", why));
  throw Error(fmt::format("{}: cannot be opened ({})", file, detail));
}

[[noreturn]] void fail(const std::string& file, sqlite3* connection, int code) {
  const std::string detail = connection != nullptr ? sqlite3_errmsg(connection) : sqlite3_errstr(code);
  switch (code & 0xff) {
    case SQLITE_NOTADB:
      throw Error(fmt::format("{}: not an SQLite database ({})", file, detail));
    case SQLITE_CORRUPT:
      fail_damaged(file, detail);
    case SQLITE_CANTOPEN:
      fail_to_open(file, connection, detail);
    case SQLITE_FULL:
      throw Error(fmt::format("{}: the disk is full ({}); free some space and run again", file, detail));
    case SQLITE_READONLY:
      throw Error(fmt::format("{}: cannot be written ({}); give write permission on it and its folder", file,
                              detail));
    case SQLITE_IOERR:
      throw Error(fmt::format("{}: reading or writing failed ({}{}; is the disk full or failing?)", file,
                              detail, system_cause(connection)));
    case SQLITE_CONSTRAINT:
      throw ConstraintViolation(detail);
    case SQLITE_BUSY:
      throw Busy(fmt::format("{}: {} keeps the database locked ({}); close it there and run again", file,
                             who_keeps(file), detail));
    case SQLITE_ERROR:
      throw BadStatement(fmt::format("{}: {}", file, detail),
                         connection != nullptr ? sqlite3_error_offset(connection) : -1);
    default:
      throw Error(fmt::format("{}: {}", file, detail));
  }
}

/// SQLite asks when the file is locked: nonzero tries again.
int wait_for_lock(void* connection, int before) {
  constexpr std::chrono::milliseconds step(50);
  const double waited = std::chrono::duration<double>(step).count() * before;
  const char* file = sqlite3_db_filename(static_cast<sqlite3*>(connection), "main");
  if (!Patience::lasts(file != nullptr ? file : "", waited)) return 0;
  std::this_thread::sleep_for(step);
  return 1;
}

constexpr const char* any_read = "SELECT count(*) FROM sqlite_schema";

/// A writer that was killed may leave a journal which only a connection that may write can play back.
bool waits_for_a_writer(sqlite3* connection) {
  return (sqlite3_exec(connection, any_read, nullptr, nullptr, nullptr) & 0xff) == SQLITE_READONLY;
}

void play_back_journal(const std::filesystem::path& file) {
  sqlite3* connection = nullptr;
  if (sqlite3_open_v2(file.c_str(), &connection, SQLITE_OPEN_READWRITE, nullptr) == SQLITE_OK) {
    sqlite3_busy_handler(connection, wait_for_lock, connection);
    sqlite3_exec(connection, any_read, nullptr, nullptr, nullptr);
  }
  sqlite3_close_v2(connection);
}

}  // namespace

void fail_damaged(const std::filesystem::path& file, std::string_view detail) {
  throw Damaged(
      fmt::format("{}: the database is damaged ({}); run the campaign again: it saves what is whole",
                  file.string(), detail));
}

Statement::Statement(sqlite3* connection, IdleStatements& idle, std::string_view sql, const std::string& file)
    : connection_(connection), file_(file) {
  auto same = idle.find(sql);
  if (same == idle.end()) same = idle.try_emplace(std::string(sql)).first;
  idle_ = &same->second;
  if (idle_->empty()) {
    compile(sql);
    return;
  }
  statement_ = idle_->back();
  idle_->pop_back();
}

void Statement::compile(std::string_view sql) {
  const char* tail = nullptr;
  check(sqlite3_prepare_v3(connection_, sql.data(), static_cast<int>(sql.size()), SQLITE_PREPARE_PERSISTENT,
                           &statement_, &tail));
  if (statement_ == nullptr) throw Error(file_ + ": empty SQL statement");
  const std::string_view rest = sql.substr(static_cast<std::size_t>(tail - sql.data()));
  if (rest.find_first_not_of(" \t\r\n;") != std::string_view::npos) {
    sqlite3_finalize(statement_);
    throw BadStatement(file_ + ": more than one SQL statement", -1);
  }
}

Statement::~Statement() {
  if (statement_ == nullptr) return;  // moved from
  sqlite3_reset(statement_);
  sqlite3_clear_bindings(statement_);
  idle_->push_back(statement_);
}

Statement::Statement(Statement&& other) noexcept
    : connection_(other.connection_),
      idle_(other.idle_),
      statement_(std::exchange(other.statement_, nullptr)),
      file_(std::move(other.file_)),
      next_parameter_(other.next_parameter_) {}

void Statement::check(int code) const {
  if (code != SQLITE_OK) fail(file_, connection_, code);
}

Statement& Statement::bind(std::int64_t value) {
  check(sqlite3_bind_int64(statement_, next_parameter_++, value));
  return *this;
}

Statement& Statement::bind(double value) {
  const int i = next_parameter_++;
  check(std::isfinite(value) ? sqlite3_bind_double(statement_, i, value) : sqlite3_bind_null(statement_, i));
  return *this;
}

Statement& Statement::bind(std::string_view value) {
  check(sqlite3_bind_text(statement_, next_parameter_++, value.empty() ? "" : value.data(),
                          static_cast<int>(value.size()), SQLITE_TRANSIENT));
  return *this;
}

Statement& Statement::bind_or_null(std::string_view value) {
  if (!value.empty()) return bind(value);
  check(sqlite3_bind_null(statement_, next_parameter_++));
  return *this;
}

Statement& Statement::bind(const std::vector<double>& values) {
  const int i = next_parameter_++;
  check(values.empty() ? sqlite3_bind_zeroblob(statement_, i, 0)
                       : sqlite3_bind_blob64(statement_, i, values.data(), values.size() * sizeof(double),
                                             SQLITE_TRANSIENT));
  return *this;
}

bool Statement::step() {
  const int code = sqlite3_step(statement_);
  if (code == SQLITE_ROW) return true;
  if (code != SQLITE_DONE) fail(file_, connection_, code);
  return false;
}

void Statement::run() {
  while (step()) {
  }
}

bool Statement::read_only() const { return sqlite3_stmt_readonly(statement_) != 0; }

int Statement::columns() const { return sqlite3_column_count(statement_); }

std::string Statement::column_name(int column) const { return sqlite3_column_name(statement_, column); }

bool Statement::is_null(int column) const { return sqlite3_column_type(statement_, column) == SQLITE_NULL; }

std::int64_t Statement::integer(int column) const { return sqlite3_column_int64(statement_, column); }

double Statement::number(int column) const {
  return is_null(column) ? std::numeric_limits<double>::quiet_NaN()
                         : sqlite3_column_double(statement_, column);
}

std::string Statement::text(int column) const {
  const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
  return bytes == nullptr
             ? std::string()
             : std::string(bytes, static_cast<std::size_t>(sqlite3_column_bytes(statement_, column)));
}

std::vector<double> Statement::doubles(int column) const {
  const void* bytes = sqlite3_column_blob(statement_, column);
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_, column));
  if (size % sizeof(double) != 0) throw Error(file_ + ": a stored curve has a broken length");
  std::vector<double> values(size / sizeof(double));
  if (size > 0) std::memcpy(values.data(), bytes, size);
  return values;
}

std::variant<std::monostate, std::int64_t, double, std::string> Statement::cell(int column) const {
  switch (sqlite3_column_type(statement_, column)) {
    case SQLITE_INTEGER:
      return integer(column);
    case SQLITE_FLOAT:
      return number(column);
    case SQLITE_TEXT:
      return text(column);
    case SQLITE_BLOB:
      return fmt::format("({} bytes)", sqlite3_column_bytes(statement_, column));
    default:
      return std::monostate{};
  }
}

Database::Database(const std::filesystem::path& file, Mode mode) : file_(file) {
  // Opening is lazy in SQLite, and a missing file or a folder would give a message of little help.
  std::error_code problem;
  if (mode != Mode::read_write && !std::filesystem::exists(file, problem))
    throw Error(problem ? refusal(file, "cannot be opened", problem)
                        : fmt::format("{}: no such database; run the campaign first", file.string()));
  if (const auto other = not_a_file(file); !other.empty())
    throw Error(fmt::format("{}: {}, not a database", file.string(), other));
  const int flags =
      mode == Mode::read_write ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE : SQLITE_OPEN_READONLY;
  const int code = sqlite3_open_v2(file.c_str(), &connection_, flags | SQLITE_OPEN_EXRESCODE, nullptr);
  try {
    if (code != SQLITE_OK) fail(file.string(), connection_, code);
    sqlite3_busy_handler(connection_, wait_for_lock, connection_);
    if (mode == Mode::read_only && waits_for_a_writer(connection_)) play_back_journal(file);
    // SQLite then also reads a file that is shorter than it should be, or has a broken definition.
    if (mode == Mode::salvage) execute("PRAGMA writable_schema = ON");
    execute("PRAGMA foreign_keys = ON; PRAGMA trusted_schema = OFF");
    (void)integer(any_read);  // says now if this is no database
  } catch (...) {
    close();
    throw;
  }
}

Database::Database(Database&& other) noexcept
    : file_(std::move(other.file_)),
      connection_(std::exchange(other.connection_, nullptr)),
      idle_(std::move(other.idle_)) {}

Database& Database::operator=(Database&& other) noexcept {
  std::swap(file_, other.file_);
  std::swap(connection_, other.connection_);
  std::swap(idle_, other.idle_);
  return *this;
}

Database::~Database() { close(); }

void Database::close() {
  if (idle_ != nullptr)
    for (const auto& [sql, statements] : *idle_)
      for (sqlite3_stmt* statement : statements) sqlite3_finalize(statement);
  sqlite3_close_v2(connection_);
}

Database Database::copy_in_memory() const {
  Database copy(":memory:", Mode::read_write);
  copy.file_ = file_;
  sqlite3_backup* backup = sqlite3_backup_init(copy.connection_, "main", connection_, "main");
  // What is busy or locked is no error to the end of a backup.
  const int step = backup != nullptr ? sqlite3_backup_step(backup, -1) : SQLITE_ERROR;
  const int code = sqlite3_backup_finish(backup);
  if (step != SQLITE_DONE) fail(file_.string(), copy.connection_, code != SQLITE_OK ? code : step);
  return copy;
}

Statement Database::prepare(std::string_view sql) const {
  return Statement(connection_, *idle_, sql, file_.string());
}

void Database::execute(std::string_view sql) const {
  const int code = sqlite3_exec(connection_, std::string(sql).c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) fail(file_.string(), connection_, code);
}

std::int64_t Database::integer(std::string_view sql) const {
  Statement statement = prepare(sql);
  if (!statement.step()) throw Error(fmt::format("{}: no row from: {}", file_.string(), sql));
  return statement.integer(0);
}

Transaction::Transaction(const Database& database, Kind kind) : database_(database) {
  database_.execute(kind == Kind::write ? "BEGIN IMMEDIATE" : "BEGIN");
}

Transaction::~Transaction() {
  if (!open_) return;
  try {
    database_.execute("ROLLBACK");
  } catch (const Error&) {
    // SQLite has rolled back by itself (a full disk does that); there is nothing left to undo.
  }
}

void Transaction::commit() {
  database_.execute("COMMIT");
  open_ = false;
}

}  // namespace cpt::results
