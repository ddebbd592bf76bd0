// What was found to cause a difference from the paper: prose by hand, its evidence from the databases.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "validation/paper/studies.hpp"

namespace cpt::validation::paper {

/// A parameter of a study whose effect on an average q_c shows the cause.
struct Evidence {
  std::string study, window, parameter;
};

struct Cause {
  std::string row;   ///< "S4", ...: the result of the paper that differs
  std::string text;  ///< Markdown
  std::vector<Evidence> evidence;
};

/// The results of the paper that a cause may name.
[[nodiscard]] const std::vector<std::string_view>& paper_rows();

/// Reads a TOML file with one table a row, in its order:
///
///     [S4]
///     cause = "The initial image pressure decides the trend."
///     evidence = [{ study = "image_pressure", window = "sand", parameter = "initial.sigma_h0_kPa" }]
///
/// Throws results::Error with file, line and column if it cannot be read, names an unknown row or says
/// anything else than this.
[[nodiscard]] std::vector<Cause> read_causes(const std::filesystem::path& file);

/// Markdown: what the databases say of the evidence, "`image_pressure`: σ'h0 from 15 to 35 changes ... by
/// +3.0 %", or why they say nothing.
[[nodiscard]] std::string in_numbers(const Evidence& evidence, const Studies& studies);

}  // namespace cpt::validation::paper
