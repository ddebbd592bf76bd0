#include "cli/common/input_kind.hpp"

#include <fmt/format.h>

#include <optional>
#include <system_error>

#include "cli/common/study_argument.hpp"
#include "parameters/document.hpp"
#include "results/files/error.hpp"
#include "results/files/file_bytes.hpp"

namespace cpt::cli {
namespace {

constexpr std::size_t largest_recording = 256U << 20U, largest_table = 1024U << 20U;  // [bytes]

// What a kind is called, and which commands take it.
struct Described {
  std::string_view name, commands;
};

Described described(InputKind kind) {
  switch (kind) {
    case InputKind::study:
      return {"a study", "run, rerun, query, export, report and push take it"};
    case InputKind::request:
      return {"a request", "campaign diagnose or campaign calibrate takes it"};
    case InputKind::plan:
      return {"a plan of concealed cases", "campaign conceal and campaign reveal take it"};
    case InputKind::recording:
      return {"a recording",
              "campaign recording and the requests of campaign diagnose and calibrate take it"};
    case InputKind::triaxial_test:
      return {"a triaxial test", "campaign element calibrate takes it"};
    case InputKind::table:
      return {"a table", "campaign import takes it"};
    case InputKind::database:
      return {"a database", "query, compare, export, report and numerics take it"};
    case InputKind::other:
      break;
  }
  return {"another file", ""};
}

std::size_t largest(InputKind kind) {
  return kind == InputKind::recording ? largest_recording
         : kind == InputKind::table   ? largest_table
                                      : results::largest_text;
}

}  // namespace

InputKind kind_of(std::string_view content) {
  if (content.starts_with("SQLite format 3")) return InputKind::database;
  const auto document = parameters::parse_document(content);
  const auto* root = std::get_if<parameters::Value>(&document);
  if (root == nullptr) return InputKind::other;
  if (root->find("cases") != nullptr) return InputKind::plan;
  if (root->find("soundings") != nullptr || root->find("study") != nullptr) return InputKind::request;
  return root->find("profile") != nullptr || root->find("windows") != nullptr ? InputKind::study
                                                                              : InputKind::other;
}

std::string read_input(InputKind wanted, const std::filesystem::path& file) {
  std::error_code why;
  std::optional<std::string> text = results::bytes_of(file, why, largest(wanted));
  if (why == std::errc::interrupted)
    throw results::Interrupted(fmt::format("{}: a signal ended the wait for it", file.string()));
  if (!text)
    throw BadInput(fmt::format("{}: cannot be read as {} ({})", file.string(), described(wanted).name,
                               results::cause_of(file, why, largest(wanted))));
  const InputKind kind = kind_of(*text);
  // A plan that lacks its [cases] looks like a request.
  const bool plan_without_cases = wanted == InputKind::plan && kind == InputKind::request;
  if (kind == wanted || kind == InputKind::other || plan_without_cases) return *std::move(text);
  throw BadInput(fmt::format("{}: is {}, not {}; {}", file.string(), described(kind).name,
                             described(wanted).name, described(kind).commands));
}

}  // namespace cpt::cli
