#include "parameters/read_design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "parameters/designs/design.hpp"
#include "parameters/designs/sectioning.hpp"
#include "parameters/distributions/drawn.hpp"
#include "parameters/nearest_name.hpp"
#include "parameters/read_quantities.hpp"
#include "parameters/study_keys.hpp"

namespace cpt::parameters {
namespace {

constexpr long most_runs = 20000;  // more than any solver finishes; keeps a typing error from filling memory

template <auto Member>
void set(Design& design, double value) {
  design.*Member = static_cast<std::remove_reference_t<decltype(design.*Member)>>(value);
}
/// A key of the section that holds a whole number.
struct Number {
  std::string_view key;
  void (*set)(Design& design, double value);
};
const std::array<Number, 6> number_keys = {{{"runs", set<&Design::runs>},
                                            {"sections", set<&Design::sections>},
                                            {"first_runs", set<&Design::first_runs>},
                                            {"trajectories", set<&Design::trajectories>},
                                            {"levels", set<&Design::levels>},
                                            {"seed", set<&Design::seed>}}};

const DesignKey* find_key(const DesignKind& kind, std::string_view name) {
  const auto key = std::ranges::find(kind.keys, name, &DesignKey::name);
  return key == kind.keys.end() ? nullptr : &*key;
}

class DesignReader {
 public:
  DesignReader(const Value& root, const Value& table, const std::vector<Row>& rows,
               const solver::Setup& setup, ErrorList& errors)
      : root_(root),
        table_(table),
        rows_(rows),
        setup_(setup),
        rows_sound_(errors.empty()),
        errors_(errors) {}

  Design read() {
    bool sound = refuse_unknown_keys(table_, "design", known_names(study_keys(), "design"), errors_);
    const auto kind = name_field(table_, "design", "kind", true, design_kinds(), errors_);
    if (!kind) return {};
    kind_ = &design_named(*kind);
    design_.kind = *kind;
    sound = read_parameters() && sound;
    for (const Number& number : number_keys) sound = read_number(number) && sound;
    sound = read_estimator() && sound;
    sound = read_sampling() && sound;
    sound = read_until() && sound;
    sound = read_numerical_error() && sound;
    sound = may_shift_points() && sound;
    sound = sound && growth() && enough_sections();
    return sound && affordable() ? design_ : Design();
  }

 private:
  void refuse(const Member& member, std::string message, std::string hint = "") {
    errors_.add(member.value.place, joined("design", member.key), std::move(message), std::move(hint));
  }

  bool read_parameters() {
    const Member* member = table_.find("parameters");
    if (kind_->places == nullptr) {
      if (member != nullptr)
        refuse(*member, fmt::format("{} changes every row of [parameters]", kind_->name));
      return member == nullptr;
    }
    if (member == nullptr) {
      for (std::size_t row = 0; row < rows_.size(); ++row)
        if (!rows_[row].only_drawn() && design_.rows.size() < kind_->usual_rows) design_.rows.push_back(row);
    } else if (!read_names(*member)) {
      return false;
    }
    // Last: the directions of the sequence that the other rows take stay theirs.
    for (std::size_t row = 0; row < rows_.size() && kind_->draws_fields; ++row)
      if (rows_[row].only_drawn()) design_.rows.push_back(row);
    if (design_.rows.size() >= kind_->least_rows) return true;
    if (rows_sound_)
      errors_.add(
          member ? member->value.place : table_.place, "design.parameters",
          fmt::format("{} wants at least {} of the rows of [parameters]", kind_->name, kind_->least_rows));
    return false;
  }

  bool read_names(const Member& member) {
    const std::size_t before = design_.rows.size();
    const std::string form = "such as parameters = [\"sand.H\", \"sand.D_r_percent\"]";
    if (member.value.kind != Value::Kind::array) {
      refuse(member, fmt::format("must be an array of names, not {}", to_string(member.value.kind)), form);
      return false;
    }
    for (const Value& item : member.value.items) {
      if (item.kind != Value::Kind::text) {
        errors_.add(item.place, "design.parameters",
                    fmt::format("must hold names, not {}", to_string(item.kind)), form);
        continue;
      }
      if (const auto row = row_named(item)) design_.rows.push_back(*row);
    }
    return design_.rows.size() - before == member.value.items.size();
  }

