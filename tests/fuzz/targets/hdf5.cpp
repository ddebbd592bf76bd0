#include "tests/fuzz/targets/hdf5.hpp"

#include <fstream>

#include "results/ledger/curve_store.hpp"
#include "results/push/checkpoint.hpp"
#include "results/push/histories.hpp"
#include "solver/presets.hpp"
#include "tests/fuzz/targets/use_ledger.hpp"

namespace cpt::fuzz {
namespace {

const solver::Setup& setup() {
  static const solver::Setup quick =
      solver::make_setup(solver::Profile::homogeneous_sand, solver::Preset::quick);
  return quick;
}

std::string curve_file() {
  const std::filesystem::path database = scratch("fuzzed.sqlite"), curves = database.parent_path() / "a.h5";
  std::ofstream(database, std::ios::binary) << sound_ledger();
  results::sync_curves(curves, database);
  return bytes_of(curves);
}

std::string checkpoint() {
  const std::filesystem::path file = scratch("a.h5");
  results::write_checkpoint(file, setup(), {{"push.depth", {0.03}}, {"points.slots", {1.0, 2.0, 3.0}}});
  return bytes_of(file);
}

std::string histories() {
  const std::filesystem::path file = scratch("a.h5");
  const results::HistoryColumns columns = {{"stress_rr", {"Pa", {-1.0e3, -2.0e3}}}};
  results::Histories histories;
  histories.tip_depth = {0.02, 0.03};
  histories.points = {{{0.1, 0.2}, {0.1, 0.21}, 7, "sand", columns}};
  histories.walls = {{{0.1, 0.5}, 2, columns}};
  histories.profile = {{0.01, 0.02}, {1.0e6, 2.0e6}, {1.0e4, 2.0e4}};
  write_histories(file, histories);
  return bytes_of(file);
}

}  // namespace

const std::vector<std::string>& sound_hdf5_files() {
  static const std::vector<std::string> files = {curve_file(), checkpoint(), histories()};
  return files;
}

Fate use_hdf5(std::string_view bytes) {
  const std::filesystem::path file = scratch("fuzzed.h5");
  std::ofstream(file, std::ios::binary) << bytes;
  int read = 0;
  const auto attempt = [&](auto use) {
    try {
      use();
      ++read;
    } catch (const results::Error& error) {
      promise(*error.what() != '\0', "an error says what is wrong");
    }
  };
  attempt([&] { (void)results::read_curves(file); });
  attempt([&] { (void)results::read_checkpoint(file, setup()); });
  attempt([&] { (void)results::read_histories(file); });
  return read > 0 ? Fate::sound : Fate::refused;
}

}  // namespace cpt::fuzz
