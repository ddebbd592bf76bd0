#include "diagnosis/assemble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <stdexcept>

#include "diagnosis/median.hpp"
#include "diagnosis/run_curves.hpp"
#include "diagnosis/several/quieted.hpp"
#include "parameters/designs/value_of_score.hpp"
#include "parameters/distributions/copula.hpp"

namespace cpt::diagnosis {
namespace {

using parameters::Side;

VectorXd recorded_cells(const recordings::Recording& recording, const SoundingGrid& grid,
                        const solver::Channel& channel) {
  double recordings::Reading::*reading =
      channel.name == "q_c" ? &recordings::Reading::q_c : &recordings::Reading::f_s;
  return channel_means(grid, recordings::column(recording, &recordings::Reading::depth),
                       recordings::column(recording, reading), channel);
}

// Recording against simulation.
void check_pair(const SoundingRequest& sounding, const solver::Channel& channel, const VectorXd& recorded,
                const VectorXd& simulated) {
  std::vector<double> ratios;
  for (Index i = 0; i < recorded.size(); ++i)
    if (std::isfinite(recorded(i)) && std::isfinite(simulated(i)))
      ratios.push_back(recorded(i) - simulated(i));
  if (ratios.size() < 10)
    throw std::invalid_argument(
        fmt::format("{}: {} of {} cells have both a recorded and a simulated {}, and 10 are needed",
                    sounding.name, ratios.size(), recorded.size(), channel.name));
  const double apart = median(ratios);
  if (std::abs(apart) > std::log(100.0))
    throw std::invalid_argument(fmt::format(
        "{}: the recorded {} is {:.3g} times the simulated one: mind its unit, or the study is of another "
        "profile",
        sounding.name, channel.name, std::exp(apart)));
}

class Assembler {
 public:
  Assembler(const Request& request, const std::vector<SoundingData>& soundings, const ChannelList& measured,
            bool quiet = false)
      : request_(request), soundings_(soundings), measured_(measured), quiet_(quiet) {}

  Assembled make() {
    lay_grids();
    take_recordings();
    if (request_.measurement > 0.0)
      made_.problem.measurement = NoiseModel{Kernel::ar1, request_.measurement, request_.correlation};
    take_runs();
    return std::move(made_);
  }

  Assembled make_unmeasured(const NoiseModel& measurement) {
    lay_grids();
    std::vector<VectorXd> baseline;
    for (const RunCurves& curves : curves_) baseline.push_back(simulated(curves));
    made_.problem.baseline = made_.problem.recorded = concatenate(baseline);
    made_.problem.measurement = measurement;
    take_runs();
    return std::move(made_);
  }

 private:
  void take_runs() {
    take_repeats();
    if (quiet_) {
      quieted_.emplace(made_.problem.cells, made_.problem.baseline, made_.problem.repeats);
      made_.problem.baseline = quieted_->baseline();
    }
    made_.problem.numerical_shares = (quieted_ ? quieted_->share() : 1.0) + (request_.simulated ? 1.0 : 0.0);
    take_parameters();
    take_joint();
    take_mechanisms();
  }

  void lay_grids() {
    for (const SoundingData& data : soundings_) {
      grids_.push_back(grid_of(data.request, request_.cell_height));
      curves_.emplace_back(data, grids_.back(), measured_);
    }
    made_.problem.cells = cells_of(grids_, static_cast<int>(measured_.size()));
  }

  [[nodiscard]] VectorXd simulated(const RunCurves& curves) const {
    const SoundingData& data = curves.sounding();
    const std::optional<VectorXd> baseline = curves.baseline();
    if (!baseline)
      throw std::invalid_argument(data.request.name + ": the baseline's run failed; see the failures of " +
                                  data.study.study.database.string());
    return *baseline;
  }

  void take_recordings() {
    std::vector<VectorXd> recorded, baseline;
    for (std::size_t s = 0; s < soundings_.size(); ++s) {
      const SoundingData& data = soundings_[s];
      const VectorXd here = simulated(curves_[s]);
      check_recording(data.request, data.recording, request_.cell_height);
      for (const solver::Channel* channel : measured_)
        recorded.push_back(recorded_cells(data.recording, grids_[s], *channel));
      const Index rows = grids_[s].cells, count = static_cast<Index>(measured_.size());
      for (Index c = 0; c < count; ++c)
        check_pair(data.request, *measured_[static_cast<std::size_t>(c)],
                   recorded[recorded.size() - static_cast<std::size_t>(count - c)],
                   here.segment(c * rows, rows));
      baseline.push_back(here);
    }
    made_.problem.recorded = concatenate(recorded);
    made_.problem.baseline = concatenate(baseline);
  }

