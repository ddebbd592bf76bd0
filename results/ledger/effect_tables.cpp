#include "results/ledger/effect_tables.hpp"

#include <fmt/format.h>

namespace cpt::results {
namespace {

using parameters::Estimate;

template <class Get>
void add_estimate(RowTable<DepthBandRow>& table, const std::string& name, Get get) {
  const auto add = [&](const char* end, double Estimate::*part) {
    table.columns.push_back(column_of<DepthBandRow>(
        name + end, "", [ get, part ](auto& row) -> auto& { return get(row).*part; }));
  };
  add("_kPa", &Estimate::value);
  add("_lower_kPa", &Estimate::lower);
  add("_upper_kPa", &Estimate::upper);
}

RowTable<DepthBandRow> make_depth_band_table() {
  using B = DepthBandRow;
  RowTable<B> table{"depth_band",
                    {column("channel", "NOT NULL", &B::channel), column("depth_m", "NOT NULL", &B::depth_m),
                     column("runs", "NOT NULL", &B::runs)},
                    "PRIMARY KEY (channel, depth_m)",
                    "channel, depth_m"};
  add_estimate(
      table, "mean", [](auto& row) -> auto& { return row.mean; });
  table.columns.push_back(column("standard_deviation_kPa", "", &B::standard_deviation));
  for (std::size_t k = 0; k < band_quantiles.size(); ++k)
    add_estimate(
        table, fmt::format("quantile_{:02.0f}", 100.0 * band_quantiles[k]), [k](auto& row) -> auto& {
          return row.quantiles[k];
        });
  return table;
}

template <class Row>
void replace_rows(const Database& database, const RowTable<Row>& table, const std::vector<Row>& rows) {
  database.execute("DELETE FROM " + table.name);
  for (const Row& row : rows) insert_row(database, table, row);
}

}  // namespace

const RowTable<EffectRow>& effect_table() {
  using E = EffectRow;
  static const RowTable<E> table = {
      "effect",
      {column("window", "NOT NULL", &E::window), column("parameter", "", &E::parameter),
       column("other_parameter", "", &E::other_parameter), column("quantity", "NOT NULL", &E::quantity),
       column("unit", "NOT NULL", &E::unit), column("threshold_kPa", "", &E::threshold_kPa),
       column("value", "", &E::value), column("lower", "", &E::lower), column("upper", "", &E::upper),
       column("used", "NOT NULL", &E::used), column("dropped", "NOT NULL", &E::dropped),
       column("note", "NOT NULL", &E::note), column("method", "", &E::method), column("runs", "", &E::runs)},
      "",
      "rowid"};
  return table;
}

const RowTable<DepthBandRow>& depth_band_table() {
  static const RowTable<DepthBandRow> table = make_depth_band_table();
  return table;
}

void write_effects(const Database& database, const Effects& effects) {
  replace_rows(database, effect_table(), effects.rows);
  replace_rows(database, depth_band_table(), effects.bands);
}

}  // namespace cpt::results
