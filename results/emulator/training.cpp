#include "results/emulator/training.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "results/files/error.hpp"
#include "results/statistics/value_at_depth.hpp"
#include "results/tables/count_of.hpp"
#include "solver/channels.hpp"

namespace cpt::results {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using parameters::Row;
using parameters::Study;

using Values = std::map<std::string, double>;  // of a run, by the name of the quantity

std::map<int, Values> inputs_by_run(const Snapshot& campaign) {
  std::map<int, Values> by_run;
  for (const InputRow& row : campaign.inputs) by_run[row.realization][row.quantity] = row.value;
  return by_run;
}

std::vector<const Row*> rows_that_vary(const Study& study) {
  std::vector<const Row*> rows;
  if (!study.design.rows.empty() && study.design.kind != "one_at_a_time") {
    for (const std::size_t row : study.design.rows)
      if (!study.rows[row].only_drawn()) rows.push_back(&study.rows[row]);
    return rows;
  }
  std::set<std::string> changed;
  for (const parameters::DesignPoint& point : study.points)
    for (const parameters::Change& change : point.changes)
      if (!point.repeat) changed.insert(change.quantity->name);
  for (const Row& row : study.rows)
    if (changed.contains(row.quantity->name)) rows.push_back(&row);
  return rows;
}

EmulatorInput input_of(const Row& row) {
  EmulatorInput input;
  input.name = row.quantity->name;
  input.unit = row.quantity->unit;
  input.lower = std::min(row.lower, row.upper);
  input.upper = std::max(row.lower, row.upper);
  input.baseline = row.baseline;
  input.integer = row.quantity->integer;
  if (!row.quantity->choices.empty())
    input.choices = {row.quantity->format(input.lower), row.quantity->format(input.upper)};
  if (row.marginal == nullptr) return input;
  input.lower = std::min(input.lower, row.marginal->quantile(0.0005));
  input.upper = std::max(input.upper, row.marginal->quantile(0.9995));
  return input;
}

// A median nearer to the middle in ln(value) than in value tells a skewed distribution.
void choose_scale(EmulatorInput& input, const Row& row) {
  if (row.marginal == nullptr || !(input.lower > 0.0)) return;
  const double median = row.marginal->quantile(0.5);
  const double linear = std::abs(input.place(median) - 0.5);
  input.logarithmic = true;
  if (!(std::abs(input.place(median) - 0.5) < linear)) input.logarithmic = false;
}

std::string windows_text(const Snapshot& campaign) {
  std::string text;
  for (const WindowRow& window : campaign.windows)
    text += fmt::format("{} {} {} to {} m\n", window.name, window.kind, window.from_m, window.to_m);
  return text;
}

class Trainer {
 public:
  Trainer(const Study& study, const Snapshot& campaign)
      : campaign_(campaign), rows_(rows_that_vary(study)), by_run_(inputs_by_run(campaign)) {
    for (const Row& row : study.rows)
      if (row.only_drawn()) drawn_.insert(row.quantity->name);
    made_.study = campaign.campaign.name;
    made_.solver_version = campaign.campaign.solver_version;
    made_.windows = windows_text(campaign);
  }

  TrainingRuns make() {
    if (rows_.empty())
      throw Error(
          fmt::format("{}: an emulator needs runs that vary inputs together; give the study a "
                      "[design], as kind = \"latin_hypercube\", or [[points]]",
                      campaign_.campaign.name));
    for (const Row* row : rows_) made_.inputs.push_back(input_of(*row));
    choose_runs();
    for (std::size_t j = 0; j < rows_.size(); ++j) choose_scale(made_.inputs[j], *rows_[j]);
    place_runs();
    add_averages();
    add_curves();
    if (made_.outputs.empty())
      throw Error(fmt::format("{}: its runs have no average and no curve in common", made_.study));
    return std::move(made_);
  }

 private:
  // Whether all that is no input is as in the baseline, but for random fields and shifted
  // points, which are noise to an emulator.
  [[nodiscard]] bool others_are_at_baseline(const Values& values) const {
    const Values& baseline = by_run_.at(1);
    return std::ranges::all_of(values, [&](const auto& entry) {
      return std::ranges::find(made_.inputs, entry.first, &EmulatorInput::name) != made_.inputs.end() ||
             drawn_.contains(entry.first) || !baseline.contains(entry.first) ||
             baseline.at(entry.first) == entry.second;
    });
  }

  // Of a row with a distribution the range grows with the runs, which were drawn from it.
  [[nodiscard]] bool within_range(const Values& values) {
    for (std::size_t j = 0; j < rows_.size(); ++j) {
      EmulatorInput& input = made_.inputs[j];
      const double value = values.at(input.name);
      if (rows_[j]->marginal != nullptr) {
        input.lower = std::min(input.lower, value);
        input.upper = std::max(input.upper, value);
      } else if (value < input.lower || value > input.upper) {
        return false;
      }
    }
    return true;
  }

