// The campaign at a glance, and its failures.
"use strict";

function glance() {
  const done = runs.filter((run) => run.status === "completed").length;
  const lost = runs.filter(failed).length;
  const fact = (name, value) => el("div", {}, el("dt", {}, name), el("dd", {}, value));
  const seconds = d3.sum(runs, (run) => run.wall_s || 0);
  const facts = el("dl", { class: "facts" },
    fact("completed", `${done} of ${runs.length}`),
    lost ? fact("failed", String(lost)) : null,
    done + lost < runs.length ? fact("still to run", String(runs.length - done - lost)) : null,
    fact("uncertain inputs", String(data.parameters.length)),
    fact("computing time", duration(seconds)),
    fact("profile", data.campaign.profile.replaceAll("_", " ")),
    fact("preset", data.campaign.preset));
  byId("glance").append(
    el("progress", { max: runs.length, value: done, "aria-label": "realizations completed" }), facts);
  for (const remark of data.remarks) byId("glance").append(el("p", { class: "warn" }, `Note: ${remark}.`));
  for (const window of data.windows) {
    const text = el("p", {}, el("strong", {}, window.name), " ");
    const rows = indices_in(window).filter(has_both);
    if (window.problem) text.append(el("span", { class: "warn" }, window.problem));
    else if (baseline && mean(baseline, window)) {
      text.append(`(${depths(window)}): the baseline's `, rich(q_c),
        ` averages ${number(mean(baseline, window).q_c_mean_kPa)} kPa. `);
      // What differs by rounding alone has the index 0 or none.
      const first = d3.greatest(rows.filter((row) => row.si !== 0 && !row.note.includes("does not vary")), swing);
      const loud = rows.filter(is_loud);
      const repeats = repeats_in(window);
      const paper = rows.filter((row) => row.above_si_noise === 1).length;
      const judged = rows.some((row) => known(row.above_noise));
      if (first)
        text.append(rich(parameter_of.get(first.parameter).label), ` changes it most, from ` +
          `${number(first.q_lower_kPa)} kPa at its lower to ${number(first.q_upper_kPa)} kPa at its upper bound${within_noise(first) ? ", which is within the noise" : ""}. `);
      else if (rows.length) text.append("No input changes it. ");
      if (first && judged)
        text.append(`The index of ${loud.length} of ${indices_in(window).length} inputs exceeds the noise of ` +
          (repeats ? `the baseline's ${repeats.runs - 1} repeats` : "the baseline"),
          ...loud.flatMap((row, k) => [k ? ", " : ": ", rich(parameter_of.get(row.parameter).label)]), ". ");
      if (first && judged && repeats && rows.some((row) => known(row.above_si_noise)))
        text.append(`By the paper's `, rich([["SI", false], ["noise", true]]), `, the spread inside the window, ${paper} would.`);
    } else text.append("has no baseline yet.");
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
