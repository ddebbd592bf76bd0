// What the study's design says of its inputs: bars with intervals, and all numbers.
"use strict";

const label_of_effect = (row) => {
  const one = row.parameter ? parameter_of.get(row.parameter).label : [["", false]];
  return row.other_parameter ? [...one, [" × ", false], ...parameter_of.get(row.other_parameter).label] : one;
};
const effects_in = (window, quantity) =>
  data.effects.filter((row) => row.window === window.name && row.quantity === quantity);

/// What is drawn of a kind: a bar with its interval, and a circle.
const drawn_of = {
  pairs: { bar: "interaction", circle: null, unit: " (kPa)", before: "interaction in the average ",
           words: "bar: interaction of two inputs; line: 95 % interval from the repeats." },
  morris: { bar: "mu_star", circle: "sigma", unit: " (kPa)", before: "elementary effect on the average ",
            words: "bar: mean size μ* of the elementary effects, lower to upper bound, with its 95 % interval; circle: their " +
              "standard deviation σ, large where the effect is not linear or depends on other inputs." },
};
const shares_drawn = {
  bar: "total_order", circle: "first_order", unit: " (-)", before: "share of the variance of the average ",
  words: "bar: share of the variance with all interactions (total order) and its 95 % interval; circle: alone (first order).",
};

function effect_bars(window, drawn) {
  const size = (row) => (known(row.value) ? Math.abs(row.value) : -1);
  const rows = d3.sort(effects_in(window, drawn.bar), (row) => -size(row)).slice(0, 20);
  const labels = rows.map(label_of_effect);
  const key_of = (row) => `${row.parameter} ${row.other_parameter}`;
  const values = rows.filter((row) => known(row.value));
  const circles = effects_in(window, drawn.circle).filter((row) => known(row.value));
  const end = (row) => d3.max([0, row.value, row.upper].filter(known));
  const words = (row) => [plain(label_of_effect(row)), `${number(row.value)} ${row.unit}`,
    known(row.lower) ? `95 %: ${number(row.lower)} to ${number(row.upper)}` : "", row.note].filter((line) => line).join("\n");
  return (width) => {
    const svg = Plot.plot({
      ...frame_of(rows, labels, width),
      x: { insetRight: 64, label: "q_c", labelAnchor: "center", labelArrow: "none", grid: true, tickSpacing: 80 },
      y: { domain: rows.map(key_of), label: null, tickSize: 0, padding: 0.35 },
      marks: [
        Plot.barX(values, { x: "value", y: key_of, fill: (row) => (row.value < 0 ? "var(--vermillion)" : "var(--blue)"), className: "effect" }),
        Plot.ruleY(values.filter((row) => known(row.lower)), { x1: "lower", x2: "upper", y: key_of, stroke: "var(--ink)",
                                                               strokeWidth: 1.5, marker: "tick" }),
        Plot.dot(circles, { x: "value", y: key_of, r: 4, fill: "var(--paper)", stroke: "var(--vermillion)", strokeWidth: 2 }),
        Plot.text(values, { x: end, y: key_of, text: (row) => number(row.value, 3), textAnchor: "start", dx: 9, fill: "var(--ink)",
                            stroke: "var(--paper)", strokeWidth: 4 }),
        Plot.text(rows.filter((row) => !known(row.value)), {
          x: 0, y: key_of, text: () => "× undefined", textAnchor: "start", dx: 5, fill: "var(--warn)" }),
        Plot.ruleX([0], { stroke: "var(--ink)" }),
        Plot.tip(rows, Plot.pointerY({ y: key_of, x: (row) => row.value || 0, title: words, fill: "var(--paper)", stroke: "var(--muted)" })),
      ],
    });
    set_labels(svg, "y-axis tick label", labels);
    set_labels(svg, "x-axis label", [with_q_c(drawn.before, drawn.unit)]);
    return svg;
  };
}

/// What holds for all inputs of a window; the notes of pairs are their own.
function remarks(rows) {
  const fit = rows.find((row) => row.quantity === "Q2");
  if (fit) return [[`Polynomial chaos, Q² = ${decimals(fit.value, 3)}`, fit.note].filter((words) => words).join("; ")];
  return data.design === "pairs" ? [] : new Set(rows.map((row) => row.note).filter((note) => note));
}

function effects() {
  if (!data.effects.length) return;
  const section = byId("effects");
  section.hidden = false;
  const drawn = drawn_of[data.design] || shares_drawn;
  section.append(el("p", {}, `Design ${data.design.replaceAll("_", " ")}: inputs changed together.`));
  for (const window of data.windows) {
    const rows = data.effects.filter((row) => row.window === window.name);
    section.append(el("h3", {}, window.name));
    for (const words of remarks(rows))
      section.append(el("p", { class: words.includes("not to be believed") ? "warn" : null }, words));
    section.append(
      figure(`What the design says in window ${window.name}`, el("span", {}, drawn.words), effect_bars(window, drawn)),
      el("details", {}, el("summary", {}, `Numbers of the design in ${window.name}`),
        table([{ name: "input" }, { name: "quantity" }, { name: "value", numeric: true }, { name: "from (95 %)", numeric: true },
               { name: "to (95 %)", numeric: true }, { name: "unit" }, { name: "used", numeric: true }, { name: "dropped", numeric: true },
               { name: "note", long: true }],
          rows.map((row) => ({
            class: known(row.value) ? null : "failed",
            cells: [rich(label_of_effect(row)), row.quantity, number(row.value), number(row.lower), number(row.upper), row.unit,
                    String(row.used), String(row.dropped), row.note],
          })), `Numbers of the design in ${window.name}`)));
  }
}
