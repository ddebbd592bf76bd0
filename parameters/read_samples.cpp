#include "parameters/read_samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "parameters/all_realizations.hpp"
#include "parameters/document.hpp"
#include "parameters/fields.hpp"
#include "parameters/nearest_name.hpp"
#include "parameters/read_quantities.hpp"
#include "parameters/realization.hpp"
#include "parameters/response_names.hpp"
#include "parameters/written_number.hpp"

namespace cpt::parameters {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<std::string_view, 10> statuses = {
    "pending",      "running",    "completed",          "did_not_converge",
    "energy_drift", "time_limit", "invalid_parameters", "crashed",
    "rank_lost",    "not_needed"};
constexpr std::array<std::string_view, 3> not_read = {"interface", "interface_id", "realization"};

constexpr std::array parts = {&WindowResponse::mean, &WindowResponse::min, &WindowResponse::max};

/// What a column holds; nothing of it set: it is not read.
struct Meaning {
  const solver::Quantity* quantity = nullptr;
  std::string word;  // name, status, reason or eval_id
  std::size_t window = 0;
  double WindowResponse::*part = nullptr;
};

bool is_void(std::string_view text) {
  for (const std::string_view word : {"", "nan", "NaN", "NAN", "NA", "null"})
    if (text == word) return true;
  return false;
}

class SamplesReader {
 public:
  SamplesReader(const FieldTable& table, const Study& study, const SampleColumns& columns)
      : table_(table), study_(study), columns_(columns), errors_(table.file) {}

  SamplesOrErrors read() {
    for (const Field& name : table_.names) meanings_.push_back(meaning_of(name));
    check_columns();
    if (!errors_.empty()) return errors_.sorted();
    for (std::size_t i = 0; i < table_.rows.size() && errors_.size() < most_errors; ++i) read_row(i);
    if (samples_.empty()) errors_.add({}, "", "has no rows");
    if (!errors_.empty()) return errors_.sorted();
    return std::move(samples_);
  }

 private:
  [[nodiscard]] std::vector<std::string> responses() const {
    std::vector<std::string> names;
    for (const Window& window : study_.windows)
      for (const std::string& name : names_of(window)) names.push_back(name);
    return names;
  }

  [[nodiscard]] static std::array<std::string, 3> names_of(const Window& window) {
    return response_names(window.name, !window.output.empty());
  }

  Meaning meaning_of(const Field& name) {
    const auto is = [&](const auto& list) {
      return std::find(list.begin(), list.end(), name.text) != list.end();
    };
    if (is(columns_.ignored) || is(not_read)) return {};
    std::string meaning = name.text;
    for (const SampleColumns::Name& given : columns_.names)
      if (given.column == name.text) meaning = given.meaning;
    Meaning found;
    for (const std::string_view word : {"name", "status", "reason", "eval_id"})
      if (meaning == word) found.word = meaning;
    found.quantity = solver::find_quantity(meaning, study_.baseline);
    for (std::size_t w = 0; w < study_.windows.size(); ++w)
      for (std::size_t k = 0; k < parts.size(); ++k)
        if (meaning == names_of(study_.windows[w])[k]) {
          found.window = w;
          found.part = parts[k];
        }
    if (found.quantity == nullptr && found.word.empty() && found.part == nullptr)
      refuse_unknown(name, meaning);
    if (found.part != nullptr && columns_.responses && study_.windows[found.window].width > 0.0)
      errors_.add(
          name.place, name.text,
          fmt::format("the window {} is placed by the baseline's curve, which a table of averages does "
                      "not have",
                      study_.windows[found.window].name),
          "give it from_m and to_m in a copy of the study, or leave the column out with --ignore");
    return found;
  }

  void refuse_unknown(const Field& name, const std::string& meaning) {
    const std::vector<std::string> averages = responses();
    const std::vector<std::string_view> known(averages.begin(), averages.end());
    const bool external = study_.baseline.program != nullptr;
    const bool average = external || meaning.find("q_c") != meaning.npos;
    const std::string_view near =
        average ? nearest_name(meaning, known) : nearest_quantity(meaning, study_.baseline);
    errors_.add(
        name.place, name.text,
        fmt::format("is neither {} of the study ({})",
                    external ? "an input nor an output" : "a quantity nor an average of q_c in a window",
                    fmt::join(averages, ", ")),
        fmt::format("{}--column KEY={} says what it is, --ignore {} leaves it out",
                    near.empty() ? "" : fmt::format("did you mean {}? ", near), name.text, name.text));
  }

