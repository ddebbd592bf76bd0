#include "reports/calibration/sentences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "results/tables/count_of.hpp"

namespace cpt::reports::calibrated {
namespace {

using diagnosis::CalibratedBand;
using diagnosis::CalibratedUnknown;
using diagnosis::Convergence;
using Eigen::Index;
using results::count_of;

// Of the posterior's standard deviation over the prior's.
constexpr double well_learnt = 0.5, learnt = 0.9;

std::string inputs_between(const CalibrationReport& report, double least, double most, const char* verb) {
  std::vector<std::string> told;
  for (const CalibratedUnknown& unknown : report.posterior.unknowns)
    if (unknown.is_input && unknown.left() > least && unknown.left() <= most)
      told.push_back(fmt::format("{} (to {:.0f} %)", unknown.name, 100.0 * unknown.left()));
  return told.empty() ? "" : fmt::format("{}: {}.", verb, fmt::join(told, ", "));
}

std::string sampler_sentence(const CalibrationReport& report) {
  double r_hat = 0.0, size = HUGE_VAL;
  for (const Convergence& here : report.posterior.sample.convergence) {
    r_hat = std::max(r_hat, here.r_hat);
    size = std::min(size, here.least_size());
  }
  const diagnosis::Sample& sample = report.posterior.sample;
  const std::string numbers =
      fmt::format("largest R-hat {:.3f}, least effective size {:.0f}, of {} draws in {}", r_hat, size,
                  sample.chains.front().rows() * static_cast<Index>(sample.chains.size()),
                  count_of(sample.chains.size(), "chain"));
  if (sample.converged) return fmt::format("The chains agree: {}.", numbers);
  return fmt::format(
      "The chains do not agree within the limit ({}; R-hat below {} and an effective size above {:g} "
      "are wanted): mistrust what follows from them.",
      numbers, report.limits.most_r_hat, report.limits.least_size);
}

}  // namespace

std::vector<ApartDepths> apart_depths(const std::vector<CalibratedBand>& bands, int sounding) {
  std::vector<ApartDepths> found;
  const CalibratedBand* before = nullptr;
  double sum = 0.0;
  int cells = 0;
  for (const CalibratedBand& band : bands) {
    if (band.cell.sounding != sounding) continue;
    const double top = band.cell.depth - 0.5 * band.cell.height, bottom = top + band.cell.height;
    if (band.apart()) {
      const bool goes_on = before != nullptr && before->apart() &&
                           (before->discrepancy.lower > 0.0) == (band.discrepancy.lower > 0.0) &&
                           std::abs(found.back().to - top) < 0.5 * band.cell.height;
      if (!goes_on) {
        found.push_back({top, bottom, 0.0});
        sum = 0.0;
        cells = 0;
      }
      sum += band.discrepancy.mean;
      found.back().to = bottom;
      found.back().mean_percent = sum / ++cells;
    }
    before = &band;
  }
  return found;
}

std::vector<std::string> calibration_sentences(const CalibrationReport& report) {
  std::vector<std::string> told;
  for (const std::string& sentence :
       {inputs_between(report, -1.0, well_learnt,
                       "Learnt from the recordings, with the standard deviation over that of the prior"),
        inputs_between(report, well_learnt, learnt, "Learnt a little"),
        inputs_between(report, learnt, HUGE_VAL, "The recordings say hardly anything of")})
    if (!sentence.empty()) told.push_back(sentence);
  for (std::size_t c = 0; c < report.channels.size(); ++c)
    for (std::size_t s = 0; s < report.soundings.size(); ++s) {
      const std::vector<CalibratedBand>& bands = report.posterior.bands[c];
      const auto sounding = static_cast<int>(s);
      if (std::ranges::none_of(bands, [&](const auto& band) { return band.cell.sounding == sounding; }))
        continue;
      const std::string where = report.soundings.size() > 1 ? " in " + report.soundings[s] : "";
      const std::vector<ApartDepths> apart = apart_depths(bands, sounding);
      if (apart.empty())
        told.push_back(fmt::format("Nowhere does the discrepancy of {}{} keep its 90 % band off zero.",
                                   report.channels[c].name, where));
      for (const ApartDepths& here : apart)
        told.push_back(
            fmt::format("{}{} is recorded {:.1f} % {} than simulated from {:.3f} to {:.3f} m, where the "
                        "90 % band of the discrepancy leaves zero out.",
                        report.channels[c].name, where, std::abs(here.mean_percent),
                        here.mean_percent > 0.0 ? "higher" : "lower", here.from, here.to));
    }
  told.push_back(sampler_sentence(report));
  return told;
}

std::vector<std::string> rank_sentences(const RankReport& report) {
  using namespace diagnosis;
  const RankCheck& check = report.check;
  const auto cases = static_cast<int>(check.cases.size());
  const EcdfDifference band = simultaneous_band(cases, check.draws, 0.95, report.seed);
  std::vector<std::string> out;
  double least = 1.0;
  for (std::size_t j = 0; j < check.unknowns.size(); ++j) {
    const Eigen::VectorXi ranks = check.ranks.col(static_cast<Index>(j));
    least = std::min(least, uniformity(ranks, check.draws, rank_bins));
    if (!stays_within(ecdf_difference(ranks, check.draws, band.at), band)) out.push_back(check.unknowns[j]);
  }
  std::vector<std::string> told;
  const auto count = check.unknowns.size();
  if (out.empty())
    told.push_back(
        fmt::format("Ranks of {} unknowns over {} recordings stay within the 95 % band of uniform ones; "
                    "least probability of their chi-squares {:.2g}.",
                    count, cases, least));
  else
    told.push_back(
        fmt::format("Ranks of {} of {} unknowns over {} recordings leave the 95 % band of uniform ones "
                    "({}): 1 in 20 does so by chance; least probability of the chi-squares {:.2g}.",
                    out.size(), count, cases, fmt::join(out, ", "), least));
  constexpr int expected_in_a_bin = 5;
  if (cases < expected_in_a_bin * rank_bins)
    told.push_back(fmt::format(
        "{} recordings tell little: with fewer than {} the chi-squares do not hold, and only gross "
        "errors leave the band.",
        cases, expected_in_a_bin * rank_bins));
  const auto stuck = std::ranges::count(check.converged, false);
  if (stuck > 0)
    told.push_back(
        fmt::format("Of {} of the {} recordings the chains did not agree within the limit.", stuck, cases));
  return told;
}

}  // namespace cpt::reports::calibrated
