// Disks that are full, read-only or damage files.
#include <fmt/format.h>
#include <signal.h>

#include <algorithm>
#include <random>

#include "tests/faults/trial.hpp"

namespace cpt::tests {
namespace {

std::string quoted(const Command& command) {
  std::string text;
  for (const std::string& word : command) text += (text.empty() ? "'" : " '") + word + "'";
  return text;
}

Command shell(const std::string& script) { return {"/bin/sh", "-c", script}; }

// A mount namespace of one's own, if need be as the root of a user namespace, so that no privilege is needed.
Command in_namespace(const std::string& script) {
  return {"unshare", "--user", "--map-root-user", "--mount", "/bin/sh", "-c", script};
}
bool namespaces_work() { return run(in_namespace("mount -t tmpfs none /mnt")).exit_code == 0; }

void write_bytes(const Trial& trial, const std::string& name, const std::string& bytes) {
  trial.folder().write(name, bytes);
}

std::string flip_bit(std::string bytes, std::mt19937& random) {
  const std::size_t at = random() % bytes.size();
  bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
  return bytes;
}

// Files may not grow beyond a size: what a quota does, and much the same to a program as a full disk.
Finding file_size_limit(int trials, unsigned seed) {
  Finding finding{.fault = "files reach their size limit (quota)"};
  std::mt19937 random(seed);
  while (finding.trials < trials) {
    Trial trial(Solver::stand_in);
    const int blocks = static_cast<int>(8 + random() % 300);  // of 512 bytes
    const Result result =
        run(shell(fmt::format("ulimit -f {}; exec {}", blocks, quoted(campaign(trial.arguments())))),
            trial.variables());
    trial.check(finding, result);
    expect(finding, result.exit_code == 6 || result.exit_code == 0,
           fmt::format("exit code {}: {}", result.exit_code, result.err));
    if (result.exit_code == 6) finding.told = line_with(result.err, "disk full");
    trial.finish(finding);
  }
  expect(finding, !finding.told.empty(), "nothing was told");
  return finding;
}

Finding full_disk(int trials, unsigned seed) {
  Finding finding{.fault = "the disk is full"};
  if (!namespaces_work()) {
    finding.problems.emplace_back("no namespaces here: not tried");
    return finding;
  }
  std::mt19937 random(seed);
  while (finding.trials < trials) {
    Trial trial(Solver::stand_in);
    const std::string small = trial.folder().file("small");
    std::filesystem::create_directory(small);
    Command command = campaign(trial.arguments());
    command[1] = small + "/faults.toml";
    // The campaign fills a small file system; then there is room, and what is there is carried out.
    const Result result =
        run(in_namespace(fmt::format("mount -t tmpfs -o size={0}k none {1} && cp {2} {1}/ && {3}; code=$?; "
                                     "cp {1}/faults.* {4}/; exit $code",
                                     24 + random() % 200, small, trial.folder().file("faults.toml"),
                                     quoted(command), trial.folder().file("."))),
            trial.variables());
    trial.check(finding, result);
    expect(finding, result.exit_code == 6 || result.exit_code == 0,
           fmt::format("exit code {}: {}", result.exit_code, result.err));
    if (const std::string line = line_with(result.err, "disk"); !line.empty()) finding.told = line;
    trial.finish(finding);
  }
  expect(finding, !finding.told.empty(), "nothing was told");
  return finding;
}

Finding read_only(int trials, unsigned) {
  Finding finding{.fault = "the database is on a read-only file system"};
  if (!namespaces_work()) {
    finding.problems.emplace_back("no namespaces here: not tried");
    return finding;
  }
  for (int k = 0; k < trials; ++k) {
    Trial trial(Solver::stand_in);
    expect(finding, run(campaign(trial.arguments()), trial.variables()).exit_code == 0, "did not run");
    const std::string before = trial.folder().read("faults.sqlite");
    const std::string folder = trial.folder().file(".");
    const auto read_only_run = [&](const Command& command) {
      return run(in_namespace(fmt::format("mount --bind {0} {0} && mount -o remount,bind,ro {0} && exec {1}",
                                          folder, quoted(command))),
                 trial.variables());
    };
    const Result query =
        read_only_run(campaign({"query", trial.folder().file("faults.toml"), "sensitivity"}));
    expect(finding, query.exit_code == 0, "cannot be queried: " + query.err);
    const Result result = read_only_run(campaign(trial.arguments()));
    expect(finding, result.exit_code == 6, fmt::format("exit code {}", result.exit_code));
    finding.told = line_with(result.err, "Read-only");
    expect(finding, trial.folder().read("faults.sqlite") == before, "the database was changed");
    trial.check(finding, result);
    trial.finish(finding);
  }
  expect(finding, !finding.told.empty(), "nothing was told");
  return finding;
}

// Runs the study on a damaged database. All is well in the end, or the file is refused because it is no
// database any more; only what was damaged runs again.
void run_on_damaged(Trial& trial, Finding& finding, const std::string& damage) {
  const Result result = run(campaign(trial.arguments()), trial.variables());
  ++finding.trials;
  finding.exit_codes.insert(result.exit_code);
  expect(finding, result.exit_code == 0 || result.exit_code == 6,
         fmt::format("{}: exit code {}: {}", damage, result.exit_code, result.err));
  if (const std::string line = line_with(result.err, "damaged"); !line.empty()) finding.told = line;
  if (result.exit_code == 6) {
    expect(finding, !result.err.empty(), damage + ": nothing was told");
    std::filesystem::remove(trial.database());  // moved away, as the message says
  }
  trial.finish(finding);
  const std::string log = trial.folder().read("log");
  finding.destroyed += static_cast<int>(std::count(log.begin(), log.end(), '\n'));
}

Finding damaged_database(int trials, unsigned seed, const char* fault,
                         const std::function<std::string(std::string, std::mt19937&)>& damage) {
  Finding finding{.fault = fault};
  std::mt19937 random(seed);
  const Trial whole(Solver::stand_in);
  expect(finding, run(campaign(whole.arguments()), whole.variables()).exit_code == 0, "did not run");
  const std::string good = whole.folder().read("faults.sqlite"), mirror = whole.folder().read("faults.h5");
  for (int k = 0; k < trials; ++k) {
    Trial trial(Solver::stand_in);
    write_bytes(trial, "faults.sqlite", damage(good, random));
    write_bytes(trial, "faults.h5", mirror);
    run_on_damaged(trial, finding, fmt::format("trial {}", k));
  }
  return finding;
}

Finding flipped_database(int trials, unsigned seed) {
  return damaged_database(trials, seed, "a bit of the database is flipped", flip_bit);
}

Finding cut_database(int trials, unsigned seed) {
  return damaged_database(
      trials, seed, "the database is cut short",
      [](const std::string& bytes, auto& random) { return bytes.substr(0, random() % bytes.size()); });
}

Finding damaged_curves(int trials, unsigned seed) {
  Finding finding{.fault = "the curve file (HDF5) is cut short or has a bit flipped"};
  std::mt19937 random(seed);
  Trial trial(Solver::stand_in);
  expect(finding, run(campaign(trial.arguments()), trial.variables()).exit_code == 0, "did not run");
  const std::string good = trial.folder().read("faults.h5");
  while (finding.trials < trials) {
    write_bytes(trial, "faults.h5",
                finding.trials % 2 == 0 ? flip_bit(good, random) : good.substr(0, random() % good.size()));
    const Result result = run(campaign(trial.arguments()), trial.variables());
    trial.check(finding, result);
    expect(finding, result.exit_code == 0, "went on with " + result.err);
    expect(finding, trial.folder().read("faults.h5") == good, "the curve file was not mended");
  }
  finding.told = "(nothing: it is mended from the database)";
  return finding;
}

Finding damaged_checkpoint(int trials, unsigned seed) {
  Finding finding{.fault = "a checkpoint (HDF5) is cut short, has a bit flipped or is another file"};
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  while (finding.trials < trials) {
    Trial trial(Solver::real);
    Background job(campaign(trial.gated_arguments({"--slots", "1"})), trial.gated_variables(share(random)));
    expect(finding, eventually([&] { return trial.at_gate() || !alive(job.pid()); }), "no push was started");
    ::kill(job.pid(), SIGTERM);  // it keeps its state and ends
    trial.check(finding, job.wait());
    const std::string checkpoints = trial.folder().file("faults.checkpoints");
    std::vector<std::filesystem::path> files;
    std::error_code missing;
    for (const auto& entry : std::filesystem::directory_iterator(checkpoints, missing))
      if (entry.path().extension() == ".h5") files.push_back(entry.path());
    expect(finding, !files.empty(), "no checkpoint was written");
    for (const auto& file : files) {
      const std::string name = "faults.checkpoints/" + file.filename().string();
      const std::string good = trial.folder().read(name);
      const std::string bad = finding.trials % 3 == 0   ? flip_bit(good, random)
                              : finding.trials % 3 == 1 ? good.substr(0, 1 + random() % (good.size() - 1))
                                                        : std::string("another file");
      write_bytes(trial, name, bad);
    }
    const Result result = run(campaign(trial.arguments()), trial.variables());
    finding.told = line_with(result.err, "starts afresh");
    expect(finding, !finding.told.empty(), "the damage was not told: " + result.err);
    trial.finish(finding);
    expect(finding, !std::filesystem::exists(checkpoints), "checkpoints were left over");
  }
  return finding;
}

}  // namespace

std::vector<Fault> storage_faults() {
  return {{"file_size_limit", 2, 30, file_size_limit},
          {"full_disk", 2, 30, full_disk},
          {"read_only", 1, 3, read_only},
          {"flipped_database", 6, 200, flipped_database},
          {"cut_database", 2, 30, cut_database},
          {"damaged_curves", 4, 100, damaged_curves},
          {"damaged_checkpoint", 3, 15, damaged_checkpoint}};
}

}  // namespace cpt::tests