  void check_columns() {
    const auto has = [&](const std::string& column) {
      return std::any_of(table_.names.begin(), table_.names.end(),
                         [&](const Field& name) { return name.text == column; });
    };
    for (const SampleColumns::Name& given : columns_.names)
      if (!has(given.column)) errors_.add({}, given.column, "there is no such column", columns_of_file());
    for (const std::string& ignored : columns_.ignored)
      if (!has(ignored)) errors_.add({}, ignored, "there is no such column to leave out", columns_of_file());
    for (std::size_t i = 0; i < meanings_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (same(meanings_[i], meanings_[j]))
          errors_.add(table_.names[i].place, table_.names[i].text,
                      fmt::format("says the same as the column {}", table_.names[j].text),
                      "keep one of the two");
    if (!errors_.empty()) return;
    const auto some = [&](auto is) { return std::any_of(meanings_.begin(), meanings_.end(), is); };
    if (!some([](const Meaning& m) { return m.quantity != nullptr; }))
      errors_.add({}, "", "no column is an input", "`campaign list quantities` prints all of them");
    if (columns_.responses && !some([](const Meaning& m) { return m.part == &WindowResponse::mean; }))
      errors_.add({}, "",
                  fmt::format("no column is {}", study_.baseline.program ? "an output" : "an average of q_c"),
                  fmt::format("name one {}, or say which it is with --column",
                              names_of(study_.windows.front()).front()));
  }

  [[nodiscard]] std::string columns_of_file() const {
    std::string names;
    for (const Field& name : table_.names)
      names += (names.empty() ? "columns of the file: " : ", ") + name.text;
    return names.substr(0, 300);
  }

  static bool same(const Meaning& a, const Meaning& b) {
    if (a.quantity != nullptr) return a.quantity == b.quantity;
    if (a.part != nullptr) return a.part == b.part && a.window == b.window;
    return !a.word.empty() && a.word == b.word;
  }

  void read_row(std::size_t index) {
    const std::vector<Field>& fields = table_.rows[index];
    if (repeats_the_names(fields)) return;
    Sample sample;
    sample.place = fields.front().place;
    sample.responses.assign(study_.windows.size(), {no_value, no_value, no_value});
    Value inputs;
    inputs.place = sample.place;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const Meaning& meaning = meanings_[i];
      if (meaning.quantity != nullptr) add_input(inputs, *meaning.quantity, fields[i]);
      if (columns_.responses && meaning.part != nullptr)
        sample.responses[meaning.window].*meaning.part = response(table_.names[i], fields[i]);
      if (meaning.word == "name") sample.name = fields[i].text;
      if (meaning.word == "eval_id" && sample.name.empty()) sample.name = "eval " + fields[i].text;
      if (columns_.responses && meaning.word == "status") read_status(fields[i], sample);
      if (meaning.word == "reason") sample.reason = fields[i].text;
    }
    if (sample.name.empty()) sample.name = fmt::format("row {}", index + 1);
    if (const auto [first, is_new] = names_.try_emplace(sample.name, index + 1); !is_new)
      errors_.add(sample.place, "name",
                  fmt::format("\"{}\" names row {} already", sample.name, first->second));
    for (const Setting& setting : read_settings(inputs, "", {}, study_.baseline, {}, errors_))
      sample.changes.push_back({setting.quantity, setting.value});
    if (columns_.responses) judge(sample, index + 1);
    samples_.push_back(std::move(sample));
  }

  // Two files joined into one: the second one's rows may mean something else.
  bool repeats_the_names(const std::vector<Field>& fields) {
    for (std::size_t i = 0; i < fields.size(); ++i)
      if (fields[i].text != table_.names[i].text) return false;
    errors_.add(fields.front().place, "", "the line of names stands here again",
                "a table has one; were two files joined?");
    return true;
  }

