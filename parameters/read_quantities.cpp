#include "parameters/read_quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "parameters/distributions/library.hpp"
#include "parameters/distributions/read_distribution.hpp"
#include "parameters/nearest_name.hpp"
#include "parameters/read_field.hpp"
#include "parameters/study_keys.hpp"
#include "parameters/unknown_quantity.hpp"
#include "solver/soils/law.hpp"

namespace cpt::parameters {
namespace {

using solver::Quantity;

// Where the bounds of a row lie that has a distribution and none of its own.
constexpr double lower_probability = 0.05;

struct OtherUnit {
  std::string_view unit;   // of the study files
  std::string_view other;  // what may have been meant
  double factor;           // from the other to the study unit
};
constexpr std::array<OtherUnit, 9> other_units = {{{"kPa", "Pa", 1.0e-3},
                                                   {"kPa", "MPa", 1.0e3},
                                                   {"m", "mm", 1.0e-3},
                                                   {"m", "cm", 1.0e-2},
                                                   {"m", "km", 1.0e3},
                                                   {"m/s", "mm/s", 1.0e-3},
                                                   {"kg/m3", "g/cm3", 1.0e3},
                                                   {"%", "(as a fraction)", 100.0},
                                                   {"deg", "rad", 180.0 / std::numbers::pi}}};

// "the unit is kPa: 27900 Pa would be 27.9" where another unit brings the value into its range.
std::string other_unit_hint(const Quantity& quantity, double value) {
  std::string hint;
  for (const OtherUnit& other : other_units) {
    const double converted = value * other.factor;
    if (other.unit != quantity.unit || converted < quantity.min || converted > quantity.max) continue;
    hint += fmt::format("{}{} {} would be {:.6g}", hint.empty() ? "" : ", ", value, other.other, converted);
  }
  return hint.empty() ? "" : fmt::format("the unit is {}: {}", quantity.unit, hint);
}

std::optional<double> read_choice(const Value& value, const Quantity& quantity, const std::string& key,
                                  ErrorList& errors) {
  if (value.kind != Value::Kind::text) {
    errors.add(value.place, key,
               fmt::format("must be one of {}, not {}", listed(quantity.choices), to_string(value.kind)));
    return std::nullopt;
  }
  const auto found = std::find(quantity.choices.begin(), quantity.choices.end(), value.text);
  if (found != quantity.choices.end()) return static_cast<double>(found - quantity.choices.begin());
  const std::string_view near = nearest_name(value.text, quantity.choices);
  errors.add(value.place, key, fmt::format("\"{}\" is not one of {}", value.text, listed(quantity.choices)),
             near.empty() ? "" : fmt::format("did you mean \"{}\"?", near));
  return std::nullopt;
}

// A value of the quantity, in study units.
std::optional<double> read_value(const Value& value, const Quantity& quantity, const std::string& key,
                                 ErrorList& errors) {
  if (!quantity.choices.empty()) return read_choice(value, quantity, key, errors);
  const std::optional<double> number = finite_number(value, key, errors);
  if (!number) return std::nullopt;
  if (*number < quantity.min || *number > quantity.max) {
    const std::string unit = quantity.unit == "-" ? "" : fmt::format(" {}", quantity.unit);
    errors.add(
        value.place, key,
        fmt::format("{} is outside the valid range {} to {}{}", *number, quantity.min, quantity.max, unit),
        other_unit_hint(quantity, *number));
    return std::nullopt;
  }
  if (quantity.integer && *number != std::round(*number)) {
    errors.add(value.place, key, fmt::format("{} must be a whole number", *number));
    return std::nullopt;
  }
  return number;
}

// A quantity named in a section.
struct Named {
  const Quantity* quantity;
  const Member* member;
  std::string key;  // with the section
};

bool is_group(std::string_view name, const solver::Setup& setup) {
  return std::ranges::any_of(solver::quantities_of(setup), [&](const Quantity* quantity) {
    return quantity->name.size() > name.size() && quantity->name.starts_with(name) &&
           quantity->name[name.size()] == '.';
  });
}

std::string hint_for_unknown(std::string_view name, const solver::Setup& setup, bool layers_known) {
  if (setup.program != nullptr) {
    std::vector<std::string_view> names;
    for (const solver::ProgramInput& input : setup.program->inputs) names.push_back(input.name);
    const std::string_view near = nearest_name(name, names);
    return near.empty() ? "name an input of [solver.inputs]" : fmt::format("did you mean {}?", near);
  }
  if (name == "layers" || name == "numerics.zones" || name == "zones")
    return fmt::format("give a [[{}]] table for each", name == "layers" ? "layers" : "zones");
  const std::string meant = meant_quantity(name, setup, layers_known);
  if (!meant.empty()) return meant;
  const auto soil = std::ranges::find(setup.soils, name.substr(0, name.find('.')), &solver::Soil::name);
  return soil == setup.soils.end()
             ? "`campaign list quantities` prints all of them"
             : fmt::format("`campaign list laws` prints the parameters of {}", solver::law_of(*soil).name());
}

class QuantitiesReader {
 public:
  QuantitiesReader(const solver::Setup& setup, const SoilDoubts& doubts, ErrorList& errors)
      : setup_(setup), doubts_(doubts), errors_(errors) {}

