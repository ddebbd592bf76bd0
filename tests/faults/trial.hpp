// A campaign that is disturbed, and the books on what it had finished before.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/cli/program.hpp"
#include "tests/faults/faults.hpp"

namespace cpt::tests {

/// Which study, and what runs its realizations.
enum class Solver { stand_in, real };

class Trial {
 public:
  explicit Trial(Solver solver);

  /// Arguments of `campaign` to run the study.
  [[nodiscard]] std::vector<std::string> arguments(std::vector<std::string> more = {}) const;
  /// The same with realizations that heed the gate.
  [[nodiscard]] std::vector<std::string> gated_arguments(std::vector<std::string> more = {}) const;
  /// Environment of a campaign.
  [[nodiscard]] std::vector<std::string> variables() const;
  /// The same with the gate closed: the last realization waits at it (stand-in) or each one, at a depth of
  /// the cone that `place` in [0, 1] tells (real), until open_gate or until it is asked to end. So a campaign
  /// is under way until it is disturbed, however fast the machine.
  [[nodiscard]] std::vector<std::string> gated_variables(double place) const;
  void open_gate() const;
  /// True once a realization has come to the gate since it was closed.
  [[nodiscard]] bool at_gate() const;
  [[nodiscard]] const StudyFolder& folder() const { return folder_; }
  [[nodiscard]] std::string database() const { return folder_.file("faults.sqlite"); }

  /// After a disturbed campaign: what had finished before must still be there and must not have been started
  /// again.
  void check(Finding& finding, const Result& result);
  /// True once every realization is completed.
  [[nodiscard]] bool complete() const;
  /// Runs what is left, undisturbed; the database must then be that of a campaign that nothing happened to.
  void finish(Finding& finding, const std::vector<std::string>& more = {});

 private:
  Solver solver_;
  StudyFolder folder_;
  struct Finished {
    std::string curve, when;
  };
  std::map<std::string, Finished> finished_;  // by settings hash
  std::size_t log_read_ = 0;                  // bytes of the stand-in's log
};

/// `contents` of a campaign of this study that nothing happened to; `seconds` that it took, for the spread of
/// random moments.
struct Undisturbed {
  std::string contents;
  double seconds;
};
[[nodiscard]] const Undisturbed& undisturbed(Solver solver);

/// The line of a text that has this part; empty if there is none.
[[nodiscard]] std::string line_with(const std::string& text, const std::string& part);

/// Notes a problem unless the condition holds.
void expect(Finding& finding, bool condition, const std::string& problem);

}  // namespace cpt::tests
