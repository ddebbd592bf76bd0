// The program's commands: one file each, listed once in main.cpp.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace cpt::cli {

/// What the command line asked for; returns the exit code. Set by the command that was parsed.
using Action = std::function<int()>;

/// Each adds its subcommand to `program` and, when that is parsed, sets `action`.
void add_run(CLI::App& program, Action& action);
void add_rerun(CLI::App& program, Action& action);
void add_push(CLI::App& program, Action& action);
void add_view(CLI::App& program, Action& action);
void add_query(CLI::App& program, Action& action);
void add_compare(CLI::App& program, Action& action);
void add_combine(CLI::App& program, Action& action);
void add_emulate(CLI::App& program, Action& action);
void add_predict(CLI::App& program, Action& action);
void add_export(CLI::App& program, Action& action);
void add_import(CLI::App& program, Action& action);
void add_prune(CLI::App& program, Action& action);
void add_report(CLI::App& program, Action& action);
void add_element(CLI::App& program, Action& action);
void add_list(CLI::App& program, Action& action);
void add_reference(CLI::App& program, Action& action);
void add_completion(CLI::App& program, Action& action);
void add_numerics(CLI::App& program, Action& action);
void add_paper(CLI::App& program, Action& action);
void add_conceal(CLI::App& program, Action& action);
void add_reveal(CLI::App& program, Action& action);
void add_diagnose(CLI::App& program, Action& action);
void add_calibration(CLI::App& program, Action& action);
void add_recording(CLI::App& program, Action& action);

/// Adds `calibrate` to the command `element`.
void add_calibrate(CLI::App& element, Action& action);

}  // namespace cpt::cli