  QuantitySections read(const Value& root) {
    root_ = &root;
    if (const Value* table = section(root, "fixed", errors_)) read_settings(*table, "fixed", {});
    if (const Value* table = section(root, "parameters", errors_))
      for (const Named& named : named_quantities(*table, "parameters", {}))
        if (acceptable(named)) read_row(named);
    return std::move(sections_);
  }

  std::vector<Setting> read_settings(const Value& table, std::string_view section_name,
                                     std::span<const std::string_view> except) {
    for (const Named& named : named_quantities(table, section_name, except))
      if (acceptable(named)) read_fixed(named);
    return sections_.settings;
  }

 private:
  std::vector<Named> named_quantities(const Value& table, std::string_view section_name,
                                      std::span<const std::string_view> except) {
    std::vector<Named> found;
    collect(table, section_name, "", except, found);
    std::stable_sort(found.begin(), found.end(),
                     [](const Named& a, const Named& b) { return a.member->place < b.member->place; });
    return found;
  }

  // Quantities of a section in file order; groups may be spelt as nested tables.
  void collect(const Value& table, std::string_view section_name, const std::string& prefix,
               std::span<const std::string_view> except, std::vector<Named>& found) {
    for (const Member& member : table.members) {
      const std::string name = joined(prefix, member.key);
      if (std::find(except.begin(), except.end(), name) != except.end()) continue;
      if (doubts_.about(name.substr(0, name.find('.')), setup_)) continue;
      const Quantity* quantity = solver::find_quantity(name, setup_);
      if (quantity != nullptr)
        found.push_back({quantity, &member, joined(section_name, name)});
      else if (member.value.kind == Value::Kind::table && is_group(name, setup_))
        collect(member.value, section_name, name, except, found);
      else
        refuse_unknown(section_name, name, member.place);
    }
  }

  void refuse_unknown(std::string_view section_name, const std::string& name, Place place) {
    if (is_group(name, setup_))
      errors_.add(place, joined(section_name, name), "is a group of quantities",
                  fmt::format("name one of them: {}.NAME", name));
    else
      errors_.add(place, joined(section_name, name), "unknown quantity",
                  hint_for_unknown(name, setup_, !doubts_.layers));
  }

  // Named once, and of a soil that the profile contains.
  bool acceptable(const Named& named) {
    const auto [first, inserted] = first_.try_emplace(named.quantity, named.key, named.member->place);
    if (!inserted) {
      const auto& [key, place] = first->second;
      errors_.add(named.member->place, named.key,
                  fmt::format("is already given as {} in line {}", key, place.line), "keep one of the two");
      return false;
    }
    if (doubts_.layers || solver::matters(*named.quantity, setup_) || of_unused_soil(*named.quantity))
      return true;
    const std::string& soil = named.quantity->soil;
    errors_.add(named.member->place, named.key,
                soil.empty() ? fmt::format("has no effect: it acts on {}, and no layer is of that",
                                           solver::acts_on_text(*named.quantity))
                             : fmt::format("has no effect: the profile has no {}", soil));
    return false;
  }

