#include "tests/fuzz/targets/hdf5.hpp"

#include <fstream>

#include "results/emulator/emulator_file.hpp"
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

std::string emulator() {
  const std::filesystem::path file = scratch("a.h5");
  Eigen::MatrixXd places(7, 1), average(1, 7), curve(3, 7);
  for (int i = 0; i < 7; ++i) {
    places(i, 0) = i / 6.0;
    average(0, i) = i * i + 1.0;
    curve.col(i) << 1.0, 2.0 + i, 3.0;
  }
  results::Emulator made;
  made.study = "study";
  made.inputs = {{"sand.H", "-", 25.0, 75.0, 50.0, false, false, {}}};
  for (int i = 0; i < 7; ++i) made.runs.push_back({i + 1, "0123"});
  made.outputs.push_back({{"deep.q_c_mean_kPa"}, {}, results::OutputEmulator::fit(places, average), {}});
  made.outputs.push_back(
      {{"q_c_kPa"}, Eigen::Vector3d(0.1, 0.2, 0.3), results::OutputEmulator::fit(places, curve), {}});
  results::write_emulator(file, made);
  return bytes_of(file);
}

// What is read can be asked, and its numbers are none that is not finite where it has runs.
void use_emulator(const std::filesystem::path& file) {
  const results::Emulator read = results::read_emulator(file);
  const Eigen::MatrixXd middle =
      Eigen::MatrixXd::Constant(1, static_cast<Eigen::Index>(read.inputs.size()), 0.5);
  for (const results::EmulatedOutput& output : read.outputs) {
    const results::OutputPrediction at = output.emulator.predict(middle);
    promise(at.value.rows() == output.emulator.values() && at.value.cols() == 1, "a value for each depth");
    promise(!output.is_curve() || output.abscissa.size() == at.value.rows(), "a depth for each value");
  }
}

}  // namespace

const std::vector<std::string>& sound_hdf5_files() {
  static const std::vector<std::string> files = {curve_file(), checkpoint(), histories(), emulator()};
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
  attempt([&] { use_emulator(file); });
  return read > 0 ? Fate::sound : Fate::refused;
}

}  // namespace cpt::fuzz
