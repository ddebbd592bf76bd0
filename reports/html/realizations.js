// The table of realizations, which sorts and filters; the profiles show what it shows.
"use strict";

/// Steps and audit, which another program's runs do not have.
const of_a_push = [
  { name: "steps", numeric: true, screen: true, value: (run) => run.steps || null },
  { name: "energy error", numeric: true, value: (run) => run.energy_error, show: (run) => number(run.energy_error, 2) },
  { name: "momentum error", numeric: true, screen: true, value: (run) => run.momentum_error, show: (run) => number(run.momentum_error, 2) },
  { name: "kinetic energy", numeric: true, screen: true, value: (run) => run.kinetic_fraction, show: (run) => number(run.kinetic_fraction, 2) },
  { name: "out of line", long: true, value: (run) => run.out_of_line },
  { name: "mass error", numeric: true, screen: true, value: (run) => run.mass_error, show: (run) => number(run.mass_error, 2) },
];

function realizations() {
  const base = (window) => baseline && mean(baseline, window);
  const columns = [
    { name: "id", numeric: true, value: (run) => run.id },
    { name: "input", value: (run) => plain(run.label), show: (run) => rich(run.label) },
    { name: "bound", value: (run) => run.side },
    { name: "status", value: (run) => run.status },
    ...data.windows.flatMap((window) => {
      const many = data.windows.length > 1 ? `, ${window.name}` : "";
      const screen = data.windows.length > 2;
      return [
        { name: `${window.is_scalar ? "" : "mean "}${name_of(window)}${in_unit(window)}${window.is_scalar ? "" : many}`, numeric: true, value: (run) => mean(run, window)?.q_c_mean_kPa,
          show: (run) => number(mean(run, window)?.q_c_mean_kPa, 5) },
        { name: `to baseline${many}`, numeric: true, screen,
          value: (run) => (mean(run, window) && base(window) ? mean(run, window).q_c_mean_kPa / base(window).q_c_mean_kPa - 1 : NaN),
          show: (run) => (run === baseline ? "" : percent(columns.find((c) => c.name === `to baseline${many}`).value(run))) },
      ];
    }),
    { name: "time (s)", numeric: true, value: (run) => run.wall_s, show: (run) => decimals(run.wall_s, 1) },
    ...(data.external ? [] : of_a_push),
    { name: "reason", long: true, value: (run) => run.reason },
  ];
  const state = kept("table", { by: "id", down: false, text: "", status: "" });
  const absent = (value) => value === null || value === undefined || value === "" || Number.isNaN(value);
  const text_of = (column, run) => {
    const value = column.value(run);
    return absent(value) ? "–" : String(value);
  };
  const everything = new Map(runs.map((run) =>
    [run.id, [plain(run.label), run.parameter, run.side, run.status, run.reason, run.out_of_line ? `out of line: ${run.out_of_line}` : "", `#${run.id}`].join(" ").toLowerCase()]));
  const statuses = [...new Set(runs.map((run) => run.status))].sort();

  const filter = el("input", { type: "search", id: "filter", placeholder: "words, e.g. wall flexible" });
  filter.value = state.text;
  const status = el("select", { id: "status" }, el("option", { value: "" }, "all"),
    ...statuses.map((name) => el("option", { value: name }, name)));
  status.value = statuses.includes(state.status) ? state.status : "";
  const count = el("span", { class: "muted", "aria-live": "polite", id: "count" });
  const heads = columns.map((column) => el("th", { scope: "col", class: look_of(column) },
    el("button", { type: "button", onclick: () => {
      state.down = state.by === column.name ? !state.down : false;
      state.by = column.name;
      draw();
    } }, column.name)));
  const body = el("tbody");

  function draw() {
    Object.assign(state, { text: filter.value, status: status.value });
    keep("table", state);
    const words = state.text.toLowerCase().split(/\s+/).filter((word) => word);
    const fits = (run) => (!state.status || run.status === state.status) &&
      words.every((word) => everything.get(run.id).includes(word));
    const by = columns.find((column) => column.name === state.by) || columns[0];
    const order = (a, b) => {
      const [p, q] = [by.value(a), by.value(b)];
      if (absent(p) || absent(q)) return absent(p) - absent(q);
      return (by.numeric ? p - q : String(p).localeCompare(String(q), "en", { numeric: true })) * (state.down ? -1 : 1);
    };
    const rows = runs.filter(fits).sort(order);
    heads.forEach((head, i) => {
      if (columns[i] === by) head.setAttribute("aria-sort", state.down ? "descending" : "ascending");
      else head.removeAttribute("aria-sort");
    });
    body.replaceChildren(...rows.map((run) => el("tr", {
      class: failed(run) ? "failed" : run.out_of_line ? "doubtful" : waiting(run) ? "quiet" : null, "data-id": run.id,
      onpointerenter: () => light(run.id), onpointerleave: () => light(null),
      onfocusin: () => light(run.id), onfocusout: () => light(null),
    },
      el("td", {}, el("input", { type: "checkbox", "aria-label": `Highlight ${plain(run.label)}`,
                                 disabled: run === baseline || !curve_of.has(run.id), checked: shown.pins.has(run.id),
                                 onchange: (event) => pin(run.id, event.target.checked) })),
      ...columns.map((column) => cell(column.show ? column.show(run) : text_of(column, run), column)))));
    shown.out = new Set(runs.filter((run) => !fits(run)).map((run) => run.id));
    count.textContent = rows.length === runs.length ? `all ${runs.length}`
      : `${rows.length} of ${runs.length}${data.external ? "" : "; the profiles show the same and what is highlighted"}`;
    changed.pins.forEach((tell) => tell !== tick && tell());
  }
  function tick() {
    for (const row of body.rows) row.querySelector("input").checked = shown.pins.has(Number(row.dataset.id));
  }
  filter.addEventListener("input", draw);
  status.addEventListener("change", draw);
  changed.pins.push(tick);
  changed.lit.push(() => {
    for (const row of body.rows) row.classList.toggle("lit", Number(row.dataset.id) === shown.lit);
  });
  byId("realizations").append(
    el("div", { class: "controls", role: "group", "aria-label": "Filter" }, el("label", {}, "filter", filter),
      el("label", {}, "status", status), count),
    el("div", { class: "wide", tabindex: "0", role: "region", "aria-label": "Realizations" },
      el("table", { id: "table" }, el("thead", {}, el("tr", {},
        el("th", { scope: "col" }, "highlight"), ...heads)), body)));
  draw();
}
