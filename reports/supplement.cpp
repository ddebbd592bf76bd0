#include "reports/supplement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "drawing/palette.hpp"
#include "reports/labels.hpp"
#include "reports/notes.hpp"
#include "results/ledger/audit_bounds.hpp"
#include "results/ledger/model_remarks.hpp"
#include "results/statistics/effects.hpp"

namespace cpt::reports {
namespace {

using drawing::a4_height, drawing::a4_width, drawing::Anchor, drawing::decimals, drawing::number,
    drawing::PdfPage, drawing::plain, drawing::Rich, drawing::Span, drawing::Svg;
namespace palette = drawing::palette;

using results::Snapshot;

constexpr double text_width = 190.0 / 25.4 * 72.0;  // double column of a journal
constexpr double text_left = 0.5 * (a4_width - text_width);
constexpr double text_bottom = a4_height - 40.0;
constexpr double paragraph_size = 9.0, table_size = 7.5;

/// Height of a figure over its width.
double shape_of(const std::string& svg) {
  constexpr std::string_view before = "viewBox=\"0 0 ";
  std::istringstream size(svg.substr(svg.find(before) + before.size(), 40));
  double wide = 1.0, high = 1.0;
  size >> wide >> high;
  return high / wide;
}

/// Writes downward; begins a new page where one is full.
class Writer {
 public:
  void heading(const std::string& text, double size = 12.0) {
    const auto lines = wrapped(text, size, text_width, true);
    need(1.3 * size * static_cast<double>(lines.size()) + 2.0 * size);
    y_ += 6.0;
    for (const std::string& line : lines)
      svg_.text({text_left, y_ += 1.2 * size}, plain(line), {.size = size, .bold = true});
    y_ += 6.0;
  }
  void paragraph(const std::string& text) {
    for (const std::string& line : wrapped(text, paragraph_size, text_width)) {
      need(1.4 * paragraph_size);
      svg_.text({text_left, y_ += 1.4 * paragraph_size}, plain(line), {.size = paragraph_size});
    }
    y_ += 4.0;
  }
  /// A row of a table, as high as its longest cell wants.
  void row(const std::vector<Rich>& cells, const std::vector<double>& widths, bool bold = false) {
    constexpr double pitch = 1.2 * table_size;
    std::vector<std::vector<Rich>> lines;
    std::size_t most = 1;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      lines.push_back(lines_of(cells[k], widths[k] - 6.0, bold));
      most = std::max(most, lines.back().size());
    }
    const double below = pitch * static_cast<double>(most - 1);
    need(1.5 * table_size + below + 3.0);
    y_ += 1.5 * table_size;
    double x = text_left;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      for (std::size_t i = 0; i < lines[k].size(); ++i)
        svg_.text({x, y_ + pitch * static_cast<double>(i)}, lines[k][i], {.size = table_size, .bold = bold});
      x += widths[k];
    }
    y_ += below;
    svg_.line({text_left, y_ + 3.0}, {text_left + text_width, y_ + 3.0},
              {bold ? palette::ink : palette::grid, bold ? 0.8 : 0.4, {}});
  }
  void figure(const std::string& svg, const std::string& caption) {
    const auto lines = wrapped(caption, paragraph_size, text_width);
    const double below = 1.4 * paragraph_size * static_cast<double>(lines.size()) + 10.0;
    const double height = std::min(text_width * shape_of(svg), text_bottom - top - below);
    y_ += y_ > top ? 12.0 : 0.0;
    need(height + below);
    placed_.push_back({svg, {text_left, y_, text_width, height}});
    y_ += height;
    paragraph(caption);
    y_ += 10.0;
  }
  std::vector<PdfPage> pages() {
    end_page();
    return std::move(pages_);
  }

 private:
  static constexpr double top = 36.0;
  /// A cell keeps its subscripts where it needs one line only.
  static std::vector<Rich> lines_of(const Rich& cell, double room, bool bold) {
    if (width(cell, table_size, bold) <= room) return {cell};
    std::string whole;
    for (const Span& span : cell) whole += span.text;
    std::vector<Rich> lines;
    for (const std::string& line : wrapped(whole, table_size, room, bold)) lines.push_back(plain(line));
    return lines;
  }
  void need(double height) {
    if (y_ + height > text_bottom) new_page();
  }
  void new_page() {
    end_page();
    svg_ = Svg(a4_width, a4_height, "page");
    y_ = top;
  }
  void end_page() {
    if (y_ == top && placed_.empty()) return;
    svg_.text({text_left + text_width, a4_height - 22.0}, plain(fmt::format("{}", pages_.size() + 1)),
              {.size = 8.0, .anchor = Anchor::end, .color = palette::muted});
    PdfPage page = {{svg_.document("page"), {0.0, 0.0, a4_width, a4_height}}};
    page.insert(page.end(), placed_.begin(), placed_.end());
    pages_.push_back(std::move(page));
    placed_.clear();
  }

