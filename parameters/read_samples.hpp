// A table of samples made elsewhere: a row an evaluation, a column an input or a response.
//
//   name,sand.D_r_percent,sand.H,deep.q_c_mean_kPa
//   loose,28,25,1840.2
//   dense,46,25,
//
// Columns are quantities of the one list in their study units, averages of q_c in the study's windows
// (WINDOW.q_c_mean_kPa, and WINDOW.q_c_min_kPa and WINDOW.q_c_max_kPa where they are known), and name, status
// and reason. Inputs without a column are the study's baseline. Dakota's eval_id names a row that has no
// name; its interface, and the number that an export gives a realization, are not read. An average that is
// empty or NaN is none: a row without any is one that failed.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "parameters/field_table.hpp"
#include "parameters/study.hpp"
#include "parameters/study_error.hpp"

namespace cpt::parameters {

/// q_c over a window [kPa]; NaN where the table does not say.
struct WindowResponse {
  double mean, min, max;
};

struct Sample {
  std::string name;  ///< unique in the table
  Place place;
  std::vector<Change> changes;            ///< one for each column of an input
  std::string status;                     ///< "pending", "completed", or how it failed
  std::string reason;                     ///< of a failure
  std::vector<WindowResponse> responses;  ///< one for each window of the study
};

struct SampleColumns {
  struct Name {
    std::string meaning;  ///< as above: "sand.H", "deep.q_c_mean_kPa", "name" ...
    std::string column;   ///< what the table calls it
  };
  std::vector<Name> names;
  std::vector<std::string> ignored;  ///< columns that are not read
  bool responses = true;             ///< false: averages, status and reason are not read
};

using SamplesOrErrors = std::variant<std::vector<Sample>, std::vector<StudyError>>;

/// The samples, or what is wrong with the table, up to 20 errors. Never throws for what the table says.
[[nodiscard]] SamplesOrErrors read_samples(const FieldTable& table, const Study& study,
                                           const SampleColumns& columns);

/// Those samples whose inputs are not those of a realization that the study has.
[[nodiscard]] std::vector<Sample> new_samples(const Study& study, const std::vector<Sample>& samples);

/// The study's text with each sample as one of its [[points]].
[[nodiscard]] std::string with_points(const std::string& study_text, const std::vector<Sample>& samples);

}  // namespace cpt::parameters
