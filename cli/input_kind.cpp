#include "cli/input_kind.hpp"

#include <fmt/format.h>

#include "cli/study_argument.hpp"
#include "parameters/document.hpp"

namespace cpt::cli {
namespace {

// What a kind is called, and which commands take it.
struct Described {
  std::string_view name, commands;
};

Described described(InputKind kind) {
  switch (kind) {
    case InputKind::study:
      return {"a study", "run, rerun, query, export, report and push take it"};
    case InputKind::request:
      return {"a request for a diagnosis", "campaign diagnose takes it"};
    case InputKind::plan:
      return {"a plan of concealed cases", "campaign conceal and campaign reveal take it"};
    case InputKind::database:
      return {"a database", "query, compare, export, report and numerics take it"};
    case InputKind::other:
      break;
  }
  return {"another file", ""};
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

void expect_kind(InputKind wanted, const std::filesystem::path& file, std::string_view content) {
  const InputKind kind = kind_of(content);
  if (kind == wanted || kind == InputKind::other) return;
  if (wanted == InputKind::plan && kind == InputKind::request) return;  // one that lacks its [cases]
  throw BadInput(fmt::format("{}: is {}, not {}; {}", file.string(), described(kind).name,
                             described(wanted).name, described(kind).commands));
}

}  // namespace cpt::cli