  [[nodiscard]] VectorXd quiet(VectorXd run) const { return quieted_ ? (*quieted_)(run) : run; }

  // Rows that are uncertain in every sounding; what is known in one is taken as it is there.
  void take_parameters() {
    const std::vector<parameters::Row>& rows = soundings_.front().study.study.rows;
    for (const parameters::Row& row : rows) {
      ParameterEffect effect;
      effect.name = std::string(row.quantity->name);
      effect.baseline = (row.baseline - row.lower) / (row.upper - row.lower);
      effect.two_valued = !row.quantity->choices.empty();
      const auto side = [&](Side which) -> VectorXd {
        const auto run = joined_run(curves_, [&](const RunCurves& curves) -> std::optional<VectorXd> {
          const auto& own = curves.sounding().study.study.rows;
          for (std::size_t k = 0; k < own.size(); ++k)
            if (own[k].quantity == row.quantity) return curves.of_row(static_cast<int>(k), which);
          return curves.baseline();
        });
        return run ? quiet(*run) : VectorXd();
      };
      if (row.lower != row.baseline) effect.lower = side(Side::lower);
      if (row.upper != row.baseline) effect.upper = side(Side::upper);
      if (effect.lower.size() == 0 && effect.upper.size() == 0)
        made_.remarks.push_back(fmt::format("{} is left out: its runs failed", row.quantity->name));
      else
        made_.problem.parameters.push_back(distributed(std::move(effect), row));
    }
    correlate();
  }

  static ParameterEffect distributed(ParameterEffect effect, const parameters::Row& row) {
    if (row.marginal != nullptr && !effect.two_valued)
      effect.place_of_score = [value = parameters::ValueOfScore(row), lower = row.lower, upper = row.upper](
                                  double score) { return (value(score) - lower) / (upper - lower); };
    return effect;
  }

  void correlate() {
    const parameters::Study& study = soundings_.front().study.study;
    const std::vector<ParameterEffect>& effects = made_.problem.parameters;
    const auto count = static_cast<Index>(effects.size());
    MatrixXd& correlation = made_.problem.correlation;
    correlation = MatrixXd::Identity(count, count);
    for (const parameters::RankCorrelation& pair : study.correlations) {
      const auto place = [&](std::size_t row) {
        return std::ranges::find(effects, study.rows[row].quantity->name, &ParameterEffect::name) -
               effects.begin();
      };
      const Index a = place(pair.first), b = place(pair.second);
      if (a < count && b < count)
        correlation(a, b) = correlation(b, a) = parameters::score_correlation(pair.rho);
    }
  }

  MatrixXd points(std::size_t first, std::size_t count, std::vector<std::size_t>& kept) {
    std::vector<VectorXd> columns;
    for (std::size_t k = 0; k < count; ++k) {
      const auto run =
          joined_run(curves_, [&](const RunCurves& curves) { return curves.of_point(first + k); });
      if (!run) {
        made_.remarks.push_back(fmt::format("{} is left out: its run failed",
                                            soundings_.front().study.study.points[first + k].name));
        continue;
      }
      columns.push_back(quiet(*run));
      kept.push_back(k);
    }
    MatrixXd all(made_.problem.baseline.size(), static_cast<Index>(columns.size()));
    for (std::size_t k = 0; k < columns.size(); ++k) all.col(static_cast<Index>(k)) = columns[k];
    return all;
  }

  void take_repeats() {
    const Design& design = soundings_.front().study.design;
    std::vector<std::size_t> kept;
    made_.problem.repeats = points(design.first_repeat, design.repeats, kept);
  }

  void take_joint() {
    const SoundingStudy& first = soundings_.front().study;
    std::vector<std::size_t> kept;
    JointRuns& joint = made_.problem.joint;
    joint.curves = points(first.design.first_joint, first.design.joint, kept);
    joint.places.resize(joint.curves.cols(), static_cast<Index>(made_.problem.parameters.size()));
    for (std::size_t k = 0; k < kept.size(); ++k)
      joint.places.row(static_cast<Index>(k)) = place_of(first.design.first_joint + kept[k]).transpose();
    surface_.emplace(made_.problem.baseline, made_.problem.parameters, joint);
  }

  // Where a point has the soil's parameters, each between its bounds.
  VectorXd place_of(std::size_t point) const {
    const std::vector<ParameterEffect>& effects = made_.problem.parameters;
    VectorXd t(static_cast<Index>(effects.size()));
    for (std::size_t j = 0; j < effects.size(); ++j) t(static_cast<Index>(j)) = effects[j].baseline;
    for (const SoundingData& data : soundings_)
      for (const parameters::Change& change : data.study.study.points[point].changes)
        for (const parameters::Row& row : data.study.study.rows)
          for (Index j = 0; j < t.size(); ++j)
            if (row.quantity == change.quantity &&
                row.quantity->name == effects[static_cast<std::size_t>(j)].name)
              t(j) = (change.value - row.lower) / (row.upper - row.lower);
    return t;
  }

