#include "diagnosis/calibration/assemble_calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "diagnosis/assemble.hpp"
#include "diagnosis/median.hpp"
#include "parameters/all_realizations.hpp"
#include "parameters/designs/design.hpp"
#include "parameters/designs/value_of_score.hpp"
#include "parameters/distributions/copula.hpp"
#include "results/tables/count_of.hpp"

namespace cpt::diagnosis {
namespace {

constexpr double kPa = 1.0e3;  // [Pa]
constexpr std::size_t least_cells = 10;

const parameters::Row& row_named(const parameters::Study& study, const std::string& name) {
  for (const parameters::Row& row : study.rows)
    if (row.quantity->name == name) return row;
  throw std::invalid_argument(fmt::format("the study has no row {}, which its emulator knows", name));
}

// Mean of each cell's values; NaN where one of them is not finite or there is none. [kPa]
VectorXd cell_means(const SoundingGrid& grid, const std::vector<double>& depth,
                    const std::vector<double>& values, bool logarithmic) {
  if (logarithmic) return log_cell_means(grid, depth, values).array() - std::log(kPa);
  VectorXd sum = VectorXd::Zero(grid.cells), samples = VectorXd::Zero(grid.cells);
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const double place = std::floor((depth[i] - grid.from) / grid.height + 1e-9);
    if (!(place >= 0.0 && place < grid.cells)) continue;
    sum(static_cast<Index>(place)) += values[i] / kPa;
    samples(static_cast<Index>(place)) += 1.0;
  }
  return sum.array() / samples.array();
}

// Each row takes values at the emulator's depths to their mean in a cell, linear between depths where the
// cell holds none. Empty where the cell lies beyond them.
Eigen::RowVectorXd cell_average(const VectorXd& depth, const Cell& cell) {
  Eigen::RowVectorXd weights = Eigen::RowVectorXd::Zero(depth.size());
  const double top = cell.depth - 0.5 * cell.height, bottom = cell.depth + 0.5 * cell.height;
  for (Index k = 0; k < depth.size(); ++k)
    if (depth(k) >= top - 1e-9 && depth(k) < bottom - 1e-9) weights(k) = 1.0;
  if (weights.sum() > 0.0) return weights / weights.sum();
  for (Index k = 0; k + 1 < depth.size(); ++k)
    if (depth(k) <= cell.depth && cell.depth <= depth(k + 1)) {
      const double share = (cell.depth - depth(k)) / (depth(k + 1) - depth(k));
      weights(k) = 1.0 - share;
      weights(k + 1) = share;
      return weights;
    }
  return {};
}

MatrixXd cell_averages(const VectorXd& depth, const std::vector<Cell>& cells) {
  MatrixXd averages(static_cast<Index>(cells.size()), depth.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
    averages.row(static_cast<Index>(i)) = cell_average(depth, cells[i]);
  return averages;
}

class CalibrationAssembler {
 public:
  CalibrationAssembler(const CalibrationRequest& request, const parameters::Study& study,
                       const results::Emulator& emulator,
                       const std::vector<recordings::Recording>* recordings, std::vector<std::string>& notes)
      : request_(request), emulator_(emulator), recordings_(recordings), notes_(notes) {
    made_ = prior_of(study, emulator);
    for (const SoundingRequest& sounding : request.soundings) {
      made_.soundings.push_back(sounding.name);
      grids_.push_back(grid_of(sounding, request.cell_height));
    }
  }

  CalibrationProblem make() {
    for (const solver::Channel* channel : request_.channels) add_channel(*channel);
    if (made_.channels.empty())
      throw std::invalid_argument(fmt::format("no channel is left to compare: {}", fmt::join(notes_, "; ")));
    return std::move(made_);
  }

 private:
  void add_channel(const solver::Channel& channel) {
    const std::string output_name = solver::in_unit(channel, "kPa");
    const results::EmulatedOutput* output = emulator_.output(output_name);
    if (output == nullptr || !output->is_curve()) {
      notes_.push_back(fmt::format("{} is left out: the emulator has no curve of it", channel.name));
      return;
    }
    if (const std::string why = refusal_of(*output); !why.empty()) {
      notes_.push_back(fmt::format("{} is left out: its emulator is refused: {}", channel.name, why));
      return;
    }
    CalibrationChannel made;
    made.name = channel.name;
    made.logarithmic = output->emulator.logarithmic();
    made.discrepancy = request_.discrepancy;
    made.length = request_.discrepancy_length;
    made.noise = request_.noise * channel.deviation_over_q_c;
    made.noise_is_known = request_.noise_is_known;
    std::vector<double> recorded;
    for (std::size_t s = 0; s < grids_.size(); ++s) add_cells(channel, *output, s, made, recorded);
    if (made.cells.empty()) return;
    const MatrixXd average = cell_averages(output->abscissa, made.cells);
    const results::PrincipalComponents& components = output->emulator.components();
    made.mean = average * components.mean;
    made.shapes = average * components.shapes;
    made.left_out = average * results::left_out_covariance(components) * average.transpose();
    made.recorded =
        recordings_ == nullptr
            ? made.mean
            : VectorXd(Eigen::Map<const VectorXd>(recorded.data(), static_cast<Index>(recorded.size())));
    const results::OutputEmulator& curve = output->emulator;
    made.scores = [&curve](const Eigen::RowVectorXd& place) {
      results::OutputEmulator::ScoresAtPoint at = curve.scores_at(place);
      return ScorePrediction{std::move(at.mean), std::move(at.variance)};
    };
    check_magnitude(made);
    made_.channels.push_back(std::move(made));
  }

  void add_cells(const solver::Channel& channel, const results::EmulatedOutput& output, std::size_t s,
                 CalibrationChannel& made, std::vector<double>& recorded) {
    const SoundingRequest& sounding = request_.soundings[s];
    VectorXd values = VectorXd::Zero(grids_[s].cells);
    if (recordings_ != nullptr) {
      const recordings::Recording& recording = (*recordings_)[s];
      double recordings::Reading::*quantity =
          channel.name == "q_c" ? &recordings::Reading::q_c : &recordings::Reading::f_s;
      values = cell_means(grids_[s], recordings::column(recording, &recordings::Reading::depth),
                          recordings::column(recording, quantity), made.logarithmic);
    }
    std::vector<Cell> cells = cells_of({grids_[s]});
    std::vector<std::size_t> kept;
    std::size_t beyond = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      cells[i].sounding = static_cast<int>(s);
      if (cell_average(output.abscissa, cells[i]).size() == 0)
        ++beyond;
      else if (std::isfinite(values(static_cast<Index>(i))))
        kept.push_back(i);
    }
    if (kept.size() < least_cells) {
      notes_.push_back(
          fmt::format("{} of {} is left out: {} of its {} cells have both a recorded and a simulated value, "
                      "{} are needed",
                      channel.name, sounding.name, kept.size(), cells.size(), least_cells));
      return;
    }
    if (kept.size() < cells.size())
      notes_.push_back(
          fmt::format("{} of {}: {} of {} cells are left out, {} beyond the emulator's depths, {} "
                      "without a recorded value",
                      channel.name, sounding.name, cells.size() - kept.size(), cells.size(), beyond,
                      cells.size() - kept.size() - beyond));
    for (const std::size_t i : kept) {
      made.cells.push_back(cells[i]);
      recorded.push_back(values(static_cast<Index>(i)));
    }
  }

  static void check_magnitude(const CalibrationChannel& channel) {
    std::vector<double> ratios;
    for (Index i = 0; i < channel.recorded.size(); ++i)
      ratios.push_back(channel.logarithmic ? std::exp(channel.recorded(i) - channel.mean(i))
                                           : channel.recorded(i) / channel.mean(i));
    const double apart = std::abs(median(ratios));
    constexpr double most = 100.0;
    if (apart > most || apart < 1.0 / most)
      throw std::invalid_argument(
          fmt::format("the recorded {0} is {1:.3g} times the simulated one: mind the unit "
                      "of {0}, or the study is of another soil",
                      channel.name, apart));
  }

  const CalibrationRequest& request_;
  const results::Emulator& emulator_;
  const std::vector<recordings::Recording>* recordings_;
  std::vector<std::string>& notes_;
  std::vector<SoundingGrid> grids_;
  CalibrationProblem made_;
};

}  // namespace

