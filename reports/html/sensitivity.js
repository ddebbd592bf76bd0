// Tornado and sensitivity indices of every window.
"use strict";

const lines_of = (row) => {
  const p = parameter_of.get(row.parameter);
  return [`${plain(p.label)}: ${p.meaning}`,
    `lower ${p.lower} ${p.unit}: ${number(row.q_lower_kPa)} kPa`,
    `upper ${p.upper} ${p.unit}: ${number(row.q_upper_kPa)} kPa`,
    `SI ${decimals(row.si, 4)}${known(row.si_half_width) ? ` ± ${decimals(row.si_half_width, 4)}` : ""}`, row.note].filter((line) => line).join("\n");
};
const tip = (rows, options) =>
  Plot.tip(rows, Plot.pointerY({ ...options, title: lines_of, fill: "var(--paper)", stroke: "var(--muted)" }));

function tornado(window) {
  const rows = d3.sort(indices_in(window), (row) => (has_both(row) ? -swing(row) : 1));
  const base = mean(baseline, window);
  const labels = rows.map((row) => label_of(parameter_of.get(row.parameter)));
  const names = rows.map((row) => row.parameter);
  // Each half has its bound's colour; they meet at the baseline, or halfway where that lies outside.
  const halves = rows.flatMap((row) => {
    const ends = [row.q_lower_kPa, row.q_upper_kPa].filter(known);
    const inside = ends.length < 2 || (base.q_c_mean_kPa - ends[0]) * (base.q_c_mean_kPa - ends[1]) <= 0;
    const meet = inside ? base.q_c_mean_kPa : d3.mean(ends);
    return ["lower", "upper"].filter((side) => known(row[`q_${side}_kPa`])).map((side) => {
      const end = row[`q_${side}_kPa`];
      const other = row[`q_${side === "lower" ? "upper" : "lower"}_kPa`];
      const right = end === other ? side === "upper" : end > (known(other) ? other : base.q_c_mean_kPa);
      return { parameter: row.parameter, side, meet, end, right, text: parameter_of.get(row.parameter)[side] };
    });
  });
  // What is missing stands in the half of the frame that the row's own half bar leaves free.
  const gaps = rows.map((row) => {
    const words = ["lower", "upper"].map((side) => missing(row, side)).filter((text) => text);
    const both = words.length === 2 && to_come(row) && words.every((text) => text.endsWith("not run yet"));
    const beyond = d3.sum(["lower", "upper"], (side) => (known(row[`q_${side}_kPa`]) ? row[`q_${side}_kPa`] - base.q_c_mean_kPa : 0));
    return { row, parameter: row.parameter, left: beyond > 0, text: both ? "not run yet" : words.join(", ") };
  }).filter((gap) => gap.text);
  const ends = (right) => Plot.text(halves.filter((half) => half.right === right), {
    x: "end", y: "parameter", text: "text", textAnchor: right ? "start" : "end", dx: right ? 4 : -4,
    fill: "var(--ink)", stroke: "var(--paper)", strokeWidth: 4,
  });
  // Where nothing varies a scale of no width would fill the frame with bars.
  const extent = d3.extent([base.q_c_mean_kPa, ...halves.map((half) => half.end)]);
  const margin = extent[0] < extent[1] ? 0 : Math.max(0.05 * Math.abs(extent[0]), 1e-6);
  return (width) => {
    const room = Math.min(text_width(halves.map((half) => half.text).concat("00")) + 10, 0.2 * width);
    const svg = Plot.plot({
      ...frame_of(rows, labels, width),
      x: { domain: [extent[0] - margin, extent[1] + margin], insetLeft: room, insetRight: room, label: "q_c", labelAnchor: "center", labelArrow: "none", nice: true, tickSpacing: 80, grid: true },
      y: { domain: names, label: null, tickSize: 0, padding: 0.35 },
      marks: [
        Plot.barX([base], { x1: "q_c_min_kPa", x2: "q_c_max_kPa", fill: "var(--band)", inset: 0, clip: true }),
        ...["lower", "upper"].map((side) => Plot.barX(halves.filter((half) => half.side === side), {
          x1: "meet", x2: "end", y: "parameter", fill: side === "lower" ? "var(--blue)" : "var(--vermillion)",
          className: side,
        })),
        Plot.ruleX([base.q_c_mean_kPa], { stroke: "var(--ink)", strokeWidth: 1.5 }),
        ends(true), ends(false),
        ...[true, false].map((left) => Plot.text(gaps.filter((gap) => gap.left === left), {
          frameAnchor: left ? "left" : "right", y: "parameter", text: (gap) => (to_come(gap.row) ? gap.text : `× ${gap.text}`),
          textAnchor: left ? "start" : "end", fill: (gap) => its_colour(gap.row), stroke: "var(--paper)", strokeWidth: 4 })),
        tip(rows, { y: "parameter", x: (row) => (known(row.q_upper_kPa) ? row.q_upper_kPa : base.q_c_mean_kPa) }),
      ],
    });
    set_labels(svg, "y-axis tick label", labels);
    set_labels(svg, "x-axis label", [with_q_c("average ", " (kPa)")]);
    return svg;
  };
}

