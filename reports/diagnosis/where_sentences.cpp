// Where recording and simulation part, and what the study's own parameters did about it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawing/text.hpp"
#include "reports/diagnosis/errors.hpp"
#include "reports/diagnosis/sentences.hpp"
#include "reports/diagnosis/words.hpp"

namespace cpt::reports::diagnosed {
namespace {

std::string place_of(const DiagnosisInput& input, const diagnosis::Mismatch& m) {
  const std::string between = fmt::format("between {} and {} m", metres(m.from), metres(m.to));
  if (input.soundings.size() == 1) return capitalized(between);
  if (m.sounding < 0) return "In all soundings, " + between;
  return fmt::format("In {}, {}", input.soundings[static_cast<std::size_t>(m.sounding)].name, between);
}

std::string side_of(double value) { return value < 0.0 ? "below" : "above"; }

// "38 % (410 kPa) above"; in kPa only where that has the same sign.
std::string how_far(const diagnosis::Departure& on) {
  const std::string size = percent(std::abs(on.percent));
  if (size == percent(0.0)) return "level with";
  const bool alike = (on.difference < 0.0) == (on.percent < 0.0);
  return fmt::format("{}{} {}", size,
                     alike ? fmt::format(" ({} kPa)", brief(std::abs(on.difference) / 1e3)) : "",
                     side_of(on.percent));
}

// What a mean hides: cells on the other side, and a step of the scan that points the other way.
std::string what_the_mean_hides(const diagnosis::Departure& on, const diagnosis::Mismatch& m) {
  std::string text;
  if (on.least <= -0.5 && on.greatest >= 0.5)
    text = fmt::format(" It lies from {} below to {} above over that interval.", percent(-on.least),
                       percent(on.greatest));
  if ((m.size < 0.0) != (on.percent < 0.0))
    text += fmt::format(
        " The step that the scan finds missing beside the parameters there is of the other sign ({}).",
        percent(percent_of(m.size)));
  return text;
}

std::string move_of(const DiagnosisInput& input, std::size_t j) {
  const StudyParameter& p = input.parameters[j];
  const double place = input.diagnosis.null.recalibrated.place(static_cast<Index>(j));
  const bool at_bound = !p.is_choice() && (place < 0.005 || place > 0.995);
  return fmt::format("{} from {} to {}{}{}", p.quantity->symbol, value_text(p, baseline_place(p)),
                     value_text(p, place), p.is_choice() ? "" : unit_after(p.quantity->unit),
                     at_bound ? ", its bound" : "");
}

}  // namespace

std::string where_it_differs(const DiagnosisInput& input) {
  const diagnosis::Location& location = input.diagnosis.location;
  if (location.mismatches.empty())
    return fmt::format(
        "At no depth does the recording depart from the simulation by more than the study's parameters and "
        "the noise allow (greatest step statistic {}, threshold {}, {}).",
        brief(location.greatest), brief(location.threshold), p_value(location.p));
  std::string text;
  for (std::size_t i = 0; i < std::min(location.mismatches.size(), most_told); ++i) {
    const diagnosis::Mismatch& m = location.mismatches[i];
    const diagnosis::Departure on = departure(input, m);
    text += fmt::format("{}{} the recording is on average {} the {}simulation{} ({}).{}", i > 0 ? " " : "",
                        place_of(input, m), how_far(on), i > 0 ? "refitted " : "",
                        i == 0 ? " with the study's parameters refitted" : "", p_value(m.p),
                        what_the_mean_hides(on, m));
  }
  if (const std::size_t n = location.mismatches.size(); n > most_told)
    text += fmt::format(" {} more interval{} the table below.", n - most_told,
                        n - most_told == 1 ? " is in" : "s are in");
  return text;
}

std::string parameters_moved(const DiagnosisInput& input) {
  const VectorXd& place = input.diagnosis.null.recalibrated.place;
  const auto moved = [&](std::size_t j) {
    return std::abs(place(static_cast<Index>(j)) - baseline_place(input.parameters[j]));
  };
  std::vector<std::size_t> order;
  for (std::size_t j = 0; j < input.parameters.size(); ++j)
    if (moved(j) > 0.1) order.push_back(j);  // of the range between the bounds
  if (order.empty())
    return input.parameters.empty()
               ? ""
               : "No study parameter moved by more than a tenth of the range between its bounds.";
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return moved(a) > moved(b); });
  std::vector<std::string> moves;
  for (const std::size_t j : order)
    if (moves.size() < most_told) moves.push_back(move_of(input, j));
  std::string separated;  // the moves may hold commas themselves
  for (std::size_t i = 0; i < moves.size(); ++i) separated += (i > 0 ? "; " : "") + moves[i];
  return fmt::format("Within their bounds, these study parameters moved most: {}.", separated);
}

std::string recalibration_error(const DiagnosisInput& input) {
  const double before = percent_of(rmse(input.recorded, input.baseline));
  const double after = percent_of(input.diagnosis.null.recalibrated.rmse);
  if (percent(before) == percent(after))
    return fmt::format(
        "Fitting the study's parameters leaves the root-mean-square error of the simulated cone resistance "
        "at {}.",
        percent(after));
  return fmt::format(
      "Fitting the study's parameters takes the root-mean-square error of the simulated cone resistance from "
      "{} to {}.",
      percent(before), percent(after));
}

}  // namespace cpt::reports::diagnosed
