#include "cli/exchange/read_table.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "cli/common/input_kind.hpp"
#include "cli/common/study_argument.hpp"
#include "recordings/delimited.hpp"
#include "results/ledger/provenance.hpp"

namespace cpt::cli {
namespace {

parameters::FieldTable parsed(const std::string& bytes, const std::filesystem::path& file) {
  const recordings::Decoded content = recordings::decoded(bytes);
  if (const auto& problem = content.problem)
    throw BadInput(recordings::format(
        {{file.string(), problem->line, problem->column, problem->found, problem->expected, problem->hint}}));
  recordings::Problems problems(file.string());
  recordings::DelimitedTable read = recordings::read_delimited(content.text, problems);
  if (problems.any()) throw BadInput(recordings::format(problems.errors()));
  const auto fields = [](std::vector<recordings::PlacedText>& texts) {
    std::vector<parameters::Field> moved;
    moved.reserve(texts.size());
    for (recordings::PlacedText& text : texts)
      moved.push_back({std::move(text.text), {text.line, text.column}});
    return moved;
  };
  parameters::FieldTable table{file.string(), file.stem().string(), fields(read.names), {}};
  for (std::vector<recordings::PlacedText>& row : read.rows) table.rows.push_back(fields(row));
  return table;
}

}  // namespace

TableFile read_table(const std::filesystem::path& file) {
  const std::string bytes = read_input(InputKind::table, file);
  // Without the folders above: they may name a machine or a user.
  return {parsed(bytes, file), {file.filename().string(), results::sha256(bytes)}};
}

}  // namespace cpt::cli