function indices(window) {
  const rows = d3.sort(indices_in(window), (row) => (known(row.si_abs) ? -row.si_abs : 1));
  const labels = rows.map((row) => parameter_of.get(row.parameter).label);
  const noise = rows.map((row) => row.si_noise).find(known);
  const bars = rows.filter((row) => known(row.si_abs));
  const half = (row) => row.si_half_width || 0;
  const bar = (some, fill, className) => Plot.barX(some, { x: "si_abs", y: "parameter", fill, className });
  return (width) => {
    const svg = Plot.plot({
      ...frame_of(rows, labels, width),
      x: { domain: [0, 1.02 * d3.max([noise, ...bars.map((row) => row.si_abs + half(row)), 1e-3].filter(known))], insetRight: 64,
           label: "|SI| (-)", labelAnchor: "center", labelArrow: "none", grid: true },
      y: { domain: rows.map((row) => row.parameter), label: null, tickSize: 0, padding: 0.35 },
      marks: [
        bar(bars.filter(is_loud), "var(--blue)", "loud"),
        bar(bars.filter((row) => !is_loud(row)), "var(--faint)", "quiet"),
        known(noise) ? Plot.ruleX([noise], { stroke: "var(--ink)", strokeWidth: 1.5, strokeDasharray: "5 4" }) : null,
        Plot.ruleY(bars.filter(half), { x1: (row) => Math.max(0, row.si_abs - half(row)), x2: (row) => row.si_abs + half(row),
                                        y: "parameter", stroke: "var(--ink)", strokeWidth: 1.5, marker: "tick" }),
        Plot.text(bars, { x: (row) => row.si_abs + half(row), y: "parameter", text: (row) => decimals(row.si, 3), textAnchor: "start", dx: 5,
                          fill: "var(--ink)", stroke: "var(--paper)", strokeWidth: 4 }),
        Plot.text(rows.filter((row) => !known(row.si_abs)), {
          x: 0, y: "parameter", text: without_index, textAnchor: "start", dx: 5, fill: its_colour }),
        Plot.ruleX([0], { stroke: "var(--ink)" }),
        tip(rows, { y: "parameter", x: (row) => row.si_abs || 0 }),
      ],
    });
    set_labels(svg, "y-axis tick label", labels);
    return svg;
  };
}

const key = (color) => el("span", { class: "key", style: `background: var(--${color})` });

// Why there is no noise from repeats.
function without_repeats() {
  const all = runs.filter((run) => run.side === "repeat");
  if (!all.length) return ": the study has no repeats";
  return all.some(waiting) ? " until the repeats have run" : ": too few repeats completed";
}

function sensitivity() {
  const section = byId("sensitivity");
  if (!data.parameters.length) section.append(el("p", {}, "The study has no uncertain input."));
  for (const window of data.windows) {
    const rows = indices_in(window);
    if (!rows.length) continue;
    section.append(el("h3", {}, `${window.name}, ${depths(window)}`));
    if (!baseline || !mean(baseline, window)) {
      section.append(el("p", { class: baseline && waiting(baseline) ? "muted" : "warn" }, `Nothing to compare with: ${no_baseline(window)}.`));
      continue;
    }
    const noise = rows.map((row) => row.si_noise).find(known);
    const repeats = repeats_in(window);
    section.append(
      el("div", { class: "pair" },
        figure(`Tornado of the average cone resistance in window ${window.name}`,
          el("span", {}, "Range of the average ", rich(q_c), " between each input's bounds, whose values stand at the ends;",
            key("blue"), "to the lower bound", key("vermillion"), "to the upper bound", key("band"),
            "spread of the baseline inside the window."), tornado(window)),
        figure(`Sensitivity indices in window ${window.name}`,
          el("span", {}, "Size of SI = (", rich(q_c), " at the upper − at the lower bound) / ", rich(q_c),
            " at the upper bound, with its sign as a number", repeats ? `, and its own 95 % interval from ${repeats.runs} runs ` +
              "of the baseline with shifted material points" + (repeats_so_far() && `, ${repeats_so_far()}`) +
              (rows.some((row) => row.pairs) ? ", or where its bounds were repeated, too, from these pairs" : "") : "", ";", key("faint"),
            repeats ? "within that interval of 0, so perhaps noise;" : "within the noise;", el("span", { class: "key line" }),
            "spread of the baseline inside the window, the paper's ", rich([["SI", false], ["noise", true]]),
            ` = ${decimals(noise, 4)}${repeats || !known(noise) ? "" : `, which is the noise here${without_repeats()}`}.`), indices(window))),
      el("details", {}, el("summary", {}, `Numbers of ${window.name}`),
        el("p", { class: "muted" }, "Grey: not run yet, or not above the noise: SI no larger than ",
          ...(repeats ? ["its ± from the repeats."] : [rich([["SI", false], ["noise", true]]), ", the spread of the baseline inside the window."])),
        table([{ name: "input" }, { name: "meaning", long: true }, { name: "lower", numeric: true }, { name: "baseline", numeric: true },
               { name: "upper", numeric: true }, { name: "unit" }, { name: "q_c at lower (kPa)", numeric: true },
               { name: "q_c at upper (kPa)", numeric: true }, { name: "SI (-)", numeric: true },
               ...(repeats ? [{ name: "± (-)", numeric: true }] : []), { name: "note", long: true }],
          d3.sort(rows, (row) => (known(row.si_abs) ? -row.si_abs : 1)).map((row) => {
            const p = parameter_of.get(row.parameter);
            return {
              class: row.note.startsWith("undefined") ? (to_come(row) ? "quiet" : "failed") : within_noise(row) ? "quiet" : null,
              cells: [rich(p.label), p.meaning, p.lower, p.baseline, p.upper, p.unit, number(row.q_lower_kPa, 5),
                      number(row.q_upper_kPa, 5), decimals(row.si, 4), ...(repeats ? [decimals(row.si_half_width, 4)] : []), row.note],
            };
          }), `Numbers of ${window.name}`)));
  }
}
