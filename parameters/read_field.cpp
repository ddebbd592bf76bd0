#include "parameters/read_field.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <memory>

#include "parameters/distributions/drawn.hpp"

namespace cpt::parameters {
namespace {

using solver::Quantity;

constexpr std::string_view infix = "_field_deviation";

// "sand.D_r_percent" of "sand.D_r_field_deviation_percent"; empty of any other.
std::string field_owner(std::string_view name) {
  const auto at = name.find(infix);
  if (at == name.npos) return "";
  return std::string(name.substr(0, at)) + std::string(name.substr(at + infix.size()));
}

const Quantity* deviation_of(std::string_view owner, const solver::Setup& setup) {
  for (const Quantity* quantity : solver::quantities_of(setup))
    if (field_owner(quantity->name) == owner) return quantity;
  return nullptr;
}

class FieldReader {
 public:
  FieldReader(const Member& member, const Quantity& quantity, const solver::Setup& setup, std::string key,
              ErrorList& errors)
      : member_(member), quantity_(quantity), setup_(setup), key_(std::move(key)), errors_(errors) {}

  std::optional<ReadField> read(double mean) {
    const std::size_t before = errors_.size();
    const Quantity* deviation = deviation_of(quantity_.name, setup_);
    if (deviation == nullptr) {
      const std::vector<std::string> may = field_quantities(setup_);
      errors_.add(member_.place, key_, fmt::format("{} cannot be a random field", quantity_.name),
                  may.empty() ? "" : fmt::format("these can: {}", fmt::join(may, ", ")));
      return std::nullopt;
    }
    if (member_.value.kind != Value::Kind::table) {
      errors_.add(member_.value.place, key_,
                  fmt::format("must be a table, not {}", to_string(member_.value.kind)),
                  "such as field = { standard_deviation = 5, correlation_length_m = 0.1 }");
      return std::nullopt;
    }
    constexpr std::array<std::string_view, 4> known = {"standard_deviation", "cv", "correlation_length_m",
                                                       "kind"};
    refuse_unknown_keys(member_.value, key_, known, errors_);
    const std::string stem = deviation->name.substr(0, deviation->name.find(infix));
    const auto part = [&](std::string_view name) -> const Quantity& {
      return *solver::find_quantity(fmt::format("{}_field_{}", stem, name), setup_);
    };
    ReadField field{{}, {&part("seed"), 1.0, 1.0, 1.0, std::make_shared<FieldSeed>()}};
    const auto set = [&](const Quantity& quantity, double value, std::string_view name) {
      field.settings.push_back({&quantity, value, joined(key_, name), member_.place});
    };
    const bool by_cv = member_.value.find("cv") != nullptr;
    if (by_cv == (member_.value.find("standard_deviation") != nullptr))
      errors_.add(member_.value.place, joined(key_, "standard_deviation"),
                  by_cv ? "stands beside cv" : "is missing", "give standard_deviation or cv");
    else if (const auto given = within(by_cv ? "cv" : "standard_deviation", true, 0.0,
                                       by_cv ? deviation->max / std::abs(mean) : deviation->max))
      set(*deviation, by_cv ? *given * std::abs(mean) : *given, by_cv ? "cv" : "standard_deviation");
    const Quantity& length = part("length_m");
    if (const auto given = within("correlation_length_m", true, length.min, length.max))
      set(length, *given, "correlation_length_m");
    const Quantity& kind = part("kind");
    if (const auto name = name_field(member_.value, key_, "kind", false, kind.choices, errors_))
      set(kind, *name == kind.choices[0] ? 0.0 : 1.0, "kind");
    return errors_.size() == before ? std::optional(std::move(field)) : std::nullopt;
  }

 private:
  // Above 0.
  std::optional<double> within(std::string_view name, bool required, double least, double most) {
    const auto value = number_field(member_.value, key_, name, required, errors_);
    if (!value || (*value > 0.0 && *value >= least && *value <= most)) return value;
    errors_.add(member_.value.find(name)->value.place, joined(key_, name),
                least > 0.0 ? fmt::format("{} is outside of {} to {}", *value, least, most)
                            : fmt::format("{} must be above 0 and at most {:.6g}", *value, most));
    return std::nullopt;
  }

  const Member& member_;
  const Quantity& quantity_;
  const solver::Setup& setup_;
  std::string key_;
  ErrorList& errors_;
};

}  // namespace

std::optional<ReadField> read_field(const Member& member, const Quantity& quantity, double mean,
                                    const solver::Setup& setup, const std::string& key, ErrorList& errors) {
  return FieldReader(member, quantity, setup, key, errors).read(mean);
}

std::vector<std::string> field_quantities(const solver::Setup& setup) {
  std::vector<std::string> names;
  for (const Quantity* quantity : solver::quantities_of(setup))
    if (std::string owner = field_owner(quantity->name); !owner.empty()) names.push_back(std::move(owner));
  return names;
}

}  // namespace cpt::parameters
