#include "results/push/stored_push.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "parameters/written_number.hpp"
#include "results/ledger/setup_text.hpp"

namespace cpt::results {
namespace {

namespace fs = std::filesystem;

// FOLDER/NAME-fields/NAME.pvd of every series in a folder.
std::vector<fs::path> series_in(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with("-fields")) continue;
    const fs::path series = entry.path() / (name.substr(0, name.size() - 7) + ".pvd");
    if (fs::exists(series, error)) found.push_back(series);
  }
  std::ranges::sort(found);
  return found;
}

fs::path series_of(const fs::path& place) {
  std::error_code error;
  if (!fs::exists(place, error))
    throw Error(fmt::format("{}: there is no such folder or file", place.string()));
  if (!fs::is_directory(place, error)) {
    if (place.extension() == ".pvd") return place;
    throw Error(fmt::format("{}: not the folder of a push, nor its NAME-fields/NAME.pvd", place.string()));
  }
  const std::vector<fs::path> found = series_in(place);
  if (found.empty())
    throw Error(
        fmt::format("{}: no fields are stored here; campaign push STUDY --fields-every 0.01 stores "
                    "them, in NAME-push/",
                    place.string()));
  if (found.size() > 1)
    throw Error(fmt::format("{}: holds the fields of {} pushes; name one: {}, {}, ...", place.string(),
                            found.size(), found[0].string(), found[1].string()));
  return found.front();
}

}  // namespace

bool StoredPush::has_setting(const std::string& name_of_setting) const {
  return setup_by_name(histories.origin.at("setup")).contains(name_of_setting);
}

std::string StoredPush::setting(const std::string& name_of_setting) const {
  const auto setup = setup_by_name(histories.origin.at("setup"));
  if (const auto found = setup.find(name_of_setting); found != setup.end()) return found->second;
  throw Error(fmt::format("{}: its histories do not tell {}", folder.string(), name_of_setting));
}

double StoredPush::number(const std::string& name_of_setting) const {
  const std::string text = setting(name_of_setting);
  const auto value =
      parameters::written_number(text.substr(0, text.find(" (SI")));  // as canonical_text has it
  if (!value) throw Error(fmt::format("{}: {} = {} is no number", folder.string(), name_of_setting, text));
  return *value;
}

StoredPush read_stored_push(const fs::path& folder_or_series) {
  const fs::path series = fs::absolute(series_of(folder_or_series)).lexically_normal();
  StoredPush push;
  push.name = series.stem().string();
  push.folder = series.parent_path().parent_path();
  const fs::path histories = push.folder / (push.name + "-histories.h5");
  std::error_code error;
  if (!fs::exists(histories, error))
    throw Error(
        fmt::format("{}: missing beside the fields; campaign push writes it at its end. Let the push "
                    "finish, or run it again",
                    histories.string()));
  push.histories = read_histories(histories);
  for (const VtkFrame& frame : read_pvd(series))
    push.fields.push_back({frame.time, series.parent_path() / frame.file});
  if (push.fields.empty()) throw Error(fmt::format("{}: lists no fields", series.string()));
  return push;
}

VtkPoints read_field(const StoredPush& push, const StoredField& field) {
  VtkPoints points = read_vtu(field.file);
  if (points.comment.find(push.histories.origin.at("settings_hash")) == std::string::npos)
    throw Error(fmt::format("{}: of other settings than {}-histories.h5; run campaign push again",
                            field.file.string(), push.name));
  return points;
}

}  // namespace cpt::results
