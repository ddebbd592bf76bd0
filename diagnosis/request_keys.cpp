#include "diagnosis/request_keys.hpp"

namespace cpt::diagnosis {
namespace {

std::vector<parameters::KeyTable> listed_tables() {
  constexpr double most_cases = 9999.0;
  return {
      {"",
       false,
       "the top of the file",
       {{"title", "text", "the file's name", "name of the diagnosis in its report"},
        {"study", "path", "required", "study with the parameters and bounds that are no missing physics"},
        {"mechanisms", "array of names", "all that act on the study's profile",
         "effects that may be missing: `campaign list mechanisms`"}}},
      {"soundings",
       true,
       "a recording that is held against the study; at least one",
       {{"name", "text", "the recording's name; in a plan required", "name of the sounding in the report"},
        {"recording", "path", "required; not in a plan", "file with the measured sounding"},
        {"columns", "{ QUANTITY = \"NAME\" }", "columns named as quantities",
         "CSV alone: which column is what (recordings.md)"},
        {"from_m", "number, from 0.03", "required", "depth where the comparison begins [m]"},
        {"to_m", "number", "required", "depth where it ends [m]; at most the end of the study's push"},
        {"fixed", "{ \"QUANTITY\" = VALUE }", "none",
         "what is known to differ from the study where this sounding was pushed"}}},
      {"candidates",
       true,
       "a push that could be made next, ranked where several effects explain the recordings",
       {{"name", "text", "required", "name of the push in the report"},
        {"from_m", "number, from 0.03", "required", "depth where its recording would begin [m]"},
        {"to_m", "number", "required", "depth where it would end [m]"},
        {"fixed", "{ \"QUANTITY\" = VALUE }", "none", "what would be different from the study"}}},
      {"noise",
       false,
       "what is known of the recordings' noise",
       {{"measurement_percent", "number above 0", "from the recording's high-pass part",
         "standard deviation of the noise, relative to q_c [%]"},
        {"correlation_mm", "number above 0", "10", "its correlation length, with measurement_percent [mm]"},
        {"cone_class", "whole number", "no noise beside the percentage, faults of class 2",
         "application class of the cone, ISO 22476-1: its resolution in kPa, and how far its zero may be off",
         1.0, 4.0},
        {"simulated", "true or false", "false",
         "the recordings are simulations, with numerical noise of their own"}}},
      {"options",
       false,
       "how much is computed",
       {{"cell_mm", "number above 0", "5", "spacing of the depth grid [mm]"},
        {"repeats", "whole number", "8", "runs of the baseline with other points, meshes and time steps", 3.0,
         1000.0},
        {"joint", "whole number", "12", "runs that change all parameters of the study at once", 0.0, 1000.0},
        {"confirm", "whole number", "3", "mechanisms that are run fitted in the full solver", 0.0, 1000.0},
        {"seed", "whole number", "1", "of the bootstraps", 0.0, 1e15}}},
      {"cases",
       false,
       "plans alone: how many cases of which kind (`campaign conceal`)",
       {{"nothing", "whole number", "0", "with the study's parameters only", 0.0, most_cases},
        {"single", "whole number", "0", "with one mechanism of the catalogue", 0.0, most_cases},
        {"pair", "whole number", "0", "with two of them", 0.0, most_cases},
        {"outside", "whole number", "0", "with an effect that no mechanism has", 0.0, most_cases},
        {"two_soundings", "whole number", "0", "of all these, with the second [[soundings]] too", 0.0,
         most_cases}}},
  };
}

}  // namespace

std::span<const parameters::KeyTable> request_keys() {
  static const std::vector<parameters::KeyTable> tables = listed_tables();
  return tables;
}

}  // namespace cpt::diagnosis
