// Every fault many times, and a page of what came of them: fault_injection FILE [TIMES [FAULT]]. TIMES scales
// the number of trials (1); FAULT is the one to try (all).
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "results/ledger/provenance.hpp"
#include "tests/faults/faults.hpp"

namespace {

using cpt::tests::Finding;

constexpr const char* top = R"(# Reliability

What happens to a campaign when something goes wrong around it, tried out by `scripts/fault-injection`, which writes this
page. The test suite does the same a few times for each fault (`tests/faults`). A realization is *finished* once it is in
the database. The kills hit a campaign of two MPI ranks at random moments; the same campaign is started and killed again
until it is complete, then another. In the end every database must equal, but for times, that of a campaign that nothing
happened to: curves byte for byte.

| fault | trials | finished work lost | run twice | database did not open | exit codes | what the user is told |
|---|---|---|---|---|---|---|
)";

constexpr const char* bottom = R"(
Exit codes are those of `reference.md`; under mpirun a killed rank shows as 137 (128 + 9), and a stop may show as mpirun's
own 1. *Destroyed* counts finished realizations whose bytes the fault itself took, of 12 in each trial; they are run again,
and nothing else is. Each realization is stored with a checksum, which finds a changed bit. Where the file's structure is
hit, the campaign keeps it as `NAME.sqlite.damaged`, saves into a new database what is whole, and runs the rest. Only a
file whose header says that it is no database is refused, with exit code 6.
)";

// One cell of a table: no bars, no paths of this machine.
std::string cell(std::string text) {
  const std::string folder = std::filesystem::temp_directory_path().string() + "/campaign-test-";
  for (auto at = text.find(folder); at != std::string::npos; at = text.find(folder))
    text.erase(at, folder.size() + 7);  // the folder's random letters and the slash
  std::replace(text.begin(), text.end(), '|', '/');
  return text.size() > 260 ? text.substr(0, 257) + "..." : text;
}

std::string row(const Finding& finding) {
  std::string codes;
  for (const int code : finding.exit_codes) codes += fmt::format("{}{}", codes.empty() ? "" : ", ", code);
  const std::string destroyed =
      finding.destroyed > 0 ? fmt::format(" ({} destroyed)", finding.destroyed) : std::string();
  return fmt::format("| {} | {} | {}{} | {} | {} | {} | {} |\n", finding.fault, finding.trials, finding.lost,
                     destroyed, finding.twice, finding.unopened, codes, cell(finding.told));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "usage: fault_injection FILE [TIMES [FAULT]]\n");
    return 2;
  }
  const double times = argc > 2 ? std::atof(argv[2]) : 1.0;
  std::string page = top;
  std::size_t problems = 0;
  for (const cpt::tests::Fault& fault : cpt::tests::all_faults()) {
    if (argc > 3 && std::string(argv[3]) != fault.name) continue;
    const Finding finding = fault.inject(std::max(1, static_cast<int>(fault.many * times)), 20240501);
    const std::string line = row(finding);
    fmt::print("{}", line);
    for (const std::string& problem : finding.problems) fmt::print("  PROBLEM: {}\n", problem);
    std::fflush(stdout);
    problems += finding.problems.size();
    page += line;
  }
  std::ofstream(argv[1]) << page << bottom;
  fmt::print("{} problems\n", problems);
  return problems == 0 ? 0 : 1;
}
