// The campaign at a glance, and its failures.
"use strict";

/// Why a window has no average of the baseline; the sentence's end.
function no_baseline(window) {
  if (window.problem) return window.problem;
  if (!baseline) return "the study has no baseline";
  if (baseline.status === "pending") return "the baseline has not been run yet";
  if (baseline.status === "running") return "the baseline is being run";
  if (baseline.status === "interrupted") return "the baseline was running when the campaign ended";
  if (failed(baseline)) return `the baseline failed (${baseline.status}${baseline.reason ? `: ${baseline.reason}` : ""})`;
  return "the baseline has no value here";
}

/// Two numbers with as many digits as tell them apart.
function apart(a, b) {
  for (let digits = 4; digits < 10; ++digits)
    if (number(a, digits) !== number(b, digits)) return [number(a, digits), number(b, digits)];
  return null;
}

/// What differs by rounding alone does not: such a row has the index 0 or none.
const varies = (row) => row.si !== 0 && !row.note.includes("does not vary") && apart(row.q_lower_kPa, row.q_upper_kPa) !== null;

/// What changes a window's average most, alone.
function of_bounds(window) {
  const all = indices_in(window);
  const rows = all.filter((row) => has_both(row) && has_bound(row));
  if (!rows.length) return all.length ? ["No input has results at both of its bounds yet. "] : [];
  const first = d3.greatest(rows.filter(varies), swing);
  const some = rows.length < all.length ? `Of the ${rows.length} inputs (of ${all.length}) with results at both bounds, ` : "";
  if (!first) return [some ? `${some}none changes it. ` : "No input alone changes it: it is the same at all bounds. "];
  const ends = apart(first.q_lower_kPa, first.q_upper_kPa);
  const quiet = within_noise(first) ? ", which is within the noise" : "";
  return [some, rich(parameter_of.get(first.parameter).label), ` ${some ? "alone " : ""}changes it most${some ? "" : " of all inputs alone"}, ` +
    `from ${ends[0]}${window.unit} at its lower to ${ends[1]}${window.unit} at its upper bound${quiet}. `];
}

function of_noise(window) {
  const rows = indices_in(window).filter((row) => has_both(row) && has_bound(row));
  const loud = rows.filter((row) => is_loud(row) && swing(row) > 0);
  const repeats = repeats_in(window);
  if (!rows.some(varies) || !rows.some((row) => known(row.above_noise))) return [];
  const told = loud.length > 8 ? d3.sort(loud, (row) => -row.si_abs).slice(0, 6) : loud;
  return [`The index of ${loud.length} of ${rows.length} inputs exceeds the noise of ` +
    (repeats ? `the baseline's ${repeats_so_far() || `${repeats.runs - 1} repeats`}` : "the baseline, its spread inside the window"),
    ...told.flatMap((row, k) => [k ? ", " : told === loud ? ": " : ", most that of ", rich(parameter_of.get(row.parameter).label)]), ". ",
    ...(repeats && rows.some((row) => known(row.above_si_noise))
      ? ["By the paper's ", rich([["SI", false], ["noise", true]]),
        `, the spread inside the window, ${rows.filter((row) => row.above_si_noise === 1).length} would. `] : [])];
}

/// Of a kind of design: the quantity that its figure has as bars, and what the largest one means.
const largest_of = {
  pairs: { quantity: "interaction", words: "act together most: their interaction is" },
  morris: { quantity: "mu_star", words: "has the largest elementary effects: their mean size μ* is" },
};
const largest_share = { quantity: "total_order", words: "holds the largest share of its variance, interactions included:" };

/// "2135 kPa (95 %: 2106 to 2164)"
function estimated(row) {
  const interval = known(row.lower) ? ` (95 %: ${number(row.lower)} to ${number(row.upper)})` : "";
  return `${number(row.value)}${row.unit === "-" ? "" : ` ${row.unit}`}${interval}`;
}

/// "above 250 kPa with a probability of 12.5 % (95 %: 9.1 to 16)"
function exceeded(row) {
  const percent = (share) => number(100 * share, 3);
  return `above ${number(row.threshold_kPa)} kPa with a probability of ${percent(row.value)} %` +
    (known(row.lower) ? ` (95 %: ${percent(row.lower)} to ${percent(row.upper)})` : "");
}

/// The input that most of the variance comes from.
function share_of_variance(window) {
  const first = d3.greatest(effects_in(window, "shapley").filter((row) => known(row.value)), (row) => row.value);
  if (!first || first.note.includes("not to be believed")) return [];
  return [" Most of its variance comes from ", rich(label_of_effect(first)), `: a share of ${estimated(first)}.`];
}

