// The data that a study takes from CSV files: put into the study's own text, so that a copy of it is whole.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "parameters/document.hpp"
#include "parameters/field_table.hpp"
#include "parameters/fields.hpp"

namespace cpt::parameters {

/// A CSV file that empirical distributions are made of.
struct WantedFile {
  std::string file;                  ///< as the study has it
  Place place;                       ///< of its name in the study, where it comes first
  std::vector<std::string> columns;  ///< each once
};

/// The files that a study's text asks for and does not have in its section [data]. None of a text that is no
/// TOML.
[[nodiscard]] std::vector<WantedFile> wanted_files(std::string_view study_text);

/// The section [data."FILE"] with the columns as `table` has them, to be put behind a study's text. Fields
/// without a number do not count. Empty after an error: no such column, a field that is no finite number,
/// fewer than five numbers or more than 10000.
[[nodiscard]] std::string data_section(const FieldTable& table, const WantedFile& wanted, ErrorList& errors);

}  // namespace cpt::parameters
