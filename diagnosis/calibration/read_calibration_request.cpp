#include "diagnosis/calibration/read_calibration_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "diagnosis/calibration/calibration_keys.hpp"
#include "diagnosis/read_sounding.hpp"
#include "parameters/fields.hpp"

namespace cpt::diagnosis {
namespace {

using namespace parameters;

std::vector<const solver::Channel*> measured_channels() {
  std::vector<const solver::Channel*> measured;
  for (const solver::Channel& channel : solver::channels())
    if (std::isfinite(channel.deviation_over_q_c)) measured.push_back(&channel);
  return measured;
}

class CalibrationReader {
 public:
  CalibrationReader(const Value& root, const std::filesystem::path& file, const Study* study,
                    ErrorList& errors)
      : root_(root), study_(study), errors_(errors) {
    request_.file = std::filesystem::absolute(file).lexically_normal();
    request_.name = request_.file.stem().string();
    request_.folder = request_.file.parent_path() / (request_.name + "-calibration");
    if (study == nullptr) return;
    request_.study = study->file;
    constexpr double diameters = 5.0;
    request_.discrepancy_length = diameters * study->baseline.penetrometer.diameter;
  }

  CalibrationRequest read() {
    refuse_unknown_keys(root_, "", known_names(calibration_keys(), ""), errors_);
    request_.title = text_field(root_, "", "title", false, errors_).value_or(request_.name);
    (void)text_field(root_, "", "study", true, errors_);
    read_channels();
    read_noise();
    read_discrepancy();
    read_options();
    for (const Value* table : sections(root_, "soundings", errors_)) read_push(*table);
    if (request_.soundings.empty() && errors_.empty())
      errors_.add({}, "soundings", "is missing: a calibration needs at least one recording",
                  "add [[soundings]] with recording, from_m and to_m");
    check_names();
    return request_;
  }