/// What a window's average is worth with distributed inputs.
function of_propagation(window) {
  const row = (quantity) => effects_in(window, quantity).find((one) => known(one.value));
  const mean = row("mean"), deviation = row("standard_deviation"), low = row("quantile_05"), high = row("quantile_95");
  if (!mean || !deviation || !low || !high) return ["The design (propagation) says nothing yet."];
  return [`With its inputs drawn from their distributions it averages ${estimated(mean)}, with a standard deviation of ` +
    `${estimated(deviation)}; nine of ten values lie between ${number(low.value)} and ${number(high.value)}${window.unit}` +
    `${effects_in(window, "exceedance").filter((one) => known(one.value)).map((one) => `; ${exceeded(one)}`).join("")}` +
    `${mean.dropped ? `; ${mean.dropped} runs are missing` : ""}.` +
    `${data.numerical_error ? ` A numerical error of ${data.numerical_error} is in it.` : ""}${data.stopped ? ` By the study's rule, ${data.stopped}.` : ""}`, ...share_of_variance(window)];
}

/// What the design adds: its largest bar, as drawn further down.
function of_design(window) {
  if (!has_design) return [];
  if (data.design === "propagation") return of_propagation(window);
  const { quantity, words } = largest_of[data.design] || largest_share;
  const rows = effects_in(window, quantity);
  const first = d3.greatest(rows.filter((row) => known(row.value)), (row) => Math.abs(row.value));
  const name = data.design.replaceAll("_", " ");
  if (!first) {
    const why = [...new Set(rows.map((row) => row.note).filter((note) => note))];
    return [`The design (${name}) says nothing yet${why.length ? `: ${why.join("; ")}` : ""}.`];
  }
  const interval = known(first.lower) ? `, 95 % interval ${number(first.lower, 3)} to ${number(first.upper, 3)}` : "";
  const label = rich(label_of_effect(first));
  if (first.value === 0) return [`Changed together (${name}), no input changes it.`];
  const fit = data.effects.find((row) => row.window === window.name && row.quantity === "Q2");
  const doubt = fit && fit.note.includes("not to be believed") ? " The polynomial behind it is not to be believed." : "";
  return [`Changed together (${name}), `, label, ` ${words} ${number(first.value, 3)}${first.unit === "-" ? "" : ` ${first.unit}`}${interval}` +
    `${first.dropped ? `; ${first.dropped} runs are missing` : ""}.${doubt}`];
}

/// "homogeneous sand", "3 layers of sand and clay": the soils that are there, whatever profile they came from.
function profile_words(campaign) {
  const soils = [...new Set(campaign.layers.map((layer) => layer.soil))];
  if (campaign.layers.length < 2) return soils.length ? `homogeneous ${soils[0]}` : campaign.campaign.profile.replaceAll("_", " ");
  const names = soils.length < 2 ? soils[0] : `${soils.slice(0, -1).join(", ")} and ${soils.at(-1)}`;
  return `${campaign.layers.length} layers of ${names}`;
}

/// What stands between a window's name and what is said of it.
const place_before = (window) => (window.place ? `(${window.place}): ` : ": ");

function glance() {
  const done = runs.filter((run) => run.status === "completed").length;
  const lost = runs.filter(failed).length;
  const doubtful = runs.filter((run) => run.out_of_line).length;
  const now = runs.filter((run) => run.status === "running").length;
  const fact = (name, value) => el("div", {}, el("dt", {}, name), el("dd", {}, value));
  const seconds = d3.sum(runs, (run) => run.wall_s || 0);
  const facts = el("dl", { class: "facts" });
  put(facts,
    fact("completed", `${done} of ${runs.length}`),
    lost ? fact("failed", String(lost)) : null,
    doubtful ? fact("completed, out of line", String(doubtful)) : null,
    now ? fact("running", String(now)) : null,
    done + lost + now < runs.length ? fact("still to run", String(runs.length - done - lost - now)) : null,
    fact("uncertain inputs", String(data.parameters.length)),
    not_needed ? fact("not needed", String(not_needed)) : null,
    has_design ? fact("design", data.design.replaceAll("_", " ")) : null,
    fact("computing time", duration(seconds)),
    data.external ? fact("solver", `external program ${data.campaign.solver_version}`.trim()) : fact("profile", profile_words(data)),
    data.external ? null : fact("preset", data.campaign.preset));
  byId("glance").append(
    el("progress", { max: runs.length, value: done, "aria-label": "realizations completed" }), facts);
  for (const remark of data.remarks) byId("glance").append(el("p", { class: "warn" }, `Note: ${remark}.`));
  for (const window of data.windows) {
    const text = el("p", {}, el("strong", {}, window.name), " ");
    const mean_here = baseline && mean(baseline, window);
    if (window.problem) text.append(el("span", { class: "warn" }, window.problem));
    else if (mean_here)
      put(text, `${place_before(window)}the baseline's `, rich(window.quantity),
        ` ${window.is_scalar ? "is" : "averages"} ${number(mean_here.q_c_mean_kPa)}${window.unit}. `,
        ...of_bounds(window), ...of_noise(window), ...of_design(window),
        window.remark ? el("span", { class: "warn" }, ` ${window.remark}`) : null);
    else put(text, place_before(window), el("span", { class: baseline && waiting(baseline) ? "muted" : "warn" },
      `nothing to compare with, ${no_baseline(window)}.`));
    byId("glance").append(text);
  }
}

function failures() {
  const rows = runs.filter(failed);
  if (!rows.length) return;
  byId("failures").hidden = false;
  byId("failures").append(
    el("p", {}, "They take no part in the indices; rows that need them say so."),
    table([{ name: "id", numeric: true }, { name: "input" }, { name: "status" }, { name: "reason", long: true }],
      rows.map((run) => ({ class: "failed", cells: [String(run.id), rich(run.label), run.status, run.reason] })),
      "Failed realizations"));
}