  std::optional<std::size_t> row_named(const Value& name) {
    const auto row = std::find_if(rows_.begin(), rows_.end(), [&](const Row& r) {
      return r.quantity->name == name.text && !r.only_drawn();
    });
    const auto index = static_cast<std::size_t>(row - rows_.begin());
    if (row == rows_.end()) {
      // A row with an error of its own is not among the rows.
      const bool told = is_row_given(root_, name.text) ||
                        (!rows_sound_ && solver::find_quantity(name.text, setup_) != nullptr);
      if (!told) {
        std::vector<std::string_view> names;
        for (const Row& r : rows_)
          if (!r.only_drawn()) names.push_back(r.quantity->name);
        const std::string_view near = nearest_name(name.text, names);
        errors_.add(name.place, "design.parameters",
                    fmt::format("\"{}\" is no row of [parameters]", name.text),
                    near.empty() ? "" : fmt::format("did you mean \"{}\"?", near));
      }
      return std::nullopt;
    }
    if (std::find(design_.rows.begin(), design_.rows.end(), index) != design_.rows.end()) {
      errors_.add(name.place, "design.parameters", fmt::format("\"{}\" is named twice", name.text));
      return std::nullopt;
    }
    return index;
  }

  bool read_number(const Number& number) {
    const Member* member = table_.find(number.key);
    const DesignKey* known = find_key(*kind_, number.key);
    if (member != nullptr && known == nullptr) {
      std::string kinds;
      for (const DesignKind& kind : all_designs())
        if (find_key(kind, number.key) != nullptr)
          kinds += (kinds.empty() ? "" : ", ") + std::string(kind.name);
      refuse(*member, fmt::format("means nothing to {}; it belongs to {}", kind_->name, kinds));
      return false;
    }
    if (known == nullptr) return true;
    const auto given = number_field(table_, "design", number.key, false, errors_);
    if (member != nullptr && !given) return false;
    if (!given) {
      number.set(design_, known->usual + known->usual_a_row * static_cast<double>(design_.rows.size()));
      return true;
    }
    const double value = *given;
    const Key& key = key_named(study_keys(), "design", number.key);
    const bool even = number.key != "levels" || std::fmod(value, 2.0) == 0.0;
    if (value != std::round(value) || !even || value < key.least || value > key.most) {
      refuse(*member, fmt::format("{} must be {} number from {} to {}", value,
                                  number.key == "levels" ? "an even" : "a whole", key.least, key.most));
      return false;
    }
    number.set(design_, value);
    return true;
  }

  bool belongs_to_propagation(const Member& member) {
    if (kind_->propagates) return true;
    refuse(member, fmt::format("means nothing to {}; it belongs to propagation", kind_->name));
    return false;
  }

  bool read_sampling() {
    const Member* member = table_.find("sampling");
    if (member == nullptr) return true;
    if (!belongs_to_propagation(*member)) return false;
    const auto name = name_field(table_, "design", "sampling", false,
                                 key_named(study_keys(), "design", "sampling").choices, errors_);
    design_.latin = name == "latin_hypercube";
    return name.has_value();
  }

  // A rule stops before `runs`; without that number it may take 1000, never more unasked.
  bool read_until() {
    const Member* member = table_.find("until");
    if (member == nullptr) return true;
    if (!belongs_to_propagation(*member)) return false;
    if (member->value.kind != Value::Kind::table) {
      refuse(*member, fmt::format("must be a table, not {}", to_string(member->value.kind)),
             "such as until = { quantile = 0.95, half_width_percent = 3 }");
      return false;
    }
    constexpr std::array<std::string_view, 2> known = {"quantile", "half_width_percent"};
    const std::string key = "design.until";
    StopRule rule;
    bool sound = refuse_unknown_keys(member->value, key, known, errors_);
    const auto within = [&](std::string_view name, bool required, double most) -> std::optional<double> {
      const auto value = number_field(member->value, key, name, required, errors_);
      sound = sound && (value || (!required && member->value.find(name) == nullptr));
      if (!value || (*value > 0.0 && *value < most)) return value;
      errors_.add(member->value.find(name)->value.place, joined(key, name),
                  fmt::format("{} must be above 0 and below {}", *value, most));
      sound = false;
      return std::nullopt;
    };
    if (const auto quantile = within("quantile", false, 1.0)) rule.quantile = *quantile;
    if (const auto percent = within("half_width_percent", true, 100.0)) rule.half_width = 0.01 * *percent;
    if (!sound) return false;
    design_.until = rule;
    constexpr int most_untold = 1000;
    if (table_.find("runs") == nullptr) design_.runs = most_untold;
    return true;
  }

