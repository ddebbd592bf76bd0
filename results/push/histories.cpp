#include "results/push/histories.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "results/files/hdf5_file.hpp"

namespace cpt::results {
namespace {

constexpr const char* origin_names[] = {"study",    "title",           "realization",    "parameter",
                                        "side",     "value_text",      "status",         "setup",
                                        "recorded", "program_version", "solver_version", "settings_hash"};

double required(const Hdf5Group& group, const char* name) {
  if (const auto value = group.number(name)) return *value;
  throw Error(fmt::format("the attribute {} is missing", name));
}

/// A count or a number of something.
int whole(const Hdf5Group& group, const char* name) {
  const double value = required(group, name);
  if (!(value >= 0.0 && value <= std::numeric_limits<int>::max() && value == std::floor(value)))
    throw Error(fmt::format("{} is not a whole number", name));
  return static_cast<int>(value);
}

void put_columns(const Hdf5Group& group, const HistoryColumns& columns) {
  for (const auto& [name, column] : columns) group.put_array(name, column.values, column.unit);
}

HistoryColumns columns_of(const Hdf5Group& group) {
  HistoryColumns columns;
  for (const std::string& name : group.names()) columns[name] = {group.unit(name), group.array(name)};
  return columns;
}

void put(const Hdf5Group& group, const PointHistory& point) {
  group.put_number("wanted_r_m", point.wanted.r);
  group.put_number("wanted_depth_m", point.wanted.depth);
  group.put_number("start_r_m", point.start.r);
  group.put_number("start_depth_m", point.start.depth);
  group.put_number("id", static_cast<double>(point.id));
  group.put_text("material", point.material);
  put_columns(group, point.columns);
}

PointHistory point_of(const Hdf5Group& group) {
  return {{required(group, "wanted_r_m"), required(group, "wanted_depth_m")},
          {required(group, "start_r_m"), required(group, "start_depth_m")},
          whole(group, "id"),
          group.text("material"),
          columns_of(group)};
}

void put(const Hdf5Group& group, const WallHistory& wall) {
  group.put_number("from_m", wall.between.from);
  group.put_number("to_m", wall.between.to);
  group.put_number("points", wall.points);
  put_columns(group, wall.columns);
}

WallHistory wall_of(const Hdf5Group& group) {
  return {{required(group, "from_m"), required(group, "to_m")}, whole(group, "points"), columns_of(group)};
}

void put(const Hdf5Group& group, const SoilAtEnd& soil) {
  group.put_array("r", soil.r, "m");
  group.put_array("depth", soil.depth, "m");
  group.put_array("volume", soil.volume, "m3");
  group.put_array("void_ratio", soil.void_ratio, "-");
  group.put_array("void_ratio_start", soil.void_ratio_start, "-");
}

SoilAtEnd soil_of(const Hdf5Group& group) {
  return {group.array("r"), group.array("depth"), group.array("volume"), group.array("void_ratio"),
          group.array("void_ratio_start")};
}

// Groups 0001, 0002, ... in the order of the list.
template <typename History>
void put_all(const Hdf5Group& group, const std::vector<History>& list) {
  for (std::size_t i = 0; i < list.size(); ++i) put(group.add_group(fmt::format("{:04}", i + 1)), list[i]);
}

template <typename History>
std::vector<History> all_of(const Hdf5Group& group, History (*read)(const Hdf5Group&)) {
  std::vector<History> list;
  for (const std::string& name : group.names()) list.push_back(read(group.group(name)));
  return list;
}

}  // namespace

void write_histories(const std::filesystem::path& file, const Histories& histories) {
  write_hdf5(file, [&](const Hdf5Group& root) {
    for (const char* name : origin_names) {
      const auto found = histories.origin.find(name);
      root.put_text(name, found == histories.origin.end() ? "" : found->second);
    }
    root.put_array("tip_depth", histories.tip_depth, "m");
    put_all(root.add_group("points"), histories.points);
    put_all(root.add_group("walls"), histories.walls);
    const Hdf5Group profile = root.add_group("profile");
    profile.put_array("depth", histories.profile.depth, "m");
    for (const solver::Channel& channel : solver::channels())
      if (channel.required || !(histories.profile.*channel.values).empty())
        profile.put_array(std::string(channel.name), histories.profile.*channel.values, "Pa");
    put(root.add_group("end"), histories.end);
  });
}

Histories read_histories(const std::filesystem::path& file) {
  Histories histories;
  try {
    read_hdf5(file, [&](const Hdf5Group& root) {
      for (const char* name : origin_names) histories.origin[name] = root.text(name);
      histories.tip_depth = root.array("tip_depth");
      histories.points = all_of(root.group("points"), point_of);
      histories.walls = all_of(root.group("walls"), wall_of);
      const Hdf5Group profile = root.group("profile");
      histories.profile.depth = profile.array("depth");
      const std::vector<std::string> stored = profile.names();
      for (const solver::Channel& channel : solver::channels())
        if (channel.required || std::ranges::find(stored, channel.name) != stored.end())
          histories.profile.*channel.values = profile.array(std::string(channel.name));
      histories.end = soil_of(root.group("end"));
    });
  } catch (const Error& error) {
    throw Error(fmt::format("{}: not a readable file of histories ({})", file.string(), error.what()));
  }
  return histories;
}

}  // namespace cpt::results
