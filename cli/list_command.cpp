// campaign list WHAT
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/command.hpp"
#include "cli/exit_codes.hpp"
#include "cli/format_option.hpp"
#include "results/query.hpp"
#include "solver/mechanisms/catalogue.hpp"
#include "solver/presets.hpp"
#include "solver/quantities.hpp"
#include "solver/simulate.hpp"

namespace cpt::cli {
namespace {

using results::Format;
using results::Table;

std::string range(const solver::Quantity& quantity) {
  if (quantity.choices.empty()) return fmt::format("{} to {}", quantity.min, quantity.max);
  return fmt::format("{}", fmt::join(quantity.choices, ", "));
}

Table quantities(Format format) {
  const solver::Setup setup = solver::make_setup(solver::Profile::homogeneous_sand, solver::Preset::standard);
  Table table{{"name", "unit", "range", "default", "meaning"}, {}};
  const bool all = format != Format::table;  // a line of the terminal has no room for everything
  if (all) table.columns.insert(table.columns.end(), {"symbol", "source"});
  for (const solver::Quantity& quantity : solver::all_quantities()) {
    auto& row = table.rows.emplace_back();
    row.emplace_back(std::string(quantity.name));
    row.emplace_back(std::string(quantity.unit));
    row.emplace_back(range(quantity));
    row.emplace_back(quantity.format(quantity.value(setup)));
    row.emplace_back(std::string(quantity.meaning));
    if (!all) continue;
    row.emplace_back(std::string(quantity.symbol));
    row.emplace_back(std::string(quantity.source));
  }
  return table;
}

Table mechanisms(Format format) {
  Table table{{"mechanism", "what it is", "quantity", "unit", "prior range", "signature in q_c"}, {}};
  const bool all = format != Format::table;
  if (all) table.columns.insert(table.columns.end(), {"equation", "source"});
  for (const solver::Mechanism& mechanism : solver::all_mechanisms()) {
    bool first = true;
    for (const solver::MechanismParameter& parameter : mechanism.parameters) {
      const bool told = all || first;  // on a terminal, once for each mechanism
      auto& row = table.rows.emplace_back();
      row.emplace_back(std::string(told ? mechanism.name : ""));
      row.emplace_back(std::string(told ? mechanism.title : ""));
      row.emplace_back(std::string(parameter.quantity.name));
      row.emplace_back(std::string(parameter.quantity.unit));
      row.emplace_back(fmt::format("{} to {}", parameter.prior_lower, parameter.prior_upper));
      row.emplace_back(std::string(told ? mechanism.signature : ""));
      first = false;
      if (!all) continue;
      row.emplace_back(std::string(mechanism.equation));
      row.emplace_back(std::string(mechanism.source));
    }
  }
  return table;
}

Table profiles(Format) {
  Table table{{"profile", "layers"}, {}};
  for (const solver::Profile profile : solver::all_profiles()) {
    std::string layers;
    for (const solver::Layer& layer : solver::make_setup(profile, solver::Preset::standard).layers)
      layers += fmt::format("{}{} {} to {} m", layers.empty() ? "" : ", ",
                            layer.soil == solver::Soil::sand ? "sand" : "clay", layer.top, layer.bottom);
    table.rows.push_back({std::string(to_string(profile)), layers});
  }
  return table;
}

Table presets(Format) {
  Table table{{"preset", "columns x rows per metre of material points", "elements over the cone's radius"},
              {}};
  for (const solver::Preset preset : solver::all_presets()) {
    const solver::Numerics numerics = solver::make_setup(solver::Profile::homogeneous_sand, preset).numerics;
    std::string zones;
    for (const solver::PointZone& zone : numerics.zones)
      zones += fmt::format("{}{} x {}", zones.empty() ? "" : ", ", zone.columns, zone.rows_per_metre);
    table.rows.push_back({std::string(to_string(preset)), zones, std::int64_t{numerics.face_elements}});
  }
  return table;
}

Table queries(Format) {
  Table table{{"query", "meaning"}, {}};
  for (const results::NamedQuery& query : results::named_queries())
    table.rows.push_back({std::string(query.name), std::string(query.meaning)});
  return table;
}

Table outcomes(Format) {
  using solver::Status;
  Table table{{"outcome", "meaning"}, {}};
  const std::pair<Status, const char*> meanings[] = {
      {Status::completed, "pushed to the final depth, audit passed"},
      {Status::did_not_converge, "the stress integration or the motion broke down"},
      {Status::energy_drift, "the energy balance left its tolerance"},
      {Status::time_limit, "wall-clock limit, or no step for too long"},
      {Status::invalid_parameters, "the inputs describe no possible model"},
      {Status::crashed, "its process died; the reason says how"},
      {Status::rank_lost, "the MPI ranks that ran it were lost"}};
  for (const auto& [status, meaning] : meanings)
    table.rows.push_back({std::string(to_string(status)), std::string(meaning)});
  return table;
}

struct Listing {
  const char* name;
  const char* meaning;
  Table (*make)(Format);
};
constexpr Listing listings[] = {
    {"quantities", "everything a study can set or vary; csv and json also give symbol and source",
     quantities},
    {"mechanisms", "physical effects that can be switched on and that a diagnosis looks for", mechanisms},
    {"profiles", "soil profiles a study can start from", profiles},
    {"presets", "resolutions of the model", presets},
    {"queries", "what campaign query answers", queries},
    {"outcomes", "how a realization can end", outcomes},
};

struct Arguments {
  std::string what;
  Format format = Format::table;
};

int list(const Arguments& arguments) {
  for (const Listing& listing : listings)
    if (arguments.what == listing.name)
      fmt::print("{}", results::format(listing.make(arguments.format), arguments.format));
  return all_well;
}

}  // namespace

void add_list(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand("list", "Print what there is to choose from");
  std::vector<std::string> names;
  std::string help = "WHAT is one of\n";
  for (const Listing& listing : listings) {
    names.emplace_back(listing.name);
    help += fmt::format("  {:<14}{}\n", listing.name, listing.meaning);
  }
  command->add_option("WHAT", arguments->what, "What to list")
      ->type_name("")
      ->required()
      ->check(CLI::IsMember(names).description(""));
  add_format_option(*command, arguments->format);
  help += "\nDefaults are those of the profile homogeneous_sand at the preset standard.";
  command->footer(help);
  command->callback([arguments, &action] { action = [arguments] { return list(*arguments); }; });
}

}  // namespace cpt::cli
