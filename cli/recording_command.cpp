// campaign recording FILE
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <memory>

#include "cli/command.hpp"
#include "cli/exit_codes.hpp"
#include "cli/format_option.hpp"
#include "cli/recording_summary.hpp"
#include "cli/study_argument.hpp"
#include "recordings/csv.hpp"
#include "recordings/read_recording.hpp"
#include "reports/depth_panels.hpp"
#include "reports/figure_files.hpp"
#include "reports/palette.hpp"
#include "reports/png.hpp"

namespace cpt::cli {
namespace {

using recordings::Reading;
using recordings::Recording;

struct Arguments {
  std::filesystem::path file;
  std::vector<std::string> columns;  // QUANTITY=NAME
  recordings::ReadOptions options;
  std::filesystem::path out, csv;
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

std::string plot(const Recording& recording) {
  struct Shown {
    const char* title;
    double scale;  // [Pa]
    double Reading::*quantity;
    std::string_view color;
  };
  static constexpr Shown shown[] = {
      {"q_c (MPa)", 1e6, &Reading::q_c, reports::palette::ink},
      {"f_s (kPa)", 1e3, &Reading::f_s, reports::palette::vermillion},
      {"u_2 (kPa)", 1e3, &Reading::u_2, reports::palette::blue},
  };
  reports::DepthPanels figure;
  figure.title = recording.id;
  figure.lines = {fmt::format("{}, {}{}{}", std::filesystem::path(recording.file).filename().string(),
                              name_of(recording.format), recording.date.empty() ? "" : ", ", recording.date),
                  fmt::format("depth: {}", name_of(recording.depth_rule))};
  figure.depth = column(recording, &Reading::depth);
  for (const Shown& s : shown) {
    std::vector<double> values = column(recording, s.quantity);
    if (recordings::spread(values).values == 0) continue;
    for (double& value : values) value /= s.scale;
    figure.panels.push_back({reports::symbolic(s.title), std::move(values), s.color});
  }
  for (const Reading& reading : recording.readings) {
    if (reading.predrilled) figure.shaded_to = recording.predrilled_depth;
    if (reading.after_stop) figure.marks.push_back(reading.depth);
  }
  if (!std::isnan(figure.shaded_to)) figure.note = "grey: predrilled";
  if (!figure.marks.empty())
    figure.note +=
        std::string(figure.note.empty() ? "" : "; ") + "ticks at the right edge: stops of the push";
  return reports::depth_panels(figure);
}

int show(const Arguments& arguments) {
  recordings::ReadOptions options = arguments.options;
  options.columns = column_map(arguments.columns);
  std::filesystem::path out = arguments.out;
  if (out.empty()) out = arguments.file.stem().string() + "-recording.svg";
  if (out.extension() != ".svg" && out.extension() != ".png")
    throw BadInput(fmt::format("--out {}: must end in .svg or .png", out.string()));
  const auto read = recordings::read_recording(arguments.file, options);
  if (const auto* errors = std::get_if<std::vector<recordings::RecordingError>>(&read))
    throw BadInput(recordings::format(*errors));
  const auto& recording = std::get<Recording>(read);

  fmt::print("{}", summary(recording, arguments.format));
  const std::string svg = plot(recording);
  if (out.extension() == ".png")
    reports::write_png(svg, out);
  else
    reports::write_text(out, svg);
  if (!arguments.csv.empty()) results::write_csv(arguments.csv, readings_table(recording));
  if (arguments.format == results::Format::table) fmt::print("\n{}\n", out.string());
  return all_well;
}

}  // namespace

void add_recording(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<Arguments>();
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
  sub->add_option("--out", arguments->out, "Figure, .svg or .png [NAME-recording.svg]")->type_name("FILE");
  sub->add_option("--csv", arguments->csv, "Write all readings to this file too, with all digits")
      ->type_name("FILE");
  add_format_option(*sub, arguments->format);
  sub->footer(R"(Examples:
  campaign recording S04.gef
  campaign recording S04.gef --out S04.png --csv S04.csv
  campaign recording site.ags --push CPT01/1 --format json
  campaign recording chamber.csv --column depth_m=z_m --column q_c_MPa=qc_measured_MPa --void -9999
Quantities of --column, with their unit: depth_m, length_m, q_c_MPa, f_s_kPa, u_2_kPa, inclination_deg,
speed_mm_per_s, time_s; also _cm, _mm, _Pa, _kPa, _MPa, _rad. No value of a sensor is changed; whatever was found,
corrected or set aside is told with its rows (docs/recordings.md).)");
  sub->callback([arguments, &action] { action = [arguments] { return show(*arguments); }; });
}

}  // namespace cpt::cli