  void choose_runs() {
    int others = 0, outside = 0, missing = 0;
    for (const RealizationRow& run : campaign_.realizations) {
      if (run.side == "repeat") continue;
      if (!others_are_at_baseline(by_run_[run.id])) {
        ++others;
      } else if (!run.completed()) {
        ++missing;
      } else if (!within_range(by_run_[run.id])) {
        ++outside;
      } else {
        made_.runs.push_back({run.id, run.settings_hash});
      }
    }
    const auto note = [&](int count, const char* why) {
      if (count > 0) made_.notes.push_back(fmt::format("{} left out: {}", count_of(count, "run"), why));
    };
    note(missing, "failed, or not finished");
    note(others, "what is no input of the emulator is not at its baseline");
    note(outside, "outside the bounds of the inputs");
    const Index least = least_training_runs(made_.inputs.size());
    if (static_cast<Index>(made_.runs.size()) < least)
      throw Error(fmt::format(
          "{}: an emulator of {} needs {} completed runs that vary inputs together, the ledger has {}; "
          "run the campaign, or ask for more in [design]",
          made_.study, count_of(made_.inputs.size(), "input"), least, made_.runs.size()));
  }

  void place_runs() {
    made_.places.resize(static_cast<Index>(made_.runs.size()), static_cast<Index>(made_.inputs.size()));
    for (Index i = 0; i < made_.places.rows(); ++i)
      for (Index j = 0; j < made_.places.cols(); ++j) {
        const EmulatorInput& input = made_.inputs[static_cast<std::size_t>(j)];
        made_.places(i, j) = input.place(by_run_[made_.runs[static_cast<std::size_t>(i)].id].at(input.name));
      }
  }

  [[nodiscard]] std::map<int, Index> columns() const {
    std::map<int, Index> by_id;
    for (std::size_t i = 0; i < made_.runs.size(); ++i) by_id[made_.runs[i].id] = static_cast<Index>(i);
    return by_id;
  }

  void add(TrainingOutput output) {
    if (output.values.allFinite() && output.values.rows() > 0)
      made_.outputs.push_back(std::move(output));
    else
      made_.notes.push_back(fmt::format("{} left out: not every run has it", output.name));
  }

  // The results of an external program's windows.
  void add_result(const WindowRow& window) {
    const std::map<int, Index> column = columns();
    const std::string name =
        window.is_scalar() ? window.name : fmt::format("{}.{}_mean", window.name, window.output);
    TrainingOutput output{{name, window.output_unit, "", ""},
                          {},
                          MatrixXd::Constant(1, static_cast<Index>(made_.runs.size()), std::nan(""))};
    for (const WindowMeanRow& mean : campaign_.window_means)
      if (mean.window == window.name && column.contains(mean.realization))
        output.values(column.at(mean.realization)) = mean.q_c_mean_kPa;
    add(std::move(output));
  }

  void add_averages() {
    const std::map<int, Index> column = columns();
    for (const WindowRow& window : campaign_.windows) {
      if (!window.problem.empty()) {
        made_.notes.push_back(fmt::format("window {} left out: {}", window.name, window.problem));
        continue;
      }
      if (campaign_.is_external()) {
        add_result(window);
        continue;
      }
      for (std::size_t c = 0; c < solver::channels().size(); ++c) {
        const solver::Channel& channel = solver::channels()[c];
        if (!std::isfinite(channel.deviation_over_q_c)) continue;  // no sounding measures it
        TrainingOutput output{{fmt::format("{}.{}_mean_kPa", window.name, channel.name)},
                              {},
                              MatrixXd::Constant(1, static_cast<Index>(made_.runs.size()), std::nan(""))};
        for (const WindowMeanRow& mean : campaign_.window_means)
          if (mean.window == window.name && column.contains(mean.realization))
            output.values(column.at(mean.realization)) =
                c == 0 ? mean.q_c_mean_kPa : mean.other_means_kPa[c - 1];
        add(std::move(output));
      }
    }
  }

  // A curve of each run and of the baseline: its abscissa and its values.
  using Curve = std::pair<const std::vector<double>*, const std::vector<double>*>;

  // At the baseline's abscissa as far as every run's goes, `scale` in the output's unit.
  void add_curve(OutputLabel label, const Curve& baseline, const std::vector<Curve>& curves, double scale) {
    double from = baseline.first->front(), to = baseline.first->back();
    for (const Curve& curve : curves) {
      from = std::max(from, curve.first->front());
      to = std::min(to, curve.first->back());
    }
    std::vector<double> at;
    for (const double x : *baseline.first)
      if (x >= from && x <= to) at.push_back(x);
    TrainingOutput output{
        std::move(label), Eigen::Map<const VectorXd>(at.data(), static_cast<Index>(at.size())),
        MatrixXd::Constant(static_cast<Index>(at.size()), static_cast<Index>(curves.size()), std::nan(""))};
    for (std::size_t i = 0; i < curves.size(); ++i) {
      const auto& [abscissa, values] = curves[i];
      for (std::size_t k = 0; k < at.size() && !values->empty(); ++k)
        output.values(static_cast<Index>(k), static_cast<Index>(i)) =
            value_at_depth(*abscissa, *values, at[k]) / scale;
    }
    add(std::move(output));
  }

