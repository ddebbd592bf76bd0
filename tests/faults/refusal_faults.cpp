// What the system or another program refuses: output that nobody takes, databases that are kept locked, paths
// that are too long, folders and files without permission or of another kind.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "results/files/database.hpp"
#include "tests/faults/trial.hpp"

namespace cpt::tests {
namespace {

using results::Database;

std::string quoted(const Command& command) {
  std::string text;
  for (const std::string& word : command) text += (text.empty() ? "'" : " '") + word + "'";
  return text;
}

Command shell(const std::string& script) { return {"/bin/sh", "-c", script}; }

// Everything is done, whatever becomes of the words about it; lost standard output is no success.
Finding unwritable_output(int trials, unsigned) {
  Finding finding{.fault = "standard output or error is full, closed, or a pipe whose reader has gone"};
  struct Case {
    const char* script;  // {0} is the campaign, {1} a file
    int exit_code;
  };
  constexpr Case cases[] = {
      {"{0} > /dev/full", 6},
      {"{0} 2> /dev/full", 0},
      {"{0} > /dev/full 2>&1", 6},
      {"{0} >&-", 6},
      {"{0} <&- >&- 2>&-", 6},
      // The reader closes the pipe before the campaign is let go.
      {"{{ until [ -e {1} ]; do sleep 0.01; done; {0}; echo $? > {1}; }} | {{ exec <&-; : > {1}; }}; "
       "exit $(cat {1})",
       6},
      {"{{ until [ -e {1} ]; do sleep 0.01; done; {0} 2>&1 >/dev/null; echo $? > {1}; }} | "
       "{{ exec <&-; : > {1}; }}; exit $(cat {1})",
       0}};
  while (finding.trials < trials)
    for (const auto& [script, exit_code] : cases) {
      Trial trial(Solver::stand_in);
      const Result result = run(shell(fmt::format(fmt::runtime(script), quoted(campaign(trial.arguments())),
                                                  trial.folder().file("gate"))),
                                trial.variables());
      trial.check(finding, result);
      expect(finding, result.exit_code == exit_code,
             fmt::format("{}: exit code {}: {}", script, result.exit_code, result.err));
      expect(finding, trial.complete(), fmt::format("{}: the campaign did not go on", script));
      if (const std::string line = line_with(result.err, "standard output"); !line.empty())
        finding.told = line;
      trial.finish(finding);
    }
  return finding;
}

// Another program opens the database and keeps it locked until the campaign has said that it waits.
Finding locked_database(int trials, unsigned) {
  Finding finding{.fault =
                      "another program keeps the database locked, at the start and while realizations end"};
  while (finding.trials < trials) {
    Trial trial(Solver::stand_in);
    const auto lock_until_told = [&](Background& job, const Database& browser) {
      expect(finding, eventually([&] {
               finding.told = line_with(job.err_so_far(), "keeps the database locked");
               return !finding.told.empty() || !alive(job.pid());
             }),
             "the wait was not told");
      browser.execute("ROLLBACK");
    };
    std::vector<std::string> variables = trial.variables();
    variables.insert(variables.end(), {"CPT_FAKE=*:wait", "CPT_FAKE_GATE=" + trial.folder().file("gate")});
    Background job(campaign(trial.arguments()), variables);
    const auto running = [&] {
      try {
        return Database(trial.database(), Database::Mode::read_only)
                   .integer("SELECT count(*) FROM realization WHERE status = 'running'") > 0;
      } catch (const results::Error&) {
        return false;  // it is being made
      }
    };
    expect(finding, eventually(running), "nothing runs");
    {
      const Database browser(trial.database(), Database::Mode::read_write);
      browser.execute("BEGIN IMMEDIATE");
      trial.folder().write("gate", "");
      lock_until_told(job, browser);
    }
    const Result result = job.wait();
    trial.check(finding, result);
    expect(finding, result.exit_code == 0, fmt::format("while it ran: {}", result.err));

    const Database browser(trial.database(), Database::Mode::read_write);
    browser.execute("BEGIN EXCLUSIVE");
    Background again(campaign(trial.arguments()), trial.variables());
    lock_until_told(again, browser);
    const Result started = again.wait();
    trial.check(finding, started);
    expect(finding, started.exit_code == 0, fmt::format("at its start: {}", started.err));
    trial.finish(finding);
  }
  return finding;
}

// Paths that SQLite or the file system does not take: refused before anything runs, and nothing is left
// there.
Finding long_path(int trials, unsigned) {
  Finding finding{.fault = "the path or the name is too long for SQLite or for the file system"};
  while (finding.trials < trials) {
    Trial trial(Solver::stand_in);
    std::filesystem::path deep = trial.folder().file("d");
    while (deep.native().size() < 510) deep /= std::string(100, 'd');
    std::filesystem::create_directories(deep);
    for (const auto& [study, told] : {std::pair{deep / "faults.toml", "SQLite takes 504"},
                                      {trial.folder().file(std::string(248, 'n') + ".toml"), "255 bytes"}}) {
      std::filesystem::copy_file(trial.folder().file("faults.toml"), study);
      std::vector<std::string> words = trial.arguments();
      words.front() = study;
      const Result result = run(campaign(words), trial.variables());
      trial.check(finding, result);
      expect(finding, result.exit_code == 6, fmt::format("exit code {}: {}", result.exit_code, result.err));
      finding.told = line_with(result.err, told);
      expect(finding, !finding.told.empty(), "the cause is not told: " + result.err);
      expect(finding, trial.folder().read("log").empty(), "something was run");
    }
    expect(finding, std::distance(std::filesystem::directory_iterator(deep), {}) == 1, "something is left");
    trial.finish(finding);
    finding.told = finding.told.substr(finding.told.find(": ") + 2);
  }
  return finding;
}

// Root may write everything; without its capabilities it may not.
std::string without_privilege() {
  return ::geteuid() == 0 ? "exec setpriv --inh-caps=-all --bounding-set=-all " : "exec ";
}

Finding no_permission(int trials, unsigned) {
  Finding finding{.fault = "the folder or the database may only be read, or is of another kind"};
  if (run(shell(without_privilege() + "true")).exit_code != 0) {
    finding.problems.emplace_back("setpriv does not work here: not tried");
    return finding;
  }
  while (finding.trials < trials) {
    Trial trial(Solver::stand_in);
    const std::string all = trial.folder().file(".");
    const auto expect_refused = [&](const char* part) {
      const Result result =
          run(shell(without_privilege() + quoted(campaign(trial.arguments()))), trial.variables());
      trial.check(finding, result);
      expect(finding, result.exit_code == 6,
             fmt::format("{}: exit code {}: {}", part, result.exit_code, result.err));
      finding.told = line_with(result.err, part);
      expect(finding, !finding.told.empty(), fmt::format("'{}' is not told: {}", part, result.err));
    };
    namespace fs = std::filesystem;
    const auto writable = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
    fs::permissions(all, writable, fs::perm_options::remove);
    expect_refused("(Permission denied); give permission on it and its folder");
    fs::permissions(all, fs::perms::owner_write, fs::perm_options::add);

    expect(finding, run(campaign(trial.arguments()), trial.variables()).exit_code == 0, "did not run");
    const std::string before = trial.folder().read("faults.sqlite");
    fs::permissions(trial.database(), writable, fs::perm_options::remove);
    expect_refused("give write permission on it and its folder");
    fs::permissions(trial.database(), fs::perms::owner_write, fs::perm_options::add);
    expect(finding, trial.folder().read("faults.sqlite") == before, "the database was changed");

    fs::rename(trial.database(), trial.folder().file("kept"));
    fs::create_directory(trial.database());
    const Result result = run(campaign(trial.arguments()), trial.variables());
    ++finding.trials;
    expect(finding, result.exit_code == 6 && !line_with(result.err, "is a folder, not a database").empty(),
           result.err);
    fs::remove(trial.database());
    fs::rename(trial.folder().file("kept"), trial.database());

    fs::remove(trial.folder().file("faults.h5"));
    fs::create_directory(trial.folder().file("faults.h5"));
    const Result mirror = run(campaign(trial.arguments()), trial.variables());
    trial.check(finding, mirror);
    expect(finding, mirror.exit_code == 6 && !line_with(mirror.err, "the curves are safe in").empty(),
           mirror.err);
    fs::remove(trial.folder().file("faults.h5"));
    trial.finish(finding);
  }
  return finding;
}

}  // namespace

std::vector<Fault> refusal_faults() {
  return {{"unwritable_output", 7, 21, unwritable_output},
          {"locked_database", 2, 6, locked_database},
          {"long_path", 2, 4, long_path},
          {"no_permission", 4, 12, no_permission}};
}

}  // namespace cpt::tests