  // The same less the baseline's (runs x parameters).
  template <class Indices>
  MatrixXd soil_of(std::size_t first, const Indices& kept) const {
    MatrixXd soil(static_cast<Index>(kept.size()), surface_->parameters());
    for (std::size_t k = 0; k < kept.size(); ++k)
      soil.row(static_cast<Index>(k)) =
          (place_of(first + static_cast<std::size_t>(kept[k])) - surface_->baseline_place()).transpose();
    return soil;
  }

  void take_mechanisms() {
    for (const MechanismDesign& design : soundings_.front().study.design.mechanisms) {
      if (design.mechanism.of_reading) {
        take_mechanism_of_reading(design);
        continue;
      }
      std::vector<std::size_t> kept;
      const MatrixXd runs = points(design.first_point, static_cast<std::size_t>(design.unit.rows()), kept);
      const auto least = 4 * static_cast<std::ptrdiff_t>(design.varied.size());
      if (static_cast<std::ptrdiff_t>(kept.size()) < least) {
        made_.remarks.push_back(fmt::format("{} is left out: {} of its runs completed, {} are needed",
                                            design.mechanism.name, kept.size(), least));
        continue;
      }
      MechanismEffect effect = effect_of(design);
      effect.design.resize(runs.cols(), design.unit.cols());
      for (Index k = 0; k < runs.cols(); ++k)
        effect.design.row(k) = design.unit.row(static_cast<Index>(kept[static_cast<std::size_t>(k)]));
      effect.delta = runs.colwise() - made_.problem.baseline;
      effect.vanishes_at_zero = vanishes_at_zero(design);
      take_joint_of(design, effect);
      made_.problem.mechanisms.push_back(std::move(effect));
      made_.mechanisms.push_back(design);
    }
  }

  static MechanismEffect effect_of(const MechanismDesign& design) {
    MechanismEffect effect;
    effect.name = std::string(design.mechanism.name);
    for (const std::size_t varied : design.varied)
      effect.parameters.emplace_back(design.mechanism.parameters[varied].quantity.name);
    return effect;
  }

  // What another reading of a run differs from the run.
  VectorXd reading_effect(const MechanismDesign& design, const VectorXd& phi,
                          const std::function<int(const RunCurves&)>& id_in) const {
    const std::vector<parameters::Change> changes = mechanism_changes(design.mechanism, phi);
    const auto otherwise = joined_run(
        curves_, [&](const RunCurves& curves) { return curves.read_otherwise(id_in(curves), changes); });
    const auto plain = joined_run(curves_, [&](const RunCurves& curves) { return curves.of(id_in(curves)); });
    return otherwise && plain ? VectorXd(*otherwise - *plain) : VectorXd();
  }

  void take_mechanism_of_reading(const MechanismDesign& design) {
    MechanismEffect effect = effect_of(design);
    effect.vanishes_at_zero = vanishes_at_zero(design);  // not where read too high or too low
    effect.design = design.unit;
    effect.delta.resize(made_.problem.baseline.size(), design.unit.rows());
    for (Index k = 0; k < design.unit.rows(); ++k)
      effect.delta.col(k) = reading_effect(design, design.unit.row(k).transpose(),
                                           [](const RunCurves& curves) { return curves.baseline_id(); });
    std::vector<VectorXd> joint;
    std::vector<Index> kept;
    const std::size_t first = soundings_.front().study.design.first_joint;
    for (Index k = 0; k < design.joint_unit.rows(); ++k) {
      const VectorXd in_other_soil = reading_effect(
          design, design.joint_unit.row(k).transpose(),
          [&](const RunCurves& curves) { return curves.id_of_point(first + static_cast<std::size_t>(k)); });
      if (in_other_soil.size() == 0) continue;
      joint.push_back(in_other_soil);
      kept.push_back(k);
    }
    effect.joint_design = design.joint_unit(kept, Eigen::all);
    effect.joint_soil = soil_of(first, kept);
    effect.joint_delta.resize(made_.problem.baseline.size(), static_cast<Index>(joint.size()));
    for (std::size_t k = 0; k < joint.size(); ++k) effect.joint_delta.col(static_cast<Index>(k)) = joint[k];
    made_.problem.mechanisms.push_back(std::move(effect));
    made_.mechanisms.push_back(design);
  }

