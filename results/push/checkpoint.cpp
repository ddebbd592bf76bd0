#include "results/push/checkpoint.hpp"

#include <fmt/format.h>

#include <system_error>
#include <vector>

#include "results/files/hdf5_file.hpp"
#include "results/files/refusal.hpp"
#include "results/ledger/provenance.hpp"
#include "solver/instruction_set.hpp"
#include "solver/simulate.hpp"

namespace cpt::results {
namespace {

constexpr std::size_t hash_length = 64;

/// What a checkpoint belongs to, as attributes of its file, and what to say where it differs.
struct Origin {
  const char* name;
  std::string value;
  const char* what;
};

std::vector<Origin> origins(const solver::Setup& setup) {
  return {{"solver_version", std::string(solver::solver_version()), "by solver version"},
          {"instruction_set", std::string(to_string(solver::instruction_set())), "on instruction set"},
          {"settings_hash", settings_hash(setup), "with the settings"}};
}

solver::PushState state_in(const Hdf5Group& root, const solver::Setup& setup) {
  for (const Origin& origin : origins(setup))
    if (const std::string stored = root.text(origin.name); stored != origin.value)
      throw Error(fmt::format("made {} {} and not {}", origin.what, stored, origin.value));
  solver::PushState state;
  const Hdf5Group arrays = root.group("state");
  for (const std::string& name : arrays.names()) state[name] = arrays.array(name);
  return state;
}

}  // namespace

void write_checkpoint(const std::filesystem::path& file, const solver::Setup& setup,
                      const solver::PushState& state) {
  write_hdf5(file, [&](const Hdf5Group& root) {
    for (const Origin& origin : origins(setup)) root.put_text(origin.name, origin.value);
    const Hdf5Group arrays = root.add_group("state");
    for (const auto& [name, values] : state) arrays.put_array(name, values);
  });
}

std::optional<solver::PushState> read_checkpoint(const std::filesystem::path& file,
                                                 const solver::Setup& setup) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return std::nullopt;
  try {
    std::optional<solver::PushState> state;
    read_hdf5(file, [&](const Hdf5Group& root) { state = state_in(root, setup); });
    return state;
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", file.string(), error.what()));
  }
}

CheckpointFolder::CheckpointFolder(const std::filesystem::path& database,
                                   const std::set<std::string>& unfinished)
    : folder_(std::filesystem::absolute(database).replace_extension(".checkpoints")) {
  std::error_code problem;
  std::filesystem::create_directory(folder_, problem);
  if (problem) throw Error(refusal(folder_, "cannot be made", problem));
  std::vector<std::filesystem::path> stale;
  for (const auto& entry : std::filesystem::directory_iterator(folder_, problem)) {
    const std::string name = entry.path().filename().string();
    const std::string hash = name.substr(0, hash_length), rest = name.substr(hash.size());
    const bool ours = hash.find_first_not_of("0123456789abcdef") == std::string::npos &&
                      (rest == ".h5" || rest == ".h5.tmp" || (rest.empty() && hash.size() == hash_length));
    if (ours && (rest == ".h5.tmp" || !unfinished.contains(hash))) stale.push_back(entry.path());
  }
  for (const auto& file : stale) std::filesystem::remove_all(file, problem);
}

CheckpointFolder::~CheckpointFolder() {
  std::error_code not_empty;
  std::filesystem::remove(folder_, not_empty);
}

std::filesystem::path CheckpointFolder::file(const std::string& settings_hash) const {
  return folder_ / (settings_hash + ".h5");
}

void CheckpointFolder::remove(const std::string& settings_hash) const {
  std::error_code ignored;
  std::filesystem::remove(file(settings_hash), ignored);
  std::filesystem::remove_all(file(settings_hash).replace_extension(), ignored);
}

}  // namespace cpt::results
