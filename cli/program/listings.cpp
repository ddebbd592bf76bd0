#include "cli/program/listings.hpp"

#include <fmt/format.h>

#include "cli/exit_codes.hpp"
#include "diagnosis/calibration/calibration_keys.hpp"
#include "diagnosis/request_keys.hpp"
#include "parameters/distributions/read_distribution.hpp"
#include "parameters/study_keys.hpp"
#include "results/tables/query.hpp"
#include "solver/channels.hpp"
#include "solver/mechanisms/catalogue.hpp"
#include "solver/presets.hpp"
#include "solver/quantities.hpp"
#include "solver/simulate.hpp"
#include "solver/soils/law.hpp"

namespace cpt::cli {
namespace {

using results::Table;

std::string range(const solver::Quantity& quantity) {
  if (quantity.choices.empty()) return fmt::format("{} to {}", quantity.min, quantity.max);
  return fmt::format("{}", fmt::join(quantity.choices, ", "));
}

Table quantities(bool all) {
  const solver::Setup setup = solver::make_setup(solver::Profile::homogeneous_sand, solver::Preset::standard);
  Table table{{"name", "unit", "range", "default", "meaning"}, {}};
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

std::string range(const solver::LawQuantity& quantity) {
  if (quantity.choices.empty()) return fmt::format("{} to {}", quantity.min, quantity.max);
  return fmt::format("{}", fmt::join(quantity.choices, ", "));
}

// Of each law what it says of itself, then its parameters, whose full name is that of a soil, a dot and the
// name here.
Table laws(bool all) {
  Table table{{"law", "parameter", "unit", "range", "default", "meaning"}, {}};
  if (all) table.columns.emplace_back("source");
  for (const solver::Law* law : solver::all_laws()) {
    auto& head = table.rows.emplace_back();
    for (const std::string_view text :
         {law->name(), std::string_view(), std::string_view(), std::string_view(), std::string_view()})
      head.emplace_back(std::string(text));
    head.emplace_back(fmt::format("{}: {}. {}", law->title(), law->models(), law->departs()));
    if (all) head.emplace_back(std::string(law->source()));
    solver::Setup setup;
    setup.soils = {{"soil", law->defaults()}};
    for (const solver::LawQuantity& parameter : law->quantities()) {
      const solver::Quantity& quantity =
          *solver::find_quantity(fmt::format("soil.{}", parameter.name), setup);
      auto& row = table.rows.emplace_back();
      for (const std::string& text :
           {std::string(law->name()), std::string(parameter.name), std::string(parameter.unit),
            range(parameter), quantity.format(quantity.value(setup)), std::string(parameter.meaning)})
        row.emplace_back(text);
      if (all) row.emplace_back(std::string(parameter.source));
    }
  }
  return table;
}

Table mechanisms(bool all) {
  Table table{{"mechanism", "what it is", "quantity", "unit", "prior range", "signature in q_c"}, {}};
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

Table profiles(bool) {
  Table table{{"profile", "layers"}, {}};
  for (const solver::Profile profile : solver::all_profiles()) {
    std::string layers;
    const solver::Setup setup = solver::make_setup(profile, solver::Preset::standard);
    for (const solver::Layer& layer : setup.layers)
      layers += fmt::format("{}{} {} to {} m", layers.empty() ? "" : ", ", setup.soils[layer.soil].name,
                            layer.top, layer.bottom);
    table.rows.push_back({std::string(to_string(profile)), layers});
  }
  return table;
}

Table presets(bool) {
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

Table queries(bool) {
  Table table{{"query", "meaning"}, {}};
  for (const results::NamedQuery& query : results::named_queries())
    table.rows.push_back({std::string(query.name), std::string(query.meaning)});
  return table;
}

Table outcomes(bool) {
  using solver::Status;
  Table table{{"outcome", "meaning"}, {}};
  const std::pair<Status, const char*> meanings[] = {
      {Status::completed,
       "pushed to the final depth within the solver's limits; what its audit has out of line is told"},
      {Status::did_not_converge,
       "the stress integration or the motion broke down, mass changed, or 2 % of the cells lost their "
       "points"},
      {Status::energy_drift,
       "kinetic energy above half of the penetrometer's work, after 20 mm (of a cone of 25.3 mm): no slow "
       "push; energy_error ends "
       "none"},
      {Status::time_limit, "wall-clock limit, or no step for too long"},
      {Status::invalid_parameters, "the inputs describe no possible model"},
      {Status::crashed, "its process died; the reason says how"},
      {Status::rank_lost, "the MPI ranks that ran it were lost"}};
  for (const auto& [status, meaning] : meanings)
    table.rows.push_back({std::string(to_string(status)), std::string(meaning)});
  return table;
}

// "[limits]", "[[windows]]", "" at the top of the file.
std::string heading(const parameters::KeyTable& table) {
  if (table.name.empty()) return "";
  return table.list ? fmt::format("[[{}]]", table.name) : fmt::format("[{}]", table.name);
}

std::string kind_name(const parameters::KeyTable& kind) { return std::string(kind.name); }

Table keys(std::span<const parameters::KeyTable> tables, const char* what = "section",
           std::string (*name)(const parameters::KeyTable&) = heading) {
  Table rows{{what, "key", "values", "without it", "meaning"}, {}};
  for (const parameters::KeyTable& table : tables) {
    if (!table.name.empty())
      rows.rows.push_back(
          {name(table), std::string(), std::string(), std::string(), std::string(table.meaning)});
    for (const parameters::Key& key : table.keys)
      rows.rows.push_back({name(table), std::string(key.name), values_of(key), std::string(key.usually),
                           std::string(key.meaning)});
  }
  return rows;
}

Table study_keys(bool) { return keys(parameters::study_keys()); }
Table distributions(bool) { return keys(parameters::distribution_kinds(), "kind", kind_name); }
Table request_keys(bool) { return keys(diagnosis::request_keys()); }
Table calibration_keys(bool) { return keys(diagnosis::calibration_keys()); }

Table exit_codes(bool) {
  Table table{{"exit code", "meaning"}, {}};
  for (const ExitMeaning& exit : exit_meanings())
    table.rows.push_back({to_string(exit.code), std::string(exit.meaning)});
  return table;
}

Table commands(bool) {
  return {
      {"command line", "does"},
      {{"campaign STUDY",
        "runs the study or goes on with it, on all cores; the report is there after the first results"},
       {"mpirun -np 2 campaign STUDY",
        "the same with MPI ranks; over several machines with mpirun's `--host`"},
       {"campaign STUDY --plan", "shows the realizations"},
       {"campaign STUDY --validate", "builds every model once and quits"},
       {"campaign STUDY --retry-failed", "runs failed realizations again"},
       {"campaign STUDY --checkpoint 60",
        "keeps the state of running realizations every 60 s in place of every 5 min; 0: never"},
       {"campaign rerun STUDY ID",
        "runs one realization again and compares its curve bit for bit with the stored one"},
       {"campaign query STUDY sensitivity",
        "also `effects`, `convergence`, `realizations`, `windows`, `tornado`, `failures`, `sql`; as table, "
        "CSV or JSON"},
       {"campaign compare A B",
        "two campaigns side by side: averages, `sensitivity`, or the `settings` that differ"},
       {"campaign combine DEAR CHEAP",
        "what q_c of a dear preset is worth, from few of its runs and many of a cheap one (designs.md)"},
       {"campaign emulate STUDY", "emulator of averages and curves, with its quality at held-out runs"},
       {"campaign predict STUDY --set NAME=VALUE", "what a run would give that was not made"},
       {"campaign prune STUDY",
        "names finished results that the study no longer asks for, and removes them with --yes"},
       {"campaign export STUDY",
        "all results as CSV tables that pandas and R read, as JSON or for Dakota (schema.md)"},
       {"campaign import SOURCE --to NEW",
        "makes a database of an export or of another program's table, or a study that runs the table's "
        "inputs"},
       {"campaign report STUDY",
        "writes page, figures and tables; with `--watch` again whenever the campaign has got further"},
       {"campaign push STUDY ID",
        "runs one realization and writes stress, void ratio and displacement for ParaView, and histories "
        "(output.md)"},
       {"campaign view PUSH", "draws the fields that `push` stored: a PNG for each depth and an animation"},
       {"campaign paper FOLDER", "holds the paper's studies in FOLDER against the paper (paper.md)"},
       {"campaign numerics STUDY",
        "what mesh, material points, time step, mass scaling and speed do to q_c (numerical-uncertainty.md)"},
       {"campaign element triaxial",
        "also `oedometer`, `isotropic`: single elements through the same constitutive code"},
       {"campaign element calibrate TEST.csv",
        "finds H from drained triaxial tests by matching their initial stiffness; with `--fit all` every "
        "NorSand "
        "parameter that triaxial and oedometer tests tell, with intervals (laws.md)"},
       {"campaign recording FILE",
        "what a measured sounding holds, what is odd about it, and its plot (recordings.md)"},
       {"campaign diagnose REQUEST",
        "where recordings and simulation part, and which left-out physics closes the gap "
        "(diagnosis-method.md)"},
       {"campaign calibrate REQUEST",
        "posterior of a study's parameters from recordings, by its emulator (calibration.md)"},
       {"campaign conceal PLAN", "draws sealed cases for the diagnosis"},
       {"campaign reveal PLAN", "opens them once they are diagnosed, and scores the answers"},
       {"campaign list quantities",
        "also `study-keys`, `mechanisms`, `presets`, ...: all that there is to choose from"},
       {"campaign reference", "prints this page"},
       {"campaign completion bash", "prints the script that completes the command line"}}};
}

Table environment(bool) {
  return {{"variable", "meaning"},
          {{"PATH", "where the program of an external solver is looked for (external-solvers.md)"},
           {"OMP_NUM_THREADS", "handed to an external solver; the realization's threads where it is not set"},
           {"CPT_RECORDINGS", "folder of recordings that do not lie beside their request"},
           {"CPT_INSTRUCTION_SET",
            "avx2 or baseline: the widest vector instructions to use, where the processor has wider ones"},
           {"OMPI_ALLOW_RUN_AS_ROOT",
            "1, with OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1, lets Open MPI's mpirun run as root"},
           {"PMIX_MCA_gds",
            "hash, for Open MPI 4's mpirun: it then ends also where a rank is killed while it starts, which "
            "can else leave it waiting for ever"}}};
}

Table channels(bool) {
  Table table{{"channel", "symbol", "what", "meaning"}, {}};
  for (const solver::Channel& channel : solver::channels()) {
    auto& row = table.rows.emplace_back();
    for (const std::string_view text : {channel.name, channel.symbol, channel.title, channel.meaning})
      row.emplace_back(std::string(text));
  }
  return table;
}

Table files(bool) {
  return {
      {"file", "meaning"},
      {{"NAME.toml", "a study, a request for a diagnosis or a calibration, or a plan of concealed cases"},
       {"NAME.sqlite", "the campaign's ledger: realizations, settings, curves, window means (schema.md)"},
       {"NAME.h5", "its curves as HDF5"},
       {"NAME-report/", "its report, index.html first"},
       {"NAME.checkpoints/", "states of realizations that are not finished"},
       {"NAME.work/",
        "work folders of an external solver, those of failed realizations (external-solvers.md)"},
       {"NAME-diagnosis.sqlite", "runs that diagnoses of the study NAME made"},
       {"NAME-calibration/", "posterior, draws, bands and figures of `campaign calibrate` (calibration.md)"},
       {"NAME-push/", "fields and histories of `campaign push` (output.md)"},
       {"NAME-cases/, NAME-sealed/", "what `campaign conceal` drew: recordings and requests; the truth"}}};
}

constexpr Listing all_listings[] = {
    {"commands", "What to type",
     "the usual command lines; a database may stand where a study does, but to run it", commands},
    {"study-keys", "Keys of a study", "the keys of a study file", study_keys},
    {"distributions", "Distributions",
     "how a row of [parameters] may be distributed, with the keys of each kind (designs.md)", distributions},
    {"quantities", "Quantities",
     "everything a study can set or vary; defaults of homogeneous_sand at standard", quantities},
    {"laws", "Constitutive laws", "what a soil of [soils] may be, and the parameters it then has", laws},
    {"channels", "Channels", "what a push records over depth", channels},
    {"profiles", "Profiles", "soil profiles a study can start from", profiles},
    {"presets", "Presets", "resolutions of the model", presets},
    {"request-keys", "Keys of a request", "the keys of a request for a diagnosis", request_keys},
    {"calibration-keys", "Keys of a calibration", "the keys of a request for a calibration",
     calibration_keys},
    {"mechanisms", "Mechanisms", "physical effects that can be switched on and that a diagnosis looks for",
     mechanisms},
    {"queries", "Queries", "what campaign query answers", queries},
    {"outcomes", "Outcomes", "how a realization can end", outcomes},
    {"exit-codes", "Exit codes", "what the program returns", exit_codes},
    {"environment", "Environment", "variables of the environment that the program reads", environment},
    {"files", "Files", "what the program reads and writes", files},
};

}  // namespace

std::span<const Listing> listings() { return all_listings; }

}  // namespace cpt::cli
