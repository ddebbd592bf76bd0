#include "diagnosis/read_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "diagnosis/cone_class.hpp"
#include "diagnosis/read_sounding.hpp"
#include "diagnosis/request_keys.hpp"
#include "parameters/all_realizations.hpp"
#include "parameters/fields.hpp"
#include "parameters/nearest_name.hpp"
#include "parameters/read_quantities.hpp"

namespace cpt::diagnosis {
namespace {

using namespace parameters;

class RequestReader {
 public:
  /// Without a study what it would decide is not checked.
  RequestReader(const Value& root, const std::filesystem::path& file, const Study* study,
                Recordings recordings, ErrorList& errors)
      : root_(root),
        known_(study != nullptr),
        study_(known_ ? *study : no_study()),
        recordings_(recordings),
        errors_(errors) {
    request_.file = std::filesystem::absolute(file).lexically_normal();
    request_.name = request_.file.stem().string();
    request_.study = study_.file;
    request_.database = beside(request_.name + ".sqlite");
    request_.report_dir = beside(request_.name + "-report");
  }

  Request read() {
    refuse_unknown("", root_, recordings_ == Recordings::to_be_made ? Names{} : Names{"cases"});
    request_.title = text_field(root_, "", "title", false, errors_).value_or(request_.name);
    (void)text_field(root_, "", "study", true, errors_);
    read_mechanisms();
    read_noise();
    read_options();
    const bool recorded = recordings_ == Recordings::given;
    for (const Value* table : sections(root_, "soundings", errors_))
      read_sounding(*table, "soundings", recorded, request_.soundings);
    for (const Value* table : sections(root_, "candidates", errors_))
      read_sounding(*table, "candidates", false, request_.candidates);
    if (request_.soundings.empty() && errors_.empty())
      errors_.add({}, "soundings", "is missing: a diagnosis needs at least one recording",
                  "add [[soundings]] with recording, from_m and to_m");
    if (known_ && request_.database == study_.database)
      errors_.add({}, "",
                  fmt::format("the diagnosis would be written over the study's database {}",
                              study_.database.string()),
                  "give the request another file name");
    for (solver::Mechanism& mechanism : request_.mechanisms) {
      look_where_compared(mechanism);
      look_as_class(mechanism);
    }
    return std::move(request_);
  }

 private:
  using Names = std::vector<std::string_view>;

  void refuse_unknown(std::string_view name, const Value& table, const Names& except = {}) {
    Names known = known_names(request_keys(), name);
    std::erase_if(known, [&](std::string_view key) { return std::ranges::count(except, key) > 0; });
    refuse_unknown_keys(table, name, known, errors_);
  }

  [[nodiscard]] std::filesystem::path beside(const std::filesystem::path& path) const {
    return (request_.file.parent_path() / path).lexically_normal();
  }

  void read_mechanisms() {
    const Member* member = root_.find("mechanisms");
    if (member == nullptr) {
      for (const solver::Mechanism& mechanism : solver::all_mechanisms())
        if (applies(mechanism, study_.baseline)) request_.mechanisms.push_back(mechanism);
      return;
    }
    if (member->value.kind != Value::Kind::array)
      return errors_.add(member->place, "mechanisms", "must be a list of names",
                         "`campaign list mechanisms` prints them");
    std::vector<std::string_view> names;
    for (const solver::Mechanism& mechanism : solver::all_mechanisms()) names.push_back(mechanism.name);
    for (const Value& item : member->value.items) {
      const solver::Mechanism* mechanism = solver::find_mechanism(item.text);
      const std::string_view near = parameters::nearest_name(item.text, names);
      if (mechanism == nullptr)
        errors_.add(item.place, "mechanisms", fmt::format("\"{}\" is not a mechanism", item.text),
                    near.empty() ? "`campaign list mechanisms` prints them"
                                 : fmt::format("did you mean \"{}\"?", near));
      else if (known_ && !applies(*mechanism, study_.baseline))
        errors_.add(item.place, "mechanisms",
                    fmt::format("\"{}\" acts on nothing in this study's profile", item.text));
      else if (std::ranges::count(request_.mechanisms, mechanism->name, &solver::Mechanism::name) > 0)
        errors_.add(item.place, "mechanisms", fmt::format("\"{}\" is given twice", item.text));
      else
        request_.mechanisms.push_back(*mechanism);
    }
    if (member->value.items.empty())
      errors_.add(member->place, "mechanisms", "is empty", "leave it out for all");
  }

