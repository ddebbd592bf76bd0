#include "reports/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "drawing/text.hpp"
#include "reports/diagnosis/figures.hpp"
#include "reports/figure_files.hpp"
#include "reports/html/assets.hpp"
#include "reports/labels.hpp"
#include "reports/notes.hpp"
#include "reports/numbers.hpp"
#include "results/ledger/interrupted.hpp"
#include "results/push/push_start.hpp"
#include "solver/channels.hpp"

namespace cpt::reports {
namespace {

using Json = nlohmann::ordered_json;
using results::Snapshot;

Json label(const drawing::Rich& text) {
  Json spans = Json::array();
  for (const drawing::Span& span : text) spans.push_back({span.text, span.subscript});
  return spans;
}

Json in_kPa(const std::vector<double>& pascal) {
  Json values = Json::array();
  for (const double value : pascal) values.push_back(value / 1.0e3);  // what is not finite becomes null
  return values;
}

Json answers(const std::vector<diagnosis::StoredAnswer>& stored) {
  Json all = Json::array();
  for (const diagnosis::StoredAnswer& a : stored) {
    Json answer = {{"file", a.file},
                   {"title", a.title},
                   {"headline", a.headline},
                   {"reservations", a.reservations},
                   {"held_out_rmse_null", a.held_out_rmse_null},
                   {"held_out_rmse", a.held_out_rmse},
                   {"held_out_gain", a.held_out_gain},
                   {"held_out_gain_lower", a.held_out_gain_lower},
                   {"held_out_gain_upper", a.held_out_gain_upper},
                   {"hypotheses", Json::array()},
                   {"mismatches", Json::array()},
                   {"fitted", Json::array()}};
    for (const auto& h : a.hypotheses)
      answer["hypotheses"].push_back(
          {{"name", h.name}, {"prior", h.prior}, {"probability", h.probability}, {"in_set", h.in_set}});
    for (const auto& m : a.mismatches)
      answer["mismatches"].push_back(
          {{"sounding", m.sounding}, {"from_m", m.from}, {"to_m", m.to}, {"percent", m.percent}, {"p", m.p}});
    for (const auto& f : a.fitted)
      answer["fitted"].push_back({{"mechanism", f.mechanism},
                                  {"quantity", f.quantity},
                                  {"unit", f.unit},
                                  {"value", f.value},
                                  {"lower", f.lower},
                                  {"upper", f.upper}});
    all.push_back(std::move(answer));
  }
  return all;
}

/// What sentences and tables call a window's numbers.
void describe(Json& window, const Snapshot& s, const results::WindowRow& row) {
  window["remark"] = window_remark(s, row);
  window["place"] = place_of(s, row);
  window["quantity"] =
      row.output.empty() ? label(drawing::symbolic("q_c")) : label(drawing::plain(row.output));
  window["is_scalar"] = row.is_scalar();
  window["unit"] = unit_behind(row);
}

/// The numbers of report.json, with labels, layers, curves and diagnoses.
Json page_data(const Snapshot& s, const PageContext& context) {
  Json data = Json::parse(report_json(s, context.effects));
  for (std::size_t i = 0; i < s.parameters.size(); ++i)
    data["parameters"][i]["label"] = label(symbol_of(s, s.parameters[i]));
  std::string newest;
  for (std::size_t i = 0; i < s.realizations.size(); ++i) {
    data["realizations"][i]["status"] = results::status_words(s.realizations[i]);
    data["realizations"][i]["label"] = label(run_label(s, s.realizations[i]));
    newest = std::max(newest, s.realizations[i].finished);
  }
  for (std::size_t i = 0; i < s.windows.size(); ++i) describe(data["windows"][i], s, s.windows[i]);
  data["external"] = s.is_external();
  data["layers"] = Json::array();
  for (const results::LayerRow& layer : s.layers)
    data["layers"].push_back({{"top_m", layer.top_m}, {"bottom_m", layer.bottom_m}, {"soil", layer.soil}});
  data["curves"] = Json::array();
  static const std::vector<results::CurveRow> none;
  for (const results::CurveRow& curve : s.is_external() ? none : s.curves) {
    Json& drawn = data["curves"].emplace_back();
    drawn = {{"realization", curve.realization},
             {"depth_m", curve.profile.depth},
             {"start", results::bins_of_start(curve.profile)}};
    for (const solver::Channel& channel : solver::channels())
      if (const std::vector<double>& values = curve.profile.*channel.values; !values.empty())
        drawn[in_unit(channel, "kPa")] = in_kPa(values);
  }
  data["channels"] = Json::array();
  for (const solver::Channel& channel : solver::channels())
    if (std::ranges::any_of(s.curves,
                            [&](const auto& curve) { return !(curve.profile.*channel.values).empty(); }))
      data["channels"].push_back({{"name", channel.name},
                                  {"symbol", label(drawing::symbolic(channel.symbol))},
                                  {"title", channel.title}});
  data["diagnoses"] = answers(context.diagnoses);
  data["state"] = state_of(s);
  data["notes"] = context.notes;
  data["newest_result"] = newest;
  data["files"] = context.files;
  data["reload_seconds"] = context.reload_seconds;
  return data;
}

/// The figures of windows and diagnoses, each in a box whose id the scripts know.
std::string figures(const Snapshot& s, const PageContext& context) {
  std::string html;
  const auto add = [&](const NamedFigure& figure) {
    if (figure.svg)
      html += fmt::format("<figure class=\"drawn\" id=\"{}\">\n{}<figcaption>{}</figcaption>\n</figure>\n",
                          figure.name, *figure.svg, drawing::escape(figure.caption));
  };
  const Place place{drawing::Column::single, drawing::Ground::page};
  for (std::size_t k = 0; k < s.windows.size(); ++k)
    for (const NamedFigure& figure :
         window_figures(s, context.effects, s.windows[k], std::to_string(k), place))
      add(figure);
  for (const NamedFigure& figure : band_figures(s, context.effects, place)) add(figure);
  for (std::size_t k = 0; k < context.diagnoses.size(); ++k)
    add({fmt::format("probability_{}", k),
         "Probability of each hypothesis. Bold: the answer; framed: not ruled out, the set that holds the "
         "answer "
         "with 95 % probability; a full bar: the only one left, without reservations.",
         diagnosed::probability_figure(context.diagnoses[k])});
  return html;
}

/// JSON that can stand inside <script>: ASCII without '<', so that no name can end the block or begin
/// another.
std::string script_safe(const Json& data) {
  std::string text;
  for (const char c : data.dump(-1, ' ', true, Json::error_handler_t::replace))
    c == '<' ? text += "\\u003c" : text += c;
  return text;
}

/// The template with its {{name}} replaced, once: what is put in is not looked at again.
std::string filled(std::string_view text, const std::map<std::string_view, std::string_view>& parts) {
  std::string out;
  while (true) {
    const std::size_t open = text.find("{{");
    out += text.substr(0, open);
    if (open == std::string_view::npos) return out;
    const std::size_t close = text.find("}}", open);
    out += parts.at(text.substr(open + 2, close - open - 2));
    text.remove_prefix(close + 2);
  }
}

}  // namespace

std::string page(const Snapshot& s, const PageContext& context) {
  const std::string title = drawing::escape(s.campaign.title), drawn = figures(s, context),
                    data = script_safe(page_data(s, context));
  return filled(assets::page, {{"title", title},
                               {"style", assets::style},
                               {"figures", drawn},
                               {"data", data},
                               {"licences", assets::licences},
                               {"d3", assets::d3},
                               {"plot", assets::plot},
                               {"script", assets::script}});
}

}  // namespace cpt::reports
