// campaign recording FILE
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>

#include "cli/command.hpp"
#include "cli/common/format_option.hpp"
#include "cli/common/input_kind.hpp"
#include "cli/common/study_argument.hpp"
#include "cli/exit_codes.hpp"
#include "cli/soundings/recording_plot.hpp"
#include "cli/soundings/recording_summary.hpp"
#include "recordings/csv.hpp"
#include "recordings/read_recording.hpp"
#include "reports/figure_files.hpp"
#include "reports/picture_files.hpp"

namespace cpt::cli {
namespace {

using recordings::Recording;

struct RecordingArguments {
  std::filesystem::path file;
  std::vector<std::string> columns;  // QUANTITY=NAME
  recordings::ReadOptions options;
  std::filesystem::path out, csv;
  std::optional<double> unit_weight, water_table, surcharge, area_quotient;  // kN/m3, m, kPa, -
  results::Format format = results::Format::table;
};

recordings::ColumnMap column_map(const std::vector<std::string>& entries) {
  recordings::ColumnMap map;
  for (const std::string& entry : entries) {
    const auto equals = entry.find('=');
    if (equals == std::string::npos || equals + 1 == entry.size())
      throw BadInput(fmt::format("--column {}: must be QUANTITY=NAME, e.g. q_c_MPa=qc", entry));
    const std::string quantity = entry.substr(0, equals);
    if (const std::string problem = recordings::quantity_problem(quantity); !problem.empty())
      throw BadInput(fmt::format("--column {}: {}", entry, problem));
    map.push_back({quantity, entry.substr(equals + 1)});
  }
  return map;
}

/// A number of the command line within a range, in SI units.
std::optional<double> known(const char* option, const std::optional<double>& value, double low, double high,
                            const char* unit, double scale) {
  if (value && !(*value >= low && *value <= high))
    throw BadInput(fmt::format("{} {:g}: must be {:g} to {:g}{}{}", option, *value, low, high,
                               *unit == '\0' ? "" : " ", unit));
  return value ? std::optional(*value * scale) : std::nullopt;
}

recordings::KnownGround known_ground(const RecordingArguments& arguments) {
  return {known("--unit-weight", arguments.unit_weight, 5.0, 40.0, "kN/m3", 1e3),
          known("--water-table", arguments.water_table, -1e4, 1e4, "m", 1.0),
          known("--surcharge", arguments.surcharge, 0.0, 1e5, "kPa", 1e3),
          known("--area-quotient", arguments.area_quotient, 0.01, 1.0, "", 1.0)};
}

int show(const RecordingArguments& arguments) {
  recordings::ReadOptions options = arguments.options;
  options.columns = column_map(arguments.columns);
  std::filesystem::path out = arguments.out;
  if (out.empty()) out = arguments.file.stem().string() + "-recording.svg";
  if (out.extension() != ".svg" && out.extension() != ".png")
    throw BadInput(fmt::format("--out {}: must end in .svg or .png", out.string()));
  const recordings::KnownGround ground = known_ground(arguments);
  const auto read =
      recordings::parse_recording(read_input(InputKind::recording, arguments.file), arguments.file, options);
  if (const auto* errors = std::get_if<std::vector<recordings::RecordingError>>(&read))
    throw BadInput(recordings::format(*errors));
  const auto& recording = std::get<Recording>(read);

  const recordings::Interpretation interpretation = recordings::interpret(recording, ground);
  fmt::print("{}", summary(recording, interpretation, arguments.format));
  const std::string svg = recording_plot(recording, interpretation);
  if (out.extension() == ".png")
    reports::write_png(svg, out);
  else
    reports::write_text(out, svg);
  if (!arguments.csv.empty()) results::write_csv(arguments.csv, readings_table(recording, interpretation));
  if (arguments.format == results::Format::table) fmt::print("\n{}\n", out.string());
  return all_well;
}

}  // namespace

void add_recording(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<RecordingArguments>();
  CLI::App* sub = program.add_subcommand(
      "recording", "Show what a measured sounding holds, what is odd about it, and plot it");
  sub->add_option("FILE", arguments->file, "GEF-CPT (.gef), AGS4 (.ags), Geotech (.cpt) or CSV")
      ->type_name("")
      ->required();
  sub->add_option("--column", arguments->columns,
                  "CSV: which column is what, e.g. q_c_MPa=qc; may be repeated")
      ->type_name("QUANTITY=NAME")
      ->allow_extra_args(false);
  sub->add_option("--void", arguments->options.voids, "CSV: a value that means not measured; may be repeated")
      ->type_name("X")
      ->allow_extra_args(false);
  sub->add_option("--push", arguments->options.push, "AGS4: which push, where the file holds several")
      ->type_name("LOCA_ID[/SCPG_TESN]");
  const auto ground = [&](const char* name, std::optional<double>& value, const char* text,
                          const char* unit) { sub->add_option(name, value, text)->type_name(unit); };
  ground("--unit-weight", arguments->unit_weight, "Of the soil, for the stresses in I_c [18]", "KN_PER_M3");
  ground("--water-table", arguments->water_table, "Its depth below the ground, for the stresses in I_c [1]",
         "M");
  ground("--surcharge", arguments->surcharge, "Vertical stress on the ground, as in a chamber [0]", "KPA");
  ground("--area-quotient", arguments->area_quotient, "Of the cone, for q_t, in place of the file's", "A");
  sub->add_option("--out", arguments->out, "Figure, .svg or .png [NAME-recording.svg]")->type_name("FILE");
  sub->add_option("--csv", arguments->csv, "Write all readings to this file too, with all digits")
      ->type_name("FILE");
  add_format_option(*sub, arguments->format);
  sub->footer(R"(Examples:
  campaign recording S04.gef
  campaign recording S04.gef --out S04.png --csv S04.csv
  campaign recording S04.gef --unit-weight 17 --water-table 0.8
  campaign recording site.ags --push CPT01/1 --format json
  campaign recording chamber.csv --column depth_m=z_m --column q_c_MPa=qc_measured_MPa --void -9999
Quantities of --column, with their unit: depth_m, length_m, q_c_MPa, f_s_kPa, u_2_kPa, inclination_deg,
speed_mm_per_s, time_s; also _cm, _mm, _Pa, _kPa, _MPa, _rad. No value of a sensor is changed; whatever was found,
corrected or set aside is told with its rows (docs/recordings.md).)");
  sub->callback([arguments, &action] { action = [arguments] { return show(*arguments); }; });
}

}  // namespace cpt::cli
