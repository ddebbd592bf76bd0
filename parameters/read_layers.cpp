#include "parameters/read_layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "parameters/nearest_name.hpp"
#include "parameters/study_keys.hpp"
#include "solver/quantities.hpp"

namespace cpt::parameters {
namespace {

constexpr double touching = 1.0e-9;  // [m] interfaces closer than this are the same
constexpr double no_depth = std::numeric_limits<double>::quiet_NaN();

// A table [[layers]] as far as it can be read.
struct Given {
  const Value* table;
  std::optional<double> top, bottom;  // [m]
  std::optional<std::size_t> soil;    // of which it is, and the law of which is known

  [[nodiscard]] Place place_of(std::string_view key) const { return table->find(key)->value.place; }
};

class LayersReader {
 public:
  LayersReader(const Value& root, const solver::Setup& setup, SoilDoubts& doubts, ErrorList& errors)
      : root_(root), setup_(setup), doubts_(doubts), errors_(errors) {
    for (const solver::Soil& soil : setup.soils) names_.push_back(soil.name);
  }

  OwnLayers read() {
    read_tables();
    const std::vector<Gap> gaps = check_depths();
    const std::vector<const Member*> unused = unused_soils();
    // A layer that was forgotten leaves a gap and a soil that no layer has.
    const bool forgotten = gaps.size() == 1 && gaps.front().is_open && unused.size() == 1;
    for (const Gap& gap : gaps) tell(gap, forgotten ? unused.front() : nullptr);
    for (const Member* soil : unused) {
      doubts_.unused.insert(soil->key);
      if (!forgotten)
        errors_.add(soil->place, joined("soils", soil->key), "no layer consists of it",
                    "name it in [[layers]], or leave it out");
    }
    return result();
  }

 private:
  // Where a layer does not start at the bottom of the one above it.
  struct Gap {
    std::size_t layer;
    double reached;  // [m]
    bool is_open;    // not an overlap
  };

  void read_tables() {
    const Member* member = root_.find("layers");
    const bool elsewhere = errors_.is_meant(root_, "layers");
    const std::vector<const Value*> tables = sections(root_, "layers", errors_);
    const bool all_read = member == nullptr || (member->value.kind == Value::Kind::array &&
                                                tables.size() == member->value.items.size());
    complete_ = all_read && !elsewhere;
    if (!complete_) doubts_.layers = doubts_.depths = true;
    for (const Value* table : tables) {
      refuse_unknown_keys(*table, "layers", known_names(study_keys(), "layers"), errors_);
      Given layer{table, number_field(*table, "layers", "top_m", true, errors_),
                  number_field(*table, "layers", "bottom_m", true, errors_), soil_of(*table)};
      if (!layer.soil) doubts_.layers = true;
      if (!layer.top || !layer.bottom || !layer.soil) doubts_.depths = true;
      given_.push_back(layer);
    }
  }

  std::optional<std::size_t> soil_of(const Value& table) {
    const Member* member = table.find("soil");
    const bool is_text =
        member != nullptr && member->value.kind == Value::Kind::text && !member->value.text.empty();
    if (!is_text) {
      all_soils_known_ = false;
      if (!doubts_.any) return of_name(name_field(table, "layers", "soil", true, names_, errors_));
      return of_name(text_field(table, "layers", "soil", true, errors_));
    }
    const std::string& name = member->value.text;
    if (const auto soil = of_name(name)) {
      used_.insert(name);
      return doubts_.named.contains(name) ? std::nullopt : soil;
    }
    const std::string_view near = nearest_name(name, names_);
    if (near.empty() || doubts_.any)
      all_soils_known_ = false;
    else
      used_.emplace(near);
    if (doubts_.any || !doubts_.named.insert(name).second) return std::nullopt;
    errors_.add(member->value.place, "layers.soil",
                fmt::format("\"{}\" is not one of {}", name, listed(names_)),
                !near.empty() ? fmt::format("did you mean \"{}\"?", near)
                : root_.find("soils") != nullptr
                    ? fmt::format("add [soils.{}] with its law", name)
                    : fmt::format("add [soils.{}] with its law, and so for each soil that you use", name));
    return std::nullopt;
  }

  [[nodiscard]] std::optional<std::size_t> of_name(const std::optional<std::string>& name) const {
    const auto found = name ? std::ranges::find(names_, *name) : names_.end();
    return found == names_.end() ? std::nullopt
                                 : std::optional(static_cast<std::size_t>(found - names_.begin()));
  }

