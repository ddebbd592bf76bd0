#include "parameters/read_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>

#include "parameters/check_study.hpp"
#include "parameters/designs/design.hpp"
#include "parameters/document.hpp"
#include "parameters/fields.hpp"
#include "parameters/nearest_name.hpp"
#include "parameters/read_correlation.hpp"
#include "parameters/read_design.hpp"
#include "parameters/read_layers.hpp"
#include "parameters/read_program.hpp"
#include "parameters/read_quantities.hpp"
#include "parameters/read_soils.hpp"
#include "parameters/study_keys.hpp"

namespace cpt::parameters {
namespace {

constexpr std::size_t most_thresholds = 20;

class StudyReader {
 public:
  StudyReader(const Value& root, std::filesystem::path file, FilesBeside files, ErrorList& errors)
      : root_(root), files_(files), errors_(errors) {
    study_.file = std::move(file);
    study_.name = study_.file.stem().string();
  }

  Study read() {
    refuse_unknown("", root_);
    study_.title = text_field(root_, "", "title", false, errors_).value_or(study_.name);
    if (root_.find("solver") != nullptr) return read_with_program();
    const bool profile_known = read_profile();
    read_output();
    read_limits();
    read_own_soils(profile_known);
    const OwnLayers own = read_layers(root_, study_.baseline, doubts_, errors_);
    const bool own_layers = !own.layers.empty() || (root_.find("layers") != nullptr && doubts_.depths);
    places_.layers = own.places;
    read_zones();
    if (own_layers) study_.baseline.layers = own.layers;
    doubts_.layers = doubts_.layers || (!profile_known && !own_layers);
    QuantitySections sections = read_quantities(root_, study_.baseline, doubts_, errors_);
    for (const Setting& setting : sections.settings)
      setting.quantity->set_value(study_.baseline, setting.value);
    for (const PlacedRow& placed : sections.rows) study_.rows.push_back(placed.row);
    if (own_layers) study_.baseline.layers = own.layers;  // setting the soil's height moves the last layer
    add_drawn_shift(root_, study_.baseline, study_.rows, errors_);
    check_height(own, profile_known, sections);

    read_points();
    read_design_points();
    read_repeats();
    read_paired_repeats();
    read_windows();
    if (profile_known) check_study(study_, sections, places_, doubts_, errors_);
    return std::move(study_);
  }

 private:
  // Of a study whose realizations another program runs.
  Study read_with_program() {
    refuse_embedded(root_, errors_);
    read_output();
    read_limits();
    read_program(root_, files_, study_, errors_);
    const QuantitySections sections = read_quantities(root_, study_.baseline, doubts_, errors_);
    for (const Setting& setting : sections.settings)
      setting.quantity->set_value(study_.baseline, setting.value);
    for (const PlacedRow& placed : sections.rows) study_.rows.push_back(placed.row);
    read_points();
    read_design_points();
    study_.windows = read_program_windows(root_, *study_.baseline.program, errors_);
    check_study(study_, sections, places_, doubts_, errors_);
    return std::move(study_);
  }

  bool refuse_unknown(std::string_view name, const Value& table) {
    return refuse_unknown_keys(table, name, known_names(study_keys(), name), errors_);
  }

  std::optional<std::string> choice(const Value& table, std::string_view name, std::string_view key,
                                    bool required) {
    return name_field(table, name, key, required, key_named(study_keys(), name, key).choices, errors_);
  }

  // The setup to start from; false if the file does not say which.
  bool read_profile() {
    const auto profile = choice(root_, "", "profile", true);
    const auto preset = choice(root_, "", "preset", false);
    study_.profile =
        solver::profile_from_string(profile.value_or("")).value_or(solver::Profile::homogeneous_sand);
    study_.preset = solver::preset_from_string(preset.value_or("")).value_or(solver::Preset::standard);
    study_.baseline = solver::make_setup(study_.profile, study_.preset);
    if (const Member* member = root_.find("profile")) places_.profile = member->place;
    return profile.has_value() && (preset.has_value() || root_.find("preset") == nullptr);
  }

