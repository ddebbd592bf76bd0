#include "cli/program/version.hpp"

#include <fmt/format.h>

#include "results/ledger/provenance.hpp"
#include "solver/simulate.hpp"

namespace cpt::cli {

std::string version() {
  constexpr std::string_view commit = CPT_COMMIT;
  return fmt::format("campaign {} ({}solver {})", results::program_version(),
                     commit.empty() ? "" : fmt::format("commit {}, ", commit), solver::solver_version());
}

}  // namespace cpt::cli
