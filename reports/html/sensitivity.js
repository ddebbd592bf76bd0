// What changes q_c in every window: its figures, and all numbers.
"use strict";

/// "q_c", "settlement"
const name_of = (window) => (data.external ? plain(window.quantity) : "q_c");

function sensitivity() {
  const section = byId("sensitivity");
  if (data.external) section.querySelector("h2").textContent = "What changes the results";
  if (!data.parameters.length) section.append(el("p", {}, "The study has no uncertain input."));
  for (const [k, window] of data.windows.entries()) {
    const rows = indices_in(window);
    if (!rows.length) continue;
    section.append(el("h3", {}, window.place ? `${window.name}, ${window.place}` : window.name));
    if (!baseline || !mean(baseline, window)) {
      section.append(el("p", { class: baseline && waiting(baseline) ? "muted" : "warn" }, `Nothing to compare with: ${no_baseline(window)}.`));
      continue;
    }
    const repeats = repeats_in(window);
    const pair = el("div", { class: "pair" });
    put(pair, byId(`tornado_${k}`), byId(`sensitivity_${k}`));
    section.append(pair,
      el("details", {}, el("summary", {}, `Numbers of ${window.name}`),
        el("p", { class: "muted" }, ...(data.external ? ["Grey: not run yet."] : ["Grey: not run yet, or not above the noise: SI no larger than ",
          ...(repeats ? ["its ± from the repeats."] : [rich([["SI", false], ["noise", true]]), ", the spread of the baseline inside the window."])])),
        table([{ name: "input" }, { name: "meaning", long: true }, { name: "lower", numeric: true }, { name: "baseline", numeric: true },
               { name: "upper", numeric: true }, { name: "unit" }, { name: `${name_of(window)} at lower${in_unit(window)}`, numeric: true },
               { name: `${name_of(window)} at upper${in_unit(window)}`, numeric: true }, { name: "SI (-)", numeric: true },
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
