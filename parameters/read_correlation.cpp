#include "parameters/read_correlation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "parameters/designs/design.hpp"
#include "parameters/distributions/copula.hpp"
#include "parameters/nearest_name.hpp"

namespace cpt::parameters {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr std::string_view pair_form = "such as \"sand.G_ref\" = { \"sand.D_r_percent\" = 0.5 }";

class CorrelationReader {
 public:
  CorrelationReader(const std::vector<Row>& rows, const Design& design, ErrorList& errors)
      : rows_(rows), design_(design), errors_(errors) {}

  std::vector<RankCorrelation> read(const Value& table) {
    const std::size_t before = errors_.size();
    if (!design_named(design_.kind).dependent) {
      errors_.add(table.place, "correlation",
                  fmt::format("has no effect: {} changes inputs that do not depend on "
                              "each other",
                              design_.kind),
                  "[design] with kind = \"propagation\"");
      return {};
    }
    for (const Member& member : table.members) {
      const std::string key = joined("correlation", member.key);
      if (member.value.kind != Value::Kind::table) {
        errors_.add(member.value.place, key,
                    fmt::format("must be a table, not {}", to_string(member.value.kind)),
                    std::string(pair_form));
        continue;
      }
      const auto first = row_named(member, key);
      for (const Member& other : member.value.members) {
        const auto second = row_named(other, joined(key, other.key));
        if (first && second) read_pair(*first, *second, other, joined(key, other.key));
      }
    }
    if (errors_.size() == before) check_definite(table.place);
    return errors_.size() == before ? std::move(pairs_) : std::vector<RankCorrelation>();
  }

 private:
  std::optional<std::size_t> row_named(const Member& member, const std::string& key) {
    std::vector<std::string_view> names;
    for (const std::size_t row : design_.rows) {
      if (rows_[row].only_drawn()) continue;
      names.push_back(rows_[row].quantity->name);
      if (names.back() != member.key) continue;
      if (rows_[row].marginal != nullptr) return row;
      errors_.add(member.place, key,
                  "has no distribution: only inputs that are drawn can depend on each other",
                  "give its row a distribution");
      return std::nullopt;
    }
    const std::string_view near = nearest_name(member.key, names);
    errors_.add(
        member.place, key, "is no row of the design",
        near.empty() ? fmt::format("they are {}", listed(names)) : fmt::format("did you mean {}?", near));
    return std::nullopt;
  }

  void read_pair(std::size_t first, std::size_t second, const Member& member, const std::string& key) {
    const auto rho = finite_number(member.value, key, errors_);
    if (!rho) return;
    if (first == second) return errors_.add(member.place, key, "is the row itself", "name another row");
    if (!(*rho > -1.0 && *rho < 1.0))
      return errors_.add(member.value.place, key,
                         fmt::format("{} is no rank correlation above -1 and below 1", *rho));
    for (const RankCorrelation& pair : pairs_)
      if (std::minmax(pair.first, pair.second) == std::minmax(first, second))
        return errors_.add(member.place, key, "is given twice", "keep one of the two");
    pairs_.push_back({first, second, *rho});
  }

  void check_definite(Place place) {
    const MatrixXd asked = score_correlations(pairs_, design_);
    if (positive_definite(asked)) return;
    const MatrixXd nearest = nearest_correlation(asked);
    std::string hint = "nearest are";
    for (const RankCorrelation& pair : pairs_) {
      const auto at = [&](std::size_t row) {
        return std::ranges::find(design_.rows, row) - design_.rows.begin();
      };
      hint += fmt::format("{} {} with {}: {:.3f}", hint.ends_with("are") ? "" : ",",
                          rows_[pair.first].quantity->name, rows_[pair.second].quantity->name,
                          rank_correlation(nearest(at(pair.first), at(pair.second))));
    }
    errors_.add(place, "correlation", "cannot be: the matrix of these correlations is not positive definite",
                hint);
  }

  const std::vector<Row>& rows_;
  const Design& design_;
  ErrorList& errors_;
  std::vector<RankCorrelation> pairs_;
};

}  // namespace

std::vector<RankCorrelation> read_correlations(const Value& root, const std::vector<Row>& rows,
                                               const Design& design, ErrorList& errors) {
  // With errors elsewhere it is not known which rows and which design there are.
  if (!errors.empty()) return {};
  const Value* table = section(root, "correlation", errors);
  return table == nullptr ? std::vector<RankCorrelation>()
                          : CorrelationReader(rows, design, errors).read(*table);
}

}  // namespace cpt::parameters
