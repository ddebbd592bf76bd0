// A small writer of SVG figures. Lengths are typographic points (1/72 inch) from the upper left corner.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "drawing/text.hpp"

namespace cpt::drawing {

struct Point {
  double x, y;
};
struct Box {
  double x, y, width, height;
  [[nodiscard]] double right() const { return x + width; }
  [[nodiscard]] double bottom() const { return y + height; }
};

struct Pen {
  std::string_view color = "#000000";
  double width = 0.6;
  std::string_view dash = {};  ///< e.g. "3 2"; solid if empty
};

enum class Anchor { start, middle, end };

struct TextStyle {
  double size = 8.0;
  Anchor anchor = Anchor::start;
  std::string_view color = "#222222";
  bool bold = false;
  bool halo = false;    ///< white outline, so that lines behind do not disturb
  bool upward = false;  ///< turned by 90 degrees, read from bottom to top
};

/// Where a figure stands. A file has its size on paper, a title and white ground; in a page its place gives
/// the width, and the style sheet the colours, by their names in palette.hpp.
enum class Ground { file, page };

class Svg {
 public:
  /// `id` makes the ids inside the figure unique on a page with several; letters, digits and '_' only.
  Svg(double width, double height, std::string id, Ground ground = Ground::file);

  void line(Point from, Point to, const Pen& pen);
  void rectangle(const Box& box, std::string_view fill, double opacity = 1.0);
  void frame(const Box& box, const Pen& pen);
  void circle(Point centre, double radius, std::string_view fill, const Pen& outline);
  /// Points that are not finite break the line.
  void polyline(std::span<const Point> points, const Pen& pen);
  void polygon(std::span<const Point> corners, std::string_view fill, double opacity = 1.0);
  /// A picture as png_uri() gives it, its pixels as hard squares.
  void image(const Box& box, std::string_view uri);
  /// `at` is on the base line.
  void text(Point at, const Rich& text, const TextStyle& style = {});

  /// What is drawn until end_clip() shows inside the box only.
  void begin_clip(const Box& box);
  void end_clip();

  /// What is drawn until end_part() is told in words where the pointer rests anywhere in the box.
  void begin_part(const Box& box, std::string_view words);
  void end_part();

  /// The complete SVG document. In a page the title is what the figure is called, not shown.
  [[nodiscard]] std::string document(std::string_view title) const;
  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] Ground ground() const { return ground_; }

 private:
  [[nodiscard]] std::string paint(std::string_view color) const;
  [[nodiscard]] std::string stroke(const Pen& pen) const;

  double width_, height_;
  std::string id_;
  Ground ground_;
  std::string body_;
  int clips_ = 0;
};

}  // namespace cpt::drawing
