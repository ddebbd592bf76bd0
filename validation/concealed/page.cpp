#include "validation/concealed/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "diagnosis/median.hpp"
#include "drawing/markdown.hpp"
#include "drawing/text.hpp"
#include "reports/figure_files.hpp"
#include "validation/concealed/figures.hpp"
#include "validation/concealed/scores.hpp"

namespace cpt::validation::concealed {
namespace {

using drawing::decimals, drawing::number, drawing::table_head, drawing::table_line;
using reports::make_directory, reports::NamedFigure, reports::write_figure, reports::write_text;

using diagnosis::median;
using diagnosis::none_of_these;
using diagnosis::nothing_is_missing;
using Benchmarks = std::vector<Benchmark>;

std::string percent(double share) { return std::isfinite(share) ? decimals(100.0 * share, 0) + " %" : "–"; }

// "3 of 35, 9 % (2 to 23)"
std::string told(const Proportion& p) {
  if (p.of == 0) return "no such case";
  return fmt::format("{} of {}, {} ({} to {})", p.count, p.of, percent(p.value), decimals(100.0 * p.lower, 0),
                     decimals(100.0 * p.upper, 0));
}

bool of_kind(const Judged& judged, std::string_view kind) { return judged.truth.kind() == kind; }

Cases kind(const Benchmarks& benchmarks, std::string_view wanted) {
  return select(benchmarks, [&](const Judged& judged) { return of_kind(judged, wanted); });
}

Cases all(const Benchmarks& benchmarks) {
  return select(benchmarks, [](const Judged&) { return true; });
}

bool held_out_better(const Judged& judged) {
  return judged.answer.held_out_rmse < judged.answer.held_out_rmse_null;
}

double named_in_catalogue(const Judged& judged) {
  double most = 0.0;
  for (const auto& hypothesis : judged.answer.hypotheses)
    if (hypothesis.name != nothing_is_missing && hypothesis.name != none_of_these)
      most = std::max(most, hypothesis.probability);
  return most;
}

bool catalogued(const Judged& judged) {
  return judged.answer.answer != nothing_is_missing && judged.answer.answer != none_of_these;
}

Cases detectable_cases(const Benchmarks& benchmarks) {
  return select(benchmarks, [](const Judged& judged) {
    return (of_kind(judged, "single") || of_kind(judged, "pair")) && judged.strength >= detectable;
  });
}

std::string met(bool is, const Proportion& p) { return p.of == 0 ? "–" : is ? "yes" : "**no**"; }

std::string bars(const Benchmarks& benchmarks) {
  const Proportion alarms =
      share(kind(benchmarks, "nothing"), [](const Judged& judged) { return judged.alarm(); });
  const Proportion strong_named = share(
      select(benchmarks,
             [](const Judged& judged) { return of_kind(judged, "single") && judged.strength >= strong; }),
      [](const Judged& judged) { return judged.right(); });
  const Cases every = all(benchmarks);
  const Proportion covered = set_score(labelled(benchmarks, every).cases).coverage;
  const Proportion misnamed = share(kind(benchmarks, "outside"), [](const Judged& judged) {
    return catalogued(judged) && named_in_catalogue(judged) > 0.9;
  });
  const Proportion better = share(detectable_cases(benchmarks), held_out_better);
  std::string text = table_head({"what", "wanted", "found (95 % interval)", "met"});
  text += table_line({"false alarms where nothing is missing", "at most 5 %", told(alarms),
                      met(alarms.value <= 0.05, alarms)});
  text +=
      table_line({fmt::format("one mechanism of {} standard deviations or more is named", number(strong, 2)),
                  "at least 90 %", told(strong_named), met(strong_named.value >= 0.9, strong_named)});
  text += table_line({"the truth is in the answer's set", "85 to 95 %", told(covered),
                      met(covered.value >= 0.85 && covered.value <= 0.95, covered)});
  text += table_line({"an effect outside the catalogue is named as one of it with P > 0.9", "at most 10 %",
                      told(misnamed), met(misnamed.value <= 0.1, misnamed)});
  text += table_line({fmt::format("held-out error falls, mechanisms of {} standard deviations or more",
                                  number(detectable, 2)),
                      "at least 90 %", told(better), met(better.value >= 0.9, better)});
  return text;
}

std::string composition(const Benchmarks& benchmarks) {
  std::string text = table_head({"benchmark", "profile, preset", "cases", "nothing missing", "one mechanism",
                                 "two", "outside the catalogue", "two soundings", "withheld", "drawn"});
  for (const Benchmark& b : benchmarks) {
    const auto count = [&](const auto& is) {
      return std::to_string(std::count_if(b.cases.begin(), b.cases.end(), is));
    };
    const auto kind_count = [&](const char* wanted) {
      return count([&](const Judged& judged) { return of_kind(judged, wanted); });
    };
    text +=
        table_line({b.name, b.profile + ", " + b.preset, std::to_string(b.cases.size()),
                    kind_count("nothing"), kind_count("single"), kind_count("pair"), kind_count("outside"),
                    count([](const Judged& judged) { return judged.truth.soundings.size() > 1; }),
                    std::to_string(b.withheld), b.drawn});
  }
  return text;
}

std::string by_strength(const Benchmarks& benchmarks) {
  std::string text = table_head({"strength (standard deviations)", "alarm", "named", "among the first three",
                                 "in the set", "held-out error falls"});
  const std::size_t bins = std::size(strength_bounds);
  for (std::size_t b = 0; b < bins; ++b) {
    const double from = strength_bounds[b], to = b + 1 < bins ? strength_bounds[b + 1] : INFINITY;
    const Cases cases = select(benchmarks, [&](const Judged& judged) {
      return of_kind(judged, "single") && judged.strength >= from && judged.strength < to;
    });
    const Proportion in_set = set_score(labelled(benchmarks, cases).cases).coverage;
    text += table_line({std::isfinite(to) ? fmt::format("{} to {}", number(from, 2), number(to, 2))
                                          : fmt::format("{} and more", number(from, 2)),
                        told(share(cases, [](const Judged& judged) { return judged.alarm(); })),
                        told(share(cases, [](const Judged& judged) { return judged.right(); })),
                        told(share(cases, [](const Judged& judged) { return among_first(judged, 3); })),
                        told(in_set), told(share(cases, held_out_better))});
  }
  return text;
}

std::string confusion(const Benchmarks& benchmarks) {
  const Cases cases = select(benchmarks, [](const Judged& judged) { return !of_kind(judged, "pair"); });
  const Labelled scored = labelled(benchmarks, cases);
  const Eigen::MatrixXi counts = confusion_matrix(scored.cases, static_cast<int>(scored.labels.size()));
  std::vector<std::string> head{"truth, down; answer, across"};
  for (std::size_t k = 0; k < scored.labels.size(); ++k) head.push_back(fmt::format("{}", k + 1));
  std::string text = table_head(head);
  for (std::size_t i = 0; i < scored.labels.size(); ++i) {
    std::vector<std::string> line{fmt::format("{} {}", i + 1, scored.labels[i])};
    for (std::size_t j = 0; j < scored.labels.size(); ++j) {
      const int count = counts(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      line.push_back(count == 0 ? "" : i == j ? fmt::format("**{}**", count) : std::to_string(count));
    }
    text += table_line(line);
  }
  return text;
}

std::string beside(const Benchmarks& benchmarks) {
  const Cases nothing = kind(benchmarks, "nothing"), single = kind(benchmarks, "single");
  const Cases visible = select(benchmarks, [](const Judged& judged) {
    return of_kind(judged, "single") && judged.strength >= detectable;
  });
  const Cases outside = kind(benchmarks, "outside");
  struct Method {
    const char* name;
    std::function<std::string(const Judged&)> answer;
  };
  const Method methods[] = {
      {"the diagnosis", [](const Judged& judged) { return judged.answer.answer; }},
      {"BIC, independent errors", [](const Judged& judged) { return judged.bic; }},
      {"Gaussian-process discrepancy alone",
       [](const Judged& judged) {
         return std::string(judged.discrepancy > 0.5 ? none_of_these : nothing_is_missing);
       }},
      {"least RMSE", [](const Judged& judged) { return judged.best_rmse; }}};
  std::string text =
      table_head({"method", "false alarms where nothing is missing",
                  fmt::format("named, one mechanism, {} standard deviations or more", number(detectable, 2)),
                  "named, one mechanism, all", "effect outside the catalogue given a name of it"});
  for (const Method& method : methods) {
    const auto named = [&](const Judged& judged) { return method.answer(judged) == judged.label; };
    text += table_line(
        {method.name,
         told(share(nothing,
                    [&](const Judged& judged) { return method.answer(judged) != nothing_is_missing; })),
         told(share(visible, named)), told(share(single, named)),
         told(share(outside, [&](const Judged& judged) {
           const std::string answer = method.answer(judged);
           return answer != nothing_is_missing && answer != none_of_these;
         }))});
  }
  return text;
}

std::string further(const Benchmarks& benchmarks) {
  const Cases every = all(benchmarks), pairs = kind(benchmarks, "pair");
  const Labelled scored = labelled(benchmarks, every);
  const auto sets = set_score(scored.cases);
  const auto abstention = retrieval(scored.cases, static_cast<int>(scored.labels.size()) - 1);
  std::vector<double> overlaps, ratios;
  int checks = 0, covered = 0;
  for (const Judged* judged : every) {
    if (std::isfinite(judged->overlap) && judged->strength >= detectable) overlaps.push_back(judged->overlap);
    for (const auto& check : judged->parameters) {
      ++checks;
      covered += check.covered() ? 1 : 0;
      if (check.fitted.deviation > 0.0)
        ratios.push_back(std::abs(check.truth - check.fitted.value) / check.fitted.deviation);
    }
  }
  std::vector<double> falls;
  for (const Judged* judged : detectable_cases(benchmarks))
    falls.push_back(1.0 - judged->answer.held_out_rmse / judged->answer.held_out_rmse_null);
  std::string text = table_head({"score", "value"});
  text += table_line(
      {"Brier score, all cases (0 is perfect, 2 the worst)", decimals(brier_score(scored.cases), 3)});
  text += table_line({"mean log score", decimals(log_score(scored.cases), 2)});
  text += table_line({"mean size of the answer's set", decimals(sets.size, 1)});
  text += table_line({"\"none of these\": right when said", told(abstention.precision)});
  text += table_line({"\"none of these\": said when right", told(abstention.recall)});
  text += table_line(
      {"alarm, effect outside the catalogue of " + number(detectable, 2) + " standard deviations or more",
       told(share(select(benchmarks,
                         [](const Judged& judged) {
                           return of_kind(judged, "outside") && judged.strength >= detectable;
                         }),
                  [](const Judged& judged) { return judged.alarm(); }))});
  text += table_line({"two mechanisms: one of them is named",
                      told(share(pairs, [](const Judged& judged) { return judged.right(); }))});
  text += table_line({"two mechanisms: the best pair offered is the true one",
                      told(share(pairs, [](const Judged& judged) { return judged.pair_right(); }))});
  text += table_line({"depths located over true, intersection over union, median of the detectable",
                      percent(median(overlaps))});
  text += table_line({"true parameter inside its 90 % interval, where the mechanism was named",
                      checks > 0 ? told(proportion(covered, checks)) : "no such case"});
  text += table_line(
      {"error of that parameter over its claimed standard deviation, median", decimals(median(ratios), 2)});
  text += table_line({"held-out error taken away, median of the detectable", percent(median(falls))});
  return text;
}

std::string missed(const Benchmarks& benchmarks) {
  std::string text = table_head({"case", "truth", "strength", "answer", "P(answer)", "P(truth)", "why"});
  for (const Benchmark& benchmark : benchmarks)
    for (const Judged& judged : benchmark.cases) {
      if (judged.right()) continue;
      const bool in_set = std::ranges::any_of(judged.answer.hypotheses, [&](const auto& hypothesis) {
        return hypothesis.in_set &&
               (" " + judged.label + " ").find(" " + hypothesis.name + " ") != std::string::npos;
      });
      const std::string why = of_kind(judged, "nothing")              ? "false alarm"
                              : judged.strength < detectable          ? "too weak to be seen"
                              : !judged.alarm()                       ? "explained by the soil's parameters"
                              : in_set                                ? "not told apart, but in the set"
                              : judged.answer.answer == none_of_these ? "no mechanism passed"
                                                                      : "another mechanism fits better";
      std::string truth = judged.label;
      if (judged.truth.outside) truth += " (" + judged.truth.outside->kind + ")";
      text += table_line(
          {benchmark.name + " " + case_name(judged.truth.id), truth, decimals(judged.strength, 1),
           judged.answer.answer, decimals(judged.probability_of(judged.answer.answer), 2),
           judged.truth.parts.size() > 1 ? "–" : decimals(judged.probability_of(judged.label), 2), why});
    }
  return text;
}

}  // namespace

std::vector<std::filesystem::path> write_page(const Benchmarks& benchmarks, const std::string& note,
                                              const std::filesystem::path& file) {
  const std::filesystem::path folder = file.parent_path() / file.stem();
  std::vector<std::filesystem::path> files{file};
  make_directory(folder);
  std::string pictures;
  for (const NamedFigure& figure :
       {NamedFigure{"strength", "Share of cases named rightly, by strength", strength_figure(benchmarks)},
        NamedFigure{"reliability", "Right answers against claimed probability",
                    reliability_figure(benchmarks)}}) {
    for (const std::filesystem::path& written : write_figure(figure, folder)) files.push_back(written);
    pictures += fmt::format("![{}]({}/{}.svg)\n", figure.caption, folder.filename().string(), figure.name);
  }
  std::string text = "# The diagnosis on concealed cases\n\n" + note;
  if (!note.empty()) text += "\n";
  text +=
      "Recordings were made by the solver with an effect, soil parameters, material points, mesh, Courant "
      "number "
      "and noise that were drawn at random and sealed: beside each recording stands the salted SHA-256 of "
      "its "
      "truth. The diagnoses were made from the recordings alone; then `campaign reveal` opened the truths, "
      "compared "
      "them with their seals and wrote this page. An effect's strength is what is left of it, in standard "
      "deviations, once the study's parameters have explained what they can.\n\n";
  text += "## The bars\n\n" + bars(benchmarks);
  text += "\n## The cases\n\n" + composition(benchmarks);
  text += "\n## Beside simpler methods\n\n" + beside(benchmarks);
  text += "\n## By strength, one mechanism missing\n\n" + by_strength(benchmarks) + "\n" + pictures;
  text += "\n## Truth and answer\n\nPairs are not in this table.\n\n" + confusion(benchmarks);
  text += "\n## Further scores\n\n" + further(benchmarks);
  text += "\n## What was missed, and why\n\n" + missed(benchmarks);
  write_text(file, text);
  return files;
}

}  // namespace cpt::validation::concealed
