// The channels over depth of all realizations: hover, highlighting, depth zoom, keyboard.
"use strict";

const figure_style = { background: "transparent", color: "var(--ink)", fontSize: "13px" };

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

const values_of = (curve) => curve[`${shown.channel}_kPa`] || [];
const curves = data.curves.filter((curve) => (curve.q_c_kPa || []).some(known))
  .sort((a, b) => (a.realization === baseline?.id) - (b.realization === baseline?.id) || a.realization - b.realization);
const curve_of = new Map(curves.map((curve) => [curve.realization, curve]));
const deepest = d3.max(curves, (curve) => d3.max(curve.depth_m)) || 1;
// A run that blew up must not set the scale, nor do spikes of single bins: they may leave the frame.
// Leading bins of a curve that hold the start of the push, the cone set to full speed at once: drawn apart.
const starts_at = (curve) => curve.start || 0;
const sets_scale = (curve) => curves.length === 1 || run_of.get(curve.realization).status === "completed";
const looks = [["vermillion", ""], ["blue", "7 3"], ["green", "2 2.5"], ["purple", "9 3 2 3"], ["orange", "14 4"],
               ["sky", "4 2"]];

/// The channel shown [kPa] at a depth, linear between bins; NaN outside.
function value_at(curve, depth) {
  const values = values_of(curve);
  const i = d3.bisectLeft(curve.depth_m, depth);
  if (i === 0) return depth === curve.depth_m[0] ? values[0] : NaN;
  if (i >= curve.depth_m.length) return NaN;
  const share = (depth - curve.depth_m[i - 1]) / (curve.depth_m[i] - curve.depth_m[i - 1]);
  return values[i - 1] + share * (values[i] - values[i - 1]);
}

/// Those furthest from the baseline in a window, as in the static figure.
function furthest(count) {
  const distance = (run) => d3.max(data.windows, (window) => {
    const here = mean(run, window), there = baseline && mean(baseline, window);
    return here && there ? Math.abs(here.q_c_mean_kPa / there.q_c_mean_kPa - 1) : 0;
  });
  return d3.sort(runs.filter((run) => run !== baseline && curve_of.has(run.id)), (run) => -distance(run))
    .slice(0, count).map((run) => run.id);
}

const shown = {
  channel: data.channels.some((channel) => channel.name === kept("channel", "q_c")) ? kept("channel", "q_c") : "q_c",
  zoom: kept("zoom", null),  // [m] from, to; null is all
  pins: new Map(kept("pins", furthest(4).map((id, slot) => [id, slot])).filter(([id]) => run_of.has(id))),
  out: new Set(),  // ids that the filter leaves out
  lit: null,       // id under the pointer
  depth: null,     // [m] of the pointer
};
const changed = { lit: [], pins: [] };  // who wants to know

function light(id, depth = null) {
  if (shown.lit === id && shown.depth === depth) return;
  shown.lit = id;
  shown.depth = depth;
  changed.lit.forEach((tell) => tell());
}
function pin(id, on = !shown.pins.has(id)) {
  if (id === baseline?.id || !run_of.has(id)) return;
  if (on && !shown.pins.has(id)) {
    const taken = new Set(shown.pins.values());
    shown.pins.set(id, d3.range(99).find((slot) => !taken.has(slot)));
  } else if (!on) shown.pins.delete(id);
  keep("pins", [...shown.pins]);
  changed.pins.forEach((tell) => tell());
}
const visible = (curve) => !shown.out.has(curve.realization);

