#include "reports/page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/labels.hpp"
#include "reports/text.hpp"

namespace cpt::reports {
namespace {

using results::Snapshot;

constexpr std::string_view style = R"css(
body { font: 15px/1.5 "DejaVu Sans", Verdana, Arial, sans-serif; color: #222; max-width: 62rem; margin: 2rem auto;
       padding: 0 1rem; }
h1 { font-size: 1.6rem; margin-bottom: 0.2rem; } h2 { font-size: 1.2rem; margin-top: 2.4rem; }
.state { color: #555; } .warn { color: #a34700; font-weight: bold; }
table { border-collapse: collapse; font-size: 0.84rem; margin: 0.8rem 0; }
th, td { padding: 0.25rem 0.7rem; text-align: left; border-bottom: 1px solid #ddd; vertical-align: top; }
th { border-bottom: 2px solid #888; } td.n, th.n { text-align: right; font-variant-numeric: tabular-nums; }
tr.quiet td { color: #777; } tr.failed td { color: #a34700; }
figure { margin: 1.2rem 0; } figure svg { width: 100%; max-width: 46rem; height: auto; border: 1px solid #eee; }
figcaption { font-size: 0.84rem; color: #555; }
pre { background: #f6f6f6; padding: 0.8rem; overflow-x: auto; font-size: 0.78rem; }
.wide { overflow-x: auto; }
)css";

std::string cell(const std::string& html_text, bool numeric = false) {
  return fmt::format("<td{}>{}</td>", numeric ? " class=\"n\"" : "", html_text);
}

std::string value_with_unit(const std::string& text, const results::ParameterRow& p) {
  return escape(p.unit.empty() || p.unit == "-" ? text : text + " " + p.unit);
}

std::string failures(const Snapshot& s) {
  std::string rows;
  for (const auto& r : s.realizations)
    if (r.failed())
      rows += fmt::format("<tr class=\"failed\">{}{}{}{}</tr>\n", cell(fmt::format("{}", r.id), true),
                          cell(html(run_label(s, r))), cell(escape(r.status)), cell(escape(r.reason)));
  if (rows.empty()) return "";
  return "<h2>Failed realizations</h2>\n<p>They take no part in the indices below; rows that need them say "
         "so.</p>\n"
         "<table><tr><th class=\"n\">id</th><th>input</th><th>status</th><th>reason</th></tr>\n" +
         rows + "</table>\n";
}

std::string sensitivity_of(const Snapshot& s, const results::WindowRow& window) {
  std::string out = fmt::format("<h2>Sensitivity: {}</h2>\n", escape(window.name));
  if (!window.problem.empty()) return out + fmt::format("<p class=\"warn\">{}</p>\n", escape(window.problem));
  auto rows = sensitivity_in(s, window.name);
  std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) {
    const auto rank = [](double si) { return si >= 0.0 ? si : -1.0; };
    return rank(a.si_abs) > rank(b.si_abs);
  });
  if (rows.empty()) return out + "<p>The study has no uncertain input.</p>\n";
  out += fmt::format(
      "<p>{} over {}. Baseline {} kPa, SI<sub>noise</sub> = {}. SI = (q<sub>upper</sub> − q<sub>lower</sub>) "
      "/ "
      "q<sub>upper</sub>; rows in grey do not exceed the noise.</p>\n",
      html(symbolic("Average q_c")), depth_range(window.from_m, window.to_m),
      number(rows.front().q_baseline_kPa, 5), decimals(rows.front().si_noise, 4));
  out +=
      "<div class=\"wide\"><table><tr><th>parameter</th><th>meaning</th><th class=\"n\">lower</th>"
      "<th class=\"n\">baseline</th><th class=\"n\">upper</th><th class=\"n\">q at lower (kPa)</th>"
      "<th class=\"n\">q at upper (kPa)</th><th class=\"n\">SI</th><th>note</th></tr>\n";
  for (const auto& row : rows) {
    const auto& p = parameter_of(s, row.parameter);
    const bool quiet = row.above_noise.has_value() && !*row.above_noise;
    const bool undefined = row.note.starts_with("undefined");
    out += fmt::format(
        "<tr{}>{}{}{}{}{}{}{}{}{}</tr>\n",
        undefined ? " class=\"failed\""
        : quiet   ? " class=\"quiet\""
                  : "",
        cell(html(symbol_of(s, p))), cell(escape(p.meaning)), cell(value_with_unit(p.lower_text, p), true),
        cell(value_with_unit(p.baseline_text, p), true), cell(value_with_unit(p.upper_text, p), true),
        cell(number(row.q_lower_kPa, 5), true), cell(number(row.q_upper_kPa, 5), true),
        cell(decimals(row.si, 4), true), cell(escape(row.note)));
  }
  return out + "</table></div>\n";
}

std::string realizations(const Snapshot& s) {
  std::string out =
      "<h2>Realizations</h2>\n<div class=\"wide\"><table><tr><th "
      "class=\"n\">id</th><th>input</th><th>status</th>"
      "<th class=\"n\">material points</th><th class=\"n\">steps</th><th class=\"n\">time (s)</th>"
      "<th class=\"n\">energy error</th><th class=\"n\">mass error</th></tr>\n";
  for (const auto& r : s.realizations)
    out += fmt::format(
        "<tr{}>{}{}{}{}{}{}{}{}</tr>\n",
        r.failed()    ? " class=\"failed\""
        : r.waiting() ? " class=\"quiet\""
                      : "",
        cell(fmt::format("{}", r.id), true), cell(html(run_label(s, r))), cell(escape(r.status)),
        cell(r.waiting() ? "–" : fmt::format("{}", r.material_points), true),
        cell(r.waiting() ? "–" : fmt::format("{}", r.steps), true), cell(decimals(r.wall_s, 1), true),
        cell(number(r.audit.energy_error, 2), true), cell(number(r.audit.mass_error, 2), true));
  return out + "</table></div>\n";
}

std::string provenance(const Snapshot& s) {
  const results::CampaignRow& c = s.campaign;
  std::string out = "<h2>Provenance</h2>\n<table>\n";
  const auto row = [&](std::string_view name, const std::string& value) {
    out += fmt::format("<tr><th>{}</th><td>{}</td></tr>\n", name, escape(value));
  };
  row("study", c.name);
  row("profile", c.profile);
  row("preset", c.preset);
  row("program version", c.program_version);
  row("solver version", c.solver_version);
  row("campaign begun", c.created);
  out += "</table>\n";
  out += fmt::format("<details><summary>Study file</summary><pre>{}</pre></details>\n", escape(c.study_text));
  out += fmt::format("<details><summary>All inputs of the baseline</summary><pre>{}</pre></details>\n",
                     escape(c.baseline_setup));
  return out;
}

}  // namespace

std::string page(const Snapshot& s, const std::vector<PageFigure>& figures) {
  std::string out = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width\">\n<title>{0}</title>\n<style>{1}</style></head>\n<body>\n<h1>{0}</h1>\n"
      "<p class=\"{2}\">{3}.</p>\n",
      escape(s.campaign.title), style, all_completed(s) ? "state" : "warn", escape(state_of(s)));
  out += failures(s);
  if (!figures.empty()) out += "<h2>Figures</h2>\n";
  for (const PageFigure& figure : figures)
    out += fmt::format("<figure>\n{}<figcaption>{}</figcaption>\n</figure>\n", figure.svg,
                       escape(figure.caption));
  for (const auto& window : s.windows) out += sensitivity_of(s, window);
  out += realizations(s) + provenance(s);
  return out + "</body>\n</html>\n";
}

}  // namespace cpt::reports
