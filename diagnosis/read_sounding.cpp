#include "diagnosis/read_sounding.hpp"

#include <fmt/format.h>

#include "recordings/csv.hpp"
#include "solver/lengths.hpp"

namespace cpt::diagnosis {
namespace {

using namespace parameters;

void read_columns(const Value& table, SoundingRequest& sounding, ErrorList& errors) {
  const Member* columns = table.find("columns");
  if (columns == nullptr) return;
  if (columns->value.kind != Value::Kind::table)
    return errors.add(columns->place, "soundings.columns", "must be a table such as { depth_m = \"z\" }");
  for (const Member& member : columns->value.members) {
    const std::string key = "soundings.columns." + member.key;
    if (const std::string problem = recordings::quantity_problem(member.key); !problem.empty())
      errors.add(member.place, key, problem);
    else if (member.value.kind != Value::Kind::text)
      errors.add(member.place, key, "must be the name of a column of the file");
    else
      sounding.options.columns.push_back({member.key, member.value.text});
  }
}

void check_depths(const Value& table, std::string_view list, const SoundingRequest& sounding,
                  const SoundingPlace& asked, ErrorList& errors) {
  const Place place = table.find("to_m")->value.place;
  const double least = 10.0 * asked.cell_height;
  const double final_depth = asked.study == nullptr ? 0.0 : asked.study->baseline.penetrometer.final_depth;
  if (sounding.to <= sounding.from)
    errors.add(place, joined(list, "to_m"),
               fmt::format("{} m is not below from_m = {}", sounding.to, sounding.from),
               "depth grows downwards");
  else if (solver::falls_short(sounding.to - sounding.from, least))
    errors.add(
        place, joined(list, "to_m"),
        fmt::format("{} m to {} m is less than 10 cells of the depth grid", sounding.from, sounding.to),
        fmt::format("compare at least {:g} m", least));
  else if (asked.study != nullptr && solver::exceeds(sounding.to, final_depth))
    errors.add(place, joined(list, "to_m"),
               fmt::format("{} m is below the end of the study's push, penetrometer.final_depth_m = {}",
                           sounding.to, final_depth),
               fmt::format("compare from 0.03 m or deeper to at most {:g} m", final_depth));
  else if (solver::falls_short(sounding.from, 0.03))
    errors.add(table.find("from_m")->value.place, joined(list, "from_m"),
               fmt::format("{} m lies within the start of the simulated push, whose cone is wished in place",
                           sounding.from),
               "begin at 0.03 m or deeper");
}

}  // namespace

std::optional<SoundingRequest> read_sounding(const Value& table, std::string_view list,
                                             const SoundingPlace& place, ErrorList& errors) {
  SoundingRequest sounding;
  const auto recording = text_field(table, list, "recording", place.recorded, errors);
  const auto from = number_field(table, list, "from_m", true, errors);
  const auto to = number_field(table, list, "to_m", true, errors);
  sounding.recording = (place.folder / recording.value_or("")).lexically_normal();
  sounding.name =
      text_field(table, list, "name", !place.recorded, errors).value_or(sounding.recording.stem().string());
  read_columns(table, sounding, errors);
  if (!from || !to) return std::nullopt;
  sounding.from = *from;
  sounding.to = *to;
  check_depths(table, list, sounding, place, errors);
  return sounding;
}

}  // namespace cpt::diagnosis