 private:
  void check_names() {
    for (std::size_t i = 0; i < request_.soundings.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (request_.soundings[i].name == request_.soundings[k].name)
          return errors_.add({}, "soundings.name",
                             fmt::format("\"{}\" is given twice", request_.soundings[i].name),
                             "give each sounding a name of its own");
  }

  void read_push(const Value& table) {
    std::vector<std::string_view> known = known_names(calibration_keys(), "soundings");
    if (const Member* fixed = table.find("fixed")) {
      errors_.add(fixed->place, "soundings.fixed",
                  "has no place in a calibration: its emulator knows the study's soil and stress alone",
                  "make a study of its own for this sounding, with the known values under [fixed]");
      known.emplace_back("fixed");
    }
    refuse_unknown_keys(table, "soundings", known, errors_);
    if (auto sounding = diagnosis::read_sounding(
            table, "soundings", {request_.file.parent_path(), study_, request_.cell_height}, errors_))
      if (few_enough(*sounding, table)) request_.soundings.push_back(std::move(*sounding));
  }

  bool few_enough(const SoundingRequest& sounding, const Value& table) {
    constexpr double most_cells = 2000.0;  // a likelihood takes the cube of their number
    const double cells = (sounding.to - sounding.from) / request_.cell_height;
    if (cells <= most_cells) return true;
    errors_.add(table.place, "options.cell_mm",
                fmt::format("{:g} makes {:.3g} cells of \"{}\", at most {:g} are possible",
                            1000.0 * request_.cell_height, cells, sounding.name, most_cells),
                fmt::format("take {:.2g} or more", 1000.0 * (sounding.to - sounding.from) / most_cells));
    return false;
  }

  void read_channels() {
    const std::vector<const solver::Channel*> measured = measured_channels();
    const Member* member = root_.find("channels");
    if (member == nullptr) {
      request_.channels = measured;
      return;
    }
    std::vector<std::string_view> names;
    for (const solver::Channel* channel : measured) names.push_back(channel->name);
    const std::string hint = fmt::format("some of {}, as channels = [\"q_c\"]", listed(names));
    if (member->value.kind != Value::Kind::array || member->value.items.empty())
      return errors_.add(member->place, "channels", "must be a list of names", hint);
    for (const Value& item : member->value.items)
      if (item.kind != Value::Kind::text || std::ranges::count(names, item.text) == 0)
        errors_.add(item.place, "channels",
                    item.kind == Value::Kind::text
                        ? fmt::format("\"{}\" is not measured by a sounding", item.text)
                        : std::string("must be a list of names"),
                    hint);
    request_.channels_are_given = true;
    for (const solver::Channel* channel : measured)
      for (const Value& item : member->value.items)
        if (item.text == channel->name && std::ranges::count(request_.channels, channel) == 0)
          request_.channels.push_back(channel);
  }

  // Above 0 and at most what the key says, times its unit; true if it is given.
  bool read_above_0(const Value& table, std::string_view prefix, std::string_view name, double unit,
                    double& into) {
    const auto number = number_field(table, prefix, name, false, errors_);
    if (!number) return false;
    const double most = key_named(calibration_keys(), prefix, name).most;
    if (*number > 0.0 && *number <= most) {
      into = *number * unit;
      return true;
    }
    errors_.add(table.find(name)->value.place, joined(prefix, name),
                std::isfinite(most) ? fmt::format("{} must be above 0 and at most {}", *number, most)
                                    : fmt::format("{} must be above 0", *number));
    return false;
  }

  std::optional<double> whole_number(const Value& table, std::string_view name) {
    const auto number = number_field(table, "options", name, false, errors_);
    if (!number) return std::nullopt;
    const Key& key = key_named(calibration_keys(), "options", name);
    if (*number == std::round(*number) && *number >= key.least && *number <= key.most) return number;
    errors_.add(table.find(name)->value.place, joined("options", name),
                fmt::format("{} must be a whole number from {} to {}", *number, key.least, key.most));
    return std::nullopt;
  }

  const Value* known_section(std::string_view name) {
    const Value* table = section(root_, name, errors_);
    if (table != nullptr) refuse_unknown_keys(*table, name, known_names(calibration_keys(), name), errors_);
    return table;
  }

  void read_noise() {
    if (const Value* table = known_section("noise"))
      request_.noise_is_known = read_above_0(*table, "noise", "measurement_percent", 0.01, request_.noise);
  }

  void read_discrepancy() {
    const Value* table = known_section("discrepancy");
    if (table == nullptr) return;
    read_above_0(*table, "discrepancy", "deviation_percent", 0.01, request_.discrepancy);
    read_above_0(*table, "discrepancy", "correlation_mm", 0.001, request_.discrepancy_length);
  }

  void read_options() {
    const Value* table = known_section("options");
    if (table == nullptr) return;
    read_above_0(*table, "options", "cell_mm", 0.001, request_.cell_height);
    if (const auto chains = whole_number(*table, "chains")) request_.chains = static_cast<int>(*chains);
    if (const auto seed = whole_number(*table, "seed")) request_.seed = static_cast<std::uint64_t>(*seed);
  }

  const Value& root_;
  const Study* study_;
  ErrorList& errors_;
  CalibrationRequest request_;
};

}  // namespace

CalibrationRequestOrErrors parse_calibration_request(std::string_view toml, const std::filesystem::path& file,
                                                     const Study& study) {
  ErrorList errors(file.string());
  const auto document = parse_document(toml);
  if (const auto* syntax = std::get_if<SyntaxError>(&document)) {
    errors.add(syntax->place, "", syntax->message, syntax->hint);
    return errors.sorted();
  }
  CalibrationRequest request = CalibrationReader(std::get<Value>(document), file, &study, errors).read();
  if (!errors.empty()) return errors.sorted();
  return request;
}

std::vector<StudyError> calibration_request_problems(std::string_view toml,
                                                     const std::filesystem::path& file) {
  ErrorList errors(file.string());
  const auto document = parse_document(toml);
  if (const auto* syntax = std::get_if<SyntaxError>(&document))
    errors.add(syntax->place, "", syntax->message, syntax->hint);
  else
    (void)CalibrationReader(std::get<Value>(document), file, nullptr, errors).read();
  return errors.sorted();
}

}  // namespace cpt::diagnosis
