// campaign element triaxial|oedometer|isotropic; calibrate has a file of its own
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "cli/command.hpp"
#include "cli/common/cells.hpp"
#include "cli/common/set_quantity.hpp"
#include "cli/common/study_argument.hpp"
#include "cli/exit_codes.hpp"
#include "results/tables/table_format.hpp"
#include "solver/constitutive/element_test.hpp"
#include "solver/presets.hpp"
#include "solver/quantities.hpp"
#include "solver/soils/law.hpp"

namespace cpt::cli {
namespace {

struct ElementArguments {
  solver::ElementPath path = solver::ElementPath::triaxial;
  std::string material = "sand";
  bool drained = true;
  std::vector<std::string> settings;       // name=value
  std::optional<double> e_0, D_r_percent;  // initial density
  std::optional<double> p_0_kPa, sigma_v0_kPa, sigma_h0_kPa, p_i_kPa;
  std::optional<double> max_sigma_v_kPa;
  double strain_percent = 25.0;
  int steps = 250;
  std::filesystem::path csv;
};

void choose_stress(const ElementArguments& arguments, solver::ElementTest& test) {
  const bool split = arguments.sigma_v0_kPa.has_value() || arguments.sigma_h0_kPa.has_value();
  if (arguments.p_0_kPa && split) throw BadInput("give either --p0_kPa or --sigma_v0_kPa and --sigma_h0_kPa");
  if (split && !arguments.sigma_v0_kPa) throw BadInput("--sigma_h0_kPa needs --sigma_v0_kPa too");
  // Without a horizontal stress: that of K_0 = 0.5 in the oedometer, the vertical one otherwise.
  const double K_0 = arguments.path == solver::ElementPath::oedometer && !arguments.p_0_kPa ? 0.5 : 1.0;
  test.sigma_a = arguments.sigma_v0_kPa.value_or(arguments.p_0_kPa.value_or(100.0)) * kPa;
  test.sigma_r = arguments.sigma_h0_kPa ? *arguments.sigma_h0_kPa * kPa : K_0 * test.sigma_a;
}

// What the law says of its parameters in a study, it says here.
void refuse_impossible(solver::Setup setup, const solver::Soil& soil, const solver::ElementTest& test) {
  const auto place = static_cast<std::size_t>(std::ranges::find(setup.soils, soil.name, &solver::Soil::name) -
                                              setup.soils.begin());
  setup.layers = {{0.0, setup.chamber.soil_height, place}};
  setup.initial.sigma_v0 = test.sigma_a;
  setup.initial.sigma_h0 = test.sigma_r;
  for (const solver::Problem& problem : solver::law_of(soil).problems(setup, place, true))
    if (problem.quantity.starts_with(soil.name + "."))
      throw BadInput(fmt::format("{}: {}", problem.quantity, problem.message));
}

solver::ElementTest make_test(const ElementArguments& arguments) {
  solver::Setup setup = solver::make_setup(solver::Profile::homogeneous_sand, solver::Preset::standard);
  if (const solver::Law* law = solver::find_law(arguments.material))
    setup.soils = {{arguments.material, law->defaults()}};
  const solver::Soil& soil = *std::ranges::find(setup.soils, arguments.material, &solver::Soil::name);
  const std::string group = soil.name + ".";
  if (arguments.D_r_percent && (arguments.e_0 || !solver::find_quantity(group + "D_r_percent", setup)))
    throw BadInput("--D_r_percent is for sand, and in place of --e0");
  std::vector<std::string> settings = arguments.settings;
  if (arguments.D_r_percent)
    settings.push_back(fmt::format("{}D_r_percent={}", group, *arguments.D_r_percent));
  for (const std::string& setting : settings) set_quantity(setup, setting, group);

  solver::ElementTest test;
  choose_stress(arguments, test);
  refuse_impossible(setup, soil, test);
  test.path = arguments.path;
  test.drained = arguments.drained;
  test.material = soil.parameters;
  if (arguments.e_0) test.e_0 = *arguments.e_0;
  if (arguments.p_i_kPa) test.h_0 = *arguments.p_i_kPa * kPa;
  if (arguments.max_sigma_v_kPa) test.max_axial_stress = *arguments.max_sigma_v_kPa * kPa;
  test.max_axial_strain = arguments.strain_percent * 0.01;
  test.steps = arguments.steps;
  return test;
}

// Every `stride`-th row, and the last; with the state variables that the law keeps.
results::Table path_table(const solver::Law& law, const std::vector<solver::ElementRow>& rows,
                          std::size_t stride) {
  results::Table table{{"eps_a", "eps_v", "q_kPa", "p_kPa", "e", "psi"}, {}};
  std::vector<double> scales;
  for (const solver::StateVariable& variable : law.state(law.defaults(), {})) {
    const bool pressure = variable.unit == "Pa";
    table.columns.push_back(std::string(variable.name) + (pressure ? "_kPa" : ""));
    scales.push_back(pressure ? kPa : 1.0);
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i % stride != 0 && i + 1 != rows.size()) continue;
    const solver::ElementRow& row = rows[i];
    std::vector<double> values = {row.eps_a, row.eps_v, row.q / kPa, row.p / kPa, row.e, row.psi};
    for (std::size_t k = 0; k < scales.size(); ++k)
      values.push_back((k == 0 ? row.h_0 : row.h_1) / scales[k]);
    std::vector<results::Cell>& cells = table.rows.emplace_back(table.columns.size());
    for (std::size_t j = 0; j < cells.size(); ++j)
      if (!std::isnan(values[j])) cells[j] = values[j];
  }
  return table;
}

int element(const ElementArguments& arguments) {
  const solver::ElementTest test = make_test(arguments);
  const solver::ElementResult result = solver::run_element_test(test);
  const solver::Law& law = solver::law_of(std::get<solver::LawParameters>(test.material));
  if (!arguments.csv.empty() && !result.rows.empty()) {
    results::write_csv(arguments.csv, path_table(law, result.rows, 1));
    fmt::print("{} rows: {}\n", result.rows.size(), arguments.csv.string());
  } else if (!result.rows.empty()) {
    const std::size_t stride = std::max<std::size_t>(1, (result.rows.size() - 1) / 25);
    fmt::print("{}", results::format(path_table(law, result.rows, stride), results::Format::table));
  }
  if (result.problem.empty()) return all_well;
  throw BadInput(fmt::format("the test did not run to its end: {}", result.problem));
}

void add_path(CLI::App& command, const char* name, const char* meaning, solver::ElementPath path,
              Action& action) {
  auto arguments = std::make_shared<ElementArguments>();
  arguments->path = path;
  CLI::App* sub = command.add_subcommand(name, meaning);
  const auto number = [sub](const char* option, auto& value, const char* what) {
    return sub->add_option(option, value, what)->type_name("X");
  };
  std::vector<std::string> materials = {"sand", "clay"};
  for (const solver::Law* law : solver::all_laws()) materials.emplace_back(law->name());
  sub->add_option("--material", arguments->material,
                  "sand (NorSand) [default], clay (Tresca), or a law, whose parameters are then LAW.NAME")
      ->type_name("SOIL")
      ->check(CLI::IsMember(materials).description(""));
  if (path == solver::ElementPath::triaxial) {
    const auto drained = [&](const char* flag, bool is_drained, const char* what) {
      const auto choose = [arguments, is_drained](std::int64_t) { arguments->drained = is_drained; };
      return sub->add_flag_function(flag, choose, what);
    };
    drained("--drained", true, "Constant cell pressure [default]")
        ->excludes(drained("--undrained", false, "Constant volume"));
  }
  sub->add_option("--set", arguments->settings,
                  "Any quantity of the material, in its study unit; may be repeated")
      ->type_name("NAME=VALUE");
  number("--e0", arguments->e_0, "Initial void ratio [from D_r or the porosity]");
  number("--D_r_percent", arguments->D_r_percent, "Initial relative density of sand");
  number("--p0_kPa", arguments->p_0_kPa, "Initial stress, equal all round [100]");
  number("--sigma_v0_kPa", arguments->sigma_v0_kPa, "Initial axial stress");
  number("--sigma_h0_kPa", arguments->sigma_h0_kPa, "Initial radial stress");
  number("--p_i_kPa", arguments->p_i_kPa, "Initial image pressure of sand [yield surface and OCR]");
  number("--strain_percent", arguments->strain_percent, "Axial strain at the end, natural [25]")
      ->check(CLI::Range(1.0e-6, 1.0e6).description(""));
  number("--max_sigma_v_kPa", arguments->max_sigma_v_kPa, "End where the axial stress passes this");
  sub->add_option("--steps", arguments->steps,
                  "Rows of the result [250]; each is integrated in small increments")
      ->type_name("N")
      ->check(CLI::Range(1, 10'000'000).description(""));
  sub->add_option("--csv", arguments->csv, "Write all rows to this file instead of printing some")
      ->type_name("FILE");
  sub->footer(
      "Columns: axial and volumetric strain (natural, compression positive), q, p, void ratio,\n"
      "state parameter psi where the law has a critical state line, and what else the law keeps:\n"
      "of NorSand the image pressure p_i.");
  sub->callback([arguments, &action] { action = [arguments] { return element(*arguments); }; });
}

}  // namespace

void add_element(CLI::App& program, Action& action) {
  CLI::App* command =
      program.add_subcommand("element", "Single-element test through the constitutive code of the push");
  command->require_subcommand(1);
  add_path(*command, "triaxial", "Axial compression at constant cell pressure, or at constant volume",
           solver::ElementPath::triaxial, action);
  add_path(*command, "oedometer", "Axial compression without radial strain", solver::ElementPath::oedometer,
           action);
  add_path(*command, "isotropic", "Compression with equal strain all round", solver::ElementPath::isotropic,
           action);
  add_calibrate(*command, action);
  command->footer(R"(Examples:
  campaign element triaxial --D_r_percent 80 --p0_kPa 320 --csv dense.csv
  campaign element triaxial --undrained --material clay --set clay.s_u_kPa=33.5
  campaign element oedometer --sigma_v0_kPa 20 --max_sigma_v_kPa 10000 --set sand.H=75
  campaign element calibrate dense_160kPa.csv loose_40kPa.csv --csv H.csv)");
}

}  // namespace cpt::cli
