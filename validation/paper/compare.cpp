#include "validation/paper/compare.hpp"

#include <fmt/format.h>

#include <cmath>

#include "drawing/text.hpp"

namespace cpt::validation::paper {
namespace {

using drawing::decimals, drawing::number;

// Without numbers: a finding that has not been run.
Finding start(const Subject& subject, std::string published, std::string_view section, std::string check) {
  Finding finding;
  finding.row = subject.row;
  finding.quantity = subject.quantity;
  finding.published = std::move(published);
  finding.section = section;
  finding.check = std::move(check);
  return finding;
}

Verdict verdict(bool holds) { return holds ? Verdict::holds : Verdict::differs; }

std::string listed(const std::vector<std::string>& items) {
  return fmt::format("{}", fmt::join(items, "; "));
}

}  // namespace

std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds";
    case Verdict::differs:
      return "**differs**";
    case Verdict::shown:
      return "–";
    case Verdict::not_run:
      return "not run";
    case Verdict::not_published:
      return "not published";
  }
  return "";
}

std::string with_sign(double value, int digits) {
  return fmt::format("{}{}", value >= 0.0 ? "+" : "", decimals(value, digits));
}

std::string percent(double fraction, int digits) { return with_sign(100.0 * fraction, digits) + " %"; }

Value magnitude(const Value& value) { return {std::abs(value.number), value.missing}; }

Value relative_change(const Value& from, const Value& to) {
  if (!from) return from;
  if (!to) return to;
  return {to.number / from.number - 1.0, {}};
}

Finding compare_level(const Subject& subject, const Published& published, const Value& ours) {
  Finding finding = start(subject, fmt::format("{} kPa", number(published.value, 4)), published.section,
                          fmt::format("level within {:.0f} %", 100.0 * level_tolerance));
  finding.detail = ours.missing;
  if (!ours) return finding;
  const double relative = ours.number / published.value - 1.0;
  finding.ours = fmt::format("{} kPa", number(ours.number, 4));
  finding.difference = percent(relative);
  finding.verdict = verdict(std::abs(relative) <= level_tolerance);
  return finding;
}

Finding compare_effect(const Subject& subject, const Published& published, const Value& ours) {
  Finding finding = start(subject, "about " + percent(published.value, 0), published.section,
                          fmt::format("sign, and within {:.0f} points", 100.0 * effect_tolerance));
  finding.detail = ours.missing;
  if (!ours) return finding;
  const double apart = ours.number - published.value;
  finding.ours = percent(ours.number);
  finding.difference = fmt::format("{} points", with_sign(100.0 * apart, 1));
  finding.verdict = verdict(ours.number * published.value > 0.0 && std::abs(apart) <= effect_tolerance);
  return finding;
}

Finding compare_stress_rise(const Subject& subject, const Published& published, const Value& ours) {
  Finding finding = start(subject, "up to about " + percent(published.value, 0), published.section,
                          fmt::format("sign, and the stress within {:.0f} %", 100.0 * level_tolerance));
  finding.detail = ours.missing;
  if (!ours) return finding;
  const double relative = (1.0 + ours.number) / (1.0 + published.value) - 1.0;
  finding.ours = percent(ours.number);
  finding.difference = percent(relative) + " of the stress";
  finding.verdict = verdict(ours.number * published.value > 0.0 && std::abs(relative) <= level_tolerance);
  return finding;
}

Finding show(const Subject& subject, const Published& published, const Value& ours, int digits,
             std::string_view unit) {
  Finding finding =
      start(subject, fmt::format("{}{}", decimals(published.value, digits), unit), published.section, "");
  finding.detail = ours.missing;
  if (!ours) return finding;
  const double apart = ours.number - published.value;
  finding.ours = fmt::format("{}{}", decimals(ours.number, digits), unit);
  finding.difference = fmt::format("{}{}", with_sign(apart, digits), unit);
  finding.verdict = Verdict::shown;
  return finding;
}

Finding compare_sign(const Subject& subject, std::string statement, std::string_view section, Sign sign,
                     const Value& ours) {
  Finding finding = start(subject, std::move(statement), section, "sign");
  finding.detail = ours.missing;
  if (!ours) return finding;
  finding.ours = percent(ours.number);
  finding.verdict = verdict(sign == Sign::rises ? ours.number > 0.0 : ours.number < 0.0);
  return finding;
}

Finding compare_change(const Subject& subject, std::string statement, std::string_view section, Sign sign,
                       const Value& ours, int digits) {
  Finding finding = compare_sign(subject, std::move(statement), section, sign, ours);
  if (ours) finding.ours = with_sign(ours.number, digits);
  return finding;
}

Finding compare_nearer(const Subject& subject, std::string statement, const Published& target,
                       const Published& from, const Value& ours) {
  Finding finding = start(subject, std::move(statement), target.section,
                          fmt::format("nearer to {:.1f} than to {:.1f}", target.value, from.value));
  finding.detail = ours.missing;
  if (!ours) return finding;
  finding.ours = decimals(ours.number, 2);
  finding.verdict = verdict(std::abs(ours.number - target.value) < std::abs(ours.number - from.value));
  return finding;
}

Finding compare_less(const Subject& subject, std::string statement, std::string_view section,
                     const Value& lesser, const Value& greater, double factor) {
  const std::string check = factor == 1.0 ? "order" : fmt::format("less than {:g} times", factor);
  Finding finding = start(subject, std::move(statement), section, check);
  finding.detail = lesser ? greater.missing : lesser.missing;
  if (!lesser || !greater) return finding;
  finding.ours = fmt::format("{} against {}", decimals(lesser.number, 3), decimals(greater.number, 3));
  finding.verdict = verdict(lesser.number < factor * greater.number);
  return finding;
}

void compare_ranking(std::vector<Finding>& findings, std::string_view row, const Ranking& ranking,
                     const StudyView& study) {
  const RankingComparison result = compare(study, ranking);
  Finding order = start({row, "groups of parameters by |SI|"},
                        fmt::format("{} groups (indices below)", ranking.groups.size()), "5.2", "order");
  order.detail = result.missing;
  if (result.pairs > 0) {
    order.ours = fmt::format("{} of {} pairs in order", result.in_order, result.pairs);
    order.verdict = verdict(result.in_order == result.pairs);
    if (!result.out_of_order.empty())
      order.detail += (order.detail.empty() ? "" : "; ") + ("out of order: " + listed(result.out_of_order));
  }
  findings.push_back(std::move(order));

  std::size_t below = 0, all = 0;
  for (const Group& group : ranking.groups) {
    all += group.parameters.size();
    if (group.level == Level::at_or_below_noise) below += group.parameters.size();
  }
  Finding level =
      start({row, "parameters at or below SI<sub>noise</sub>"},
            fmt::format("{} of {} (indices below)", below, all), "5.2", "side of SI<sub>noise</sub>");
  level.detail = result.missing;
  if (result.levels > 0) {
    level.ours = fmt::format("{} of {} on the paper's side", result.at_level, result.levels);
    level.verdict = verdict(result.at_level == result.levels);
    if (!result.off_level.empty())
      level.detail += (level.detail.empty() ? "" : "; ") + ("on the other side: " + listed(result.off_level));
  }
  findings.push_back(std::move(level));
}

Finding not_run(const Subject& subject, std::string statement, std::string_view section, std::string why) {
  Finding finding = start(subject, std::move(statement), section, "");
  finding.detail = std::move(why);
  return finding;
}

}  // namespace cpt::validation::paper
