#include "drawing/text.hpp"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

namespace cpt::drawing {
namespace {

struct Character {
  std::string_view bytes;
  std::uint32_t code;
  bool valid;
};

/// The first character of a text that is not empty; a broken sequence is one invalid byte.
Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  const std::size_t length = lead < 0x80 ? 1 : lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC2 ? 2 : 0;
  if (length == 0 || lead > 0xF4 || length > text.size()) return {text.substr(0, 1), 0, false};
  std::uint32_t code = length == 1 ? lead : lead & (0xFFu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {text.substr(0, 1), 0, false};
    code = (code << 6) | (byte(i) & 0x3F);
  }
  constexpr std::array<std::uint32_t, 5> least = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  return {text.substr(0, length), code, code >= least[length] && code <= 0x10FFFF && !surrogate};
}

template <class Use>
void for_each_character(std::string_view text, const Use& use) {
  while (!text.empty()) {
    const Character c = first_character(text);
    use(c);
    text.remove_prefix(c.bytes.size());
  }
}

constexpr std::array<std::pair<std::string_view, std::string_view>, 29> subscripts = {
    {{"₀", "0"}, {"₁", "1"}, {"₂", "2"}, {"₃", "3"}, {"₄", "4"}, {"₅", "5"}, {"₆", "6"}, {"₇", "7"},
     {"₈", "8"}, {"₉", "9"}, {"ₐ", "a"}, {"ₑ", "e"}, {"ₒ", "o"}, {"ₓ", "x"}, {"ₕ", "h"}, {"ₖ", "k"},
     {"ₗ", "l"}, {"ₘ", "m"}, {"ₙ", "n"}, {"ₚ", "p"}, {"ₛ", "s"}, {"ₜ", "t"}, {"ᵢ", "i"}, {"ᵣ", "r"},
     {"ᵤ", "u"}, {"ᵥ", "v"}, {"ⱼ", "j"}, {"₊", "+"}, {"₋", "−"}}};

std::string_view subscript_letter(std::string_view bytes) {
  const auto* found =
      std::find_if(subscripts.begin(), subscripts.end(), [&](const auto& s) { return s.first == bytes; });
  return found == subscripts.end() ? std::string_view() : found->second;
}

void append(Rich& text, std::string_view bytes, bool subscript) {
  if (text.empty() || text.back().subscript != subscript) text.push_back({"", subscript});
  text.back().text += bytes;
}

std::string true_minus(std::string text) {
  if (text.starts_with('-')) text.replace(0, 1, "−");
  return text;
}

/// One font of cairo, to measure with.
class Ruler {
 public:
  explicit Ruler(bool bold)
      : surface_(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1), cairo_surface_destroy),
        context_(cairo_create(surface_.get()), cairo_destroy) {
    cairo_select_font_face(context_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context_.get(), 100.0);
  }
  [[nodiscard]] double width(const std::string& text) const {  // per unit of font size
    cairo_text_extents_t extents{};
    cairo_text_extents(context_.get(), text.c_str(), &extents);
    return extents.x_advance / 100.0;
  }

 private:
  std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface_;
  std::unique_ptr<cairo_t, decltype(&cairo_destroy)> context_;
};

}  // namespace

std::string escape(std::string_view text) {
  std::string out;
  for_each_character(text, [&](const Character& c) {
    const bool control = (c.code < 0x20 && c.code != '\n' && c.code != '\t') || c.code == 0x7F ||
                         c.code == 0xFFFE || c.code == 0xFFFF;
    if (!c.valid || control)
      out += "\uFFFD";
    else if (c.code == '&')
      out += "&amp;";
    else if (c.code == '<')
      out += "&lt;";
    else if (c.code == '>')
      out += "&gt;";
    else if (c.code == '"')
      out += "&quot;";
    else if (c.code == '\'')
      out += "&#39;";
    else
      out += c.bytes;
  });
  return out;
}

Rich plain(std::string_view text) { return {{std::string(text), false}}; }

Rich symbolic(std::string_view text) {
  Rich out;
  bool below = false;  // after '_'
  while (!text.empty()) {
    const Character c = first_character(text);
    text.remove_prefix(c.bytes.size());
    const std::string_view letter = subscript_letter(c.bytes);
    const bool list =
        c.bytes == "," && !text.empty() && text.front() != ' ';  // "e_cs,0" goes on below the line
    const bool after_subscript = !out.empty() && out.back().subscript;
    if (c.bytes == "_") {
      below = true;
    } else if (!letter.empty()) {
      append(out, letter, true);
    } else if (list && after_subscript) {
      below = true;
      append(out, c.bytes, true);
    } else {
      if (std::string_view(" /()[]=,;:").find(c.bytes) != std::string_view::npos) below = false;
      append(out, c.bytes, below);
    }
  }
  return out;
}

Rich operator+(Rich left, const Rich& right) {
  left.insert(left.end(), right.begin(), right.end());
  return left;
}

std::string words_of(const Rich& text) {
  std::string words;
  for (const Span& span : text) words += span.text;
  return words;
}

std::string html(const Rich& text) {
  std::string out;
  for (const Span& span : text)
    out += span.subscript ? fmt::format("<sub>{}</sub>", escape(span.text)) : escape(span.text);
  return out;
}

double width(const Rich& text, double font_size, bool bold) {
  static const Ruler regular(false);
  static const Ruler heavy(true);
  double sum = 0.0;
  for (const Span& span : text) {
    std::string printable;
    for_each_character(span.text, [&](const Character& c) { printable += c.valid ? c.bytes : "\uFFFD"; });
    sum += (bold ? heavy : regular).width(printable) * font_size * (span.subscript ? subscript_size : 1.0);
  }
  return sum;
}

std::string number(double value, int digits) {
  if (!std::isfinite(value)) return "–";
  if (value == 0.0) return "0";
  const int whole = static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
  if (whole > 9 || whole < -5) return true_minus(fmt::format("{:.{}g}", value, digits));
  return true_minus(fmt::format("{:.{}f}", value, std::max(0, digits - whole)));
}

std::string decimals(double value, int digits) {
  if (!std::isfinite(value)) return "–";
  std::string text = fmt::format("{:.{}f}", value, digits);
  if (text.find_first_not_of("-0.") == std::string::npos && text.front() == '-') text.erase(0, 1);
  return true_minus(text);
}

}  // namespace cpt::drawing
