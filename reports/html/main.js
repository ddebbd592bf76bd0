// Provenance, head and reloading; draws everything.
"use strict";

function provenance() {
  const c = data.campaign;
  const list = el("dl", { class: "plain" });
  const row = (name, value) => value && list.append(el("dt", {}, name), el("dd", {}, value));
  row("study", c.name);
  row("solver", data.external && "external program");
  row("profile", !data.external && c.profile);
  row("preset", c.preset);
  row("program version", c.program_version);
  row(data.external ? "version of the external program" : "solver version", c.solver_version);
  row("campaign begun", moment(c.created));
  row("newest result", moment(data.newest_result));
  for (const source of data.imports) row("imported from", `${source.file} (SHA-256 ${source.sha256}), ${moment(source.imported)}`);
  byId("provenance").append(list,
    el("details", {}, el("summary", {}, "Study file"), el("pre", {}, c.study_text)),
    el("details", {}, el("summary", {}, "All inputs of the baseline"), el("pre", {}, c.baseline_setup)),
    el("details", { class: "no-print" }, el("summary", {}, "Files beside this page"),
      el("ul", {}, ...data.files.map((file) => el("li", {}, el("a", { href: encodeURIComponent(file) }, file))))),
    el("details", { class: "no-print" }, el("summary", {}, "Licences of the libraries in this page"),
      el("pre", {}, byId("licences").textContent)),
    el("footer", {}, `Written ${moment(new Date(document.lastModified).toISOString())}; all times are UTC.`));
}

function head() {
  byId("title").textContent = data.campaign.title;
  byId("state").textContent = `${data.state}${data.newest_result ? `; newest result ${moment(data.newest_result)}` : ""}.`;
  byId("state").classList.toggle("warn", runs.some((run) => failed(run) || run.status === "interrupted"));
  byId("state").after(...data.notes.map((note) => el("p", { class: "warn note" }, `${note}.`)));
  for (const section of document.querySelectorAll("main > section:not([hidden])"))
    byId("contents").append(el("a", { href: `#${section.id}` }, ...[...section.querySelector("h2").cloneNode(true).childNodes]));
  const themes = [["as the system", "light dark"], ["light", "light"], ["dark", "dark"]];
  let theme = kept("theme", 0);
  const paint = () => {
    document.documentElement.style.colorScheme = themes[theme][1];
    byId("theme").textContent = `Colours: ${themes[theme][0]}`;
  };
  byId("theme").addEventListener("click", () => {
    theme = (theme + 1) % themes.length;
    keep("theme", theme);
    paint();
  });
  paint();
}

/// A page of `report --watch` loads itself anew, but not under the reader's hands.
function live() {
  if (!data.reload_seconds) return;
  const button = byId("live");
  let on = kept("live", true);
  const paint = () => {
    button.setAttribute("aria-pressed", on);
    button.textContent = on ? `Reloads every ${data.reload_seconds} s` : "Reloading paused";
  };
  button.hidden = false;
  button.addEventListener("click", () => { on = !on; keep("live", on); paint(); });
  paint();
  setInterval(() => {
    const busy = ["INPUT", "SELECT"].includes(document.activeElement.tagName) || shown.lit !== null;
    if (on && !busy) location.reload();
  }, 1000 * data.reload_seconds);
}

glance();
failures();
diagnoses();
sensitivity();
effects();
if (data.external) byId("profiles").hidden = true;
else profiles();
realizations();
provenance();
head();
live();

// Paper shows what a screen folds away, but for the long texts.
window.addEventListener("beforeprint", () => {
  for (const details of document.querySelectorAll("#sensitivity details")) details.open = true;
});