  void add_curves() {
    const std::map<int, Index> column = columns();
    std::vector<const solver::DepthProfile*> profiles(made_.runs.size(), nullptr);
    const solver::DepthProfile* baseline = nullptr;
    for (const CurveRow& row : campaign_.curves) {
      if (row.realization == 1) baseline = &row.profile;
      if (column.contains(row.realization))
        profiles[static_cast<std::size_t>(column.at(row.realization))] = &row.profile;
    }
    const bool all = std::ranges::none_of(
        profiles, [](const auto* profile) { return profile == nullptr || profile->is_empty(); });
    if (baseline == nullptr || baseline->is_empty() || !all) {
      made_.notes.emplace_back("curves left out: not every run has one");
      return;
    }
    const auto add_each = [&](OutputLabel label, double scale, auto curve_of) {
      std::vector<Curve> curves;
      for (const solver::DepthProfile* profile : profiles) curves.push_back(curve_of(*profile));
      add_curve(std::move(label), curve_of(*baseline), curves, scale);
    };
    constexpr double kPa = 1.0e3;  // [Pa]
    if (!campaign_.is_external())
      for (const solver::Channel& channel : solver::channels())
        if (std::isfinite(channel.deviation_over_q_c))
          add_each({solver::in_unit(channel, "kPa")}, kPa, [&](const solver::DepthProfile& of) {
            return Curve{&of.depth, &(of.*channel.values)};
          });
    for (std::size_t k = 0; k < campaign_.outputs.size(); ++k)
      if (const OutputRow& output = campaign_.outputs[k]; !output.over.empty())
        add_each({output.name, output.unit, output.over, output.over_unit}, 1.0,
                 [k](const solver::DepthProfile& of) {
                   return Curve{&of.declared[k].x, &of.declared[k].y};
                 });
  }

  std::set<std::string> drawn_;  // seeds and shifts that runs draw
  const Snapshot& campaign_;
  std::vector<const Row*> rows_;
  std::map<int, Values> by_run_;
  TrainingRuns made_;
};

bool varies(const MatrixXd& values) {
  return ((values.rowwise().maxCoeff() - values.rowwise().minCoeff()).array() > 0.0).any();
}

}  // namespace

Index least_training_runs(std::size_t inputs) { return 3 * static_cast<Index>(inputs) + 10; }

TrainingRuns training_runs(const Study& study, const Snapshot& campaign) {
  return Trainer(study, campaign).make();
}

Emulator make_emulator(const TrainingRuns& runs, std::vector<std::string>& notes) {
  Emulator made{runs.study, runs.solver_version, runs.inputs, runs.runs, {}, runs.windows};
  for (const TrainingOutput& output : runs.outputs) {
    if (!varies(output.values)) {
      notes.push_back(fmt::format("{} left out: it does not vary", output.name));
      continue;
    }
    try {
      OutputEmulator emulator = OutputEmulator::fit(runs.places, output.values);
      const Validation validation = cross_validation(runs.places, output.values, emulator.logarithmic());
      made.outputs.push_back({output, output.abscissa, std::move(emulator), validation});
    } catch (const std::invalid_argument& problem) {
      notes.push_back(fmt::format("{} left out: {}", output.name, problem.what()));
    }
  }
  return made;
}

std::vector<std::string> stale(const Emulator& emulator, const TrainingRuns& now) {
  std::vector<std::string> differences;
  if (emulator.solver_version != now.solver_version)
    differences.push_back(fmt::format("its runs are of solver version {}, the ledger's of {}",
                                      emulator.solver_version, now.solver_version));
  if (emulator.inputs != now.inputs) {
    std::string which;
    for (const EmulatorInput& input : now.inputs)
      if (const EmulatorInput* before = emulator.input(input.name); before == nullptr || *before != input)
        which += (which.empty() ? "" : ", ") + input.name;
    for (const EmulatorInput& input : emulator.inputs)
      if (std::ranges::find(now.inputs, input.name, &EmulatorInput::name) == now.inputs.end())
        which += (which.empty() ? "" : ", ") + input.name;
    differences.push_back(
        fmt::format("inputs or their ranges are others{}{}", which.empty() ? "" : ": ", which));
  }
  if (emulator.windows != now.windows) differences.emplace_back("the windows are others");
  std::set<std::string> before, after;
  for (const TrainedRun& run : emulator.runs) before.insert(run.settings_hash);
  for (const TrainedRun& run : now.runs) after.insert(run.settings_hash);
  const auto gone = std::ranges::count_if(before, [&](const auto& hash) { return !after.contains(hash); });
  const auto fresh = std::ranges::count_if(after, [&](const auto& hash) { return !before.contains(hash); });
  if (gone > 0) differences.push_back(fmt::format("{} of its {} runs are gone", gone, before.size()));
  if (fresh > 0)
    differences.push_back(fmt::format("{} more run{} there", fresh, fresh == 1 ? " is" : "s are"));
  return differences;
}

}  // namespace cpt::results
