#include "drawing/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "drawing/palette.hpp"

namespace cpt::drawing {
namespace {

/// Two decimals of a point are 4 micrometres on paper.
std::string length(double value) {
  std::string text = fmt::format("{:.2f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

}  // namespace

Svg::Svg(double width, double height, std::string id, Ground ground)
    : width_(width), height_(height), id_(std::move(id)), ground_(ground) {}

std::string Svg::paint(std::string_view color) const {
  const auto* const named = std::ranges::find(palette::names, color, &palette::Name::color);
  return ground_ == Ground::file || named == palette::names.end() ? std::string(color)
                                                                  : fmt::format("var(--{})", named->name);
}

std::string Svg::stroke(const Pen& pen) const {
  std::string text = fmt::format(" stroke=\"{}\" stroke-width=\"{}\"", paint(pen.color), length(pen.width));
  if (!pen.dash.empty()) text += fmt::format(" stroke-dasharray=\"{}\"", pen.dash);
  return text;
}

void Svg::line(Point from, Point to, const Pen& pen) {
  fmt::format_to(std::back_inserter(body_), "<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"{}/>\n",
                 length(from.x), length(from.y), length(to.x), length(to.y), stroke(pen));
}

void Svg::rectangle(const Box& box, std::string_view fill, double opacity) {
  fmt::format_to(std::back_inserter(body_),
                 "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"{}/>\n", length(box.x),
                 length(box.y), length(box.width), length(box.height), paint(fill),
                 opacity < 1.0 ? fmt::format(" fill-opacity=\"{}\"", length(opacity)) : "");
}

void Svg::frame(const Box& box, const Pen& pen) {
  fmt::format_to(std::back_inserter(body_),
                 "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\"{}/>\n", length(box.x),
                 length(box.y), length(box.width), length(box.height), stroke(pen));
}

void Svg::circle(Point centre, double radius, std::string_view fill, const Pen& outline) {
  fmt::format_to(std::back_inserter(body_), "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\"{}/>\n",
                 length(centre.x), length(centre.y), length(radius), paint(fill), stroke(outline));
}

void Svg::polyline(std::span<const Point> points, const Pen& pen) {
  std::string path;
  bool down = false;
  for (const Point& p : points) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) {
      down = false;
      continue;
    }
    fmt::format_to(std::back_inserter(path), "{}{} {}", down ? "L" : "M", length(p.x), length(p.y));
    down = true;
  }
  if (path.empty()) return;
  fmt::format_to(std::back_inserter(body_), "<path d=\"{}\" fill=\"none\" stroke-linejoin=\"round\"{}/>\n",
                 path, stroke(pen));
}

void Svg::polygon(std::span<const Point> corners, std::string_view fill, double opacity) {
  std::string points;
  for (const Point& p : corners)
    fmt::format_to(std::back_inserter(points), "{},{} ", length(p.x), length(p.y));
  fmt::format_to(std::back_inserter(body_), "<polygon points=\"{}\" fill=\"{}\"{}/>\n", points, paint(fill),
                 opacity < 1.0 ? fmt::format(" fill-opacity=\"{}\"", length(opacity)) : "");
}

void Svg::image(const Box& box, std::string_view uri) {
  fmt::format_to(std::back_inserter(body_),
                 "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" "
                 "image-rendering=\"optimizeSpeed\" href=\"{}\"/>\n",
                 length(box.x), length(box.y), length(box.width), length(box.height), uri);
}

void Svg::text(Point at, const Rich& text, const TextStyle& style) {
  constexpr std::string_view anchors[] = {"start", "middle", "end"};
  const std::string place =
      style.upward ? fmt::format("transform=\"translate({} {}) rotate(-90)\"", length(at.x), length(at.y))
                   : fmt::format("x=\"{}\" y=\"{}\"", length(at.x), length(at.y));
  std::string spans;
  bool below = false;
  for (const Span& span : text) {
    // dy moves all that follows, so the way back up is written too.
    const double shift = subscript_drop * style.size * (span.subscript == below ? 0.0 : below ? -1.0 : 1.0);
    below = span.subscript;
    spans +=
        fmt::format("<tspan{}{}>{}</tspan>", shift != 0.0 ? fmt::format(" dy=\"{}\"", length(shift)) : "",
                    below ? fmt::format(" font-size=\"{}\"", length(style.size * subscript_size)) : "",
                    escape(span.text));
  }
  fmt::format_to(
      std::back_inserter(body_), "<text {} font-size=\"{}\" text-anchor=\"{}\" fill=\"{}\"{}{}>{}</text>\n",
      place, length(style.size), anchors[static_cast<int>(style.anchor)], paint(style.color),
      style.bold ? " font-weight=\"bold\"" : "",
      style.halo ? stroke({palette::paper, 2.4, {}}) + " stroke-linejoin=\"round\" paint-order=\"stroke\""
                 : "",
      spans);
}

void Svg::begin_clip(const Box& box) {
  const std::string name = fmt::format("{}_clip{}", id_, ++clips_);
  fmt::format_to(std::back_inserter(body_),
                 "<clipPath id=\"{0}\"><rect x=\"{1}\" y=\"{2}\" width=\"{3}\" height=\"{4}\"/></clipPath>\n"
                 "<g clip-path=\"url(#{0})\">\n",
                 name, length(box.x), length(box.y), length(box.width), length(box.height));
}

void Svg::end_clip() { body_ += "</g>\n"; }

void Svg::begin_part(const Box& box, std::string_view words) {
  fmt::format_to(std::back_inserter(body_),
                 "<g>\n<title>{}</title>\n<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" "
                 "pointer-events=\"all\"/>\n",
                 escape(words), length(box.x), length(box.y), length(box.width), length(box.height));
}

void Svg::end_part() { body_ += "</g>\n"; }

std::string Svg::document(std::string_view title) const {
  if (ground_ == Ground::page)
    return fmt::format(
        "<svg role=\"img\" aria-label=\"{}\" viewBox=\"0 0 {} {}\" font-family=\"{}\" "
        "xml:space=\"preserve\">\n{}</svg>\n",
        escape(title), length(width_), length(height_), font_family, body_);
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}pt\" height=\"{1}pt\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"{2}\" xml:space=\"preserve\">\n<title>{3}</title>\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n{4}</svg>\n",
      length(width_), length(height_), font_family, escape(title), body_);
}

}  // namespace cpt::drawing
