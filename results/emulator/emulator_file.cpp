#include "results/emulator/emulator_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "results/files/hdf5_file.hpp"
#include "results/ledger/provenance.hpp"

namespace cpt::results {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr const char* format_name = "emulator 3";

std::string numbered(std::size_t i) { return fmt::format("{:04}", i + 1); }

// Column by column.
std::vector<double> flat(const MatrixXd& matrix) { return {matrix.data(), matrix.data() + matrix.size()}; }

double number_in(const Hdf5Group& group, const std::string& name) {
  const std::optional<double> value = group.number(name);
  if (!value || !std::isfinite(*value)) throw Error(fmt::format("{} is missing or no number", name));
  return *value;
}

int count_in(const Hdf5Group& group, const std::string& name) {
  const double value = number_in(group, name);
  if (!(value >= 0.0 && value <= 1e9) || value != std::floor(value))
    throw Error(fmt::format("{} is no count", name));
  return static_cast<int>(value);
}

VectorXd vector_in(const Hdf5Group& group, const std::string& name) {
  const std::vector<double> values = group.array(name);
  VectorXd made = Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
  if (!made.allFinite()) throw Error(fmt::format("{} has a value that is not finite", name));
  return made;
}

MatrixXd matrix_in(const Hdf5Group& group, const std::string& name, Index rows, Index columns) {
  const VectorXd values = vector_in(group, name);
  if (rows < 0 || columns < 0 || values.size() != rows * columns)
    throw Error(fmt::format("{} has another size than the rest", name));
  return values.reshaped(rows, columns);
}

void put_input(const Hdf5Group& group, const EmulatorInput& input) {
  group.put_text("name", input.name);
  group.put_text("unit", input.unit);
  group.put_number("lower", input.lower);
  group.put_number("upper", input.upper);
  group.put_number("baseline", input.baseline);
  group.put_number("logarithmic", input.logarithmic ? 1.0 : 0.0);
  group.put_number("integer", input.integer ? 1.0 : 0.0);
  group.put_number("choice", input.choices.empty() ? 0.0 : 1.0);
  if (input.choices.empty()) return;
  group.put_text("lower_text", input.choices[0]);
  group.put_text("upper_text", input.choices[1]);
}

EmulatorInput input_in(const Hdf5Group& group) {
  EmulatorInput input;
  input.name = group.text("name");
  input.unit = group.text("unit");
  input.lower = number_in(group, "lower");
  input.upper = number_in(group, "upper");
  input.baseline = number_in(group, "baseline");
  input.logarithmic = number_in(group, "logarithmic") != 0.0;
  input.integer = number_in(group, "integer") != 0.0;
  if (number_in(group, "choice") != 0.0) input.choices = {group.text("lower_text"), group.text("upper_text")};
  if (!(input.lower < input.upper) || (input.logarithmic && !(input.lower > 0.0)))
    throw Error(fmt::format("{} has no range", input.name));
  return input;
}

void put_output(const Hdf5Group& group, const EmulatedOutput& output) {
  const OutputEmulator& emulator = output.emulator;
  const Validation& validation = output.validation;
  group.put_text("name", output.name);
  group.put_text("unit", output.unit);
  group.put_text("over", output.over);
  group.put_text("over_unit", output.over_unit);
  group.put_number("logarithmic", emulator.logarithmic() ? 1.0 : 0.0);
  group.put_number("held_out_runs", validation.runs);
  group.put_number("Q2", validation.q2);
  group.put_number("rmse", validation.rmse);
  group.put_number("coverage", validation.coverage);
  group.put_number("coverage_lower", validation.coverage_lower);
  group.put_number("coverage_upper", validation.coverage_upper);
  group.put_array("abscissa", flat(output.abscissa), output.over_unit);
  group.put_array("mean", flat(emulator.components().mean));
  group.put_array("left_out_variance", flat(emulator.components().left_out));
  group.put_array("left_out_correlation", flat(emulator.components().left_out_correlation));
  group.put_array("shapes", flat(emulator.components().shapes));
  const Hdf5Group components = group.add_group("components");
  for (std::size_t c = 0; c < emulator.processes().size(); ++c) {
    const GaussianProcess& process = emulator.processes()[c];
    const Hdf5Group component = components.add_group(numbered(c));
    component.put_number("trend_degree", static_cast<int>(process.trend()));
    component.put_number("nugget", process.kernel().nugget);
    component.put_array("lengths", flat(process.kernel().lengths));
    component.put_array("scores", flat(process.values()));
  }
}

GaussianProcess process_in(const Hdf5Group& group, const MatrixXd& design) {
  const int degree = count_in(group, "trend_degree");
  if (degree > 2) throw Error("a trend is of no degree that there is");
  return {design, vector_in(group, "scores"), static_cast<Trend>(degree),
          Kernel{vector_in(group, "lengths"), number_in(group, "nugget")}};
}

EmulatedOutput output_in(const Hdf5Group& group, const MatrixXd& design) {
  std::vector<GaussianProcess> processes;
  const Hdf5Group stored = group.group("components");
  for (const std::string& name : stored.names()) processes.push_back(process_in(stored.group(name), design));
  PrincipalComponents components;
  components.mean = vector_in(group, "mean");
  components.left_out = vector_in(group, "left_out_variance");
  components.left_out_correlation = vector_in(group, "left_out_correlation");
  components.shapes =
      matrix_in(group, "shapes", components.mean.size(), static_cast<Index>(processes.size()));
  VectorXd abscissa = vector_in(group, "abscissa");
  if (abscissa.size() != (abscissa.size() == 0 ? 0 : components.mean.size()) ||
      (abscissa.size() == 0 && components.mean.size() != 1))
    throw Error("a curve has not as many abscissas as values");
  Validation validation;
  validation.runs = count_in(group, "held_out_runs");
  validation.q2 = number_in(group, "Q2");
  validation.rmse = number_in(group, "rmse");
  validation.coverage = number_in(group, "coverage");
  validation.coverage_lower = number_in(group, "coverage_lower");
  validation.coverage_upper = number_in(group, "coverage_upper");
  return {{group.text("name"), group.text("unit"), group.text("over"), group.text("over_unit")},
          std::move(abscissa),
          OutputEmulator(std::move(components), std::move(processes), number_in(group, "logarithmic") != 0.0),
          validation};
}

void put_emulator(const Hdf5Group& root, const Emulator& emulator) {
  root.put_text("format", format_name);
  root.put_text("study", emulator.study);
  root.put_text("program_version", std::string(program_version()));
  root.put_text("solver_version", emulator.solver_version);
  root.put_text("windows", emulator.windows);
  const Hdf5Group inputs = root.add_group("inputs");
  for (std::size_t j = 0; j < emulator.inputs.size(); ++j)
    put_input(inputs.add_group(numbered(j)), emulator.inputs[j]);
  const Hdf5Group runs = root.add_group("runs");
  std::vector<double> ids;
  std::string hashes;
  for (const TrainedRun& run : emulator.runs) {
    ids.push_back(run.id);
    hashes += run.settings_hash + '\n';
  }
  runs.put_array("realization", ids);
  runs.put_text("settings_hashes", hashes);
  const MatrixXd none;
  runs.put_array(
      "places",
      flat(emulator.outputs.empty() ? none : emulator.outputs.front().emulator.processes().front().design()));
  const Hdf5Group outputs = root.add_group("outputs");
  for (std::size_t k = 0; k < emulator.outputs.size(); ++k)
    put_output(outputs.add_group(numbered(k)), emulator.outputs[k]);
}

Emulator emulator_in(const Hdf5Group& root) {
  if (root.text("format") != format_name) throw Error("no emulator of a kind that this program reads");
  Emulator emulator;
  emulator.study = root.text("study");
  emulator.solver_version = root.text("solver_version");
  emulator.windows = root.text("windows");
  const Hdf5Group inputs = root.group("inputs");
  for (const std::string& name : inputs.names()) emulator.inputs.push_back(input_in(inputs.group(name)));
  const Hdf5Group runs = root.group("runs");
  const VectorXd ids = vector_in(runs, "realization");
  const std::string hashes = runs.text("settings_hashes");
  std::size_t from = 0;
  for (const double id : ids) {
    const std::size_t end = hashes.find('\n', from);
    if (end == std::string::npos || !(std::abs(id) < 1e9)) throw Error("its runs have no settings hashes");
    emulator.runs.push_back({static_cast<int>(id), hashes.substr(from, end - from)});
    from = end + 1;
  }
  const Hdf5Group outputs = root.group("outputs");
  const std::vector<std::string> names = outputs.names();
  if (names.empty()) return emulator;
  const MatrixXd design = matrix_in(runs, "places", ids.size(), static_cast<Index>(emulator.inputs.size()));
  for (const std::string& name : names) emulator.outputs.push_back(output_in(outputs.group(name), design));
  return emulator;
}

}  // namespace

std::filesystem::path emulator_file_of(const std::filesystem::path& database) {
  return database.parent_path() / (database.stem().string() + "-emulator.h5");
}

void write_emulator(const std::filesystem::path& file, const Emulator& emulator) {
  write_hdf5(file, [&](const Hdf5Group& root) { put_emulator(root, emulator); });
}

Emulator read_emulator(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
    throw Error(fmt::format("{}: no such emulator; campaign emulate STUDY makes it", file.string()));
  try {
    Emulator emulator;
    read_hdf5(file, [&](const Hdf5Group& root) { emulator = emulator_in(root); });
    return emulator;
  } catch (const std::invalid_argument& problem) {
    throw Error(fmt::format("{}: cannot be read as an emulator ({}); campaign emulate STUDY makes it anew",
                            file.string(), problem.what()));
  } catch (const Error& problem) {
    throw Error(fmt::format("{}: cannot be read as an emulator ({}); campaign emulate STUDY makes it anew",
                            file.string(), problem.what()));
  }
}

}  // namespace cpt::results