  void read_output() {
    study_.database = beside(study_.name + ".sqlite");
    study_.curves = beside(study_.name + ".h5");
    study_.report_dir = beside(study_.name + "-report");
    const Value* table = section(root_, "output", errors_);
    if (table == nullptr) return;
    refuse_unknown("output", *table);
    const auto read = [&](std::string_view key, std::filesystem::path& path) {
      if (const auto text = text_field(*table, "output", key, false, errors_)) path = beside(*text);
    };
    read("database", study_.database);
    read("curves", study_.curves);
    read("report", study_.report_dir);
    const std::array<std::filesystem::path, 4> paths = {study_.file, study_.database, study_.curves,
                                                        study_.report_dir};
    for (std::size_t i = 0; i < paths.size(); ++i)
      for (std::size_t j = i + 1; j < paths.size(); ++j)
        if (paths[i] == paths[j])
          errors_.add(
              table->place, "output",
              fmt::format("{} would hold two things: the study, its database, its curves and its report each "
                          "need a path of their own",
                          paths[i].string()));
  }

  [[nodiscard]] std::filesystem::path beside(const std::filesystem::path& path) const {
    return (study_.file.parent_path() / path).lexically_normal();
  }

  void read_limits() {
    study_.wall_limit_seconds = std::numeric_limits<double>::infinity();
    const Value* table = section(root_, "limits", errors_);
    if (table == nullptr) return;
    refuse_unknown("limits", *table);
    if (root_.find("solver") == nullptr) refuse_program_limits(*table, errors_);
    const auto minutes = number_field(*table, "limits", "wall_minutes", false, errors_);
    if (!minutes) return;
    if (*minutes <= 0.0)
      errors_.add(table->find("wall_minutes")->value.place, "limits.wall_minutes",
                  fmt::format("{} must be above 0", *minutes));
    study_.wall_limit_seconds = *minutes * 60.0;
  }

  // Those of the section, or the defaults. The layers of the profile then have its soils by name.
  void read_own_soils(bool profile_known) {
    const std::vector<solver::Soil> defaults = study_.baseline.soils;
    read_soils(root_, study_.baseline, doubts_, errors_);
    const Member* soils = root_.find("soils");
    if (soils == nullptr) return;
    places_.soils = soils->place;
    const bool own_layers = root_.find("layers") != nullptr || errors_.is_meant(root_, "layers");
    std::vector<solver::Layer> layers;
    std::set<std::string> missing;
    for (const solver::Layer& layer : study_.baseline.layers) {
      const std::string& name = defaults[layer.soil].name;
      const std::optional<std::size_t> place = soil_named(name);
      const bool known = place && !doubts_.named.contains(name);
      if (known) layers.push_back({layer.top, layer.bottom, *place});
      if (!known && !own_layers) doubts_.layers = doubts_.depths = true;
      if (!place) missing.insert(name);
    }
    if (!missing.empty() && !own_layers && !doubts_.any && profile_known)
      errors_.add(places_.soils, "soils",
                  fmt::format("names no soil \"{}\", which layers of the profile have",
                              fmt::join(missing, "\" and no soil \"")),
                  "give [[layers]] of your own soils");
    study_.baseline.layers = layers;
  }

  [[nodiscard]] std::optional<std::size_t> soil_named(std::string_view name) const {
    const auto& soils = study_.baseline.soils;
    const auto found = std::ranges::find(soils, name, &solver::Soil::name);
    return found == soils.end() ? std::nullopt
                                : std::optional(static_cast<std::size_t>(found - soils.begin()));
  }

  // Layers that do not end at the soil's height leave it in doubt which of the two is meant.
  void check_height(const OwnLayers& own, bool profile_known, QuantitySections& sections) {
    const solver::Quantity& height = *solver::find_quantity("chamber.soil_height_m");
    if (!profile_known || sections.doubtful.contains(height.name)) return;
    if (check_end(own, height.value(study_.baseline), errors_)) return;
    doubts_.depths = true;
    sections.doubtful.insert(height.name);
  }