CalibrationProblem prior_of(const parameters::Study& study, const results::Emulator& emulator) {
  CalibrationProblem problem;
  const auto count = static_cast<Index>(emulator.inputs.size());
  std::vector<const parameters::Row*> rows;
  for (const results::EmulatorInput& input : emulator.inputs) {
    const parameters::Row& row = row_named(study, input.name);
    rows.push_back(&row);
    problem.inputs.push_back({input.name, input.unit, parameters::ValueOfScore(row),
                              [&input](double value) { return input.place(value); }, input.lower,
                              input.upper});
  }
  problem.correlation = MatrixXd::Identity(count, count);
  for (const parameters::RankCorrelation& pair : study.correlations) {
    const auto place = [&](std::size_t row) {
      return std::ranges::find(rows, &study.rows[row]) - rows.begin();
    };
    const Index a = place(pair.first), b = place(pair.second);
    if (a < count && b < count)
      problem.correlation(a, b) = problem.correlation(b, a) = parameters::score_correlation(pair.rho);
  }
  return problem;
}

CalibrationProblem assemble_calibration(const CalibrationRequest& request, const parameters::Study& study,
                                        const results::Emulator& emulator,
                                        const std::vector<recordings::Recording>& recordings,
                                        std::vector<std::string>& notes) {
  return CalibrationAssembler(request, study, emulator, &recordings, notes).make();
}

