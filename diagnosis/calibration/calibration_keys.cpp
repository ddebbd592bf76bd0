#include "diagnosis/calibration/calibration_keys.hpp"

namespace cpt::diagnosis {
namespace {

std::vector<parameters::KeyTable> listed_calibration_tables() {
  return {
      {"",
       false,
       "the top of the file",
       {{"title", "text", "the file's name", "name of the calibration in its figures"},
        {"study", "path", "required", "study with the parameters, their distributions and the runs"},
        {"channels", "array of names", "all that study and recordings have",
         "what is compared: q_c, f_s (`campaign list channels`)"}}},
      {"soundings",
       true,
       "a recording in the study's soil; at least one, and all have the same parameters",
       {{"name", "text", "the recording's name", "name of the sounding in tables and figures"},
        {"recording", "path", "required", "file with the measured sounding"},
        {"columns", "{ QUANTITY = \"NAME\" }", "columns named as quantities",
         "CSV alone: which column is what (recordings.md)"},
        {"from_m", "number, from 0.03", "required", "depth where the comparison begins [m]"},
        {"to_m", "number", "required", "depth where it ends [m]; at most the end of the study's push"}}},
      {"noise",
       false,
       "what is known of the recordings' noise, white over depth",
       {{"measurement_percent", "number above 0", "found, with a half-normal prior of 1 %",
         "standard deviation of a cell of q_c, relative [%]; of f_s three times as much", 0.0, 100.0}}},
      {"discrepancy",
       false,
       "what a simulation with the true parameters may be off, a smooth curve over depth",
       {{"deviation_percent", "number above 0", "5",
         "scale of the half-normal prior of its standard deviation, relative [%]", 0.0, 1000.0},
        {"correlation_mm", "number above 0", "five diameters of the cone",
         "its correlation length over depth [mm]"}}},
      {"options",
       false,
       "how much is computed",
       {{"cell_mm", "number above 0", "5",
         "spacing of the depth grid [mm]; a sounding has at most 2000 cells", 0.0, 1000.0},
        {"chains", "whole number", "4", "chains of the sampler", 4.0, 32.0},
        {"seed", "whole number", "1", "of all random numbers", 0.0, 1e15}}},
  };
}

}  // namespace

std::span<const parameters::KeyTable> calibration_keys() {
  static const std::vector<parameters::KeyTable> tables = listed_calibration_tables();
  return tables;
}

}  // namespace cpt::diagnosis
