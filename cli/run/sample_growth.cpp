#include "cli/run/sample_growth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <span>
#include <variant>

#include "cli/common/study_argument.hpp"
#include "parameters/designs/design.hpp"
#include "parameters/designs/discrepancy.hpp"
#include "parameters/designs/latin_hypercube.hpp"
#include "parameters/read_study.hpp"
#include "results/ledger/provenance.hpp"

namespace cpt::cli {
namespace {

using parameters::Design;

constexpr int most_told = 4000;  // runs: the discrepancy's cost grows with their square

bool is_sample(const parameters::Study& study) { return study.design.kind == "latin_hypercube"; }

// How many of the points have been run.
long kept(const parameters::Study& study, std::span<const parameters::DesignPoint> points,
          const std::set<std::string>& finished) {
  return std::count_if(points.begin(), points.end(), [&](const parameters::DesignPoint& point) {
    solver::Setup setup = study.baseline;
    for (const parameters::Change& change : point.changes) change.quantity->set_value(setup, change.value);
    return finished.contains(results::settings_hash(setup));
  });
}

std::set<std::string> finished_runs(const results::Matching& matching) {
  std::set<std::string> hashes;
  for (const results::MatchedRun& run : matching.realizations)
    if (run.held && run.held->finished()) hashes.insert(run.held->settings_hash);
  for (const results::HeldRun& run : matching.left)
    if (run.finished() && !run.damaged) hashes.insert(run.settings_hash);
  return hashes;
}

}  // namespace

std::string growth_note(const parameters::Study& study) {
  const Design& design = study.design;
  if (!is_sample(study) || design.first_runs == 0 || design.first_runs == design.runs ||
      design.runs > most_told)
    return "";
  const auto count = static_cast<int>(design.rows.size());
  const auto grown =
      parameters::grown_latin_hypercube_places(count, design.first_runs, design.runs, design.seed);
  const auto fresh = parameters::latin_hypercube_places(count, design.runs, design.seed);
  return fmt::format(
      "the Latin hypercube has grown from {} to {} runs: its centred L2 discrepancy is {:.4f}, that of a "
      "fresh "
      "one of {} is {:.4f} (0 would be perfectly even)",
      design.first_runs, design.runs, parameters::centred_discrepancy(grown), design.runs,
      parameters::centred_discrepancy(fresh));
}

std::string growth_advice(const parameters::Study& study, const results::Prospect& stored) {
  const Design& design = study.design;
  if (!is_sample(study) || design.first_runs != 0) return "";
  const auto parsed = parameters::parse_study(stored.stored_text, study.file);
  const auto* before = std::get_if<parameters::Study>(&parsed);
  if (before == nullptr || !is_sample(*before) || before->design.runs >= design.runs) return "";

  parameters::Study grown = study;
  const auto first = grown.points.begin() + static_cast<std::ptrdiff_t>(design.first_point);
  grown.points.erase(first, first + static_cast<std::ptrdiff_t>(design.points));
  grown.design.first_runs = before->design.first_runs > 0 ? before->design.first_runs : before->design.runs;
  const std::set<std::string> finished = finished_runs(stored.matching);
  const long now = kept(study, std::span(study.points).subspan(design.first_point, design.points), finished),
             then = kept(study, parameters::design_points(grown), finished);
  if (then <= now) return "";
  return fmt::format(
      "{}: design.runs grew from {} to {}, and a fresh sample of {} has none of the {} points that have been "
      "run; "
      "write under [design]\n    first_runs = {}    to keep them and add {}, or\n    first_runs = {}    for "
      "a fresh "
      "sample (what has been run stays in the database, unused)",
      study.file.filename().string(), before->design.runs, design.runs, design.runs, then,
      grown.design.first_runs, design.runs - before->design.runs, design.runs);
}

void refuse_forgotten_growth(const parameters::Study& study) {
  if (!is_sample(study) || study.design.first_runs != 0) return;
  std::string advice;
  try {
    if (const auto stored = results::prospect(study)) advice = growth_advice(study, *stored);
  } catch (const results::Error&) {
    return;  // the campaign itself says what is wrong with the database, or mends it
  }
  if (!advice.empty()) throw BadInput(advice);
}

}  // namespace cpt::cli
