// What diagnoses of the study found.
"use strict";

function diagnoses() {
  if (!data.diagnoses.length) return;
  const section = byId("diagnosis");
  section.hidden = false;
  const words = (name) => name.replaceAll("_", " ");
  for (const [k, d] of data.diagnoses.entries()) {
    const rows = d3.sort(d.hypotheses, (h) => -h.probability);
    const held_out = known(d.held_out_gain)
      ? `On depths held out of the fit the error goes from ${decimals(100 * d.held_out_rmse_null, 1)} % to ` +
        `${decimals(100 * d.held_out_rmse, 1)} % (gain in log score ${decimals(d.held_out_gain, 2)} per cell, 90 % interval ` +
        `${decimals(d.held_out_gain_lower, 2)} to ${decimals(d.held_out_gain_upper, 2)}).` : null;
    const fitted = d.fitted.filter((f) => rows.some((h) => h.in_set && h.name === f.mechanism));
    put(section, el("h3", {}, d.title), el("p", {}, el("strong", {}, d.headline)),
      ...d.reservations.map((sentence) => el("p", { class: "warn" }, sentence)),
      held_out ? el("p", {}, held_out) : null,
      byId(`probability_${k}`),
      d.mismatches.length ? table(
        [{ name: "sounding", numeric: true }, { name: "from (m)", numeric: true }, { name: "to (m)", numeric: true },
         { name: "recorded over refitted q_c", numeric: true }, { name: "p (-)", numeric: true }],
        d.mismatches.map((m) => ({ cells: [m.sounding < 0 ? "all" : String(m.sounding + 1), decimals(m.from_m, 3), decimals(m.to_m, 3),
          percent(known(m.percent) ? m.percent / 100 : NaN), number(m.p, 2)] })), `Where the recording differs, ${d.title}`) : null,
      fitted.length ? table(
        [{ name: "mechanism" }, { name: "quantity" }, { name: "value", numeric: true },
         { name: "90 % interval", numeric: true }, { name: "unit" }],
        fitted.map((f) => ({ cells: [words(f.mechanism), words(f.quantity.split(".").pop()), number(f.value, 3),
          `${number(f.lower, 3)} to ${number(f.upper, 3)}`, f.unit] })), `Fitted parameters, ${d.title}`) : null,
      el("p", { class: "muted" }, `From ${d.file}.`));
  }
}
