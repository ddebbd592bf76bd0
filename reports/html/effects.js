// What the study's design says of its inputs: its figures, and all numbers.
"use strict";

const label_of_effect = (row) => {
  const one = row.parameter ? parameter_of.get(row.parameter).label : [["", false]];
  return row.other_parameter ? [...one, [" × ", false], ...parameter_of.get(row.other_parameter).label] : one;
};
const effects_in = (window, quantity) =>
  data.effects.filter((row) => row.window === window.name && row.quantity === quantity);

/// "exceedance of 250 kPa"
const quantity_words = (row) =>
  known(row.threshold_kPa) ? `${row.quantity} of ${number(row.threshold_kPa)} kPa` : row.quantity;

/// What holds for all inputs of a window; the notes of pairs are their own.
function remarks(rows) {
  const fit = rows.find((row) => row.quantity === "Q2");
  if (fit) return [[`${data.design === "propagation" ? "Shapley effects of a sparse polynomial" : "Polynomial chaos"}, Q² = ${decimals(fit.value, 3)}`, fit.note].filter((words) => words).join("; ")];
  return data.design === "pairs" ? [] : new Set(rows.map((row) => row.note).filter((note) => note));
}

function effects() {
  if (!data.effects.length) return;
  const section = byId("effects");
  section.hidden = false;
  section.append(el("p", {}, `Design ${data.design.replaceAll("_", " ")}: inputs ${data.design === "propagation" ? "drawn from their distributions" : "changed together"}${
    data.numerical_error ? `; standard deviation, quantiles, exceedance and bands hold a numerical error of ${data.numerical_error}` : ""}.`));
  for (const [k, window] of data.windows.entries()) {
    const rows = data.effects.filter((row) => row.window === window.name);
    section.append(el("h3", {}, window.name));
    for (const words of remarks(rows))
      section.append(el("p", { class: words.includes("not to be believed") ? "warn" : null }, words));
    put(section, byId(`effects_${k}`), byId(`shapley_${k}`), byId(`convergence_${k}`),
      el("details", {}, el("summary", {}, `Numbers of the design in ${window.name}`),
        table([{ name: "input" }, { name: "quantity" }, { name: "value", numeric: true }, { name: "from (95 %)", numeric: true },
               { name: "to (95 %)", numeric: true }, { name: "unit" }, { name: "runs", numeric: true }, { name: "used", numeric: true },
               { name: "dropped", numeric: true }, { name: "method", long: true }, { name: "note", long: true }],
          rows.map((row) => ({
            class: known(row.value) ? null : "failed",
            cells: [rich(label_of_effect(row)), quantity_words(row), number(row.value), number(row.lower), number(row.upper), row.unit,
                    String(row.runs), String(row.used), String(row.dropped), row.method, row.note],
          })), `Numbers of the design in ${window.name}`)));
  }
  for (const channel of data.channels) {
    const bands = byId(`bands_${channel.name}`);
    if (bands) put(section, el("h3", {}, `${channel.title[0].toUpperCase()}${channel.title.slice(1)} over depth`), bands);
  }
}