  void take_joint_of(const MechanismDesign& design, MechanismEffect& effect) {
    std::vector<std::size_t> kept;
    effect.joint_delta = points(design.first_joint, static_cast<std::size_t>(design.joint_unit.rows()), kept);
    effect.joint_design.resize(effect.joint_delta.cols(), design.unit.cols());
    effect.joint_soil = soil_of(design.first_joint, kept);
    for (Index k = 0; k < effect.joint_delta.cols(); ++k) {
      const std::size_t run = kept[static_cast<std::size_t>(k)];
      effect.joint_design.row(k) = design.joint_unit.row(static_cast<Index>(run));
      effect.joint_delta.col(k) -= surface_->predict(place_of(design.first_joint + run));
    }
  }

  // Off, whatever the other parameters, where the first varied one is at the bottom of its prior.
  static bool vanishes_at_zero(const MechanismDesign& design) {
    const auto& parameters = design.mechanism.parameters;
    solver::Setup off;
    for (std::size_t j = 0; j < parameters.size(); ++j)
      parameters[j].quantity.set_value(off, j == 0 ? parameters[j].prior_lower : parameters[j].prior_upper);
    if (design.varied.front() != 0 || parameters.front().prior_lower != 0.0) return false;
    // A second parameter that acts by itself (the gap of a wall, the wear of an apex) has a default of zero
    // too.
    const solver::Setup defaults;
    return std::none_of(
        parameters.begin() + 1, parameters.end(), [&](const solver::MechanismParameter& parameter) {
          return parameter.quantity.get(defaults) == 0.0 && parameter.quantity.get(off) != 0.0;
        });
  }

  const Request& request_;
  const std::vector<SoundingData>& soundings_;
  const ChannelList& measured_;
  std::vector<SoundingGrid> grids_;
  std::vector<RunCurves> curves_;
  bool quiet_;
  std::optional<Quieted> quieted_;          // where runs have less of their scatter
  std::optional<ResponseSurface> surface_;  // of the soil's parameters
  Assembled made_;
};

}  // namespace

SoundingGrid grid_of(const SoundingRequest& sounding, double cell_height) {
  return {sounding.from, cell_height,
          static_cast<int>(std::floor((sounding.to - sounding.from) / cell_height + 1e-9))};
}

void check_recording(const SoundingRequest& sounding, const recordings::Recording& recording,
                     double cell_height) {
  std::vector<double> values, depths;
  for (const recordings::Reading& reading : recording.readings) {
    if (!std::isfinite(reading.q_c)) continue;
    depths.push_back(reading.depth);
    if (reading.depth >= sounding.from && reading.depth <= sounding.to) values.push_back(reading.q_c);
  }
  if (depths.empty())
    throw std::invalid_argument(fmt::format("{}: the recording holds no q_c at all", sounding.name));
  const auto [first, last] = std::minmax_element(depths.begin(), depths.end());
  if (values.empty())
    throw std::invalid_argument(
        fmt::format("{}: no overlap in depth: the recording has q_c from {:.3f} to {:.3f} m, {:.3f} to "
                    "{:.3f} m are asked for; mind the "
                    "unit of the depth column and the datum",
                    sounding.name, *first, *last, sounding.from, sounding.to));
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  if (values.size() > 1 && *least == *most)
    throw std::invalid_argument(
        fmt::format("{}: q_c is {:g} Pa in all {} readings: a constant column cannot be diagnosed",
                    sounding.name, *least, values.size()));
  const VectorXd cells =
      recorded_cells(recording, grid_of(sounding, cell_height), solver::channels().front());
  const auto filled = std::count_if(cells.begin(), cells.end(), [](double y) { return std::isfinite(y); });
  if (filled < 10)
    throw std::invalid_argument(fmt::format(
        "{}: {} of {} cells of {:g} mm have a recorded q_c, and 10 are needed; there are {} "
        "values from {:.3f} to {:.3f} m",
        sounding.name, filled, cells.size(), cell_height * 1e3, values.size(), sounding.from, sounding.to));
}

Assembled assemble(const Request& request, const std::vector<SoundingData>& soundings) {
  const ChannelList tip = {&solver::channels().front()};
  return Assembler(request, soundings, tip).make();
}

Assembled assemble(const Request& request, const std::vector<SoundingData>& soundings,
                   const ChannelList& channels) {
  return Assembler(request, soundings, channels, true).make();
}

Assembled assemble_unmeasured(const Request& request, const std::vector<SoundingData>& soundings,
                              const solver::Channel& measured, const NoiseModel& measurement) {
  NoiseModel noise = measurement;
  noise.deviation *= measured.deviation_over_q_c;
  const ChannelList one = {&measured};
  return Assembler(request, soundings, one).make_unmeasured(noise);
}

}  // namespace cpt::diagnosis
