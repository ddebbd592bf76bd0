#include "parameters/read_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

#include "parameters/nearest_name.hpp"
#include "parameters/study_keys.hpp"

namespace cpt::parameters {
namespace {

using solver::ProgramInput, solver::ProgramOutput;

constexpr std::uintmax_t largest_template = 1'000'000;  // [bytes]; it travels with every order
constexpr std::size_t longest_name = 60;

bool is_plain_name(std::string_view name) {
  return !name.empty() && name.size() <= longest_name && std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

/// A program and what the study leaves to be found out.
struct DeclaredProgram {
  solver::ExternalProgram program;
  std::vector<std::string> version_command;  // prints the version; empty: the text is told
};

class ProgramReader {
 public:
  ProgramReader(const std::filesystem::path& folder, FilesBeside files, ErrorList& errors)
      : folder_(folder), files_(files), errors_(errors) {}

  DeclaredProgram read(const Value& root) {
    program_.folder = folder_.string();
    read_limits(root);
    const Value* table = section(root, "solver", errors_);
    if (table == nullptr) return std::move(declared_);
    std::vector<std::string_view> known = known_names(study_keys(), "solver");
    known.insert(known.end(), {"inputs", "outputs"});
    refuse_unknown_keys(*table, "solver", known, errors_);
    if (const Member* command = table->find("command"))
      program_.command = words(*command, "solver.command");
    else if (!errors_.is_meant(*table, "command"))
      errors_.add(table->place, "solver.command", "is missing",
                  "such as command = [\"python3\", \"model.py\"]");
    read_version(*table);
    read_results(*table);
    program_.limits.keep_work = flag_field(*table, "solver", "keep_work", errors_).value_or(false);
    read_inputs(*table);
    read_outputs(*table);
    read_template(*table);
    return std::move(declared_);
  }

 private:
  void read_limits(const Value& root) {
    const Value* table = root.find("limits") ? section(root, "limits", errors_) : nullptr;
    if (table == nullptr) return;
    const auto positive = [&](std::string_view key, double& to, double factor) {
      const auto number = number_field(*table, "limits", key, false, errors_);
      if (!number) return;
      if (*number > 0.0)
        to = *number * factor;
      else
        errors_.add(table->find(key)->value.place, joined("limits", key),
                    fmt::format("{} must be above 0", *number));
    };
    positive("hang_minutes", program_.limits.hang_seconds, 60.0);
    positive("most_megabytes", program_.limits.most_bytes, 1.0e6);
    const Key& key = key_named(study_keys(), "limits", "retries");
    const auto retries = number_field(*table, "limits", "retries", false, errors_);
    if (retries && (*retries < key.least || *retries > key.most || *retries != std::round(*retries)))
      errors_.add(table->find("retries")->value.place, "limits.retries",
                  fmt::format("{} must be a whole number from {} to {}", *retries, key.least, key.most));
    else if (retries)
      program_.limits.retries = static_cast<int>(*retries);
  }

  // Those of a command; none after an error.
  std::vector<std::string> words(const Member& member, const std::string& key) {
    std::vector<std::string> found;
    const auto refuse = [&](Place place, std::string message) {
      errors_.add(place, key, std::move(message), "such as [\"python3\", \"model.py\"]");
      return std::vector<std::string>{};
    };
    if (member.value.kind != Value::Kind::array)
      return refuse(member.value.place,
                    fmt::format("must be an array of texts, not {}", to_string(member.value.kind)));
    for (const Value& item : member.value.items) {
      if (item.kind != Value::Kind::text)
        return refuse(item.place, fmt::format("must hold texts, not {}", to_string(item.kind)));
      if (item.text.find('\0') != std::string::npos) return refuse(item.place, "must not hold a zero byte");
      found.push_back(item.text);
    }
    if (found.empty() || found.front().empty())
      return refuse(member.value.place, found.empty() ? "has no word" : "begins with an empty word");
    return found;
  }

  void read_version(const Value& table) {
    const Member* member = table.find("version");
    if (member == nullptr) return;
    if (member->value.kind == Value::Kind::array)
      declared_.version_command = words(*member, "solver.version");
    else if (member->value.kind == Value::Kind::text)
      program_.version = member->value.text;
    else
      errors_.add(member->value.place, "solver.version",
                  fmt::format("must be a text or a command, not {}", to_string(member->value.kind)),
                  "such as version = \"2.1\" or version = [\"model\", \"--version\"]");
  }

  void read_results(const Value& table) {
    const auto file = text_field(table, "solver", "results", false, errors_);
    if (!file) return;
    const std::filesystem::path path(*file);
    const bool inside = !path.empty() && path.is_relative() && path.has_filename() &&
                        std::ranges::find(path, std::filesystem::path("..")) == path.end();
    if (!inside)
      errors_.add(table.find("results")->value.place, "solver.results",
                  fmt::format("\"{}\" must be a file in the realization's work folder", *file),
                  "such as results = \"out.csv\"");
    program_.results = *file;
  }

  // Rows of an inner table; `other` is what stands in place of a row.
  template <class Read>
  void read_rows(const Value& table, std::string_view name, std::string_view such_as, Read read) {
    const std::string key = joined("solver", name);
    const Member* rows = table.find(name);
    if (rows == nullptr || rows->value.kind != Value::Kind::table || rows->value.members.empty())
      return errors_.add(rows ? rows->place : table.place, key,
                         rows ? "must be a table with a row for each" : "is missing",
                         fmt::format("such as {}", such_as));
    for (const Member& member : rows->value.members) {
      const std::string row = joined(key, member.key);
      if (!is_plain_name(member.key))
        errors_.add(member.place, row,
                    fmt::format("the name may hold only letters, digits, _ and -, {} at most", longest_name));
      else
        read(member, row);
    }
  }

  void read_inputs(const Value& table) {
    read_rows(table, "inputs", "x1 = { default = 0.0, unit = \"m\", min = -1.0, max = 1.0 }",
              [&](const Member& member, const std::string& key) { read_input(member, key); });
  }

  void read_input(const Member& member, const std::string& key) {
    ProgramInput input{member.key};
    if (member.value.kind == Value::Kind::number) {
      const auto number = finite_number(member.value, key, errors_);
      input.usual = number.value_or(0.0);
      program_.inputs.push_back(std::move(input));
      return;
    }
    if (!is_row(member, key, "a number or a row such as { default = 0.0, unit = \"m\" }")) return;
    const Value& row = member.value;
    refuse_unknown_keys(row, key, known_names(study_keys(), "solver.inputs"), errors_);
    input.usual = number_field(row, key, "default", true, errors_).value_or(0.0);
    input.min = number_field(row, key, "min", false, errors_).value_or(input.min);
    input.max = number_field(row, key, "max", false, errors_).value_or(input.max);
    input.unit = text_field(row, key, "unit", false, errors_).value_or("-");
    input.meaning = text_field(row, key, "meaning", false, errors_).value_or("");
    input.integer = flag_field(row, key, "integer", errors_).value_or(false);
    if (input.min > input.max) {
      errors_.add(row.find("max")->value.place, joined(key, "max"),
                  fmt::format("{} is below min = {}", input.max, input.min));
      input.min = input.max = input.usual;  // told once
    } else if (const Member* usual = row.find("default");
               usual != nullptr && (input.usual < input.min || input.usual > input.max)) {
      errors_.add(usual->value.place, joined(key, "default"),
                  fmt::format("{} is outside min to max, {} to {}", input.usual, input.min, input.max));
      input.usual = std::clamp(input.usual, input.min, input.max);
    } else if (usual != nullptr && input.integer && input.usual != std::round(input.usual)) {
      errors_.add(usual->value.place, joined(key, "default"),
                  fmt::format("{} must be a whole number", input.usual));
    }
    program_.inputs.push_back(std::move(input));
  }

  void read_outputs(const Value& table) {
    read_rows(table, "outputs", "f = { unit = \"kPa\" }",
              [&](const Member& member, const std::string& key) { read_output(member, key); });
    for (const ProgramOutput& output : program_.outputs)
      if (std::ranges::find(program_.outputs, output.over, &ProgramOutput::name) != program_.outputs.end())
        errors_.add(table.find("outputs")->place, fmt::format("solver.outputs.{}.over", output.name),
                    fmt::format("\"{}\" names an output, not an abscissa", output.over));
  }

  void read_output(const Member& member, const std::string& key) {
    if (!is_row(member, key, "a row such as { unit = \"kPa\" }")) return;
    const Value& row = member.value;
    refuse_unknown_keys(row, key, known_names(study_keys(), "solver.outputs"), errors_);
    ProgramOutput output{member.key};
    output.unit = text_field(row, key, "unit", false, errors_).value_or("-");
    output.meaning = text_field(row, key, "meaning", false, errors_).value_or("");
    if (const auto over = text_field(row, key, "over", false, errors_)) {
      if (!is_plain_name(*over))
        errors_.add(row.find("over")->value.place, joined(key, "over"),
                    fmt::format("\"{}\" may hold only letters, digits, _ and -", *over));
      output.over = *over;
      output.over_unit = text_field(row, key, "over_unit", false, errors_).value_or("-");
    } else if (const Member* unit = row.find("over_unit")) {
      errors_.add(unit->place, joined(key, "over_unit"), "belongs to a curve", "give over = its abscissa");
    }
    program_.outputs.push_back(std::move(output));
  }

  bool is_row(const Member& member, const std::string& key, std::string_view what) {
    if (member.value.kind == Value::Kind::table) return true;
    errors_.add(member.value.place, key,
                fmt::format("must be {}, not {}", what, to_string(member.value.kind)));
    return false;
  }

  void read_template(const Value& table) {
    const auto name = text_field(table, "solver", "template", false, errors_);
    if (!name || files_ == FilesBeside::left) return;
    const Place place = table.find("template")->value.place;
    const std::filesystem::path file = folder_ / *name;
    std::error_code problem;
    if (!std::filesystem::is_regular_file(file, problem))
      return errors_.add(place, "solver.template", fmt::format("{}: there is no such file", file.string()),
                         "a relative path starts at the study's folder");
    if (const auto size = std::filesystem::file_size(file, problem); problem || size > largest_template)
      return errors_.add(place, "solver.template",
                         fmt::format("{} is larger than {} bytes", file.string(), largest_template));
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream)
      return errors_.add(place, "solver.template", fmt::format("{} cannot be read", file.string()));
    program_.template_name = file.filename().string();
    program_.template_text = text.str();
    check_placeholders(place, file.string());
  }

  // Each {{name}} is an input.
  void check_placeholders(Place place, const std::string& file) {
    const std::string& text = program_.template_text;
    std::vector<std::string_view> names;
    for (const ProgramInput& input : program_.inputs) names.push_back(input.name);
    for (std::size_t at = 0; (at = text.find("{{", at)) != std::string::npos; at += 2) {
      const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
      const std::size_t end = text.find("}}", at);
      const std::string name = text.substr(at + 2, end == std::string::npos ? 20 : end - at - 2);
      if (std::ranges::find(names, name) != names.end()) continue;
      const std::string_view near = nearest_name(name, names);
      errors_.add(place, "solver.template",
                  fmt::format("{}:{}: \"{{{{{}{}\" is no input of [solver.inputs]", file, line, name,
                              end == std::string::npos ? "" : "}}"),
                  near.empty() ? "" : fmt::format("did you mean {{{{{}}}}}?", near));
      return;
    }
  }

  const std::filesystem::path& folder_;
  FilesBeside files_;
  ErrorList& errors_;
  DeclaredProgram declared_;
  solver::ExternalProgram& program_ = declared_.program;
};

std::optional<Window> read_curve_window(const Value& table, const solver::ExternalProgram& program,
                                        ErrorList& errors) {
  refuse_unknown_keys(table, "windows", known_names(study_keys(), "windows"), errors);
  bool sound = true;
  const auto refuse = [&](Place place, std::string key, std::string message, std::string hint = "") {
    errors.add(place, std::move(key), std::move(message), std::move(hint));
    sound = false;
  };
  for (const std::string_view key : {"from_m", "to_m", "centre", "between_m", "width_m", "thresholds_kPa"})
    if (const Member* member = table.find(key))
      refuse(member->place, joined("windows", key), "belongs to the embedded solver",
             "give output, from and to");
  std::vector<std::string_view> curves;
  for (const ProgramOutput& output : program.outputs)
    if (output.is_curve()) curves.push_back(output.name);
  Window window;
  const auto name = text_field(table, "windows", "name", true, errors);
  if (name && !is_plain_name(*name))
    refuse(table.find("name")->value.place, "windows.name",
           fmt::format("\"{}\" may hold only letters, digits, _ and -", *name));
  const auto output = name_field(table, "windows", "output", true, curves, errors);
  const auto from = number_field(table, "windows", "from", true, errors);
  const auto to = number_field(table, "windows", "to", true, errors);
  if (from && to && *from > *to)
    refuse(table.find("to")->value.place, "windows.to",
           fmt::format("the window would go from {} to {}", *from, *to));
  if (!sound || !name || !output || !from || !to) return std::nullopt;
  window.name = *name;
  window.output = *output;
  window.from = *from;
  window.to = *to;
  return window;
}

}  // namespace

void read_program(const Value& root, FilesBeside files, Study& study, ErrorList& errors) {
  const std::filesystem::path folder = study.file.parent_path();
  DeclaredProgram declared = ProgramReader(folder, files, errors).read(root);
  for (const ProgramInput& input : declared.program.inputs)
    study.baseline.program_inputs.push_back(input.usual);
  study.baseline.program = std::make_shared<const solver::ExternalProgram>(std::move(declared.program));
  study.version_command = std::move(declared.version_command);
}

std::vector<Window> read_program_windows(const Value& root, const solver::ExternalProgram& program,
                                         ErrorList& errors) {
  std::vector<Window> windows;
  std::set<std::string> names;
  for (const ProgramOutput& output : program.outputs) {
    if (output.is_curve()) continue;
    Window window{output.name, Window::Kind::scalar};
    window.output = output.name;
    windows.push_back(std::move(window));
    names.insert(output.name);
  }
  for (const Value* table : sections(root, "windows", errors)) {
    std::optional<Window> window = read_curve_window(*table, program, errors);
    if (!window) continue;
    if (names.insert(window->name).second)
      windows.push_back(*std::move(window));
    else
      errors.add(table->find("name")->value.place, "windows.name",
                 fmt::format("\"{}\" names a scalar or another window already", window->name));
  }
  if (windows.empty() && errors.empty())
    errors.add(root.find("solver")->place, "windows",
               "is missing: of curves alone, a study needs at least one interval to average over",
               "add [[windows]] with name, output, from and to");
  return windows;
}

void refuse_program_limits(const Value& limits, ErrorList& errors) {
  for (const std::string_view key : {"hang_minutes", "most_megabytes", "retries"})
    if (const Member* member = limits.find(key))
      errors.add(member->place, joined("limits", key), "belongs to a study with a section [solver]");
}

void refuse_embedded(const Value& root, ErrorList& errors) {
  for (const std::string_view key :
       {"profile", "preset", "repeats", "paired_repeats", "soils", "layers", "zones"})
    if (const Member* member = root.find(key))
      errors.add(member->place, std::string(key),
                 "belongs to the embedded solver, and [solver] names another program",
                 "remove one of the two");
}

}  // namespace cpt::parameters