  void read_zones() {
    std::vector<solver::PointZone> zones;
    bool sound = true;
    for (const Value* table : sections(root_, "zones", errors_)) {
      if (places_.zones.line == 0) places_.zones = table->place;
      refuse_unknown("zones", *table);
      const auto radius = number_field(*table, "zones", "outer_radius_m", true, errors_);
      const auto columns = number_field(*table, "zones", "columns", true, errors_);
      const auto rows = number_field(*table, "zones", "rows_per_m", true, errors_);
      sound = sound && radius && columns && rows;
      constexpr double most = 1.0e6;  // that fit the type; the solver's limit is lower
      if (columns && (*columns != std::round(*columns) || std::abs(*columns) > most)) {
        errors_.add(table->find("columns")->value.place, "zones.columns",
                    fmt::format("{} must be a whole number of at most {}", *columns, most));
        sound = false;
      }
      if (sound) zones.push_back({*radius, static_cast<int>(*columns), *rows});
    }
    if (sound && !zones.empty()) study_.baseline.numerics.zones = zones;
  }

  void read_points() {
    const std::vector<std::string_view> own = known_names(study_keys(), "points");
    std::vector<std::string> names;
    for (const Value* table : sections(root_, "points", errors_)) {
      const auto name = text_field(*table, "points", "name", true, errors_);
      if (name && (name->empty() || std::find(names.begin(), names.end(), *name) != names.end()))
        errors_.add(table->find("name")->value.place, "points.name",
                    name->empty() ? "is empty" : fmt::format("\"{}\" names another point already", *name));
      names.push_back(name.value_or(""));
      DesignPoint point{name.value_or(""), {}};
      for (const Setting& setting : read_settings(*table, "points", own, study_.baseline, doubts_, errors_))
        point.changes.push_back({setting.quantity, setting.value});
      if (table->members.size() <= (name ? 1U : 0U))
        errors_.add(table->place, "points", "changes nothing", "give at least one quantity a value");
      study_.points.push_back(std::move(point));
      places_.points.push_back(table->place);
    }
  }

  void read_design_points() {
    study_.design = read_design(root_, study_.rows, study_.baseline, errors_);
    study_.correlations = read_correlations(root_, study_.rows, study_.design, errors_);
    study_.design.first_point = study_.points.size();
    const std::vector<DesignPoint> made = design_points(study_);
    study_.design.points = made.size();
    const Place place = made.empty() ? Place{} : root_.find("design")->place;
    for (const DesignPoint& point : made) {
      for (std::size_t i = 0; i < study_.design.first_point; ++i)
        if (study_.points[i].name == point.name)
          errors_.add(places_.points[i], "points.name",
                      fmt::format("\"{}\" names a run of the design", point.name),
                      "name the point otherwise");
      study_.points.push_back(point);
      places_.points.push_back(place);
    }
  }

  // The baseline with its material points shifted evenly to either side; the baseline itself is the middle
  // one.
  void read_repeats() {
    const Member* member = root_.find("repeats");
    const auto number = number_field(root_, "", "repeats", false, errors_);
    if (!number) return;
    constexpr double farthest = 0.4;  // [cells' share of a point]
    const Key& key = key_named(study_keys(), "", "repeats");
    if (*number < key.least || *number > key.most || std::fmod(*number, 2.0) != 0.0)
      return errors_.add(member->value.place, "repeats",
                         fmt::format("{} must be an even number from {} to {}", *number, key.least, key.most),
                         "half of them shift the material points one way, half the other");
    const solver::Quantity* shift = solver::find_quantity("numerics.point_shift");
    const int runs = static_cast<int>(*number);
    for (int k = 0, name = 0; k <= runs; ++k) {
      if (2 * k == runs) continue;
      // A grid shifted by a whole spacing is the same grid.
      const double value =
          std::remainder(shift->value(study_.baseline) + farthest * (2.0 * k / runs - 1.0), 1.0);
      DesignPoint point{fmt::format("repeat {}", ++name), {{shift, value}}, true};
      for (const DesignPoint& other : study_.points)
        if (other.name == point.name)
          errors_.add(member->place, "repeats",
                      fmt::format("\"{}\" names a point of the study already", point.name));
      study_.points.push_back(std::move(point));
      places_.points.push_back(member->place);
    }
  }

