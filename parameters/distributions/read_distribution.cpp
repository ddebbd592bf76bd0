#include "parameters/distributions/read_distribution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <vector>

#include "parameters/distributions/moments.hpp"
#include "parameters/nearest_name.hpp"

namespace cpt::parameters {
namespace {

constexpr double tolerated_outside = 1e-3;  // probability beyond the quantity's valid range

const Key min_key{"min", "value of the quantity", "none", "cut off below"};
const Key max_key{"max", "value of the quantity", "none", "cut off above"};
const Key mean_key{"mean", "number", "required without quantiles", "mean, before it is cut off"};
const Key deviation_key{"standard_deviation", "number above 0", "cv",
                        "standard deviation, before it is cut off"};
const Key cv_key{"cv", "number above 0", "standard_deviation",
                 "coefficient of variation: standard deviation over the mean"};
const Key quantiles_key{"quantiles", "[[p, x], [p, x]]", "mean and standard_deviation or cv",
                        "two values and the probability, above 0 and below 1, that each is not exceeded"};

std::vector<KeyTable> listed_kinds() {
  return {{"normal", false, "normal", {mean_key, deviation_key, cv_key, quantiles_key, min_key, max_key}},
          {"lognormal",
           false,
           "the logarithm is normal",
           {mean_key, deviation_key, cv_key, quantiles_key, min_key, max_key}},
          {"uniform",
           false,
           "all values of an interval alike",
           {{"min", "value of the quantity", "mean or quantiles", "least value"},
            {"max", "value of the quantity", "mean or quantiles", "largest value"},
            mean_key,
            deviation_key,
            cv_key,
            quantiles_key}},
          {"triangular",
           false,
           "rises straight to the mode and falls straight from it",
           {{"min", "value of the quantity", "required", "least value"},
            {"mode", "value of the quantity", "required", "most likely value"},
            {"max", "value of the quantity", "required", "largest value"}}},
          {"beta",
           false,
           "beta between two ends",
           {{"min", "value of the quantity", "required", "least value"},
            {"max", "value of the quantity", "required", "largest value"},
            {"mean", "number", "alpha and beta", "mean"},
            {"standard_deviation", "number above 0", "cv", "standard deviation"},
            cv_key,
            {"alpha", "number above 0", "mean", "first shape"},
            {"beta", "number above 0", "mean", "second shape"}}},
          {"discrete",
           false,
           "some values, each with a probability; the only kind for a choice",
           {{"values", "array of values of the quantity", "required", "which"},
            {"weights", "array of numbers above 0", "equal", "how likely each is against the others"}}},
          {"empirical",
           false,
           "the values of a sample, all alike: a column of a CSV file",
           {{"file", "path", "required", "the CSV file, from the study's folder"},
            {"column", "text", "required", "name of the column"}}}};
}

std::vector<std::string_view> kind_names() {
  std::vector<std::string_view> names;
  for (const KeyTable& kind : distribution_kinds()) names.push_back(kind.name);
  return names;
}

class DistributionReader {
 public:
  DistributionReader(const Value& table, const solver::Quantity& quantity, const std::string& key,
                     const Value& root, ErrorList& errors)
      : table_(table), quantity_(quantity), key_(key), root_(root), errors_(errors) {}

  std::optional<Distribution> read() {
    const std::size_t before = errors_.size();
    const auto kind = name_field(table_, key_, "kind", true, kind_names(), errors_);
    if (!kind) return std::nullopt;
    kind_ = *kind;
    std::vector<std::string_view> known = {"kind"};
    for (const Key& named : table_named(distribution_kinds(), kind_).keys) known.push_back(named.name);
    refuse_unknown_keys(table_, key_, known, errors_, fmt::format("of a {} distribution", kind_));
    std::optional<Distribution> read = of_kind();
    if (errors_.size() != before || !read) return std::nullopt;
    return within_the_valid_range(*read);
  }

 private:
  void refuse(std::string_view name, std::string message, std::string hint = "") {
    const Member* member = name.empty() ? nullptr : table_.find(name);
    errors_.add(member == nullptr ? table_.place : member->value.place,
                name.empty() ? key_ : joined(key_, name), std::move(message), std::move(hint));
  }