  void add_input(Value& inputs, const solver::Quantity& quantity, const Field& field) {
    if (is_void(field.text))
      return errors_.add(field.place, std::string(quantity.name), "has no value",
                         "an input that all rows leave at the study's baseline needs no column");
    Value value;
    value.place = field.place;
    const auto read = written_number(field.text);
    value.kind = read && quantity.choices.empty() ? Value::Kind::number : Value::Kind::text;
    value.number = read.value_or(0.0);
    value.text = field.text;
    inputs.members.push_back({std::string(quantity.name), field.place, std::move(value)});
  }

  double response(const Field& name, const Field& field) {
    if (is_void(field.text)) return no_value;
    const auto read = written_number(field.text);
    if (!read || !std::isfinite(*read)) {
      const std::string hint = number_hint(field.text);
      errors_.add(field.place, name.text, fmt::format("\"{}\" is not a finite number", field.text),
                  hint.empty() ? "empty or NaN where there is none" : hint);
      return no_value;
    }
    return *read;
  }

  void read_status(const Field& field, Sample& sample) {
    if (std::find(statuses.begin(), statuses.end(), field.text) != statuses.end()) {
      sample.status =
          field.text == "running" ? "pending" : field.text;  // what ran elsewhere does not run here
      return;
    }
    if (field.text.empty()) return;
    const std::string_view near = nearest_name(field.text, statuses);
    errors_.add(field.place, "status", fmt::format("\"{}\" is not one of {}", field.text, listed(statuses)),
                near.empty() ? "" : fmt::format("did you mean \"{}\"?", near));
  }

  // Status and averages must fit together; where the table has no status, the averages say it.
  void judge(Sample& sample, std::size_t row) {
    bool any = false;
    for (const WindowResponse& r : sample.responses) {
      any = any || !std::isnan(r.mean);
      if (r.min > r.mean || r.max < r.mean ||
          (std::isnan(r.mean) && !(std::isnan(r.min) && std::isnan(r.max))))
        errors_.add(sample.place, fmt::format("row {}", row),
                    fmt::format("the average {} does not lie between its least {} and largest {}", r.mean,
                                r.min, r.max));
    }
    if (sample.status.empty()) {
      sample.status = any ? "completed" : "crashed";
      if (!any && sample.reason.empty())
        sample.reason = "the imported table has no average for it and no reason";
    }
    if (any && sample.status != "completed")
      errors_.add(sample.place, fmt::format("row {}", row),
                  fmt::format("is {} and has an average of q_c: only a completed one has", sample.status));
  }

  const FieldTable& table_;
  const Study& study_;
  const SampleColumns& columns_;
  ErrorList errors_;
  std::vector<Meaning> meanings_;  // of each column
  std::map<std::string, std::size_t> names_;
  std::vector<Sample> samples_;
};

}  // namespace

SamplesOrErrors read_samples(const FieldTable& table, const Study& study, const SampleColumns& columns) {
  return SamplesReader(table, study, columns).read();
}

std::vector<Sample> new_samples(const Study& study, const std::vector<Sample>& samples) {
  std::set<std::string> known;
  for (const Realization& realization : all_realizations(study))
    known.insert(settings_text(study, realization));
  std::vector<Sample> unknown;
  for (const Sample& sample : samples) {
    solver::Setup setup = study.baseline;
    for (const auto& [quantity, value] : sample.changes) quantity->set_value(setup, value);
    if (!known.contains(solver::canonical_text(setup))) unknown.push_back(sample);
  }
  return unknown;
}

std::string with_points(const std::string& study_text, const std::vector<Sample>& samples) {
  std::string text = study_text;
  if (!text.ends_with('\n')) text += '\n';
  for (const Sample& sample : samples) {
    text += fmt::format("\n[[points]]\nname = {}\n", toml_string(sample.name));
    for (const auto& [quantity, value] : sample.changes)
      text += fmt::format(
          "\"{}\" = {}\n", quantity->name,
          quantity->choices.empty() ? quantity->format(value) : toml_string(quantity->format(value)));
  }
  return text;
}

}  // namespace cpt::parameters
