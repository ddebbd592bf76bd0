#include "validation/paper/causes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "drawing/text.hpp"
#include "parameters/document.hpp"
#include "results/files/file_bytes.hpp"
#include "results/files/refusal.hpp"
#include "validation/paper/compare.hpp"

namespace cpt::validation::paper {
namespace {

using Node = parameters::Value;
using Kind = Node::Kind;

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : file_(file) {}

  std::vector<Cause> read() const {
    std::error_code why;
    const std::optional<std::string> toml = results::bytes_of(file_, why);
    if (!toml) throw results::Error(results::refusal(file_, "cannot be read", why));
    const auto parsed = parameters::parse_document(*toml);
    if (const auto* error = std::get_if<parameters::SyntaxError>(&parsed)) fail(error->place, error->message);
    std::vector<Cause> causes;
    for (const parameters::Member& row : std::get<Node>(parsed).members) causes.push_back(cause(row));
    return causes;
  }

 private:
  [[noreturn]] void fail(parameters::Place place, std::string_view message) const {
    throw results::Error(fmt::format("{}:{}:{}: {}", file_.string(), place.line, place.column, message));
  }

  void expect(const Node& value, Kind kind) const {
    if (value.kind != kind)
      fail(value.place, fmt::format("{} is wanted here, not {}", to_string(kind), to_string(value.kind)));
  }

  // The texts of a table under exactly these keys; `also` may be there too.
  std::vector<std::string> texts(const Node& table, const std::vector<std::string_view>& keys,
                                 std::string_view also = {}) const {
    expect(table, Kind::table);
    for (const parameters::Member& member : table.members)
      if (member.key != also && std::find(keys.begin(), keys.end(), member.key) == keys.end())
        fail(member.place, fmt::format("unknown key {}", member.key));
    std::vector<std::string> values;
    for (const std::string_view key : keys) {
      const parameters::Member* member = table.find(key);
      if (member == nullptr) fail(table.place, fmt::format("{} is missing", key));
      expect(member->value, Kind::text);
      values.push_back(member->value.text);
    }
    return values;
  }

  Cause cause(const parameters::Member& row) const {
    const auto& rows = paper_rows();
    if (std::find(rows.begin(), rows.end(), row.key) == rows.end())
      fail(row.place, fmt::format("unknown row {}: must be one of {}", row.key, fmt::join(rows, ", ")));
    Cause cause{row.key, texts(row.value, {"cause"}, "evidence").front(), {}};
    if (const parameters::Member* list = row.value.find("evidence")) {
      expect(list->value, Kind::array);
      for (const Node& item : list->value.items) {
        const auto names = texts(item, {"study", "window", "parameter"});
        cause.evidence.push_back({names[0], names[1], names[2]});
      }
    }
    return cause;
  }

  std::filesystem::path file_;
};

}  // namespace

const std::vector<std::string_view>& paper_rows() {
  static const std::vector<std::string_view> rows = {"S1", "S2", "S3", "S4", "S5", "C1", "C2", "L1",
                                                     "L2", "L3", "B1", "W1", "M1", "M2", "D1", "F9"};
  return rows;
}

std::vector<Cause> read_causes(const std::filesystem::path& file) { return Reader(file).read(); }

std::string in_numbers(const Evidence& evidence, const Studies& studies) {
  const StudyView study(studies, evidence.study);
  const Value lower = study.q_c(evidence.window, evidence.parameter, Bound::lower);
  const Value upper = study.q_c(evidence.window, evidence.parameter, Bound::upper);
  const Value change = relative_change(lower, upper);
  if (!change) return change.missing;
  const results::ParameterRow* parameter = study.parameter(evidence.parameter);
  return fmt::format("`{}`, window {}: {} from {} to {} changes q<sub>c</sub> from {} to {} kPa ({})",
                     evidence.study, evidence.window, study.symbol(evidence.parameter), parameter->lower_text,
                     parameter->upper_text, drawing::number(lower.number, 4),
                     drawing::number(upper.number, 4), percent(change.number));
}

}  // namespace cpt::validation::paper