  std::optional<double> number(std::string_view name, bool required) {
    return number_field(table_, key_, name, required, errors_);
  }

  [[nodiscard]] bool has(std::string_view name) const { return table_.find(name) != nullptr; }

  std::optional<Distribution> of_kind() {
    if (!quantity_.choices.empty() && kind_ != "discrete") {
      refuse("kind", fmt::format("\"{}\" is nothing for a choice of {}", kind_, listed(quantity_.choices)),
             "kind = \"discrete\"");
      return std::nullopt;
    }
    if (kind_ == "normal") return by_moments_or_quantiles(Family::normal);
    if (kind_ == "lognormal") return by_moments_or_quantiles(Family::lognormal);
    if (kind_ == "uniform")
      return has("min") || has("max") ? between() : by_moments_or_quantiles(Family::uniform);
    if (kind_ == "triangular") return triangular();
    if (kind_ == "beta") return beta();
    return kind_ == "empirical" ? empirical() : discrete();
  }

  // Whoever reads the study from its file has put the column into [data] (parameters/study_data.hpp).
  std::optional<Distribution> empirical() {
    const auto file = text_field(table_, key_, "file", true, errors_);
    const auto column = text_field(table_, key_, "column", true, errors_);
    if (!file || !column) return std::nullopt;
    const Member* inside = root_.find("data");
    for (const std::string* name : {&*file, &*column})
      inside =
          inside == nullptr || inside->value.kind != Value::Kind::table ? nullptr : inside->value.find(*name);
    constexpr std::size_t least_values = 5;
    if (inside == nullptr || inside->value.kind != Value::Kind::array ||
        inside->value.items.size() < least_values) {
      refuse("column", fmt::format("the section [data.\"{}\"] has no array {} of {} numbers or more", *file,
                                   *column, least_values));
      return std::nullopt;
    }
    std::vector<double> given;
    for (const Value& item : inside->value.items) {
      const auto value = finite_number(item, fmt::format("data.\"{}\".{}", *file, *column), errors_);
      if (!value) return std::nullopt;
      given.push_back(*value);
    }
    return of_values(given, std::vector<double>(given.size(), 1.0));
  }

  // The standard deviation, or the coefficient of variation times the mean.
  std::optional<double> deviation(double mean) {
    if (has("cv") == has("standard_deviation")) {
      refuse("standard_deviation", has("cv") ? "stands beside cv" : "is missing",
             "give standard_deviation or cv");
      return std::nullopt;
    }
    const std::string_view name = has("cv") ? "cv" : "standard_deviation";
    const auto given = number(name, true);
    if (!given) return std::nullopt;
    if (!(*given > 0.0)) {
      refuse(name, fmt::format("{} must be above 0", *given), "a fixed value goes under [fixed]");
      return std::nullopt;
    }
    if (name == "cv" && mean == 0.0) {
      refuse(name, "says nothing about a mean of 0", "give standard_deviation");
      return std::nullopt;
    }
    return name == "cv" ? *given * std::abs(mean) : *given;
  }

  std::optional<Distribution> by_moments_or_quantiles(Family family) {
    std::optional<Distribution> found = has("quantiles") ? by_quantiles(family) : by_moments(family);
    if (!found || family == Family::uniform) return found;
    const auto least = number("min", false), most = number("max", false);
    if (least) found->least = *least;
    if (most) found->most = *most;
    if (found->least < found->most) return found;
    refuse("max", fmt::format("{} is not above min = {}", found->most, found->least));
    return std::nullopt;
  }

  std::optional<Distribution> by_moments(Family family) {
    const auto mean = number("mean", true);
    if (!mean) return std::nullopt;
    const auto spread = deviation(*mean);
    if (!spread) return std::nullopt;
    const auto found = from_moments(family, *mean, *spread);
    if (!found) refuse("mean", fmt::format("{} is no mean of a lognormal distribution: above 0", *mean));
    return found;
  }

