// campaign element calibrate DATA.csv ...
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "cli/command.hpp"
#include "cli/common/cells.hpp"
#include "cli/common/input_kind.hpp"
#include "cli/common/set_quantity.hpp"
#include "cli/common/study_argument.hpp"
#include "cli/exit_codes.hpp"
#include "cli/soils/fit_plot.hpp"
#include "cli/soils/joint_fit_tables.hpp"
#include "parameters/calibration/hardening.hpp"
#include "parameters/calibration/joint_fit.hpp"
#include "parameters/calibration/read_oedometer_curve.hpp"
#include "parameters/calibration/read_triaxial_curve.hpp"
#include "parameters/calibration/trend.hpp"
#include "parameters/nearest_name.hpp"
#include "reports/figure_files.hpp"
#include "reports/picture_files.hpp"
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
  std::string fit;  // "all" or names between commas; empty: H of each test
  std::filesystem::path csv, toml, plot;
};

// What the command line says of density and stress holds for every triaxial test.
void complete(const CalibrateArguments& arguments, const std::filesystem::path& file,
              calibration::TriaxialCurve& curve, std::vector<calibration::CurveProblem>& problems) {
  if (arguments.D_r_percent || arguments.e_0) {
    curve.D_r = arguments.D_r_percent ? *arguments.D_r_percent * percent : calibration::not_given;
    curve.e_0 = arguments.e_0.value_or(calibration::not_given);
  }
  if (arguments.p_0_kPa) curve.p_0 = *arguments.p_0_kPa * kPa;
  if (std::isnan(curve.p_0))
    problems.push_back({file.string(), 0, 0, "no stress: add '# p0_kPa = X' or give --p0_kPa"});
  if (std::isnan(curve.D_r) && std::isnan(curve.e_0))
    problems.push_back({file.string(), 0, 0,
                        "no density: add '# D_r_percent = X' or '# e0 = X', or give --D_r_percent or --e0"});
}

// Throws BadInput with all that is wrong with all files.
calibration::LaboratoryTests read_tests(const CalibrateArguments& arguments) {
  if (arguments.D_r_percent && arguments.e_0) throw BadInput("give either --D_r_percent or --e0");
  calibration::LaboratoryTests tests;
  std::vector<calibration::CurveProblem> problems;
  const auto sound = [&](auto&& read) {
    const auto* found = std::get_if<std::vector<calibration::CurveProblem>>(&read);
    if (found != nullptr) problems.insert(problems.end(), found->begin(), found->end());
    return found == nullptr;
  };
  std::string told;  // of files that cannot be read
  for (const std::filesystem::path& file : arguments.files) {
    std::string text;
    try {
      text = read_input(InputKind::triaxial_test, file);
    } catch (const BadInput& unreadable) {
      told += unreadable.what() + std::string("\n");
      continue;
    }
    if (calibration::is_oedometer_curve(text)) {
      if (arguments.fit.empty())
        problems.push_back(
            {file.string(), 0, 0, "is an oedometer test, which plays a part with --fit alone"});
      if (auto read = calibration::parse_oedometer_curve(text, file); sound(read))
        tests.oedometer.push_back(std::get<calibration::OedometerCurve>(std::move(read)));
    } else if (auto read = calibration::parse_triaxial_curve(text, file); sound(read)) {
      auto& curve = std::get<calibration::TriaxialCurve>(read);
      complete(arguments, file, curve, problems);
      tests.triaxial.push_back(std::move(curve));
    }
  }
  told += calibration::format(problems);
  while (told.ends_with('\n')) told.pop_back();
  if (!told.empty()) throw BadInput(told);
  return tests;
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

// H of each test by itself.
int fit_hardening_of_each(const CalibrateArguments& arguments,
                          const std::vector<calibration::TriaxialCurve>& curves,
                          const solver::NorSandParameters& sand) {
  std::vector<calibration::HardeningFit> fits;
  for (const calibration::TriaxialCurve& curve : curves)
    fits.push_back(calibration::fit_hardening(curve, sand, arguments.options));
  const results::Table table = fit_table(curves, fits);
  fmt::print("{}", results::format(table, results::Format::table));
  print_trends(fits);
  if (!arguments.csv.empty()) results::write_csv(arguments.csv, table);
  for (const calibration::HardeningFit& fit : fits)
    if (std::isnan(fit.H)) throw BadInput("not every test gave an H: see the notes");
  return all_well;
}

std::vector<const calibration::FitParameter*> parameters_to_fit(const std::string& text) {
  std::vector<std::string_view> names;
  for (const calibration::FitParameter& parameter : calibration::fit_parameters())
    names.push_back(parameter.quantity->name);
  std::vector<const calibration::FitParameter*> free;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(',', from), text.size());
    const std::string name = text.substr(from, to - from);
    from = to + 1;
    if (name == "all") {
      for (const calibration::FitParameter& parameter : calibration::fit_parameters())
        free.push_back(&parameter);
    } else if (const auto* parameter = calibration::find_fit_parameter(name)) {
      free.push_back(parameter);
    } else {
      const std::string_view near = parameters::nearest_name(name, names);
      throw BadInput(fmt::format(
          "--fit {}: there is no parameter '{}' to fit{}; there are {}, or all of them: all", text, name,
          near.empty() ? "" : fmt::format("; did you mean {}?", near), fmt::join(names, ", ")));
    }
  }
  return free;
}