  // A lens below the soundings' depths does nothing that they could tell.
  void look_where_compared(solver::Mechanism& mechanism) const {
    if (request_.soundings.empty()) return;
    const double top = std::ranges::min(request_.soundings, {}, &SoundingRequest::from).from;
    const double bottom = std::ranges::max(request_.soundings, {}, &SoundingRequest::to).to;
    for (solver::MechanismParameter& parameter : mechanism.parameters) {
      if (parameter.prior != solver::Prior::depth) continue;
      const auto place = [&](double depth) {
        return std::clamp(depth / parameter.quantity.scale, parameter.quantity.min, parameter.quantity.max);
      };
      parameter.prior_lower = place(top);
      parameter.prior_upper = place(bottom);
    }
  }

  // The catalogue's ranges in kPa are class 2's.
  void look_as_class(solver::Mechanism& mechanism) const {
    if (request_.cone_class == 0) return;
    const double times = cone_accuracy(request_.cone_class).tip / cone_accuracy(2).tip;
    for (solver::MechanismParameter& parameter : mechanism.parameters) {
      if (parameter.prior != solver::Prior::accuracy || parameter.quantity.unit != "kPa") continue;
      parameter.prior_lower *= times;
      parameter.prior_upper *= times;
    }
  }

  // A positive number of a section, times its unit.
  void read_positive(const Value& table, std::string_view prefix, std::string_view key, double unit,
                     double& into) {
    const auto number = number_field(table, prefix, key, false, errors_);
    if (!number) return;
    if (*number > 0.0)
      into = *number * unit;
    else
      errors_.add(table.find(key)->value.place, joined(prefix, key),
                  fmt::format("{} must be above 0", *number));
  }

  void read_count(const Value& table, std::string_view prefix, std::string_view name, int& into) {
    const auto number = number_field(table, prefix, name, false, errors_);
    if (!number) return;
    const Key& key = key_named(request_keys(), prefix, name);
    if (*number == std::round(*number) && *number >= key.least && *number <= key.most)
      into = static_cast<int>(*number);
    else
      errors_.add(table.find(name)->value.place, joined(prefix, name),
                  fmt::format("{} must be a whole number from {} to {}", *number, key.least, key.most));
  }

  void read_noise() {
    const Value* table = section(root_, "noise", errors_);
    if (table == nullptr) return;
    refuse_unknown("noise", *table);
    read_positive(*table, "noise", "measurement_percent", 0.01, request_.measurement);
    read_positive(*table, "noise", "correlation_mm", 0.001, request_.correlation);
    read_count(*table, "noise", "cone_class", request_.cone_class);
    if (const Member* simulated = table->find("simulated")) {
      if (simulated->value.kind != Value::Kind::boolean)
        errors_.add(simulated->place, "noise.simulated", "must be true or false");
      request_.simulated = simulated->value.number != 0.0;
    }
  }

  void read_options() {
    const Value* table = section(root_, "options", errors_);
    if (table == nullptr) return;
    refuse_unknown("options", *table);
    read_positive(*table, "options", "cell_mm", 0.001, request_.cell_height);
    read_count(*table, "options", "repeats", request_.repeats);
    read_count(*table, "options", "joint", request_.joint);
    read_count(*table, "options", "confirm", request_.confirm);
    if (const auto seed = number_field(*table, "options", "seed", false, errors_)) {
      constexpr double most = 1e15;  // beyond it not every whole number is a double
      if (*seed == std::round(*seed) && *seed >= 0.0 && *seed <= most)
        request_.seed = static_cast<std::uint64_t>(*seed);
      else
        errors_.add(table->find("seed")->value.place, "options.seed",
                    fmt::format("{} must be a whole number from 0 to {}", *seed, most));
    }
  }