  std::optional<Distribution> by_quantiles(Family family) {
    for (const std::string_view name : {"mean", "standard_deviation", "cv"})
      if (has(name)) {
        refuse(name, "stands beside quantiles", "give the moments or the quantiles");
        return std::nullopt;
      }
    const Value& list = table_.find("quantiles")->value;
    const std::string form = "such as quantiles = [[0.05, 600], [0.95, 900]]";
    std::vector<Quantile> pairs;
    if (list.kind == Value::Kind::array)
      for (const Value& item : list.items) {
        if (item.kind != Value::Kind::array || item.items.size() != 2) break;
        const auto p = finite_number(item.items[0], joined(key_, "quantiles"), errors_);
        const auto x = finite_number(item.items[1], joined(key_, "quantiles"), errors_);
        if (!p || !x) return std::nullopt;
        if (!(*p > 0.0 && *p < 1.0)) {
          errors_.add(item.items[0].place, joined(key_, "quantiles"),
                      fmt::format("{} is no probability above 0 and below 1", *p), form);
          return std::nullopt;
        }
        pairs.push_back({*p, *x});
      }
    if (pairs.size() != 2 || list.items.size() != 2) {
      refuse("quantiles", "must be two pairs of a probability and a value", form);
      return std::nullopt;
    }
    const auto found = from_quantiles(family, {pairs[0], pairs[1]});
    if (!found)
      refuse("quantiles",
             family == Family::lognormal && pairs[0].value <= 0.0
                 ? fmt::format("{} is no value of a lognormal distribution: above 0", pairs[0].value)
                 : "must rise: the second probability and value are above the first",
             form);
    return found;
  }

  std::optional<Distribution> between() {
    for (const std::string_view name : {"mean", "standard_deviation", "cv", "quantiles"})
      if (has(name)) {
        refuse(name, "stands beside min and max", "give the ends, the moments or the quantiles");
        return std::nullopt;
      }
    const auto ends = both_ends();
    return ends ? std::optional(Distribution{Family::uniform, {(*ends)[0], (*ends)[1]}}) : std::nullopt;
  }

  std::optional<std::array<double, 2>> both_ends() {
    const auto least = number("min", true), most = number("max", true);
    if (!least || !most) return std::nullopt;
    if (*least < *most) return std::array{*least, *most};
    refuse("max", fmt::format("{} is not above min = {}", *most, *least));
    return std::nullopt;
  }

  std::optional<Distribution> triangular() {
    const auto ends = both_ends();
    const auto mode = number("mode", true);
    if (!ends || !mode) return std::nullopt;
    const auto [least, most] = *ends;
    if (*mode >= least && *mode <= most) return Distribution{Family::triangular, {least, *mode, most}};
    refuse("mode", fmt::format("{} is outside of {} to {}", *mode, least, most));
    return std::nullopt;
  }

  std::optional<Distribution> beta() {
    const auto ends = both_ends();
    if (!ends) return std::nullopt;
    const auto [least, most] = *ends;
    if (has("alpha") || has("beta")) {
      for (const std::string_view name : {"mean", "standard_deviation", "cv"})
        if (has(name)) {
          refuse(name, "stands beside alpha and beta", "give the shapes or the moments");
          return std::nullopt;
        }
      const auto alpha = number("alpha", true), shape = number("beta", true);
      if (!alpha || !shape) return std::nullopt;
      if (*alpha > 0.0 && *shape > 0.0) return Distribution{Family::beta, {*alpha, *shape, least, most}};
      refuse(*alpha > 0.0 ? "beta" : "alpha", "must be above 0");
      return std::nullopt;
    }
    const auto mean = number("mean", true);
    if (!mean) return std::nullopt;
    if (!(least < *mean && *mean < most)) {
      refuse("mean", fmt::format("{} is outside of {} to {}", *mean, least, most));
      return std::nullopt;
    }
    const auto spread = deviation(*mean);
    if (!spread) return std::nullopt;
    const auto found = beta_from_moments(least, most, *mean, *spread);
    if (!found)
      refuse(
          has("cv") ? "cv" : "standard_deviation",
          fmt::format("a standard deviation of {:.6g} cannot be between {} and {} about a mean of {}: below "
                      "{:.6g}",
                      *spread, least, most, *mean, most_deviation(least, most, *mean)));
    return found;
  }