  Svg svg_{a4_width, a4_height, "page"};
  double y_ = top;
  PdfPage placed_;
  std::vector<PdfPage> pages_;
};

/// Which inputs stand above the noise, in words, and how many by the paper's definition; empty where nothing
/// says what is noise.
std::string loud_inputs(const Snapshot& s, const std::vector<results::SensitivityRow>& rows) {
  if (std::ranges::none_of(rows, [](const auto& row) { return row.above_noise.has_value(); })) return "";
  std::string names;
  for (const auto& row : rows)
    if (std::isfinite(row.si) && !within_noise(row)) {
      names += names.empty() ? "" : ", ";
      for (const Span& span : symbol_of(s, parameter_of(s, row.parameter))) names += span.text;
    }
  const bool repeated =
      std::ranges::any_of(rows, [](const auto& row) { return row.above_repeats.has_value(); });
  const std::string noise =
      repeated ? "the noise of the repeats" : "the noise of the baseline, its spread inside the window";
  std::string text =
      names.empty() ? "No input is above " + noise + "." : "Above " + noise + ": " + names + ".";
  if (repeated && std::isfinite(rows.front().si_noise))
    text +=
        fmt::format(" By SI_noise, the paper's definition, {} would be.",
                    std::ranges::count_if(rows, [](const auto& row) { return row.above_si_noise == true; }));
  return text;
}

void write_indices(Writer& out, const Snapshot& s, const results::WindowRow& window) {
  out.heading("Sensitivity: " + window.name);
  if (!window.problem.empty()) return out.paragraph(window.problem);
  auto rows = sensitivity_in(s, window.name);
  if (rows.empty()) return out.paragraph("The study has no uncertain input.");
  std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) {
    const auto rank = [](double si) { return si >= 0.0 ? si : -1.0; };
    return rank(a.si_abs) > rank(b.si_abs);
  });
  const std::string baseline = number(rows.front().q_baseline_kPa, 5);
  const std::string where = place_of(s, window);
  out.paragraph(
      window.output.empty()
          ? fmt::format(
                "Average cone resistance over {}: {} kPa in the baseline, whose spread inside the window, "
                "SI_noise, is {}. SI = (q at the upper bound − q at the lower bound) / q at the upper bound, "
                "after Yost et al. (2023), eq. 3.",
                where, baseline, decimals(rows.front().si_noise, 4))
          : fmt::format(
                "{}{}: {}{} in the baseline. SI = (q at the upper bound − q at the lower bound) / q at the "
                "upper bound, with q the output.",
                window.is_scalar() ? window.output : "Average " + window.output,
                where.empty() ? "" : " over " + where, baseline, unit_behind(window)));
  if (const std::string remark = window_remark(s, window); !remark.empty()) out.paragraph(remark);
  const std::string so_far = results::repeats_so_far(s);
  if (const auto* noise = repeat_noise_of(s, window.name))
    out.paragraph(fmt::format(
        "± is half the row's own 95 % interval of SI from {} runs of the baseline with shifted material "
        "points{}, which scatter by {} kPa (standard deviation){}. {}",
        noise->runs, so_far.empty() ? "" : ", " + so_far, number(noise->q_c_deviation_kPa, 3),
        std::ranges::any_of(rows, [](const auto& row) { return row.pairs > 0; })
            ? ", or, where its bounds were repeated, too, from these pairs"
            : "",
        loud_inputs(s, rows)));
  else if (const std::string words = loud_inputs(s, rows); !words.empty())
    out.paragraph(words);
  const std::string unit = window.unit() == "-" ? "" : fmt::format(" ({})", window.unit());
  const std::vector<double> widths = {58, 42, 44, 42, 68, 68, 42, 38, text_width - 402};
  out.row({plain("input"), plain("lower"), plain("baseline"), plain("upper"), plain("q lower" + unit),
           plain("q upper" + unit), plain("SI (-)"), plain("± (-)"), plain("note")},
          widths, true);
  for (const auto& row : rows) {
    const auto& p = parameter_of(s, row.parameter);
    out.row({symbol_of(s, p) + unit_of(p), plain(p.lower_text), plain(p.baseline_text), plain(p.upper_text),
             plain(number(row.q_lower_kPa, 5)), plain(number(row.q_upper_kPa, 5)), plain(decimals(row.si, 4)),
             plain(std::isfinite(row.si_half_width) ? decimals(row.si_half_width, 4) : ""),
             plain(!row.note.empty()   ? row.note
                   : within_noise(row) ? "within the noise"
                                       : "")},
            widths);
  }
}