  // Whether it would matter if a soil were used that is told to be in no layer.
  [[nodiscard]] bool of_unused_soil(const Quantity& quantity) const {
    return std::ranges::any_of(setup_.soils, [&](const solver::Soil& soil) {
      return doubts_.unused.contains(soil.name) &&
             (quantity.soil == soil.name ||
              (quantity.acts_on != nullptr && quantity.acts_on(solver::law_of(soil))));
    });
  }

  void doubt(const Named& named) { sections_.doubtful.emplace(named.quantity->name); }

  void read_fixed(const Named& named) {
    const Value& value = named.member->value;
    if (value.kind == Value::Kind::table) {
      errors_.add(named.member->place, named.key, "must be one value, not a table",
                  "a row with bounds goes under [parameters]");
      return doubt(named);
    }
    if (const auto number = read_value(value, *named.quantity, named.key, errors_))
      sections_.settings.push_back({named.quantity, *number, named.key, named.member->place});
    else
      doubt(named);
  }

  // One number of a row.
  struct Bound {
    const Member* member = nullptr;
    std::optional<double> value;

    [[nodiscard]] bool sound() const { return member == nullptr || value.has_value(); }
  };

  Bound read_bound(const Named& named, std::string_view name) {
    const Member* member = named.member->value.find(name);
    if (member == nullptr) return {};
    return {member, read_value(member->value, *named.quantity, joined(named.key, name), errors_)};
  }

  void read_row(const Named& named) {
    const Quantity& quantity = *named.quantity;
    const Value& table = named.member->value;
    if (table.kind != Value::Kind::table) {
      errors_.add(named.member->place, named.key,
                  fmt::format("must be a row such as {{ baseline = ..., lower = ..., upper = ... }}, not {}",
                              to_string(table.kind)),
                  "a single value goes under [fixed]");
      return doubt(named);
    }
    const bool known_keys =
        refuse_unknown_keys(table, named.key, known_names(study_keys(), "parameters"), errors_);
    Bound baseline = read_bound(named, "baseline"), lower = read_bound(named, "lower"),
          upper = read_bound(named, "upper"), alternative = read_bound(named, "alternative");
    if (!baseline.sound()) return doubt(named);
    std::shared_ptr<const Marginal> distributed;
    if (const Member* member = table.find("distribution")) {
      std::optional<Distribution> distribution;
      try {
        distribution = read_row_distribution(named, *member, alternative);
        if (distribution) distributed = marginal_of(*distribution, *member, named);
      } catch (const MissingLibrary& missing) {
        if (!std::exchange(library_told_, true))
          errors_.add(member->value.place, joined(named.key, "distribution"), missing.what());
      }
      if (!distributed) return doubt(named);
      const auto take = [&](Bound& bound, double probability) {
        if (bound.member == nullptr)
          bound = {member, usual_quantile(*distributed, *distribution, quantity, probability)};
      };
      take(baseline, 0.5);
      take(lower, lower_probability);
      take(upper, 1.0 - lower_probability);
    }
    const double value = baseline.value.value_or(quantity.value(setup_));
    if (baseline.value) sections_.settings.push_back({named.quantity, value, named.key, named.member->place});
    if (const Member* member = table.find("field")) {
      if (!add_field(named, *member, value)) return doubt(named);
      if (!lower.value && !upper.value && !alternative.value) return;
    }

    const bool lower_in_order = not_crossed(named, value, lower, "lower");
    const bool in_order = not_crossed(named, value, upper, "upper") && lower_in_order;
    if (!known_keys || !in_order || !lower.sound() || !upper.sound() || !alternative.sound()) return;
    if (alternative.value && (lower.value || upper.value)) {
      errors_.add(alternative.member->place, joined(named.key, "alternative"),
                  "cannot stand beside lower or upper", "keep the alternative, or the bounds");
      return;
    }
    const bool alternative_is_lower = alternative.value && *alternative.value < value;
    add_row(named, value, alternative_is_lower ? alternative : lower,
            alternative.value && !alternative_is_lower ? alternative : upper, distributed);
  }

