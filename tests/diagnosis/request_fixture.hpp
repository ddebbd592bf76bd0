// A quick study of sand and a request for its diagnosis.
#pragma once

#include <gtest/gtest.h>

#include "diagnosis/read_request.hpp"
#include "parameters/read_study.hpp"

namespace cpt::diagnosis {

inline parameters::Study quick_sand() {
  auto study = parameters::parse_study(
      "profile = \"homogeneous_sand\"\npreset = \"quick\"\n[fixed]\n\"penetrometer.final_depth_m\" = 0.30\n"
      "[parameters]\n\"sand.D_r_percent\" = { baseline = 36, lower = 26, upper = 46 }\n"
      "\"sand.H\" = { baseline = 25, upper = 75 }\n\"initial.sigma_v0_kPa\" = { baseline = 50, lower = 45, "
      "upper = 55 }\n"
      "[[windows]]\nname = \"w\"\nfrom_m = 0.2\nto_m = 0.22\n",
      "/studies/sand.toml");
  if (const auto* errors = std::get_if<std::vector<parameters::StudyError>>(&study))
    ADD_FAILURE() << format(*errors);
  return std::get<parameters::Study>(std::move(study));
}

inline const std::string sounding = "[[soundings]]\nrecording = \"first.csv\"\nfrom_m = 0.04\nto_m = 0.28\n";

inline std::vector<parameters::StudyError> errors_of(const std::string& toml) {
  const RequestOrErrors parsed = parse_request(toml, "/requests/d.toml", quick_sand());
  const auto* errors = std::get_if<std::vector<parameters::StudyError>>(&parsed);
  return errors != nullptr ? *errors : std::vector<parameters::StudyError>();
}

inline Request request_of(const std::string& toml) {
  RequestOrErrors parsed = parse_request(toml, "/requests/d.toml", quick_sand());
  if (const auto* errors = std::get_if<std::vector<parameters::StudyError>>(&parsed)) {
    ADD_FAILURE() << format(*errors);
    return {};
  }
  return std::get<Request>(std::move(parsed));
}

}  // namespace cpt::diagnosis