  // Tells layers without thickness. What follows from an error is not told.
  std::vector<Gap> check_depths() {
    std::vector<Gap> gaps;
    double reached = 0.0;  // [m]
    for (std::size_t k = 0; k < given_.size(); ++k) {
      const auto& [table, top, bottom, soil] = given_[k];
      const bool touches = !complete_ || !top || std::isnan(reached) || std::abs(*top - reached) <= touching;
      if (!touches) gaps.push_back({k, reached, *top > reached});
      reached = bottom.value_or(no_depth);
      if (!touches || !top || !bottom || *bottom > *top + touching) continue;
      doubts_.depths = true;
      reached = no_depth;
      errors_.add(given_[k].place_of("bottom_m"), "layers.bottom_m",
                  fmt::format("the layer from {} m to {} m has no thickness", *top, *bottom),
                  "depths grow downward: bottom_m must exceed top_m");
    }
    if (!gaps.empty()) doubts_.depths = true;
    return gaps;
  }

  void tell(const Gap& gap, const Member* unused) {
    const Given& layer = given_[gap.layer];
    const std::string above = gap.layer == 0
                                  ? "the soil's top is at 0 m"
                                  : fmt::format("the one above it ends at {} m (line {})", gap.reached,
                                                given_[gap.layer - 1].place_of("bottom_m").line);
    errors_.add(layer.place_of("top_m"), "layers.top_m",
                fmt::format("the layer starts at {} m, but {}: layers touch without gaps or overlaps",
                            *layer.top, above),
                unused == nullptr
                    ? ""
                    : fmt::format("a layer of {0} from {1} to {2} m closes the gap; without one, leave out "
                                  "[soils.{0}] in line {3}, since no layer consists of it",
                                  unused->key, gap.reached, *layer.top, unused->place.line));
  }

  // A soil that no layer has would be a slip of the pen.
  [[nodiscard]] std::vector<const Member*> unused_soils() {
    std::vector<const Member*> unused;
    const Member* soils = root_.find("soils");
    if (soils == nullptr || soils->value.kind != Value::Kind::table || !complete_ || !all_soils_known_)
      return unused;
    if (given_.empty()) {
      if (doubts_.layers) return unused;
      for (const solver::Layer& layer : setup_.layers) used_.insert(setup_.soils[layer.soil].name);
    }
    for (const Member& soil : soils->value.members)
      if (of_name(soil.key) && !used_.contains(soil.key)) unused.push_back(&soil);
    return unused;
  }

  [[nodiscard]] OwnLayers result() const {
    OwnLayers own;
    for (const Given& layer : given_) {
      if (!layer.soil) continue;
      own.layers.push_back({layer.top.value_or(no_depth), layer.bottom.value_or(no_depth), *layer.soil});
      own.places.push_back(layer.table->place);
    }
    if (!complete_ || given_.empty() || !given_.back().bottom) return own;
    const Given& last = given_.back();
    if (last.top && !(*last.bottom > *last.top + touching)) return own;
    own.bottom = last.bottom;
    own.bottom_place = last.place_of("bottom_m");
    return own;
  }

  const Value& root_;
  const solver::Setup& setup_;
  SoilDoubts& doubts_;
  ErrorList& errors_;
  std::vector<std::string_view> names_;
  std::vector<Given> given_;
  bool complete_ = true;         // all tables are there to be read
  bool all_soils_known_ = true;  // by their names
  std::set<std::string> used_;
};

}  // namespace

OwnLayers read_layers(const Value& root, const solver::Setup& setup, SoilDoubts& doubts, ErrorList& errors) {
  return LayersReader(root, setup, doubts, errors).read();
}

bool check_end(const OwnLayers& layers, double soil_height, ErrorList& errors) {
  if (!layers.bottom || std::abs(*layers.bottom - soil_height) <= touching) return true;
  const solver::Quantity& height = *solver::find_quantity("chamber.soil_height_m");
  const bool possible = *layers.bottom >= height.min && *layers.bottom <= height.max;
  errors.add(layers.bottom_place, "layers.bottom_m",
             fmt::format("the layers end at {} m, but {} = {}", *layers.bottom, height.name, soil_height),
             possible ? fmt::format("end them at {} m, or give {} = {} under [fixed]", soil_height,
                                    height.name, *layers.bottom)
                      : fmt::format("end them at {} m; {} may be {} to {} m", soil_height, height.name,
                                    height.min, height.max));
  return false;
}

}  // namespace cpt::parameters
