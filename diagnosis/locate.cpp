#include "diagnosis/locate.hpp"

#include <algorithm>
#include <cmath>

namespace cpt::diagnosis {
namespace {

std::vector<RowRange> soundings_of(const std::vector<Cell>& cells) {
  std::vector<RowRange> ranges;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto row = static_cast<Index>(i);
    if (i == 0 || cells[i].sounding != cells[i - 1].sounding) ranges.push_back({row, row});
    ranges.back().end = row + 1;
  }
  return ranges;
}

// Rows of a sounding with centres in [from, to].
RowRange rows_between(const std::vector<Cell>& cells, RowRange sounding, double from, double to) {
  RowRange found{sounding.end, sounding.end};
  for (Index i = sounding.first; i < sounding.end; ++i) {
    const double depth = cells[static_cast<std::size_t>(i)].depth;
    if (depth < from || depth > to) continue;
    found.first = std::min(found.first, i);
    found.end = i + 1;
  }
  return found.first < sounding.end ? found : RowRange{sounding.first, sounding.first};
}

// sums(i, j) = sum of the entries above row i and left of column j.
MatrixXd cumulative(const MatrixXd& matrix) {
  MatrixXd sums = MatrixXd::Zero(matrix.rows() + 1, matrix.cols() + 1);
  for (Index j = 0; j < matrix.cols(); ++j)
    for (Index i = 0; i < matrix.rows(); ++i)
      sums(i + 1, j + 1) = matrix(i, j) + sums(i, j + 1) + sums(i + 1, j) - sums(i, j);
  return sums;
}

VectorXd cumulative_vector(const VectorXd& v) {
  VectorXd sums = VectorXd::Zero(v.size() + 1);
  for (Index i = 0; i < v.size(); ++i) sums(i + 1) = sums(i) + v(i);
  return sums;
}

bool ranges_overlap(RowRange a, RowRange b) { return a.first < b.end && b.first < a.end; }

}  // namespace

StepScan::StepScan(const std::vector<Cell>& cells, const Whitener& covariance, int least_cells) {
  const MatrixXd sums =
      cumulative(covariance.solve(MatrixXd::Identity(covariance.size(), covariance.size())));
  const std::vector<RowRange> soundings = soundings_of(cells);
  first_.push_back(0);
  for (const RowRange& s : soundings)
    for (Index a = s.first; a < s.end; ++a)
      for (Index b = a + least_cells; b <= s.end; ++b) add({{a, b}}, sums);
  if (soundings.size() < 2) return;
  const RowRange lead = soundings.front();
  for (Index a = lead.first; a < lead.end; ++a)
    for (Index b = a + least_cells; b <= lead.end; ++b) {
      const Cell &top = cells[static_cast<std::size_t>(a)], &bottom = cells[static_cast<std::size_t>(b - 1)];
      std::vector<RowRange> joint;
      for (const RowRange& s : soundings) {
        const RowRange rows =
            rows_between(cells, s, top.depth - 0.5 * top.height, bottom.depth + 0.5 * bottom.height);
        if (rows.end - rows.first >= least_cells) joint.push_back(rows);
      }
      if (joint.size() == soundings.size()) add(joint, sums);
    }
}

void StepScan::add(const std::vector<RowRange>& ranges, const MatrixXd& sums) {
  double information = 0.0;
  for (const RowRange& r : ranges)
    for (const RowRange& c : ranges)
      information +=
          sums(r.end, c.end) - sums(r.first, c.end) - sums(r.end, c.first) + sums(r.first, c.first);
  if (!(information > 0.0)) return;
  ranges_.insert(ranges_.end(), ranges.begin(), ranges.end());
  first_.push_back(ranges_.size());
  information_.push_back(information);
}

Step StepScan::best(const VectorXd& weighted, const std::vector<RowRange>& taken) const {
  const VectorXd sums = cumulative_vector(weighted);
  Step best;
  for (std::size_t i = 0; i < information_.size(); ++i) {
    double score = 0.0;
    bool free = true;
    for (std::size_t r = first_[i]; r < first_[i + 1]; ++r) {
      score += sums(ranges_[r].end) - sums(ranges_[r].first);
      for (const RowRange& t : taken) free = free && !ranges_overlap(t, ranges_[r]);
    }
    const double statistic = score * score / information_[i];
    if (!free || statistic <= best.statistic) continue;
    best.statistic = statistic;
    best.size = score / information_[i];
    best.rows.assign(ranges_.begin() + static_cast<std::ptrdiff_t>(first_[i]),
                     ranges_.begin() + static_cast<std::ptrdiff_t>(first_[i + 1]));
  }
  return best;
}

VectorXd StepScan::greatest(const MatrixXd& weighted) const {
  VectorXd result = VectorXd::Zero(weighted.cols());
  for (Index k = 0; k < weighted.cols(); ++k) {
    const VectorXd sums = cumulative_vector(weighted.col(k));
    for (std::size_t i = 0; i < information_.size(); ++i) {
      double score = 0.0;
      for (std::size_t r = first_[i]; r < first_[i + 1]; ++r)
        score += sums(ranges_[r].end) - sums(ranges_[r].first);
      result(k) = std::max(result(k), score * score / information_[i]);
    }
  }
  return result;
}

double bootstrap_p(double value, const VectorXd& draws) {
  return (1.0 + static_cast<double>((draws.array() >= value).count())) /
         (1.0 + static_cast<double>(draws.size()));
}

Location locate(const std::vector<Cell>& cells, const VectorXd& residual, const Whitener& covariance,
                const MatrixXd& null_draws, const VectorXd& simulated, const LocateOptions& options) {
  const StepScan scan(cells, covariance, options.least_cells);
  VectorXd greatest = scan.greatest(covariance.solve(null_draws));
  std::sort(greatest.begin(), greatest.end());

  Location location;
  const double place = std::ceil((1.0 - options.alpha) * static_cast<double>(greatest.size() + 1)) - 1.0;
  location.threshold = greatest(std::min(static_cast<Index>(place), greatest.size() - 1));
  VectorXd rest = residual;
  std::vector<RowRange> taken;
  location.greatest = scan.best(covariance.solve(rest)).statistic;
  location.p = bootstrap_p(location.greatest, greatest);
  while (static_cast<int>(location.mismatches.size()) < options.most_intervals) {
    const Step step = scan.best(covariance.solve(rest), taken);
    const double p = bootstrap_p(step.statistic, greatest);
    if (p > options.alpha || step.rows.empty()) break;
    double q_c = 0.0, rows = 0.0;  // [Pa]
    for (const RowRange& r : step.rows) {
      rest.segment(r.first, r.end - r.first).array() -= step.size;
      q_c += simulated.segment(r.first, r.end - r.first).array().exp().sum();
      rows += static_cast<double>(r.end - r.first);
      taken.push_back(r);
    }
    const Cell& top = cells[static_cast<std::size_t>(step.rows.front().first)];
    const Cell& bottom = cells[static_cast<std::size_t>(step.rows.front().end - 1)];
    location.mismatches.push_back({step.rows.size() > 1 ? -1 : top.sounding, top.depth - 0.5 * top.height,
                                   bottom.depth + 0.5 * bottom.height, step.size,
                                   100.0 * std::expm1(step.size), std::expm1(step.size) * q_c / rows,
                                   step.statistic, p});
  }
  return location;
}

}  // namespace cpt::diagnosis