void write_effects(Writer& out, const Snapshot& s, const results::Effects& effects,
                   const results::WindowRow& window) {
  out.heading(fmt::format("Design {}: {}", effects.design, window.name));
  const std::vector<double> widths = {96, 62, 58, 58, 58, 34, 34, 40, text_width - 440};
  out.row({plain("input"), plain("quantity"), plain("value"), plain("from (95 %)"), plain("to (95 %)"),
           plain("unit"), plain("used"), plain("dropped"), plain("note")},
          widths, true);
  for (const results::EffectRow& row : effects.rows) {
    if (row.window != window.name) continue;
    Rich input;
    if (!row.parameter.empty()) input = symbol_of(s, parameter_of(s, row.parameter));
    if (!row.other_parameter.empty())
      input = input + plain(" × ") + symbol_of(s, parameter_of(s, row.other_parameter));
    const std::string quantity = std::isfinite(row.threshold_kPa)
                                     ? fmt::format("{} of {} kPa", row.quantity, number(row.threshold_kPa, 4))
                                     : row.quantity;
    out.row({input, plain(quantity), plain(number(row.value, 4)), plain(number(row.lower, 4)),
             plain(number(row.upper, 4)), plain(row.unit), plain(fmt::format("{}", row.used)),
             plain(fmt::format("{}", row.dropped)), plain(row.note)},
            widths);
  }
}

/// Completed runs whose balances are out of line.
void write_audit(Writer& out, const Snapshot& s) {
  if (std::ranges::all_of(s.realizations, [](const auto& run) { return run.out_of_line.empty(); })) return;
  out.heading("Runs out of line");
  out.paragraph(
      fmt::format("Completed, but more than {:.0f} % of the penetrometer's work (energy), {:.0f} % of its "
                  "impulse (momentum) "
                  "or {:.0f} % of its work in motion (kinetic energy) is open, cells lost their points or "
                  "soils that share cells could not move apart. "
                  "Indices that rest "
                  "on them say so.",
                  100.0 * results::most_energy_error, 100.0 * results::most_momentum_error,
                  100.0 * results::most_kinetic_fraction));
  const std::vector<double> widths = {30, 120, 60, 70, 60, text_width - 340};
  out.row({plain("id"), plain("input"), plain("energy"), plain("momentum"), plain("kinetic"),
           plain("out of line")},
          widths, true);
  for (const auto& run : s.realizations)
    if (!run.out_of_line.empty())
      out.row({plain(fmt::format("{}", run.id)), run_label(s, run), plain(number(run.audit.energy_error, 2)),
               plain(number(run.audit.momentum_error, 2)), plain(number(run.audit.kinetic_fraction, 2)),
               plain(run.out_of_line)},
              widths);
}

void write_imports(Writer& out, const Snapshot& s) {
  if (s.imports.empty()) return;
  std::string files;
  for (const auto& source : s.imports) files += (files.empty() ? "" : ", ") + source.file;
  out.paragraph(fmt::format("Results imported from {} at {}; report.json has the SHA-256 of what was read.",
                            files, moment(s.imports.back().imported)));
}

}  // namespace

std::vector<PdfPage> supplement(const Snapshot& s, const std::vector<NamedFigure>& figures,
                                const results::Effects& effects, const std::vector<std::string>& notes) {
  Writer out;
  out.heading(s.campaign.title, 16.0);
  out.paragraph(state_of(s) + ".");
  for (const std::string& note : notes) out.paragraph(note + ".");
  const results::CampaignRow& c = s.campaign;
  const std::string solver =
      s.is_external()
          ? fmt::format("external program{}", c.solver_version.empty() ? "" : " " + c.solver_version)
          : fmt::format("profile {}, preset {}", c.profile, c.preset);
  out.paragraph(fmt::format("Study {}, {}; {}campaign begun {}.", c.name, solver,
                            c.program_version.empty() ? ""
                            : s.is_external()
                                ? fmt::format("program {}; ", c.program_version)
                                : fmt::format("program {}, solver {}; ", c.program_version, c.solver_version),
                            moment(c.created)));
  write_imports(out, s);
  for (const std::string& remark : results::model_remarks(s)) out.paragraph("Note: " + remark + ".");
  for (const auto& window : s.windows) write_indices(out, s, window);
  if (!effects.rows.empty())
    for (const auto& window : s.windows) write_effects(out, s, effects, window);
  write_audit(out, s);
  const bool any_failed =
      std::any_of(s.realizations.begin(), s.realizations.end(), [](const auto& run) { return run.failed(); });
  if (any_failed) {
    out.heading("Failed realizations");
    const std::vector<double> widths = {30, 110, 90, text_width - 230};
    out.row({plain("id"), plain("input"), plain("status"), plain("reason")}, widths, true);
    for (const auto& run : s.realizations)
      if (run.failed())
        out.row({plain(fmt::format("{}", run.id)), run_label(s, run), plain(run.status), plain(run.reason)},
                widths);
  }
  for (const NamedFigure& figure : figures)
    if (figure.svg) out.figure(*figure.svg, figure.caption);
  return out.pages();
}

}  // namespace cpt::reports
