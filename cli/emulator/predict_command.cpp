// campaign predict STUDY|EMULATOR.h5
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <set>

#include "cli/command.hpp"
#include "cli/common/format_option.hpp"
#include "cli/emulator/emulator_argument.hpp"
#include "cli/emulator/prediction_points.hpp"
#include "cli/exit_codes.hpp"

namespace cpt::cli {
namespace {

using Eigen::Index;

struct PredictArguments {
  std::filesystem::path source, table, curves;
  std::vector<std::string> settings;
  results::Format format = results::Format::table;
};

// A row a point and average; what is refused has a row without a value.
results::Table averages(const results::Emulator& emulator, const PredictionPoints& points,
                        const Eigen::MatrixXd& places) {
  results::Table table{{"point", "output", "value", "standard_error", "lower", "upper", "unit", "note"}, {}};
  std::vector<results::OutputPrediction> predicted;
  for (const results::EmulatedOutput& output : emulator.outputs)
    predicted.push_back(output.is_curve() ? results::OutputPrediction{} : output.emulator.predict(places));
  for (Index i = 0; i < places.rows(); ++i)
    for (std::size_t k = 0; k < predicted.size(); ++k) {
      const results::EmulatedOutput& output = emulator.outputs[k];
      if (output.is_curve()) continue;
      const std::string why = refusal_of(output);
      std::vector<results::Cell> row{points.names[static_cast<std::size_t>(i)], output.name};
      for (const Eigen::MatrixXd* part :
           {&predicted[k].value, &predicted[k].error, &predicted[k].lower, &predicted[k].upper})
        row.push_back(results::number_cell(why.empty() ? (*part)(0, i) : std::nan("")));
      row.emplace_back(output.unit);
      row.emplace_back(why.empty() ? std::string() : "refused: " + why);
      table.rows.push_back(std::move(row));
    }
  return table;
}

// "depth_m"; of an external program's curves "time_d", "abscissa" where they have several.
std::string abscissa_of(const results::Emulator& emulator) {
  std::set<std::string> names;
  for (const results::EmulatedOutput& output : emulator.outputs)
    if (output.is_curve())
      names.insert(output.over_unit == "-" ? output.over : output.over + "_" + output.over_unit);
  return names.size() == 1 ? *names.begin() : "abscissa";
}

// A row a point, curve and place on it.
results::Table curves(const results::Emulator& emulator, const PredictionPoints& points,
                      const Eigen::MatrixXd& places) {
  results::Table table{
      {"point", "output", abscissa_of(emulator), "value", "standard_error", "lower", "upper", "unit"}, {}};
  for (const results::EmulatedOutput& output : emulator.outputs) {
    if (!output.is_curve()) continue;
    if (const std::string why = refusal_of(output); !why.empty()) {
      fmt::print(stderr, "refused: {}: {}\n", output.name, why);
      continue;
    }
    const results::OutputPrediction at = output.emulator.predict(places);
    for (Index i = 0; i < places.rows(); ++i)
      for (Index z = 0; z < output.abscissa.size(); ++z)
        table.rows.push_back({points.names[static_cast<std::size_t>(i)], output.name, output.abscissa(z),
                              at.value(z, i), at.error(z, i), at.lower(z, i), at.upper(z, i), output.unit});
  }
  return table;
}

int predict(const PredictArguments& arguments) {
  const results::Emulator emulator = read_emulator_of(arguments.source);
  const PredictionPoints points = arguments.table.empty()
                                      ? point_of(emulator, arguments.settings)
                                      : points_of(emulator, arguments.settings, arguments.table);
  const Eigen::MatrixXd places = emulator.places(points.values);
  if (!arguments.curves.empty()) {
    const results::Table table = curves(emulator, points, places);
    if (table.rows.empty()) throw results::Error(fmt::format("{}: has no curve to predict", emulator.study));
    results::write_csv(arguments.curves, table);
  }
  fmt::print("{}", results::format(averages(emulator, points, places), arguments.format));
  for (const results::EmulatedOutput& output : emulator.outputs)
    if (refusal_of(output).empty()) return all_well;
  return emulator_refused;
}

}  // namespace

void add_predict(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<PredictArguments>();
  CLI::App* command =
      program.add_subcommand("predict", "Averages and curves of a run that was not made, by an emulator");
  command->add_option("STUDY|EMULATOR", arguments->source, "Study file, or its NAME-emulator.h5")
      ->type_name("")
      ->required();
  command
      ->add_option("--set", arguments->settings,
                   "An input's value in its study unit; may be repeated. Others: the baseline's")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  command->add_option("--table", arguments->table, "CSV table with a point a row and a column for each input")
      ->type_name("FILE");
  command
      ->add_option("--curves", arguments->curves, "Also write mean and 95 % band over depth to this CSV file")
      ->type_name("FILE");
  add_format_option(*command, arguments->format);
  command->footer(
      R"(value, standard error and 95 % interval are those of a run with these inputs: of the emulator, with the scatter of
runs. Of a study the emulator is held against its database first and refused where runs, bounds, windows or solver are
others now; campaign emulate STUDY makes it anew. An emulator's file is taken as it is. Values beyond the inputs' ranges
are an error. An output that was refused has no value; where all are, the exit code is 7.

Examples:
  campaign predict clay.toml --set clay.s_u_kPa=30
  campaign predict clay-emulator.h5 --table points.csv --format csv
  campaign predict clay.toml --set clay.s_u_kPa=30 --curves curve.csv)");
  command->callback([arguments, &action] { action = [arguments] { return predict(*arguments); }; });
}

}  // namespace cpt::cli
