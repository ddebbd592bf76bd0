#include "recordings/spikes.hpp"

#include <algorithm>
#include <cmath>

namespace cpt::recordings {
namespace {

// [-] standard deviation of normal scatter by its median absolute deviation
constexpr double deviation_by_median = 1.4826;

struct Channel {
  std::string_view name;
  double Reading::*value;
  double least;  // [Pa]
};
constexpr Channel channels[] = {
    {"q_c", &Reading::q_c, 50.0e3}, {"f_s", &Reading::f_s, 2.0e3}, {"u_2", &Reading::u_2, 5.0e3}};

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

// A value beside what its neighbours lead one to expect.
struct Expectation {
  std::size_t reading;
  double value, expected, scatter;
};

std::vector<Expectation> expectations_of(const Recording& recording, const Channel& channel,
                                         const SpikeRule& rule) {
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < recording.readings.size(); ++i)
    if (!std::isnan(recording.readings[i].*channel.value) && !recording.readings[i].after_stop)
      used.push_back(i);
  const auto value = [&](std::size_t i) { return recording.readings[used[i]].*channel.value; };
  const auto side = static_cast<std::size_t>(rule.neighbours);
  std::vector<Expectation> expectations;
  for (std::size_t i = side; i + side < used.size(); ++i) {
    std::vector<double> around;
    for (std::size_t j = i - side; j <= i + side; ++j)
      if (j != i) around.push_back(value(j));
    const double expected = median(around);
    for (double& neighbour : around) neighbour = std::abs(neighbour - expected);
    expectations.push_back({used[i], value(i), expected, deviation_by_median * median(around)});
  }
  return expectations;
}

}  // namespace

std::vector<Spike> spikes(const Recording& recording, const SpikeRule& rule) {
  std::vector<Spike> found;
  for (const Channel& channel : channels) {
    const std::vector<Expectation> expectations = expectations_of(recording, channel, rule);
    if (expectations.empty()) continue;
    std::vector<double> off;
    for (const Expectation& one : expectations) off.push_back(std::abs(one.value - one.expected));
    const double usual = deviation_by_median * median(off);
    const auto stands_out = [&](const Expectation& one) {
      return std::abs(one.value - one.expected) >
             std::max({rule.deviations * std::max(one.scatter, usual), rule.share * std::abs(one.expected),
                       channel.least});
    };
    for (std::size_t i = 0; i < expectations.size(); ++i)
      if (stands_out(expectations[i]) && !(i > 0 && stands_out(expectations[i - 1])) &&
          !(i + 1 < expectations.size() && stands_out(expectations[i + 1])))
        found.push_back(
            {expectations[i].reading, channel.name, expectations[i].value, expectations[i].expected});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Spike& a, const Spike& b) { return a.reading < b.reading; });
  return found;
}

}  // namespace cpt::recordings
