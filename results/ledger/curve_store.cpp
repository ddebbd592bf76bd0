#include "results/ledger/curve_store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

#include "results/files/hdf5_file.hpp"

namespace cpt::results {
namespace {

/// What is in a curve file.
struct CurveFile {
  std::map<std::string, std::string> provenance;  // attributes of the file's root
  std::vector<StoredCurve> curves;
  bool operator==(const CurveFile&) const = default;
};

constexpr const char* text_attributes[] = {"parameter", "side",   "value_text",
                                           "unit",      "status", "settings_hash"};
constexpr std::string StoredCurve::*text_members[] = {&StoredCurve::parameter,  &StoredCurve::side,
                                                      &StoredCurve::value_text, &StoredCurve::unit,
                                                      &StoredCurve::status,     &StoredCurve::settings_hash};
constexpr const char* provenance_names[] = {"study",           "title",         "profile",
                                            "preset",          "study_text",    "baseline_setup",
                                            "program_version", "solver_version"};

void fill(const Hdf5Group& root, const CurveFile& content) {
  for (const auto& [name, value] : content.provenance) root.put_text(name, value);
  const Hdf5Group all = root.add_group("realizations");
  for (const StoredCurve& curve : content.curves) {
    const Hdf5Group group = all.add_group(fmt::format("{:04}", curve.realization));
    for (std::size_t i = 0; i < std::size(text_attributes); ++i)
      group.put_text(text_attributes[i], curve.*text_members[i]);
    if (curve.value) group.put_number("value", *curve.value);
    for (const solver::ProgramResult& result : curve.declared) {
      if (!result.x.empty()) group.put_array(result.name + ".x", result.x);
      group.put_array(result.name, result.y);
    }
    if (!curve.declared.empty()) continue;
    group.put_array("depth_m", curve.depth_m);
    for (const auto& [name, values] : curve.channels_kPa) group.put_array(name + "_kPa", values);
  }
}

// In the order of their names.
std::vector<solver::ProgramResult> declared_in(const Hdf5Group& group,
                                               const std::vector<std::string>& stored) {
  std::vector<solver::ProgramResult> declared;
  for (const std::string& name : stored)
    if (!name.ends_with(".x"))
      declared.push_back({name,
                          std::ranges::find(stored, name + ".x") == stored.end() ? std::vector<double>{}
                                                                                 : group.array(name + ".x"),
                          group.array(name)});
  return declared;
}

CurveFile content_of(const Hdf5Group& root) {
  CurveFile content;
  for (const char* name : provenance_names) content.provenance[name] = root.text(name);
  const Hdf5Group all = root.group("realizations");
  for (const std::string& name : all.names()) {
    const Hdf5Group group = all.group(name);
    StoredCurve curve;
    if (std::sscanf(name.c_str(), "%d", &curve.realization) != 1) throw Error("a group is not a realization");
    for (std::size_t k = 0; k < std::size(text_attributes); ++k)
      curve.*text_members[k] = group.text(text_attributes[k]);
    curve.value = group.number("value");
    const std::vector<std::string> stored = group.names();
    if (std::ranges::find(stored, "depth_m") == stored.end()) {
      curve.declared = declared_in(group, stored);
      content.curves.push_back(std::move(curve));
      continue;
    }
    curve.depth_m = group.array("depth_m");
    for (const solver::Channel& channel : solver::channels())
      if (const std::string dataset = in_unit(channel, "kPa");
          channel.required || std::ranges::find(stored, dataset) != stored.end())
        curve.channels_kPa[std::string(channel.name)] = group.array(dataset);
    content.curves.push_back(std::move(curve));
  }
  return content;
}

CurveFile read_file(const std::filesystem::path& file) {
  CurveFile content;
  read_hdf5(file, [&](const Hdf5Group& root) { content = content_of(root); });
  return content;
}

std::map<std::string, std::vector<double>> channels_kPa(const solver::DepthProfile& profile) {
  std::map<std::string, std::vector<double>> channels;
  for (const solver::Channel& channel : solver::channels()) {
    std::vector<double> values = profile.*channel.values;
    for (double& value : values) value /= 1.0e3;
    if (!values.empty() || channel.required) channels[std::string(channel.name)] = std::move(values);
  }
  return channels;
}

CurveFile content_of(const Snapshot& snapshot) {
  const CampaignRow& c = snapshot.campaign;
  CurveFile content;
  content.provenance = {{"study", c.name},
                        {"title", c.title},
                        {"profile", c.profile},
                        {"preset", c.preset},
                        {"study_text", c.study_text},
                        {"baseline_setup", c.baseline_setup},
                        {"program_version", c.program_version},
                        {"solver_version", c.solver_version}};
  auto row = snapshot.realizations.begin();
  for (const CurveRow& curve : snapshot.curves) {
    // Both are in the order of their ids.
    row = std::find_if(row, snapshot.realizations.end(),
                       [&](const RealizationRow& r) { return r.id == curve.realization; });
    if (row == snapshot.realizations.end()) throw Error("a curve has no realization");
    const auto parameter = std::find_if(snapshot.parameters.begin(), snapshot.parameters.end(),
                                        [&](const ParameterRow& p) { return p.name == row->parameter; });
    content.curves.push_back({row->id,
                              row->parameter,
                              row->side,
                              row->value_text,
                              parameter == snapshot.parameters.end() ? "" : parameter->unit,
                              row->status,
                              row->settings_hash,
                              std::isnan(row->value) ? std::nullopt : std::optional(row->value),
                              curve.profile.depth,
                              {},
                              curve.profile.declared});
    StoredCurve& stored = content.curves.back();
    if (stored.declared.empty()) stored.channels_kPa = channels_kPa(curve.profile);
    std::ranges::sort(stored.declared, {}, &solver::ProgramResult::name);
  }
  return content;
}

bool is_current(const std::filesystem::path& file, const CurveFile& wanted) {
  if (!std::filesystem::exists(file)) return false;
  try {
    return read_file(file) == wanted;
  } catch (const Error&) {
    return false;  // damaged, or of another layout: rebuilt
  }
}

void write_content(const std::filesystem::path& file, const CurveFile& content,
                   const std::filesystem::path& database) {
  try {
    write_hdf5(file, [&](const Hdf5Group& root) { fill(root, content); });
  } catch (const Error& error) {
    throw Error(fmt::format("{}; the curves are safe in {}", error.what(), database.string()));
  }
}

}  // namespace

void write_curves(const std::filesystem::path& file, const std::filesystem::path& database) {
  write_content(file, content_of(read_snapshot(database)), database);
}

bool sync_curves(const std::filesystem::path& file, const std::filesystem::path& database) {
  const CurveFile wanted = content_of(read_snapshot(database));
  if (is_current(file, wanted)) return false;
  write_content(file, wanted, database);
  return true;
}

std::vector<StoredCurve> read_curves(const std::filesystem::path& file) {
  try {
    return read_file(file).curves;
  } catch (const Error& error) {
    throw Error(fmt::format("{}: not a readable curve file ({})", file.string(), error.what()));
  }
}

}  // namespace cpt::results
