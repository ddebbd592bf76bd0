#include "reports/notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "drawing/text.hpp"
#include "reports/labels.hpp"
#include "results/push/push_start.hpp"

namespace cpt::reports {

using results::Snapshot;

namespace {

/// The longest beginning of a text, at least one character, that is no wider than the room.
std::string_view beginning(std::string_view text, double size, double room, bool bold) {
  std::size_t end = 0;
  while (end < text.size()) {
    std::size_t next = end + 1;
    while (next < text.size() && (static_cast<unsigned char>(text[next]) & 0xC0) == 0x80) ++next;
    if (end > 0 && width(drawing::plain(text.substr(0, next)), size, bold) > room) break;
    end = next;
  }
  return text.substr(0, end);
}

}  // namespace

std::vector<std::string> wrapped(std::string_view text, double size, double room, bool bold) {
  std::vector<std::string> lines(1);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    std::string_view word = text.substr(at, end - at);
    at = end + 1;
    const std::string longer =
        lines.back().empty() ? std::string(word) : lines.back() + " " + std::string(word);
    if (width(drawing::plain(longer), size, bold) <= room) {
      lines.back() = longer;
      continue;
    }
    if (!lines.back().empty()) lines.emplace_back();
    while (width(drawing::plain(word), size, bold) > room && !word.empty()) {
      const std::string_view part = beginning(word, size, room, bold);
      lines.back() = part;
      lines.emplace_back();
      word.remove_prefix(part.size());
    }
    lines.back() = word;
  }
  return lines;
}

std::string moment(std::string_view time) {
  const std::size_t fraction = time.find('.');
  return fraction == std::string_view::npos ? std::string(time) : std::string(time.substr(0, fraction)) + "Z";
}

std::string window_remark(const Snapshot& campaign, const results::WindowRow& window) {
  if (!window.output.empty()) return "";  // of a push alone
  std::size_t runs = 0;
  double deepest = 0.0;  // [m]
  for (const results::CurveRow& curve : campaign.curves) {
    const std::size_t start = results::bins_of_start(curve.profile);
    if (start == 0 || curve.profile.depth[start - 1] < window.from_m || curve.profile.depth[0] > window.to_m)
      continue;
    ++runs;
    deepest = std::max(deepest, curve.profile.depth[start - 1]);
  }
  if (runs == 0) return "";
  return fmt::format(
      "The window holds the start of the push (to {:.4f} m), where the cone's blow on the soil adds to q_c: "
      "in {} of "
      "{} curves the average is too high. Let it begin deeper.",
      deepest, runs, campaign.curves.size());
}

bool to_come(const Snapshot& campaign, const results::SensitivityRow& row) {
  const auto waiting = [](const results::RealizationRow* run) { return run != nullptr && run->waiting(); };
  return waiting(baseline_run(campaign)) || waiting(bound_run(campaign, row.parameter, "lower")) ||
         waiting(bound_run(campaign, row.parameter, "upper"));
}

std::string input_words(const Snapshot& campaign, const results::WindowRow& window,
                        const results::SensitivityRow& row) {
  const results::ParameterRow& p = parameter_of(campaign, row.parameter);
  const std::string unit = p.unit.empty() || p.unit == "-" ? "" : " " + p.unit;
  std::string words = fmt::format("{}: {}", words_of(symbol_of(campaign, p)), p.meaning);
  for (const auto& [side, value, q_kPa] : {std::tuple{"lower", p.lower_text, row.q_lower_kPa},
                                           std::tuple{"upper", p.upper_text, row.q_upper_kPa}})
    words +=
        fmt::format("\n{} {}{}: {}{}", side, value, unit, drawing::number(q_kPa, 4), unit_behind(window));
  if (!std::isfinite(row.si) && to_come(campaign, row)) return words + "\nSI not known yet";
  words += "\nSI " + drawing::decimals(row.si, 4);
  if (std::isfinite(row.si_half_width)) words += " ± " + drawing::decimals(row.si_half_width, 4);
  return row.note.empty() ? words : words + "\n" + row.note;
}

}  // namespace cpt::reports