  // A push with its recording, or one that has none (yet).
  void read_sounding(const Value& table, std::string_view list, bool recorded,
                     std::vector<SoundingRequest>& into) {
    refuse_unknown(list, table, recorded ? Names{} : Names{"recording", "columns"});
    std::optional<SoundingRequest> sounding = diagnosis::read_sounding(
        table, list,
        {request_.file.parent_path(), known_ ? &study_ : nullptr, request_.cell_height, recorded}, errors_);
    std::vector<Change> changes;
    if (const Member* fixed = table.find("fixed")) {
      if (fixed->value.kind != Value::Kind::table)
        errors_.add(fixed->place, joined(list, "fixed"), "must be a table of quantities and values");
      else
        for (const Setting& setting : read_settings(fixed->value, joined(list, "fixed"), {}, study_.baseline,
                                                    {.any = !known_, .layers = !known_}, errors_))
          changes.push_back({setting.quantity, setting.value});
      if (known_) check_bounds(fixed->place, joined(list, "fixed"), changes);
    }
    if (!sounding) return;
    sounding->changes = std::move(changes);
    into.push_back(std::move(*sounding));
  }

  // What is known of the sounding must be possible at every bound of the study.
  void check_bounds(Place place, const std::string& key, const std::vector<Change>& changes) {
    Study known = study_;
    known.points.clear();
    for (const Change& change : changes) {
      change.quantity->set_value(known.baseline, change.value);
      std::erase_if(known.rows, [&](const Row& row) { return row.quantity == change.quantity; });
    }
    for (const Realization& realization : all_realizations(known))
      for (const solver::Problem& problem : solver::problems(make_setup(known, realization)))
        return errors_.add(
            place, key,
            fmt::format("is impossible with the study's {} ({}): {}", parameter_name(known, realization),
                        to_string(realization.side), problem.message));
  }

  static const Study& no_study() {
    static const std::unique_ptr<const Study> none = std::make_unique<const Study>();
    return *none;
  }

  const Value& root_;
  bool known_;
  const Study& study_;
  Recordings recordings_;
  ErrorList& errors_;
  Request request_;
};

}  // namespace

RequestOrErrors parse_request(std::string_view toml, const std::filesystem::path& file, const Study& study,
                              Recordings recordings) {
  ErrorList errors(file.string());
  const auto document = parse_document(toml);
  if (const auto* syntax = std::get_if<SyntaxError>(&document)) {
    errors.add(syntax->place, "", syntax->message, syntax->hint);
    return errors.sorted();
  }
  Request request = RequestReader(std::get<Value>(document), file, &study, recordings, errors).read();
  if (!errors.empty()) return errors.sorted();
  return request;
}

std::vector<StudyError> request_problems(std::string_view toml, const std::filesystem::path& file,
                                         Recordings recordings) {
  ErrorList errors(file.string());
  const auto document = parse_document(toml);
  if (const auto* syntax = std::get_if<SyntaxError>(&document))
    errors.add(syntax->place, "", syntax->message, syntax->hint);
  else
    (void)RequestReader(std::get<Value>(document), file, nullptr, recordings, errors).read();
  return errors.sorted();
}

std::filesystem::path study_of_request(std::string_view toml, const std::filesystem::path& file) {
  const auto document = parse_document(toml);
  const auto* root = std::get_if<Value>(&document);
  const Member* study = root != nullptr ? root->find("study") : nullptr;
  if (study == nullptr || study->value.kind != Value::Kind::text) return {};
  return (std::filesystem::absolute(file).parent_path() / study->value.text).lexically_normal();
}

}  // namespace cpt::diagnosis
