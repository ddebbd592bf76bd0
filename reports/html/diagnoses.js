// What diagnoses of the study found.
"use strict";

function diagnoses() {
  if (!data.diagnoses.length) return;
  const section = byId("diagnosis");
  section.hidden = false;
  const words = (name) => name.replaceAll("_", " ");
  for (const d of data.diagnoses) {
    const rows = d3.sort(d.hypotheses, (h) => -h.probability);
    const labels = rows.map((h) => [[words(h.name), false]]);
    const held_out = known(d.held_out_gain)
      ? `On depths held out of the fit the error goes from ${decimals(100 * d.held_out_rmse_null, 1)} % to ` +
        `${decimals(100 * d.held_out_rmse, 1)} % (gain in log score ${decimals(d.held_out_gain, 2)} per cell, 90 % interval ` +
        `${decimals(d.held_out_gain_lower, 2)} to ${decimals(d.held_out_gain_upper, 2)}).` : null;
    const fitted = d.fitted.filter((f) => rows.some((h) => h.in_set && h.name === f.mechanism));
    // Only one explanation without reservations is drawn as a full bar; the others are outlines.
    const alone = rows.filter((h) => h.in_set).length === 1 && !d.reservations.length;
    const ruled_out = (h) => !h.in_set;
    put(section, el("h3", {}, d.title), el("p", {}, el("strong", {}, d.headline)),
      ...d.reservations.map((sentence) => el("p", { class: "warn" }, sentence)),
      held_out ? el("p", {}, held_out) : null,
      figure(`Probabilities of the hypotheses of ${d.title}`,
        el("span", {}, "Probability of each hypothesis, prior as a tick;", el("span", { class: alone ? "key" : "key hollow",
          style: "--key: var(--blue)" }), alone ? "the answer" : "not ruled out: the set that holds the answer with 95 % probability",
          ";", key("faint"), "others."),
        (width) => Plot.plot({
          ...frame_of(rows, labels, Math.min(width, 640)),
          x: { domain: [0, 1], label: "probability (-)", labelAnchor: "center", labelArrow: "none", grid: true, insetRight: 50 },
          y: { domain: rows.map((h) => h.name), tickFormat: words, label: null, tickSize: 0, padding: 0.35 },
          marks: [
            Plot.barX(rows, { x: "probability", y: "name", className: "chance",
                              fill: (h) => (ruled_out(h) ? "var(--faint)" : "var(--blue)"),
                              fillOpacity: (h) => (ruled_out(h) || alone ? 1 : 0.15),
                              stroke: (h) => (ruled_out(h) ? "none" : "var(--blue)") }),
            Plot.tickX(rows, { x: "prior", y: "name", stroke: "var(--ink)", strokeWidth: 2 }),
            Plot.text(rows, { x: (h) => Math.max(h.probability, h.prior), y: "name", dx: 6, textAnchor: "start",
                              text: (h) => (h.probability < 0.001 ? "< 0.001" : decimals(h.probability, 3)),
                              fill: "var(--ink)", stroke: "var(--paper)", strokeWidth: 4 }),
          ],
        })),
      d.mismatches.length ? table(
        [{ name: "sounding", numeric: true }, { name: "from (m)", numeric: true }, { name: "to (m)", numeric: true },
         { name: "recorded over refitted q_c", numeric: true }, { name: "p (-)", numeric: true }],
        d.mismatches.map((m) => ({ cells: [m.sounding < 0 ? "all" : String(m.sounding + 1), decimals(m.from_m, 3), decimals(m.to_m, 3),
          percent(m.percent / 100), number(m.p, 2)] })), `Where the recording differs, ${d.title}`) : null,
      fitted.length ? table(
        [{ name: "mechanism" }, { name: "quantity" }, { name: "value", numeric: true },
         { name: "90 % interval", numeric: true }, { name: "unit" }],
        fitted.map((f) => ({ cells: [words(f.mechanism), words(f.quantity.split(".").pop()), number(f.value, 3),
          `${number(f.lower, 3)} to ${number(f.upper, 3)}`, f.unit] })), `Fitted parameters, ${d.title}`) : null,
      el("p", { class: "muted" }, `From ${d.file}.`));
  }
}