  // A value of the quantity; of a choice its index.
  std::optional<double> value_of(const Value& item, std::string_view name) {
    if (quantity_.choices.empty()) return finite_number(item, joined(key_, name), errors_);
    const auto found = std::ranges::find(quantity_.choices, item.text);
    if (item.kind == Value::Kind::text && found != quantity_.choices.end())
      return static_cast<double>(found - quantity_.choices.begin());
    errors_.add(item.place, joined(key_, name), fmt::format("must be one of {}", listed(quantity_.choices)));
    return std::nullopt;
  }

  const Value* array(std::string_view name, bool required) {
    const Member* member = table_.find(name);
    if (member == nullptr) {
      if (required) refuse(name, "is missing");
      return nullptr;
    }
    if (member->value.kind == Value::Kind::array && !member->value.items.empty()) return &member->value;
    refuse(name, "must be an array that is not empty");
    return nullptr;
  }

  std::optional<Distribution> discrete() {
    const Value* values = array("values", true);
    if (values == nullptr) return std::nullopt;
    const Value* weights = array("weights", false);
    if (weights == nullptr && has("weights")) return std::nullopt;
    if (weights != nullptr && weights->items.size() != values->items.size()) {
      refuse("weights",
             fmt::format("has {} numbers for {} values", weights->items.size(), values->items.size()));
      return std::nullopt;
    }
    std::vector<double> given, weighed;
    for (std::size_t i = 0; i < values->items.size(); ++i) {
      const auto value = value_of(values->items[i], "values");
      const auto weight =
          weights ? finite_number(weights->items[i], joined(key_, "weights"), errors_) : std::optional(1.0);
      if (!value || !weight) return std::nullopt;
      if (!(*weight > 0.0)) {
        errors_.add(weights->items[i].place, joined(key_, "weights"),
                    fmt::format("{} must be above 0", *weight));
        return std::nullopt;
      }
      given.push_back(*value);
      weighed.push_back(*weight);
    }
    return of_values(given, weighed);
  }

  static Distribution of_values(const std::vector<double>& values, const std::vector<double>& weights) {
    std::map<double, double> weight_of;
    double sum = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) weight_of[values[i]] += weights[i], sum += weights[i];
    Distribution made{Family::discrete};
    for (const auto& [value, weight] : weight_of) {
      made.values.push_back(value);
      made.weights.push_back(weight / sum);
    }
    return made;
  }

  std::optional<Distribution> within_the_valid_range(Distribution read) {
    const std::string unit = quantity_.unit == "-" ? "" : fmt::format(" {}", quantity_.unit);
    if (read.family == Family::discrete) {
      for (const double value : read.values)
        if (value < quantity_.min || value > quantity_.max ||
            (quantity_.integer && value != std::round(value))) {
          refuse(kind_ == "empirical" ? "column" : "values",
                 fmt::format("{} is outside the valid range {} to {}{}", value, quantity_.min, quantity_.max,
                             unit));
          return std::nullopt;
        }
      return read;
    }
    try {
      const auto asked = marginal(read);
      const double below = asked->probability(quantity_.min), above = 1.0 - asked->probability(quantity_.max);
      if (below + above > tolerated_outside) {
        refuse("",
               fmt::format("gives {:.3g} % of the values outside the valid range {} to {}{}",
                           100.0 * (below + above), quantity_.min, quantity_.max, unit),
               "cut it off with min and max, or take another kind");
        return std::nullopt;
      }
      read.least = std::max(read.least, quantity_.min);
      read.most = std::min(read.most, quantity_.max);
      return read;
    } catch (const std::invalid_argument& problem) {
      refuse("", problem.what());
    }
    return std::nullopt;
  }

  const Value& table_;
  const solver::Quantity& quantity_;
  const std::string& key_;
  const Value& root_;
  ErrorList& errors_;
  std::string kind_;
};

}  // namespace

std::span<const KeyTable> distribution_kinds() {
  static const std::vector<KeyTable> kinds = listed_kinds();
  return kinds;
}

std::optional<Distribution> read_distribution(const Value& value, const solver::Quantity& quantity,
                                              const std::string& key, const Value& root, ErrorList& errors) {
  if (value.kind == Value::Kind::table) return DistributionReader(value, quantity, key, root, errors).read();
  errors.add(value.place, key, fmt::format("must be a table, not {}", to_string(value.kind)),
             R"(such as { kind = "lognormal", mean = 743, cv = 0.1 })");
  return std::nullopt;
}

}  // namespace cpt::parameters
