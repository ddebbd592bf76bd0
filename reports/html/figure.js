// Figures with one row an input, mechanism or the like.
"use strict";

const figure_style = { background: "transparent", color: "var(--ink)", fontSize: "13px" };
const text_width = (texts) => 7.6 * d3.max(texts, (text) => text.length);

/// Calls `draw` with the width of an element, now and whenever it changes.
function on_width(element, draw) {
  let width = 0;
  new ResizeObserver(() => requestAnimationFrame(() => {
    const now = Math.floor(element.clientWidth);
    if (now === 0 || now === width) return;
    width = now;
    draw(width);
  })).observe(element);
}

/// Draws a figure as wide as its place, and again when that changes.
function figure(description, caption, draw) {
  const drawing = el("div", { role: "img", "aria-label": description });
  const box = el("figure", {}, drawing, el("figcaption", {}, caption));
  on_width(box, (width) => drawing.replaceChildren(draw(Math.min(width, 900))));
  return box;
}

const row_height = 26;
const frame_of = (rows, labels, width) => ({
  width,
  height: row_height * rows.length + 60,
  marginLeft: Math.min(text_width(labels.map(plain)) + 12, 0.45 * width),
  marginTop: 6,
  marginRight: 12,
  marginBottom: 46,
  style: figure_style,
});
