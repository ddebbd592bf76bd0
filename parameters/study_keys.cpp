#include "parameters/study_keys.hpp"

#include "parameters/designs/design.hpp"
#include "solver/presets.hpp"
#include "solver/soils/law.hpp"

namespace cpt::parameters {
namespace {

template <class Enum>
std::vector<std::string_view> names_of(std::span<const Enum> values) {
  std::vector<std::string_view> names;
  for (const Enum value : values) names.push_back(solver::to_string(value));
  return names;
}

std::vector<std::string_view> law_names() {
  std::vector<std::string_view> names;
  for (const solver::Law* law : solver::all_laws()) names.push_back(law->name());
  return names;
}

std::vector<KeyTable> listed_tables() {
  constexpr double least = -std::numeric_limits<double>::infinity();
  constexpr double most = std::numeric_limits<double>::infinity();
  return {
      {"",
       false,
       "the top of the file",
       {{"title", "text", "the file's name", "name of the study in its report"},
        {"profile", "text", "required but for [solver]", "soil and chamber to start from", least, most,
         names_of(solver::all_profiles())},
        {"preset", "text", "standard", "resolution of the model", least, most,
         names_of(solver::all_presets())},
        {"repeats", "even number", "none",
         "runs of the baseline with shifted material points: their scatter is noise", 2.0, 20.0},
        {"paired_repeats", "names of rows", "none",
         "rows whose bounds are run with the shifts of the repeats, too: the scatter of their index gives "
         "its interval"}}},
      {"output",
       false,
       "where results go; relative paths start at the study's folder",
       {{"database", "path", "NAME.sqlite", "ledger of all realizations"},
        {"curves", "path", "NAME.h5", "curves as HDF5"},
        {"report", "path", "NAME-report", "folder of the report"}}},
      {"limits",
       false,
       "what a realization may take",
       {{"wall_minutes", "number above 0", "no limit",
         "wall-clock time after which one realization is ended"},
        {"hang_minutes", "number above 0", "no limit", "of [solver]: time without a byte written"},
        {"most_megabytes", "number above 0", "64", "of [solver]: what one realization may write"},
        {"retries", "whole number", "0", "of [solver]: further tries after a crash", 0.0, 10.0}}},
      {"solver",
       false,
       "another program in place of the embedded solver (external-solvers.md)",
       {{"command", "array of texts", "required",
         "the program and its arguments; words that name a file beside the study become its path"},
        {"version", "text or array of texts", "none",
         "version of the program, or a command that prints it; with another one, stored results are not "
         "used"},
        {"template", "path", "none", "file that is handed over with {{NAME}} filled in for each input"},
        {"results", "path", "standard output", "file in the work folder with the results: JSON or CSV"},
        {"keep_work", "true or false", "false", "keep the work folders of completed realizations, too"}}},
      {"solver.inputs",
       false,
       "its inputs: NAME = { one row }, or NAME = its usual value",
       {{"default", "number", "required", "value where the study gives no other"},
        {"unit", "text", "-", "unit, for tables and figures"},
        {"min", "number", "none", "least valid value"},
        {"max", "number", "none", "largest valid value"},
        {"integer", "true or false", "false", "whether it must be whole"},
        {"meaning", "text", "none", "one line"}}},
      {"solver.outputs",
       false,
       "what it gives: NAME = { one row }; a scalar, or with over a curve",
       {{"unit", "text", "-", "unit, for tables and figures"},
        {"over", "text", "none: a scalar", "name of the abscissa, a column of the results"},
        {"over_unit", "text", "-", "unit of the abscissa"},
        {"meaning", "text", "none", "one line"}}},
      {"soils",
       false,
       "soils by name, in place of sand (norsand) and clay (tresca): [soils.NAME], each in some layer; their "
       "quantities are "
       "NAME.parameter (laws.md)",
       {{"law", "text", "required", "the constitutive law", least, most, law_names()}}},
      {"fixed", false, "quantities in place of the preset's value: \"NAME\" = VALUE", {}},
      {"parameters",
       false,
       "uncertain quantities, each varied alone: \"NAME\" = { one row }",
       {{"baseline", "value of the quantity", "that of [fixed] or the preset",
         "value while others are varied"},
        {"lower", "value of the quantity", "the baseline", "lower bound, at most the baseline"},
        {"upper", "value of the quantity", "the baseline", "upper bound, at least the baseline"},
        {"alternative", "value of the quantity", "none", "one other value, in place of lower and upper"},
        {"distribution", "table", "none",
         "how likely which values are; without them the baseline is its median, lower and upper its 5 and 95 "
         "% "
         "quantiles"},
        {"field", "{ standard_deviation or cv, correlation_length_m, kind }", "none",
         "it varies over depth about the baseline as a random field, lognormal or normal; propagation and "
         "sobol draw "
         "one for every run"}}},
      {"points",
       true,
       "a realization with several quantities changed at once: \"NAME\" = VALUE",
       {{"name", "text", "required", "name of the realization, unique in the study"}}},
      {"design",
       false,
       "further runs that change several rows at once (designs.md)",
       {{"kind", "text", "required", "which design", least, most, design_kinds()},
        {"runs", "whole number", "10 for each parameter; of sobol 64, of propagation 100",
         "latin_hypercube, propagation: runs; sobol: rows of its two samples", 2.0, 20000.0},
        {"first_runs", "whole number", "as many as runs",
         "latin_hypercube: runs before it grew; they stay, and the others fill the gaps", 2.0, 20000.0},
        {"sections", "whole number", "1",
         "sobol: independent samples that its rows are dealt to, 5 or more of 4 rows at least; intervals "
         "then come from how far they differ",
         1.0, 100.0},
        {"estimator",
         "text",
         "saltelli",
         "sobol: saltelli (with Jansen's total order) or martinez (correlations)",
         least,
         most,
         {"saltelli", "martinez"}},
        {"trajectories", "whole number", "10", "morris: paths through the parameters", 2.0, 1000.0},
        {"levels", "even number", "4", "morris: levels of its grid", 2.0, 20.0},
        {"seed", "whole number", "1", "of its points and of its bootstrap; not for pairs", 0.0, 1e15},
        {"parameters", "array of names", "all rows; of pairs the first four",
         "rows of [parameters] that vary together"},
        {"sampling",
         "text",
         "low_discrepancy",
         "propagation: Sobol' points with random shifts, or Latin hypercubes of ten runs each",
         least,
         most,
         {"low_discrepancy", "latin_hypercube"}},
        {"until", "{ quantile = P, half_width_percent = X }", "none",
         "propagation: ends, at most after `runs` (without it 1000), once the 95 % interval of that "
         "quantile, without one "
         "of the mean, is at most X % to either side in every window"},
        {"numerical_error_percent", "{ CHANNEL = X }", "none",
         "propagation: a normal error of each run's q_c, f_s or wall_stress, of X % of its value in standard "
         "deviation (0 to 100), in standard deviation, quantiles, exceedance and bands"},
        {"shift_points", "true or false", "false",
         "propagation, sobol: every run draws where its material points lie about their grid, so that its "
         "results scatter as those of another mesh would"}}},
      {"correlation",
       false,
       "rank correlations of rows with distributions that [design] draws together: \"NAME\" = { \"OTHER\" = "
       "RHO }",
       {}},
      {"windows",
       true,
       "a depth interval over which q_c is averaged; at least one",
       {{"name", "text of letters, digits, _ and -", "required", "name of the window, unique in the study"},
        {"from_m", "number", "required without centre", "upper end of the interval [m]"},
        {"to_m", "number", "required without centre", "lower end of the interval [m]"},
        {"centre",
         "text",
         "none",
         "extreme of the baseline's q_c at the middle of the interval; inside between_m, not at an end of it",
         least,
         most,
         {"baseline_peak", "baseline_trough"}},
        {"between_m", "array of two numbers", "required with centre",
         "depths between which the extreme is looked for [m]"},
        {"width_m", "number above 0", "required with centre", "width of the interval [m]"},
        {"thresholds_kPa", "array of numbers, rising", "none",
         "average q_c: propagation tells the probability that it is exceeded"},
        {"output", "text", "required with [solver]",
         "curve of [solver.outputs] that is averaged, in place of q_c"},
        {"from", "number", "required with output", "lower end of the interval, in the unit of the abscissa"},
        {"to", "number", "required with output", "upper end of the interval"}}},
      {"data",
       false,
       "columns of CSV files that empirical distributions are made of, so that the study is whole without "
       "them; the "
       "database's copy of the study has it: [data.\"FILE.csv\"], COLUMN = [numbers]",
       {}},
      {"layers",
       true,
       "a layer in place of the profile's; all of them, from the top, without gaps",
       {{"top_m", "number", "required", "depth of its top [m]"},
        {"bottom_m", "number", "required", "depth of its bottom [m]"},
        {"soil", "text", "required", "what it consists of: a soil of [soils], else sand or clay"}}},
      {"zones",
       true,
       "a radial zone of material points in place of the preset's; all of them, from the axis",
       {{"outer_radius_m", "number", "required", "where it ends [m]"},
        {"columns", "whole number", "required", "columns of material points in it", 1.0, 5000.0},
        {"rows_per_m", "number", "required", "rows of material points per metre of depth", 1.0, 20000.0}}},
  };
}

}  // namespace

std::span<const KeyTable> study_keys() {
  static const std::vector<KeyTable> tables = listed_tables();
  return tables;
}

}  // namespace cpt::parameters
