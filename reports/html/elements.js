// Elements, numbers and labels. Text from the database only ever becomes text nodes.
"use strict";

const byId = (id) => document.getElementById(id);

function el(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (value !== null && value !== undefined && value !== false)
      element.setAttribute(name, value === true ? "" : value);
  }
  put(element, ...children);
  return element;
}

const known = (value) => typeof value === "number" && Number.isFinite(value);
const minus = (text) => text.replace("-", "−");
/// To so many significant digits; "–" for what is not known.
function number(value, digits = 4) {
  if (!known(value)) return "–";
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-4 || size >= 1e7)) return minus(value.toExponential(digits - 1));
  return minus(String(Number(value.toPrecision(digits))));
}
const decimals = (value, digits) => (known(value) ? minus(value.toFixed(digits)) : "–");
const percent = (value) => {
  if (!known(value)) return "–";
  const shown = Math.round(1000 * value) / 10 || 0; // neither +0.0 nor −0.0
  return `${shown > 0 ? "+" : ""}${decimals(shown, 1)} %`;
};
/// " (kPa)" behind what a column of a window's numbers is called.
const in_unit = (window) => (window.unit ? ` (${window.unit.trim()})` : "");
/// UTC as ISO 8601 writes it, to the second: "2026-11-29T18:20:33Z".
const moment = (text) => (text ? text.replace(/\.\d+Z$/, "Z") : text);
function duration(seconds) {
  if (seconds < 120) return `${Math.round(seconds)} s`;
  return seconds < 7200 ? `${Math.round(seconds / 60)} min` : `${number(seconds / 3600, 3)} h`;
}

// A label is a list of [text, is it a subscript?].
const plain = (label) => label.map(([text]) => text).join("");
const rich = (label) => {
  const fragment = document.createDocumentFragment();
  for (const [text, below] of label) fragment.append(below ? el("sub", {}, text) : text);
  return fragment;
};

/// Replaces the text of SVG labels by labels with subscripts, in their order.
function set_labels(svg, group, labels) {
  svg.querySelectorAll(`[aria-label="${group}"] text`).forEach((text, i) => {
    if (!labels[i]) return;
    text.replaceChildren();
    let drop = 0;
    for (const [part, below] of labels[i]) {
      const span = document.createElementNS("http://www.w3.org/2000/svg", "tspan");
      const level = below ? 0.22 : 0;
      if (level !== drop) span.setAttribute("dy", `${((level - drop) / (below ? 0.75 : 1)).toFixed(3)}em`);
      if (below) span.setAttribute("font-size", "75%");
      drop = level;
      span.textContent = part;
      text.append(span);
    }
  });
}

/// Appends what is there.
function put(parent, ...children) {
  parent.append(...children.filter((child) => child !== null && child !== undefined));
}
const look_of = (column) =>
  [column.numeric && "n", column.long && "long", column.screen && "screen"].filter(Boolean).join(" ") || null;
const cell = (content, column) => el("td", { class: look_of(column) }, content);
function table(columns, rows, caption) {
  return el("div", { class: "wide", tabindex: "0", role: "region", "aria-label": caption },
    el("table", {},
      el("thead", {}, el("tr", {}, ...columns.map((c) => el("th", { scope: "col", class: look_of(c) }, c.name)))),
      el("tbody", {}, ...rows.map((row) =>
        el("tr", { class: row.class }, ...row.cells.map((c, i) => cell(c, columns[i])))))));
}
