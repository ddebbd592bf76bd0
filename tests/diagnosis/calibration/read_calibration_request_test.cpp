#include "diagnosis/calibration/read_calibration_request.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "diagnosis/calibration/calibration_keys.hpp"
#include "tests/diagnosis/request_fixture.hpp"

namespace cpt::diagnosis {
namespace {

const std::string calibration = "study = \"sand.toml\"\n";

std::vector<parameters::StudyError> calibration_errors(const std::string& toml) {
  const auto parsed = parse_calibration_request(toml, "/requests/c.toml", quick_sand());
  const auto* errors = std::get_if<std::vector<parameters::StudyError>>(&parsed);
  return errors != nullptr ? *errors : std::vector<parameters::StudyError>();
}

TEST(ReadCalibrationRequest, DefaultsAndWhatIsWritten) {
  const auto plain = parse_calibration_request(calibration + sounding, "/requests/c.toml", quick_sand());
  ASSERT_TRUE(std::holds_alternative<CalibrationRequest>(plain))
      << format(std::get<std::vector<parameters::StudyError>>(plain));
  const auto& request = std::get<CalibrationRequest>(plain);
  EXPECT_EQ(request.study, "/studies/sand.toml");
  EXPECT_EQ(request.folder, "/requests/c-calibration");
  EXPECT_EQ(request.soundings.at(0).recording, "/requests/first.csv");
  EXPECT_EQ(request.channels.size(), 2U);
  EXPECT_FALSE(request.noise_is_known);
  EXPECT_NEAR(request.discrepancy_length, 5.0 * 0.0253, 1e-12);

  const auto full = parse_calibration_request(
      "title = \"T\"\nchannels = [\"f_s\", \"q_c\"]\n" + calibration + sounding +
          "[noise]\nmeasurement_percent = 2\n[discrepancy]\ndeviation_percent = 7\ncorrelation_mm = 50\n"
          "[options]\ncell_mm = 4\nchains = 6\nseed = 12\n",
      "/requests/c.toml", quick_sand());
  ASSERT_TRUE(std::holds_alternative<CalibrationRequest>(full));
  const auto& written = std::get<CalibrationRequest>(full);
  EXPECT_EQ(written.channels.at(0)->name, "q_c");
  EXPECT_TRUE(written.noise_is_known);
  EXPECT_DOUBLE_EQ(written.noise, 0.02);
  EXPECT_DOUBLE_EQ(written.discrepancy, 0.07);
  EXPECT_DOUBLE_EQ(written.discrepancy_length, 0.05);
  EXPECT_DOUBLE_EQ(written.cell_height, 0.004);
  EXPECT_EQ(written.chains, 6);
  EXPECT_EQ(written.seed, 12U);
}

TEST(ReadCalibrationRequest, ErrorsNameLineKeyValueAndRange) {
  struct Case {
    std::string toml, key, message;
  };
  const std::string sound = calibration + sounding;
  for (const Case& bad :
       {Case{calibration, "soundings", "is missing"}, Case{sounding, "study", "is missing"},
        Case{"channels = [\"wall_stress\"]\n" + sound, "channels", "not measured by a sounding"},
        Case{"channels = []\n" + sound, "channels", "must be a list"},
        Case{sound + "[noise]\nmeasurement_percent = 0\n", "noise.measurement_percent",
             "above 0 and at most 100"},
        Case{sound + "[discrepancy]\ncorrelation_mm = -5\n", "discrepancy.correlation_mm",
             "-5 must be above 0"},
        Case{sound + "[options]\nchains = 3\n", "options.chains", "3 must be a whole number from 4 to 32"},
        Case{sound + "[options]\ncell_mm = 1e-9\n", "options.cell_mm", "at most 2000 are possible"},
        Case{sound + "[options]\nseed = 1.5\n", "options.seed", "whole number"},
        Case{sound + "fixed = { \"initial.sigma_v0_kPa\" = 60 }\n", "soundings.fixed",
             "study's soil and stress"},
        Case{sound + sounding, "soundings.name", "given twice"},
        Case{"mechanisms = [\"worn_cone\"]\n" + sound, "mechanisms", "unknown key"},
        Case{calibration + "[[soundings]]\nrecording = \"a.csv\"\nfrom_m = 0.04\nto_m = 0.4\n",
             "soundings.to_m", "below the end of the study's push"}}) {
    const auto errors = calibration_errors(bad.toml);
    ASSERT_EQ(errors.size(), 1U) << bad.toml << format(errors);
    EXPECT_EQ(errors[0].key, bad.key) << format(errors);
    EXPECT_NE(errors[0].message.find(bad.message), std::string::npos) << format(errors);
  }
}

TEST(ReadCalibrationRequest, TheReaderReadsEveryKeyOfTheList) {
  for (const parameters::KeyTable& table : calibration_keys())
    for (const parameters::Key& key : table.keys) {
      const std::string entry = std::string(key.name) + " = 1979-05-27\n";  // what no key takes
      const std::string head =
          (table.list ? "[[" : "[") + std::string(table.name) + (table.list ? "]]\n" : "]\n");
      const auto errors =
          table.name.empty() ? calibration_errors(entry + (key.name == "study" ? "" : calibration) + sounding)
                             : calibration_errors(calibration + sounding + head + entry);
      EXPECT_TRUE(std::ranges::any_of(errors,
                                      [&](const auto& error) {
                                        return error.key.ends_with(key.name) &&
                                               error.message.starts_with("must be");
                                      }))
          << table.name << "." << key.name << "\n"
          << format(errors);
    }
}

}  // namespace
}  // namespace cpt::diagnosis