  // Each bound of the named rows again with the shifts of the repeats: the same points at baseline and
  // bounds.
  void read_paired_repeats() {
    const Member* member = root_.find("paired_repeats");
    if (member == nullptr) return;
    const std::vector<DesignPoint> all = study_.points;
    if (std::ranges::none_of(all, &DesignPoint::repeat))
      errors_.add(member->place, "paired_repeats", "wants repeats of the baseline to be paired with",
                  "add repeats = 6");
    if (member->value.kind != Value::Kind::array)
      return errors_.add(member->value.place, "paired_repeats",
                         fmt::format("must be an array of names, not {}", to_string(member->value.kind)),
                         "such as paired_repeats = [\"sand.H\"]");
    std::set<std::string> named;
    for (const Value& item : member->value.items)
      if (const Row* row = paired_row(item, named))
        for (const DesignPoint& repeat : all)
          if (repeat.repeat) {
            if (row->lower != row->baseline) add_pair(repeat, *row, "lower", row->lower, member->place);
            if (row->upper != row->baseline) add_pair(repeat, *row, "upper", row->upper, member->place);
          }
  }

  const Row* paired_row(const Value& item, std::set<std::string>& named) {
    const auto row = std::ranges::find_if(study_.rows, [&](const Row& r) {
      return item.kind == Value::Kind::text && r.quantity->name == item.text;
    });
    std::vector<std::string_view> names;
    for (const Row& r : study_.rows) names.push_back(r.quantity->name);
    const std::string_view near =
        item.kind == Value::Kind::text ? nearest_name(item.text, names) : std::string_view();
    if (row == study_.rows.end() && is_row_given(root_, item.text)) return nullptr;  // with an error
    if (row == study_.rows.end())
      errors_.add(item.place, "paired_repeats",
                  item.kind == Value::Kind::text
                      ? fmt::format("\"{}\" is no row of [parameters]", item.text)
                      : fmt::format("must hold names, not {}", to_string(item.kind)),
                  near.empty() ? "" : fmt::format("did you mean \"{}\"?", near));
    else if (!named.insert(item.text).second)
      errors_.add(item.place, "paired_repeats", fmt::format("\"{}\" is named twice", item.text));
    else if (row->quantity->name == "numerics.point_shift")
      errors_.add(item.place, "paired_repeats", "the shift of the points is what repeats change");
    else
      return &*row;
    return nullptr;
  }

  void add_pair(const DesignPoint& repeat, const Row& row, std::string_view side, double value,
                const Place& place) {
    DesignPoint point{fmt::format("{}, {} {}", repeat.name, row.quantity->name, side), repeat.changes};
    point.changes.push_back({row.quantity, value});
    study_.points.push_back(std::move(point));
    places_.points.push_back(place);
  }

  void read_windows() {
    const Member* windows = root_.find("windows");
    if ((windows == nullptr && !errors_.is_meant(root_, "windows")) ||
        (windows != nullptr && windows->value.kind == Value::Kind::array && windows->value.items.empty()))
      errors_.add(windows ? windows->place : Place{}, "windows",
                  "is missing: a study needs at least one depth window to average q_c over",
                  "add [[windows]] with name, from_m and to_m");
    for (const Value* table : sections(root_, "windows", errors_)) read_window(*table);
  }

  void read_window(const Value& table) {
    Window window;
    bool sound = refuse_unknown("windows", table);
    if (const auto name = text_field(table, "windows", "name", true, errors_)) {
      window.name = *name;
      sound = acceptable_name(*name, table.find("name")->value.place) && sound;
    } else {
      sound = false;
    }
    sound = (table.find("centre") ? read_centred(table, window) : read_interval(table, window)) && sound;
    sound = read_thresholds(table, window) && sound;
    if (!sound) return;
    study_.windows.push_back(window);
    places_.windows.push_back(table.place);
  }

  bool acceptable_name(const std::string& name, Place place) {
    const bool plain = std::all_of(name.begin(), name.end(), [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
             c == '-';
    });
    if (!plain)
      errors_.add(place, "windows.name", fmt::format("\"{}\" may hold only letters, digits, _ and -", name));
    const bool unused = std::find(window_names_.begin(), window_names_.end(), name) == window_names_.end();
    if (!unused) errors_.add(place, "windows.name", fmt::format("\"{}\" names another window already", name));
    window_names_.push_back(name);
    return plain && unused;
  }

  bool read_interval(const Value& table, Window& window) {
    bool sound = refuse_fields(table, {"between_m", "width_m"}, "belongs to a window with a centre");
    const auto from = number_field(table, "windows", "from_m", true, errors_);
    const auto to = number_field(table, "windows", "to_m", true, errors_);
    if (!from || !to) return false;
    window.from = *from;
    window.to = *to;
    return ordered(*from, *to, table.find("to_m")->value.place, "windows.to_m") && sound;
  }