function profiles() {
  const section = byId("profiles");
  if (!curves.length) {
    section.append(el("p", {}, "No realization has a curve yet."));
    return;
  }
  const from = el("input", { type: "number", min: 0, max: deepest, step: 0.01, "aria-label": "depth from, in m" });
  const to = el("input", { type: "number", min: 0, max: deepest, step: 0.01, "aria-label": "depth to, in m" });
  const plot = el("div", { class: "plot", tabindex: "0", role: "group", id: "profile-plot",
                           "aria-label": `${data.channels.find((channel) => channel.name === shown.channel)?.title} over depth of all realizations`,
                           "aria-describedby": "profile-help" });
  const bubble = el("div", { class: "tip" });
  const spoken = el("p", { class: "muted", "aria-live": "polite", id: "readout" }, " ");
  const legend = el("ul", { class: "pins", "aria-label": "Highlighted curves" });
  let scales = null;

  function zoom(range) {
    const [low, high] = range ? d3.sort(range) : [0, deepest];
    const clamped = [Math.max(0, low), Math.min(deepest, high)];
    shown.zoom = clamped[1] - clamped[0] < 2e-3 || (clamped[0] === 0 && clamped[1] === deepest) ? null : clamped;
    keep("zoom", shown.zoom);
    draw();
  }
  const range = () => shown.zoom || [0, deepest];
  const channel_of = () => data.channels.find((channel) => channel.name === shown.channel);
  const choice = el("select", { id: "channel", onchange: () => {
    shown.channel = choice.value;
    keep("channel", shown.channel);
    plot.setAttribute("aria-label", `${channel_of().title} over depth of all realizations`);
    draw();
  } }, ...data.channels.map((channel) => el("option", { value: channel.name, selected: channel.name === shown.channel },
                                            channel.title)));

  function draw() {
    const width = Math.floor(section.clientWidth);
    if (width === 0) return;
    const [top, bottom] = range();
    [from.value, to.value] = [top.toFixed(3), bottom.toFixed(3)];
    const x = [], y = [], z = [], starts = [];
    let least = 0, most = 0;
    for (const curve of curves)
      for (let i = 0; i < curve.depth_m.length; ++i) {
        const q = values_of(curve)[i];
        if (i <= starts_at(curve) && starts_at(curve)) starts.push({ q, depth: curve.depth_m[i], id: curve.realization });
        x.push(known(q) && i >= starts_at(curve) ? q : NaN);
        y.push(curve.depth_m[i]);
        z.push(curve.realization);
        if (sets_scale(curve) && i >= starts_at(curve) && curve.depth_m[i] >= top && curve.depth_m[i] <= bottom) {
          const around = d3.median(values_of(curve).slice(Math.max(starts_at(curve), i - 2), i + 3)) ?? 0;
          least = Math.min(least, around);
          most = Math.max(most, around);
        }
      }
    const layers = data.layers.filter((layer) => data.layers.length > 1 && layer.top_m < bottom && layer.bottom_m > top);
    const svg = Plot.plot({
      width,
      height: Math.min(Math.max(0.75 * width, 420), 680),
      marginLeft: 58, marginRight: 14, marginTop: 44, marginBottom: 12,
      style: figure_style,
      x: { domain: [least, 1.04 * most], axis: "top", label: shown.channel, labelAnchor: "center", labelArrow: "none", grid: true },
      y: { domain: [top, bottom], reverse: true, ticks: 10, label: "depth of the tip (m)", labelAnchor: "center", labelArrow: "none",
           grid: true },
      marks: [
        Plot.rect(data.windows.filter((window) => known(window.from_m)),
          { y1: "from_m", y2: "to_m", fill: "var(--band)", clip: true, className: "window" }),
        Plot.ruleY(layers.slice(1), { y: "top_m", stroke: "var(--muted)", strokeDasharray: "6 4" }),
        Plot.text(layers, { y: (layer) => Math.max(layer.top_m, top), frameAnchor: "right", text: "soil", dx: -6, dy: 12,
                            textAnchor: "end", fill: "var(--muted)", stroke: "var(--paper)", strokeWidth: 4 }),
        Plot.line(starts, { x: "q", y: "depth", z: "id", clip: true, className: "starts", stroke: "var(--faint)", strokeWidth: 0.8,
                            strokeDasharray: "2 2" }),
        Plot.text(starts.slice(0, 1).filter((at) => at.depth >= top && at.depth <= bottom), {
          y: "depth", frameAnchor: "right", text: ["start of the push"], textAnchor: "end", dx: -6, dy: 11, fill: "var(--muted)",
          stroke: "var(--paper)", strokeWidth: 4 }),
        Plot.line({ length: x.length }, { x, y, z, clip: true, className: "curves" }),
      ],
    });
    set_labels(svg, "x-axis label", [[...channel_of().symbol, [" (kPa)", false]]]);
    svg.querySelectorAll(".curves path").forEach((path, i) => {
      path.classList.add("curve");
      path.dataset.id = curves[i].realization;
    });
    svg.setAttribute("aria-hidden", "true");  // the plot's role and the read-out speak for it
    scales = { x: svg.scale("x"), y: svg.scale("y") };
    const [left, right] = scales.x.range, [low, high] = d3.extent(scales.y.range);
    const brush = d3.brushY().extent([[left, low], [right, high]]).touchable(() => false)
      .on("end", (event) => event.selection && zoom(event.selection.map((at) => scales.y.invert(at))));
    d3.select(svg).append("g").attr("class", "brush").call(brush);
    d3.select(svg).append("circle").attr("class", "dot").attr("r", 4.5).attr("visibility", "hidden");
    plot.replaceChildren(svg, bubble);
    mark();
    show();
  }

  function mark() {
    for (const path of plot.querySelectorAll("path.curve")) {
      const id = Number(path.dataset.id);
      const [color, dash] = looks[(shown.pins.get(id) ?? 0) % looks.length];
      const pinned = shown.pins.has(id);
      path.classList.toggle("baseline", id === baseline?.id);
      path.classList.toggle("out", shown.out.has(id) && id !== baseline?.id && !pinned);
      path.classList.toggle("pinned", pinned);
      path.style.setProperty("--pin", `var(--${color})`);
      path.style.strokeDasharray = pinned ? dash : "";
      if (pinned) path.parentNode.append(path);
    }
    const base = plot.querySelector("path.baseline");
    if (base) base.parentNode.append(base);
    const swatch = (color, dash, width) => {
      const svg = d3.create("svg").attr("viewBox", "0 0 32 10").attr("aria-hidden", "true");
      svg.append("line").attr("x2", 32).attr("y1", 5).attr("y2", 5).attr("stroke", `var(--${color})`)
        .attr("stroke-width", width).attr("stroke-dasharray", dash);
      return svg.node();
    };
    legend.replaceChildren(
      baseline ? el("li", {}, swatch("ink", "", 3), "baseline") : "",
      ...[...shown.pins].map(([id, slot]) => {
        const label = run_of.get(id).label;
        return el("li", {}, el("button", {
          type: "button", "aria-label": `Remove the highlight of ${plain(label)}`, onclick: () => pin(id, false),
          onpointerenter: () => light(id), onpointerleave: () => light(null),
        }, swatch(...looks[slot % looks.length], 3), rich(label), " ×"));
      }));
  }

  /// The read-out of the curve under the pointer.
  function show() {
    const dot = plot.querySelector(".dot");
    for (const path of plot.querySelectorAll("path.curve"))
      path.classList.toggle("lit", Number(path.dataset.id) === shown.lit);
    dot.setAttribute("visibility", "hidden");
    bubble.replaceChildren();
    const run = run_of.get(shown.lit), curve = curve_of.get(shown.lit);
    if (!run) return;
    const q = curve && shown.depth !== null ? value_at(curve, shown.depth) : NaN;
    if (!known(q)) return;
    const base = curve_of.get(baseline?.id), there = base ? value_at(base, shown.depth) : NaN;
    const lines = [`depth ${decimals(shown.depth, 4)} m: ${number(q)} kPa`,
      shown.depth < (curve.depth_m[starts_at(curve)] ?? 0) ? "start of the push" : "",
      run !== baseline && known(there) ? `${percent(q / there - 1)} of the baseline` : "",
      run.status === "completed" ? "" : `${run.status}: ${run.reason}`].filter((line) => line);
    bubble.append(el("strong", {}, rich(run.label)), ...lines.flatMap((line) => [el("br"), line]));
    spoken.textContent = `${plain(run.label)}, ${lines.join(", ")}`;
    const svg = plot.querySelector("svg"), scale = svg.clientWidth / svg.viewBox.baseVal.width;
    const at = [scales.x.apply(q), scales.y.apply(shown.depth)];
    dot.setAttribute("visibility", "visible");
    dot.setAttribute("cx", at[0]);
    dot.setAttribute("cy", at[1]);
    const right = at[0] * scale < svg.clientWidth / 2;
    bubble.style.left = right ? `${at[0] * scale + 14}px` : "";
    bubble.style.right = right ? "" : `${plot.clientWidth - at[0] * scale + 14}px`;
    bubble.style.top = `${Math.max(0, at[1] * scale - 30)}px`;
  }

  function nearest(event) {
    const [px, py] = d3.pointer(event, plot.querySelector("svg"));
    const depth = scales.y.invert(py), [top, bottom] = range();
    if (depth < top || depth > bottom) return light(null);
    const distance = (curve) => Math.abs(scales.x.apply(value_at(curve, depth)) - px);
    const near = d3.least(curves.filter((curve) => visible(curve) && distance(curve) < 60), distance);
    return light(near ? near.realization : null, depth);
  }

  // At a place of the keyboard's: the depth and the curve by rank of q_c there.
  function step(event) {
    const [top, bottom] = range(), height = bottom - top;
    const depth = Math.min(Math.max(shown.depth ?? (top + bottom) / 2, top), bottom);
    const there = d3.sort(curves.filter((curve) => visible(curve) && known(value_at(curve, depth))),
      (curve) => value_at(curve, depth));
    const i = there.findIndex((curve) => curve.realization === shown.lit);
    const go = (k) => there.length && light(there[(k + there.length) % there.length].realization, depth);
    const sink = (by) => light(shown.lit ?? there[0]?.realization ?? null, Math.min(Math.max(depth + by, top), bottom));
    const actions = {
      ArrowRight: () => go(i + 1),
      ArrowLeft: () => go(i < 0 ? 0 : i - 1),
      ArrowDown: () => sink(height / 50),
      ArrowUp: () => sink(-height / 50),
      Enter: () => shown.lit !== null && pin(shown.lit),
      "+": () => zoom([depth - height / 4, depth + height / 4]),
      "-": () => zoom([depth - height, depth + height]),
      Escape: () => zoom(null),
    };
    if (event.target !== plot || event.ctrlKey || event.metaKey || event.altKey || !actions[event.key]) return;
    event.preventDefault();
    actions[event.key]();
  }

  const typed = () => known(from.valueAsNumber) && known(to.valueAsNumber) &&
    zoom([from.valueAsNumber, to.valueAsNumber]);
  from.addEventListener("change", typed);
  to.addEventListener("change", typed);
  plot.addEventListener("pointermove", nearest);
  plot.addEventListener("pointerleave", () => light(null));
  plot.addEventListener("click", (event) => { nearest(event); if (shown.lit !== null) pin(shown.lit); });
  plot.addEventListener("dblclick", () => zoom(null));
  plot.addEventListener("keydown", step);
  changed.lit.push(show);
  changed.pins.push(mark);

  section.append(
    el("div", { class: "controls", role: "group", "aria-label": "What is shown" },
      data.channels.length > 1 ? el("label", {}, "channel", choice) : "",
      el("label", {}, "depth from", from, "m"), el("label", {}, "to", to, "m"),
      el("button", { type: "button", id: "whole", onclick: () => zoom(null) }, "Whole depth"),
      ...data.windows.filter((window) => known(window.from_m)).map((window) =>
        el("button", { type: "button", onclick: () => {
          const margin = 2 * (window.to_m - window.from_m);
          zoom([window.from_m - margin, window.to_m + margin]);
        } }, `Window ${window.name}`))),
    legend,
    el("figure", {}, plot, el("figcaption", { id: "profile-help" },
      "Point at a curve to read it, click to highlight it, drag over depths to zoom, double-click for the whole depth. " +
      "Keys: ← → next curve, ↑ ↓ depth, Enter highlight, + − zoom, Esc whole depth. Bands: windows." +
      (data.layers.length > 1 ? " Dashed across: where two layers meet." : "") +
      (curves.some(starts_at) ? " Faint dashes at a curve's beginning: the start of the push, where the cone's sudden speed adds to the soil's resistance." : ""))),
    spoken);
  on_width(section, draw);
}