  std::optional<Distribution> read_row_distribution(const Named& named, const Member& member,
                                                    const Bound& alternative) {
    if (alternative.member == nullptr)
      return read_distribution(member.value, *named.quantity, joined(named.key, "distribution"), *root_,
                               errors_);
    errors_.add(alternative.member->place, joined(named.key, "alternative"),
                "cannot stand beside a distribution",
                "give the values and their weights: distribution = { kind = \"discrete\", values = [...] }");
    return std::nullopt;
  }

  // nullptr after an error.
  std::shared_ptr<const Marginal> marginal_of(const Distribution& distribution, const Member& member,
                                              const Named& named) {
    const std::string key = joined(named.key, "distribution");
    try {
      return marginal(distribution);
    } catch (const std::invalid_argument& problem) {
      errors_.add(member.value.place, key, problem.what());
    }
    return nullptr;
  }

  // Four digits, as one would write a bound; as it is where only some values can be.
  static double usual_quantile(const Marginal& distributed, const Distribution& distribution,
                               const Quantity& quantity, double probability) {
    const double value = distributed.quantile(probability);
    if (quantity.integer) return std::round(value);
    return distribution.family == Family::discrete ? value : std::stod(fmt::format("{:.4g}", value));
  }

  bool not_crossed(const Named& named, double baseline, const Bound& side, std::string_view name) {
    const bool is_lower = name == "lower";
    if (!side.value || (is_lower ? *side.value <= baseline : *side.value >= baseline)) return true;
    const Quantity& quantity = *named.quantity;
    errors_.add(side.member->value.place, joined(named.key, name),
                fmt::format("{} is {} the baseline {}", quantity.format(*side.value),
                            is_lower ? "above" : "below", quantity.format(baseline)),
                "lower <= baseline <= upper");
    return false;
  }

  bool add_field(const Named& named, const Member& member, double mean) {
    auto field = read_field(member, *named.quantity, mean, setup_, joined(named.key, "field"), errors_);
    if (!field) return false;
    for (Setting& setting : field->settings) sections_.settings.push_back(std::move(setting));
    sections_.rows.push_back({std::move(field->seed), member.place, member.place});
    return true;
  }

  void add_row(const Named& named, double baseline, const Bound& lower, const Bound& upper,
               std::shared_ptr<const Marginal> distributed) {
    const Row row{named.quantity, baseline, lower.value.value_or(baseline), upper.value.value_or(baseline),
                  std::move(distributed)};
    if (row.lower == row.upper) {
      errors_.add(named.member->place, named.key,
                  fmt::format("nothing differs from the baseline {}", named.quantity->format(baseline)),
                  "give lower, upper or an alternative, or move the value to [fixed]");
      return;
    }
    const auto place = [&](const Bound& side) {
      return side.member ? side.member->value.place : named.member->place;
    };
    sections_.rows.push_back({row, place(lower), place(upper)});
  }

  const solver::Setup& setup_;
  const SoilDoubts& doubts_;
  ErrorList& errors_;
  const Value* root_ = nullptr;
  QuantitySections sections_;
  std::map<const Quantity*, std::pair<std::string, Place>> first_;
  bool library_told_ = false;  // that OpenTURNS is missing, of the first distribution alone
};

}  // namespace

QuantitySections read_quantities(const Value& root, const solver::Setup& setup, const SoilDoubts& doubts,
                                 ErrorList& errors) {
  return QuantitiesReader(setup, doubts, errors).read(root);
}

bool is_row_given(const Value& root, std::string_view name) {
  const Member* rows = root.find("parameters");
  const auto is_given = [](const auto& self, const Value& table, std::string_view rest) -> bool {
    return std::ranges::any_of(table.members, [&](const Member& member) {
      return member.key == rest || (rest.starts_with(member.key + '.') &&
                                    self(self, member.value, rest.substr(member.key.size() + 1)));
    });
  };
  return rows != nullptr && is_given(is_given, rows->value, name);
}

std::vector<Setting> read_settings(const Value& table, std::string_view section,
                                   std::span<const std::string_view> except, const solver::Setup& setup,
                                   const SoilDoubts& doubts, ErrorList& errors) {
  return QuantitiesReader(setup, doubts, errors).read_settings(table, section, except);
}

}  // namespace cpt::parameters