  bool read_centred(const Value& table, Window& window) {
    bool sound = refuse_fields(table, {"from_m", "to_m"}, "belongs to a window without a centre");
    const auto centre = choice(table, "windows", "centre", true);
    const auto width = number_field(table, "windows", "width_m", true, errors_);
    if (width && *width <= 0.0) {
      errors_.add(table.find("width_m")->value.place, "windows.width_m",
                  fmt::format("{} must be above 0", *width));
      sound = false;
    }
    sound = read_between(table, window) && sound;
    if (!centre || !width) return false;
    window.kind = *centre == "baseline_peak" ? Window::Kind::peak : Window::Kind::trough;
    window.width = *width;
    return sound;
  }

  bool read_between(const Value& table, Window& window) {
    const Member* between = table.find("between_m");
    if (between == nullptr && errors_.is_meant(table, "between_m")) return false;
    if (between == nullptr || between->value.kind != Value::Kind::array || between->value.items.size() != 2) {
      errors_.add(between ? between->value.place : table.place, "windows.between_m",
                  between ? "must be two depths, [from, to]" : "is missing",
                  "such as between_m = [0.285, 0.325]");
      return false;
    }
    const auto from = finite_number(between->value.items[0], "windows.between_m", errors_);
    const auto to = finite_number(between->value.items[1], "windows.between_m", errors_);
    if (!from || !to) return false;
    window.from = *from;
    window.to = *to;
    return ordered(*from, *to, between->value.place, "windows.between_m");
  }

  bool read_thresholds(const Value& table, Window& window) {
    const Member* member = table.find("thresholds_kPa");
    if (member == nullptr) return true;
    const std::string key = "windows.thresholds_kPa";
    const Value& list = member->value;
    if (list.kind != Value::Kind::array || list.items.empty() || list.items.size() > most_thresholds) {
      errors_.add(list.place, key, fmt::format("must be an array of 1 to {} numbers", most_thresholds),
                  "such as thresholds_kPa = [2000, 3000]");
      return false;
    }
    for (const Value& item : list.items) {
      const auto value = finite_number(item, key, errors_);
      if (!value) return false;
      if (!window.thresholds.empty() && *value * 1e3 <= window.thresholds.back()) {
        errors_.add(item.place, key, fmt::format("{} is not above the one before it", *value));
        return false;
      }
      window.thresholds.push_back(*value * 1e3);
    }
    return true;
  }

  bool refuse_fields(const Value& table, std::initializer_list<std::string_view> keys,
                     const std::string& why) {
    bool none = true;
    for (const std::string_view key : keys) {
      const Member* member = table.find(key);
      if (member == nullptr) continue;
      errors_.add(member->place, joined("windows", key), why);
      none = false;
    }
    return none;
  }

  bool ordered(double from, double to, Place place, const std::string& key) {
    if (from < to) return true;
    errors_.add(place, key,
                fmt::format("the window would go from {} m to {} m: depths grow downward", from, to));
    return false;
  }

  const Value& root_;
  FilesBeside files_;
  ErrorList& errors_;
  Study study_ = Study();
  StudyPlaces places_;
  SoilDoubts doubts_;
  std::vector<std::string> window_names_;
};

}  // namespace

StudyOrErrors parse_study(std::string_view toml, const std::filesystem::path& file, FilesBeside files) {
  ErrorList errors(file.string());
  const auto document = parse_document(toml);
  if (const auto* syntax = std::get_if<SyntaxError>(&document)) {
    errors.add(syntax->place, "", syntax->message, syntax->hint);
    return errors.sorted();
  }
  const auto absolute = std::filesystem::absolute(file).lexically_normal();
  Study study = StudyReader(std::get<Value>(document), absolute, files, errors).read();
  if (!errors.empty()) return errors.sorted();
  return study;
}

StudyOrErrors read_study(const std::filesystem::path& file) {
  ErrorList errors(file.string());
  std::error_code code;
  if (!std::filesystem::is_regular_file(file, code)) {
    errors.add({}, "", std::filesystem::exists(file, code) ? "is not a file" : "there is no such file");
    return errors.sorted();
  }
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream) {
    errors.add({}, "", "cannot be read");
    return errors.sorted();
  }
  return parse_study(text.str(), file);
}

}  // namespace cpt::parameters
