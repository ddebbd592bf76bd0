#include "parameters/read_design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "parameters/designs/design.hpp"
#include "parameters/nearest_name.hpp"
#include "parameters/study_keys.hpp"

namespace cpt::parameters {
namespace {

using Kind = Design::Kind;

constexpr long most_runs = 20000;  // more than any solver finishes; keeps a typing error from filling memory

/// A key of the section that holds a whole number.
struct Number {
  std::string_view key;
  std::vector<Kind> kinds;  // that know it
};
const std::array<Number, 5> number_keys = {{{"runs", {Kind::latin_hypercube, Kind::sobol}},
                                            {"first_runs", {Kind::latin_hypercube}},
                                            {"trajectories", {Kind::morris}},
                                            {"levels", {Kind::morris}},
                                            {"seed", {Kind::morris, Kind::latin_hypercube, Kind::sobol}}}};

class DesignReader {
 public:
  DesignReader(const Value& table, const std::vector<Row>& rows, const solver::Setup& setup,
               ErrorList& errors)
      : table_(table), rows_(rows), setup_(setup), rows_sound_(errors.empty()), errors_(errors) {}

  Design read() {
    bool sound = refuse_unknown_keys(table_, "design", known_names(study_keys(), "design"), errors_);
    const auto kind = name_field(table_, "design", "kind", true, design_kinds(), errors_);
    if (!kind) return {};
    const auto place = std::find(design_kinds().begin(), design_kinds().end(), *kind);
    design_.kind = static_cast<Kind>(place - design_kinds().begin());
    sound = read_parameters() && sound;
    for (const Number& number : number_keys) sound = read_number(number) && sound;
    sound = sound && growth();
    return sound && affordable() ? design_ : Design();
  }

 private:
  void refuse(const Member& member, std::string message, std::string hint = "") {
    errors_.add(member.value.place, joined("design", member.key), std::move(message), std::move(hint));
  }

  bool read_parameters() {
    const Member* member = table_.find("parameters");
    if (design_.kind == Kind::one_at_a_time) {
      if (member != nullptr) refuse(*member, "one_at_a_time changes every row of [parameters]");
      return member == nullptr;
    }
    if (member == nullptr) {
      // All pairs of a long table cost more than they tell.
      const std::size_t count =
          design_.kind == Kind::pairs ? std::min<std::size_t>(rows_.size(), 4) : rows_.size();
      design_.rows.resize(count);
      std::iota(design_.rows.begin(), design_.rows.end(), std::size_t{0});
    } else if (!read_names(*member)) {
      return false;
    }
    const std::size_t least = design_.kind == Kind::pairs ? 2 : 1;
    if (design_.rows.size() >= least) return true;
    if (rows_sound_)
      errors_.add(
          member ? member->value.place : table_.place, "design.parameters",
          fmt::format("{} wants at least {} of the rows of [parameters]", to_string(design_.kind), least));
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
    const auto row =
        std::find_if(rows_.begin(), rows_.end(), [&](const Row& r) { return r.quantity->name == name.text; });
    const auto index = static_cast<std::size_t>(row - rows_.begin());
    if (row == rows_.end()) {
      // A row with an error of its own is not among the rows.
      if (rows_sound_ || solver::find_quantity(name.text, setup_) == nullptr) {
        std::vector<std::string_view> names;
        for (const Row& r : rows_) names.push_back(r.quantity->name);
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
    const bool known =
        std::find(number.kinds.begin(), number.kinds.end(), design_.kind) != number.kinds.end();
    if (member != nullptr && !known) {
      std::string kinds;
      for (const Kind kind : number.kinds)
        kinds += (kinds.empty() ? "" : ", ") + std::string(to_string(kind));
      refuse(*member, fmt::format("means nothing to {}; it belongs to {}", to_string(design_.kind), kinds));
      return false;
    }
    if (!known) return true;
    const auto given = number_field(table_, "design", number.key, false, errors_);
    if (member != nullptr && !given) return false;
    if (number.key == "first_runs" && !given) return true;
    const double value = given.value_or(usual(number.key));
    const Key& key = key_named(study_keys(), "design", number.key);
    const bool even = number.key != "levels" || std::fmod(value, 2.0) == 0.0;
    if (value != std::round(value) || !even || value < key.least || value > key.most) {
      refuse(*member, fmt::format("{} must be {} number from {} to {}", value,
                                  number.key == "levels" ? "an even" : "a whole", key.least, key.most));
      return false;
    }
    if (number.key == "seed")
      design_.seed = static_cast<std::uint64_t>(value);
    else
      (number.key == "runs"         ? design_.runs
       : number.key == "first_runs" ? design_.first_runs
       : number.key == "levels"     ? design_.levels
                                    : design_.trajectories) = static_cast<int>(value);
    return true;
  }

  // What is taken where the study says nothing.
  [[nodiscard]] double usual(std::string_view key) const {
    if (key == "seed") return 1.0;
    if (key == "levels") return 4.0;         // Morris (1991), Campolongo et al. (2007)
    if (key == "trajectories") return 10.0;  // the same
    if (design_.kind == Kind::sobol) return 64.0;
    return 10.0 *
           static_cast<double>(design_.rows.size());  // Loeppky, Sacks & Welch (2009), Technometrics 51
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

  const Value& table_;
  const std::vector<Row>& rows_;
  const solver::Setup& setup_;
  bool rows_sound_;
  ErrorList& errors_;
  Design design_;
};

}  // namespace

Design read_design(const Value& root, const std::vector<Row>& rows, const solver::Setup& setup,
                   ErrorList& errors) {
  const Value* table = section(root, "design", errors);
  return table == nullptr ? Design() : DesignReader(*table, rows, setup, errors).read();
}

}  // namespace cpt::parameters