  bool read_numerical_error() {
    const Member* member = table_.find("numerical_error_percent");
    if (member == nullptr) return true;
    if (!belongs_to_propagation(*member)) return false;
    const std::string form = "such as numerical_error_percent = { q_c = 5 }";
    if (setup_.program) {
      refuse(*member,
             "is of the embedded solver's channels, and the study's realizations are another program's");
      return false;
    }
    if (member->value.kind != Value::Kind::table) {
      refuse(*member, fmt::format("must be a table, not {}", to_string(member->value.kind)), form);
      return false;
    }
    const std::string key = "design.numerical_error_percent";
    std::vector<std::string_view> names;
    for (const solver::Channel& channel : solver::channels()) names.push_back(channel.name);
    bool sound = refuse_unknown_keys(member->value, key, names, errors_);
    for (std::size_t k = 0; k < names.size(); ++k) {
      const Member* given = member->value.find(names[k]);
      if (given == nullptr) continue;
      constexpr double most = 100.0;
      const auto percent = number_field(member->value, key, names[k], true, errors_);
      const bool within = percent && *percent >= 0.0 && *percent <= most;
      if (percent && !within)
        errors_.add(given->value.place, joined(key, names[k]),
                    fmt::format("{} must be from 0 to {}", *percent, most));
      if (within) design_.numerical_error[k] = *percent / most;
      sound = sound && within;
    }
    return sound;
  }

  bool may_shift_points() {
    const Member* member = table_.find("shift_points");
    if (member == nullptr || (kind_->draws_fields && !setup_.program)) return true;
    if (setup_.program) {
      refuse(*member,
             "shifts the material points of the embedded solver, and the study's realizations are another "
             "program's");
      return false;
    }
    std::vector<std::string_view> kinds;
    for (const DesignKind& kind : all_designs())
      if (kind.draws_fields) kinds.push_back(kind.name);
    refuse(*member, fmt::format("means nothing to {}; it belongs to {}", kind_->name, listed(kinds)));
    return false;
  }

  bool read_estimator() {
    const Member* member = table_.find("estimator");
    if (kind_->estimators.empty()) {
      if (member != nullptr)
        refuse(*member, fmt::format("means nothing to {}, which has one estimator", kind_->name));
      return member == nullptr;
    }
    const auto name = name_field(table_, "design", "estimator", false, kind_->estimators, errors_);
    if (name) design_.estimator = *name;
    return member == nullptr || name.has_value();
  }

  // An interval rests on some sections, and each has its own estimate.
  bool enough_sections() {
    constexpr int rows_of_one = 4;
    if (design_.sections == 1) return true;
    const Member& member = *table_.find("sections");
    if (design_.sections < least_sections)
      refuse(member, fmt::format("{} must be 1, or {} and more: the interval comes from them",
                                 design_.sections, least_sections));
    else if (design_.runs < rows_of_one * design_.sections)
      refuse(member, fmt::format("{} sections need runs = {} or more, {} rows each", design_.sections,
                                 rows_of_one * design_.sections, rows_of_one));
    else
      return true;
    return false;
  }

  bool growth() {
    if (design_.first_runs <= design_.runs) return true;
    refuse(*table_.find("first_runs"),
           fmt::format("{} must be at most runs = {}: a sample grows", design_.first_runs, design_.runs));
    return false;
  }

  bool affordable() {
    const long runs = run_count(design_);
    if (runs <= most_runs) return true;
    errors_.add(table_.place, "design", fmt::format("asks for {} runs, more than {}", runs, most_runs),
                "take fewer runs, trajectories or parameters");
    return false;
  }

  const Value& root_;
  const Value& table_;
  const std::vector<Row>& rows_;
  const solver::Setup& setup_;
  bool rows_sound_;
  ErrorList& errors_;
  const DesignKind* kind_ = nullptr;
  Design design_;
};

}  // namespace

void add_drawn_shift(const Value& root, const solver::Setup& setup, std::vector<Row>& rows,
                     ErrorList& errors) {
  const Member* design = root.find("design");
  if (design == nullptr || design->value.kind != Value::Kind::table) return;
  if (!flag_field(design->value, "design", "shift_points", errors).value_or(false)) return;
  const solver::Quantity& shift = *solver::find_quantity("numerics.point_shift");
  if (std::ranges::find(rows, &shift, &Row::quantity) != rows.end())
    return errors.add(design->value.find("shift_points")->value.place, "design.shift_points",
                      "numerics.point_shift is a row of [parameters]", "leave out one of the two");
  const double baseline = shift.value(setup);
  rows.push_back({&shift, baseline, baseline, baseline, std::make_shared<PointShift>()});
}

Design read_design(const Value& root, const std::vector<Row>& rows, const solver::Setup& setup,
                   ErrorList& errors) {
  const Value* table = section(root, "design", errors);
  return table == nullptr ? Design() : DesignReader(root, *table, rows, setup, errors).read();
}

}  // namespace cpt::parameters
