// Study file (TOML) -> Study. Every problem of the file is reported in one pass.
//
//   title = "Homogeneous sand"          # optional; default: the file's name
//   profile = "homogeneous_sand"        # required: homogeneous_sand, homogeneous_clay, layered_sand_clay
//   preset = "quick"                    # quick, standard (default), paper, fine
//   repeats = 6                         # optional: even, 2 to 20; the baseline with shifted points
//   paired_repeats = ["sand.H"]         # optional: rows whose bounds are run with the same shifts
//
//   [output]                            # optional; relative paths start at the study file's folder
//   database = "sand.sqlite"            # default NAME.sqlite for the study NAME.toml
//   curves = "sand.h5"                  # default NAME.h5
//   report = "sand-report"              # default NAME-report
//
//   [limits]                            # optional
//   wall_minutes = 30                   # > 0, for one realization; default: none
//
//   [fixed]                             # optional; any quantity, in place of the preset's value
//   "numerics.courant" = 0.7            # or courant = 0.7 under [fixed.numerics]
//
//   [parameters]                        # uncertain inputs, in the order of the report
//   "sand.phi_cs_deg" = { baseline = 30, lower = 29, upper = 31 }
//   "sand.H" = { baseline = 25, upper = 75 }      # one-sided: the lower bound is the baseline
//   "sand.nu" = { lower = 0.1, upper = 0.3 }      # baseline: that of the preset
//   "chamber.wall" = { baseline = "rigid", alternative = "flexible" }
//   "chamber.radius_m" = { baseline = 0.45, alternative = 0.30 }
//
//   [[points]]                          # optional: several inputs changed at once
//   name = "dense and hard"
//   "sand.H" = 75
//
//   [design]                            # optional: more runs beside one-at-a-time (docs/designs.md)
//   kind = "morris"                     # one_at_a_time (default), pairs, morris, latin_hypercube, sobol
//   trajectories = 10                   # also levels = 4; of latin_hypercube and sobol: runs
//   seed = 1
//   parameters = ["sand.nu", "sand.H"]  # that vary together; default: all, of pairs the first four
//
//   [[windows]]                         # at least one: where q_c is averaged
//   name = "sand"                       # letters, digits, _ and -
//   from_m = 0.5054
//   to_m = 0.5255
//
//   [[windows]]                         # one that the baseline's profile places
//   name = "embedded_sand"
//   centre = "baseline_peak"            # or "baseline_trough": its largest or smallest q_c ...
//   between_m = [0.285, 0.325]          # ... between these depths
//   width_m = 0.0023
//
//   [[layers]]                          # optional; in place of the profile's, from the top, without gaps
//   top_m = 0.0
//   bottom_m = 1.0
//   soil = "sand"                       # sand or clay
//
//   [[zones]]                           # optional; in place of the preset's radial zones of points
//   outer_radius_m = 0.06
//   columns = 70
//   rows_per_m = 325
//
// [solver] with its inputs and outputs stands in place of profile, preset, soils, layers and zones: another
// program (read_program.hpp).
//
// An alternative is the bound on its side of the baseline: the smaller number, or the choice listed first, is
// the lower bound. A bound equal to the baseline reuses the baseline's run. `campaign list quantities` prints
// every quantity with its unit, range and meaning.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "parameters/study.hpp"
#include "parameters/study_error.hpp"

namespace cpt::parameters {

/// The study, or everything that is wrong with it in the order of the file.
using StudyOrErrors = std::variant<Study, std::vector<StudyError>>;

/// Reads a study file. A file that cannot be read is an error at line 0. Never throws for what the file says.
[[nodiscard]] StudyOrErrors read_study(const std::filesystem::path& file);

/// Whether files that a study names are looked for.
enum class FilesBeside { read, left };

/// The same from text; `file` names the study, its folder and its results.
[[nodiscard]] StudyOrErrors parse_study(std::string_view toml, const std::filesystem::path& file,
                                        FilesBeside files = FilesBeside::read);

/// The same of a text that a ledger keeps: no file beside it is looked for, so that an external program lacks
/// its template.
[[nodiscard]] inline StudyOrErrors parse_stored_study(std::string_view toml, const std::string& name) {
  return parse_study(toml, name + ".toml", FilesBeside::left);
}

}  // namespace cpt::parameters
