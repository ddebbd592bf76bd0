// campaign element calibrate DATA.csv ...
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <optional>

#include "cli/command.hpp"
#include "cli/common/cells.hpp"
#include "cli/common/input_kind.hpp"
#include "cli/common/set_quantity.hpp"
#include "cli/common/study_argument.hpp"
#include "cli/exit_codes.hpp"
#include "parameters/calibration/hardening.hpp"
#include "parameters/calibration/read_triaxial_curve.hpp"
#include "parameters/calibration/trend.hpp"
#include "results/tables/table_format.hpp"
#include "solver/presets.hpp"

namespace cpt::cli {
namespace {

constexpr double percent = 0.01;  // [-]

struct CalibrateArguments {
  std::vector<std::filesystem::path> files;
  std::vector<std::string> settings;                // name=value
  std::optional<double> D_r_percent, e_0, p_0_kPa;  // in place of the files'
  calibration::HardeningOptions options;
  std::filesystem::path csv;
};

// What the command line says of density and stress holds for every file. Throws BadInput with all that is
// wrong with all files.
std::vector<calibration::TriaxialCurve> read_curves(const CalibrateArguments& arguments) {
  if (arguments.D_r_percent && arguments.e_0) throw BadInput("give either --D_r_percent or --e0");
  std::vector<calibration::TriaxialCurve> curves;
  std::vector<calibration::CurveProblem> problems;
  std::string told;  // of files that cannot be read
  for (const std::filesystem::path& file : arguments.files) {
    std::string text;
    try {
      text = read_input(InputKind::triaxial_test, file);
    } catch (const BadInput& unreadable) {
      told += unreadable.what() + std::string("\n");
      continue;
    }
    auto read = calibration::parse_triaxial_curve(text, file);
    if (const auto* found = std::get_if<std::vector<calibration::CurveProblem>>(&read)) {
      problems.insert(problems.end(), found->begin(), found->end());
      continue;
    }
    auto& curve = std::get<calibration::TriaxialCurve>(read);
    if (arguments.D_r_percent || arguments.e_0) {
      curve.D_r = arguments.D_r_percent ? *arguments.D_r_percent * percent : calibration::not_given;
      curve.e_0 = arguments.e_0.value_or(calibration::not_given);
    }
    if (arguments.p_0_kPa) curve.p_0 = *arguments.p_0_kPa * kPa;
    if (std::isnan(curve.p_0))
      problems.push_back({file.string(), 0, 0, "no stress: add '# p0_kPa = X' or give --p0_kPa"});
    if (std::isnan(curve.D_r) && std::isnan(curve.e_0))
      problems.push_back(
          {file.string(), 0, 0,
           "no density: add '# D_r_percent = X' or '# e0 = X', or give --D_r_percent or --e0"});
    curves.push_back(std::move(curve));
  }
  told += calibration::format(problems);
  while (told.ends_with('\n')) told.pop_back();
  if (!told.empty()) throw BadInput(told);
  return curves;
}

results::Table fit_table(const std::vector<calibration::TriaxialCurve>& curves,
                         const std::vector<calibration::HardeningFit>& fits) {
  results::Table table{{"test", "p0_kPa", "e0", "psi_0", "H", "matched_to_percent", "readings", "E_test_MPa",
                        "E_sand_MPa", "misfit_q_percent", "misfit_eps_v_percent", "note"},
                       {}};
  for (std::size_t i = 0; i < fits.size(); ++i) {
    const calibration::HardeningFit& f = fits[i];
    table.rows.push_back({curves[i].name, cell(f.p_0 / kPa), cell(f.e_0), cell(f.psi_0), cell(f.H),
                          cell(f.eps_a / percent), std::int64_t{f.readings}, cell(f.E_test * 1e-6),
                          cell(f.E_sand * 1e-6), cell(f.misfit / percent), cell(f.eps_v_misfit / percent),
                          f.problem});
  }
  return table;
}

void print_trends(const std::vector<calibration::HardeningFit>& fits) {
  if (const auto t = calibration::hardening_trend(fits, calibration::TrendIn::psi))
    fmt::print("H = {:.4g} {:+.4g} psi_0    (R2 = {:.3f}, {} tests)\n", t->H_0, t->by_psi, t->r_squared,
               t->tests);
  if (const auto t = calibration::hardening_trend(fits, calibration::TrendIn::psi_and_p))
    fmt::print("H = {:.4g} {:+.4g} psi_0 {:+.4g} ln(p0 / 100 kPa)    (R2 = {:.3f}, {} tests)\n", t->H_0,
               t->by_psi, t->by_p, t->r_squared, t->tests);
}

int calibrate(const CalibrateArguments& arguments) {
  if (arguments.options.H_lower >= arguments.options.H_upper)
    throw BadInput("--H_lower must be less than --H_upper");
  solver::Setup setup = solver::make_setup(solver::Profile::homogeneous_sand, solver::Preset::standard);
  for (const std::string& setting : arguments.settings) set_quantity(setup, setting, "sand.");
  const auto curves = read_curves(arguments);
  std::vector<calibration::HardeningFit> fits;
  for (const calibration::TriaxialCurve& curve : curves)
    fits.push_back(calibration::fit_hardening(
        curve, solver::as<solver::NorSandParameters>(setup.soils[solver::default_sand]), arguments.options));

  const results::Table table = fit_table(curves, fits);
  fmt::print("{}", results::format(table, results::Format::table));
  print_trends(fits);
  if (!arguments.csv.empty()) results::write_csv(arguments.csv, table);
  for (const calibration::HardeningFit& fit : fits)
    if (std::isnan(fit.H)) throw BadInput("not every test gave an H: see the notes");
  return all_well;
}

}  // namespace

void add_calibrate(CLI::App& element, Action& action) {
  auto arguments = std::make_shared<CalibrateArguments>();
  CLI::App* sub = element.add_subcommand(
      "calibrate", "Find NorSand's H from drained triaxial tests by matching their initial stiffness");
  const auto number = [sub](const char* option, auto& value, const char* what) {
    return sub->add_option(option, value, what)->type_name("X");
  };
  sub->add_option("DATA.csv", arguments->files, "Measured curves, one test a file")
      ->type_name("")
      ->required();
  number("--p0_kPa", arguments->p_0_kPa, "Stress before shearing, equal all round [the file's]")
      ->check(CLI::Range(0.01, 1.0e5).description(""));
  number("--D_r_percent", arguments->D_r_percent, "Relative density before shearing [the file's]")
      ->check(CLI::Range(0.0, 120.0).description(""));
  number("--e0", arguments->e_0, "Void ratio before shearing, in place of D_r [the file's]")
      ->check(CLI::Range(0.1, 3.0).description(""));
  sub->add_option("--set", arguments->settings,
                  "Any other quantity of the sand, in its study unit; may be repeated")
      ->type_name("NAME=VALUE");
  number("--fraction", arguments->options.fraction,
         "The curve is matched up to this part of its largest q [0.5]")
      ->check(CLI::Range(0.05, 1.0).description(""));
  number("--H_lower", arguments->options.H_lower, "Least H that is tried [1]")
      ->check(CLI::Range(0.1, 1.0e5).description(""));
  number("--H_upper", arguments->options.H_upper, "Largest H that is tried [2000]")
      ->check(CLI::Range(0.1, 1.0e5).description(""));
  sub->add_option("--csv", arguments->csv, "Write the table to this file too, with all digits")
      ->type_name("FILE");
  sub->footer(R"(A file:
  # test = dense, 160 kPa
  # D_r_percent = 80
  # p0_kPa = 160
  eps_a_percent,q_kPa,eps_v_percent
  0.00,0.0,0.00
  0.25,212.4,0.05
Strains are engineering strains, compression-positive; eps_v_percent may be missing. All other parameters stay at
Table 2 of Yost et al. (2023), or as --set says. eps_v plays no part in the search: its misfit is a check.)");
  sub->callback([arguments, &action] { action = [arguments] { return calibrate(*arguments); }; });
}

}  // namespace cpt::cli