CalibrationProblem assemble_unrecorded(const CalibrationRequest& request, const parameters::Study& study,
                                       const results::Emulator& emulator, std::vector<std::string>& notes) {
  return CalibrationAssembler(request, study, emulator, nullptr, notes).make();
}

VectorXd curve_at_cells(const CalibrationChannel& channel, const VectorXd& depth_m, const VectorXd& curve) {
  const MatrixXd average = cell_averages(depth_m, channel.cells);
  return channel.logarithmic ? VectorXd(average * curve.array().log().matrix()) : VectorXd(average * curve);
}

results::TrainingRuns without_runs(const results::TrainingRuns& runs, const std::vector<Index>& held_out) {
  std::vector<Index> kept;
  for (Index i = 0; i < runs.places.rows(); ++i)
    if (!std::ranges::binary_search(held_out, i)) kept.push_back(i);
  results::TrainingRuns left = runs;
  left.runs.clear();
  for (const Index i : kept) left.runs.push_back(runs.runs[static_cast<std::size_t>(i)]);
  left.places = runs.places(kept, Eigen::all);
  left.outputs.clear();
  for (const results::TrainingOutput& output : runs.outputs)
    if (output.abscissa.size() > 0)
      left.outputs.push_back({output, output.abscissa, output.values(Eigen::all, kept)});
  return left;
}

std::vector<Index> held_out_runs(const parameters::Study& study, const results::TrainingRuns& runs,
                                 Index count, std::uint64_t seed) {
  const parameters::Design& design = study.design;
  if (!parameters::design_named(design.kind).samples)
    throw std::invalid_argument(
        fmt::format("--check needs runs that are drawn from the distributions, and the "
                    "study's design is {}; propagation, latin_hypercube and sobol draw",
                    design.kind));
  std::vector<int> drawn;
  for (const parameters::Realization& realization : parameters::all_realizations(study))
    if (realization.point >= static_cast<int>(design.first_point) &&
        realization.point < static_cast<int>(design.first_point + design.points))
      drawn.push_back(realization.id);
  std::vector<Index> candidates;
  for (std::size_t i = 0; i < runs.runs.size(); ++i)
    if (std::ranges::binary_search(drawn, runs.runs[i].id)) candidates.push_back(static_cast<Index>(i));
  const auto available = static_cast<Index>(candidates.size());
  const Index least = results::least_training_runs(runs.inputs.size());
  if (count > available || static_cast<Index>(runs.runs.size()) - count < least)
    throw std::invalid_argument(
        fmt::format("--check {}: the study has {} that its design drew and {} in all, and {} must be left "
                    "for the emulator; "
                    "ask for at most {}",
                    count, results::count_of(available, "completed run"), runs.runs.size(), least,
                    std::max<Index>(0, std::min(available, static_cast<Index>(runs.runs.size()) - least))));
  Random random(seed, 0);
  for (Index k = 0; k < count; ++k)
    std::swap(candidates[static_cast<std::size_t>(k)],
              candidates[static_cast<std::size_t>(k + random.below(available - k))]);
  candidates.resize(static_cast<std::size_t>(count));
  std::ranges::sort(candidates);
  return candidates;
}

}  // namespace cpt::diagnosis
