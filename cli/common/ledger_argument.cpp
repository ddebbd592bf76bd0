#include "cli/common/ledger_argument.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "cli/common/study_argument.hpp"

namespace cpt::cli {

results::LedgerView open_ledger(const std::filesystem::path& source, bool quiet) {
  if (!names_study(source)) return results::view_ledger(source);
  const StudyFile file = read_study_file(source);
  results::LedgerView view = results::view_ledger(file.study, file.text);
  if (!quiet)
    for (const std::string& note : view.notes) fmt::print(stderr, "note: {}\n", note);
  return view;
}

}  // namespace cpt::cli
