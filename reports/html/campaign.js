// The campaign: the JSON block "data" (made by reports/page.cpp) and what is looked up in it.
"use strict";

const data = JSON.parse(document.getElementById("data").textContent);

for (const window of data.windows) window.name = window.window;
// A design that had enough runs leaves the others out.
const runs = data.realizations.filter((run) => run.status !== "not_needed");
const not_needed = data.realizations.length - runs.length;
const run_of = new Map(runs.map((run) => [run.id, run]));
const baseline = runs.find((run) => run.side === "baseline");
const parameter_of = new Map(data.parameters.map((p) => [p.name, p]));
const waiting = (run) => ["pending", "running", "interrupted"].includes(run.status);
const failed = (run) => !waiting(run) && run.status !== "completed";
const mean_of = new Map(data.window_means.map((m) => [`${m.realization} ${m.window}`, m]));
const mean = (run, window) => mean_of.get(`${run.id} ${window.name}`);
const bound_run = (parameter, side) => runs.find((run) => run.parameter === parameter && run.side === side);
const indices_in = (window) => data.sensitivity.filter((row) => row.window === window.name);
const repeats_in = (window) => data.repeat_noise.find((row) => row.window === window.name);
/// "3 of 4 repeats so far"; empty once none is to come.
function repeats_so_far() {
  const all = runs.filter((run) => run.side === "repeat");
  const left = all.filter(waiting).length;
  return left ? `${all.length - left} of ${all.length} repeats so far` : "";
}
const within_noise = (row) => row.above_noise === 0;  // of the repeats; without them SI_noise
const is_loud = (row) => known(row.si) && !within_noise(row);
const swing = (row) => Math.abs(row.q_upper_kPa - row.q_lower_kPa);
/// A bound that has no run is the baseline; an input with neither has nothing to say.
const has_bound = (row) => Boolean(bound_run(row.parameter, "lower") || bound_run(row.parameter, "upper"));
const has_design = data.effects.length > 0;
const has_both = (row) => known(row.q_upper_kPa) && known(row.q_lower_kPa);

/// Whether an input has no index only because its runs, or the baseline, are still to come.
const to_come = (row) => [baseline, bound_run(row.parameter, "lower"), bound_run(row.parameter, "upper")]
  .some((run) => run && waiting(run));
