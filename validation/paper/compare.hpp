// Makes findings from the paper's values and ours.
#pragma once

#include "validation/paper/finding.hpp"
#include "validation/paper/published.hpp"
#include "validation/paper/ranking.hpp"
#include "validation/paper/studies.hpp"

namespace cpt::validation::paper {

/// A level holds within this part of the paper's value.
inline constexpr double level_tolerance = 0.10;
/// A relative effect holds with the paper's sign and within so much of it ("about +15 %": +10 to +20 %).
inline constexpr double effect_tolerance = 0.05;

/// Which finding.
struct Subject {
  std::string_view row;
  std::string quantity;  ///< Markdown
};

/// An average q_c [kPa], within level_tolerance.
[[nodiscard]] Finding compare_level(const Subject& subject, const Published& published, const Value& ours);
/// A relative change of q_c, within effect_tolerance.
[[nodiscard]] Finding compare_effect(const Subject& subject, const Published& published, const Value& ours);
/// A stress's largest rise over its initial value: the paper's sign, and the stress within level_tolerance.
[[nodiscard]] Finding compare_stress_rise(const Subject& subject, const Published& published,
                                          const Value& ours);
/// A number with so many decimals, shown beside the paper's.
[[nodiscard]] Finding show(const Subject& subject, const Published& published, const Value& ours, int digits,
                           std::string_view unit);
/// The sign of a relative change; `statement` is the paper's.
enum class Sign { falls, rises };
[[nodiscard]] Finding compare_sign(const Subject& subject, std::string statement, std::string_view section,
                                   Sign sign, const Value& ours);
/// The same of a change that is no relative one, with so many decimals.
[[nodiscard]] Finding compare_change(const Subject& subject, std::string statement, std::string_view section,
                                     Sign sign, const Value& ours, int digits);
/// That a number has come nearer to `target` than to where it started.
[[nodiscard]] Finding compare_nearer(const Subject& subject, std::string statement, const Published& target,
                                     const Published& start, const Value& ours);
/// That one number is less than `factor` times another, both shown.
[[nodiscard]] Finding compare_less(const Subject& subject, std::string statement, std::string_view section,
                                   const Value& lesser, const Value& greater, double factor = 1.0);
/// Order of the groups, and on which side of SI_noise each parameter lies: two findings.
void compare_ranking(std::vector<Finding>& findings, std::string_view row, const Ranking& ranking,
                     const StudyView& study);
/// Nothing of ours to show.
[[nodiscard]] Finding not_run(const Subject& subject, std::string statement, std::string_view section,
                              std::string why);

/// Without its sign.
[[nodiscard]] Value magnitude(const Value& value);
/// (to - from) / from; missing if either is.
[[nodiscard]] Value relative_change(const Value& from, const Value& to);
/// "+0.012".
[[nodiscard]] std::string with_sign(double value, int digits);
/// "+12.3 %".
[[nodiscard]] std::string percent(double fraction, int digits = 1);

}  // namespace cpt::validation::paper