// All that is free, over all tests at once.
int fit_all_tests(const CalibrateArguments& arguments, const calibration::LaboratoryTests& tests,
                  const solver::NorSandParameters& sand) {
  const auto ending = arguments.plot.extension();
  if (!arguments.plot.empty() && ending != ".svg" && ending != ".png")
    throw BadInput(fmt::format("--plot {}: must end in .svg or .png", arguments.plot.string()));
  const calibration::JointFit fit = calibration::fit_jointly(tests, sand, parameters_to_fit(arguments.fit));
  const auto print = [](const results::Table& table) {
    if (!table.rows.empty()) fmt::print("{}\n", results::format(table, results::Format::table));
  };
  print(ends_table(fit));
  for (const calibration::FirstEstimate& estimate : fit.first.estimates)
    fmt::print("by hand {} = {:.4g}: {}\n", estimate.parameter->quantity->name, estimate.value, estimate.how);
  if (!fit.first.estimates.empty()) fmt::print("\n");
  const results::Table table = parameters_table(fit);
  print(table);
  if (!arguments.csv.empty()) results::write_csv(arguments.csv, table);
  if (!fit.problem.empty()) throw BadInput(fit.problem);
  print(correlation_table(fit));
  print(channels_table(fit));
  print(misfit_table(tests, fit));
  fmt::print("{}", verdict(fit));
  if (!arguments.toml.empty()) reports::write_text(arguments.toml, study_lines(fit));
  if (arguments.plot.empty()) return all_well;
  const std::string svg = fit_plot(tests, fit.sand);
  if (ending == ".png")
    reports::write_png(svg, arguments.plot);
  else
    reports::write_text(arguments.plot, svg);
  return all_well;
}

int calibrate(const CalibrateArguments& arguments) {
  if (arguments.options.H_lower >= arguments.options.H_upper)
    throw BadInput("--H_lower must be less than --H_upper");
  if (arguments.fit.empty() && !(arguments.toml.empty() && arguments.plot.empty()))
    throw BadInput("--toml and --plot need --fit");
  solver::Setup setup = solver::make_setup(solver::Profile::homogeneous_sand, solver::Preset::standard);
  for (const std::string& setting : arguments.settings) set_quantity(setup, setting, "sand.");
  const auto& sand = solver::as<solver::NorSandParameters>(setup.soils[solver::default_sand]);
  const calibration::LaboratoryTests tests = read_tests(arguments);
  return arguments.fit.empty() ? fit_hardening_of_each(arguments, tests.triaxial, sand)
                               : fit_all_tests(arguments, tests, sand);
}

}  // namespace

void add_calibrate(CLI::App& element, Action& action) {
  auto arguments = std::make_shared<CalibrateArguments>();
  CLI::App* sub = element.add_subcommand(
      "calibrate",
      "Find NorSand's parameters from drained triaxial and oedometer tests: H of each, or all at once");
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
  sub->add_option("--fit", arguments->fit,
                  "Fit these over all tests at once, e.g. H,N,chi_tc; all: every one that the tests tell "
                  "[H of each test by itself]")
      ->type_name("NAMES");
  sub->add_option("--toml", arguments->toml,
                  "With --fit: write distributions and correlations to this file, to paste in a study")
      ->type_name("FILE");
  sub->add_option("--plot", arguments->plot, "With --fit: measured and fitted curves, .svg or .png")
      ->type_name("FILE");
  number("--fraction", arguments->options.fraction,
         "H of each test: the curve is matched up to this part of its largest q [0.5]")
      ->check(CLI::Range(0.05, 1.0).description(""));
  number("--H_lower", arguments->options.H_lower, "Least H that is tried [1]")
      ->check(CLI::Range(0.1, 1.0e5).description(""));
  number("--H_upper", arguments->options.H_upper, "Largest H that is tried [2000]")
      ->check(CLI::Range(0.1, 1.0e5).description(""));
  sub->add_option("--csv", arguments->csv, "Write the table to this file too, with all digits")
      ->type_name("FILE");
  sub->footer(R"(A triaxial test, and an oedometer test (with --fit):
  # test = dense, 160 kPa               # test = oedometer, loose
  # D_r_percent = 80                    # K0 = 0.45
  # p0_kPa = 160                        sigma_v_kPa,e
  # G0_MPa = 85                         10,0.8120
  eps_a_percent,q_kPa,eps_v_percent     20,0.8101
  0.00,0.0,0.00                         40,0.8075
  0.25,212.4,0.05
Strains are engineering strains, compression-positive; eps_v_percent, the shear modulus at small strains G0_MPa (bender
elements) and K0 [0.5] may be missing. Loading alone is read. All other parameters stay at Table 2 of Yost et al.
(2023), or as --set says.
Without --fit: H of each test; eps_v plays no part in the search, its misfit is a check.
With --fit: which tests reach critical state, what the tests tell by hand, then least squares over all curves with 95 %
intervals and correlations; a parameter that the tests do not tell is kept as given (docs/laws.md).
  campaign element calibrate *.csv --fit all --plot fit.png --toml sand.toml)");
  sub->callback([arguments, &action] { action = [arguments] { return calibrate(*arguments); }; });
}

}  // namespace cpt::cli
