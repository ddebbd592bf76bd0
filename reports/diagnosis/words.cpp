#include "reports/diagnosis/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "drawing/text.hpp"

namespace cpt::reports::diagnosed {

using drawing::decimals, drawing::escape, drawing::number, drawing::Span, drawing::symbolic;

double percent_of(double ln) { return 100.0 * std::expm1(ln); }

std::string percent(double value) { return decimals(value, std::abs(value) < 9.95 ? 1 : 0) + " %"; }

std::string p_value(double p) {
  return p < 0.001 ? "p < 0.001" : fmt::format("p = {}", decimals(p, p < 0.1 ? 3 : 2));
}

std::string probability(double value) {
  if (value < 0.001) return "below 0.001";
  if (value > 0.999) return "above 0.999";
  return decimals(value, value < 0.01 || value > 0.99 ? 3 : 2);
}

std::string brief(double value) {
  std::string text = number(value, 3);
  if (text.find('.') == std::string::npos || text.find('e') != std::string::npos) return text;
  while (text.ends_with('0')) text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text;
}

std::string metres(double depth) {
  std::string text = decimals(depth, 3);
  while (text.ends_with('0') && !text.ends_with(".0")) text.pop_back();
  return text;
}

std::string with_deviation(double value, double deviation, std::string_view unit) {
  if (!std::isfinite(deviation) || deviation <= 0.0) return brief(value) + unit_after(unit);
  const double power = std::floor(std::log10(deviation));
  const bool leads_with_one = deviation < 2.0 * std::pow(10.0, power);
  const int places = std::clamp(static_cast<int>(-power) + (leads_with_one ? 1 : 0), 0, 9);
  return fmt::format("{} ± {}{}", decimals(value, places), decimals(deviation, places), unit_after(unit));
}

std::string unit_after(std::string_view unit) {
  return unit.empty() || unit == "-" ? "" : fmt::format(" {}", unit);
}

std::string capitalized(std::string text) {
  if (!text.empty() && text.front() >= 'a' && text.front() <= 'z')
    text.front() = static_cast<char>(text.front() - 'a' + 'A');
  return text;
}

std::string listed(const std::vector<std::string>& items, std::string_view last) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0) text += i + 1 < items.size() ? ", " : fmt::format(" {} ", last);
    text += items[i];
  }
  return text;
}

std::string markdown(std::string_view text) {
  // Backslashes first: the entities of escape() hold none of these characters outside themselves.
  std::string safe;
  for (const char c : text) {
    if (std::string_view("\\`*_[]#!{}~$").find(c) != std::string_view::npos) safe += '\\';
    safe += c == '\n' || c == '\r' ? ' ' : c;
  }
  safe = escape(safe);
  // Quotes matter in attributes only, and there are none.
  for (const auto& [entity, plain_text] : {std::pair{"&#39;", "'"}, std::pair{"&quot;", "\""}})
    for (std::size_t at = 0; (at = safe.find(entity, at)) != std::string::npos; ++at)
      safe.replace(at, std::string_view(entity).size(), plain_text);
  return safe;
}

std::string markdown_symbol(std::string_view symbol) {
  std::string text;
  for (const Span& span : symbolic(symbol))
    text += span.subscript ? fmt::format("<sub>{}</sub>", markdown(span.text)) : markdown(span.text);
  return text;
}

}  // namespace cpt::reports::diagnosed
