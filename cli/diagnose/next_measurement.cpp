#include "cli/diagnose/next_measurement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "solver/channels.hpp"

namespace cpt::cli {

using namespace diagnosis;

namespace {

bool same_mechanisms(const Assembled& a, const Assembled& b) {
  const auto name = [](const MechanismDesign& design) { return design.mechanism.name; };
  return std::ranges::equal(a.mechanisms, b.mechanisms, {}, name, name);
}

}  // namespace

std::vector<NextMeasurement> next_measurements_of(StudyRunner& runner, const RequestFile& asked,
                                                  const std::vector<SoundingData>& soundings,
                                                  const Assembled& assembled, const Diagnosis& diagnosis,
                                                  std::vector<std::string>& remarks) {
  if (diagnosis.verdict.mechanisms_in_set().size() < 2) return {};
  std::vector<Observation> candidates;
  const auto add = [&](const std::string& name, const std::vector<SoundingData>& pushes,
                       const solver::Channel& measured) {
    try {
      const Assembled made =
          assemble_unmeasured(asked.request, pushes, measured, diagnosis.compared.measurement);
      if (same_mechanisms(made, assembled))
        candidates.push_back(observation_of(name, made.problem));
      else
        remarks.push_back(name + " is not ranked as next measurement: some of its runs failed");
    } catch (const std::invalid_argument& problem) {
      remarks.push_back(fmt::format("{} is not ranked as next measurement: {}", name, problem.what()));
    }
  };
  for (const solver::Channel& channel : solver::channels().subspan(1))
    if (std::isfinite(channel.deviation_over_q_c))
      add(std::string(channel.title) + " of the same push", soundings, channel);
  for (const SoundingRequest& candidate : asked.request.candidates) {
    SoundingData data{candidate,
                      sounding_study(asked.study, candidate, asked.request.mechanisms, asked.request.repeats,
                                     asked.request.joint),
                      {},
                      {}};
    data.campaign = runner.run(data.study.study, asked.study.database);
    add(candidate.name, {data}, solver::channels().front());
  }
  return rank_next_measurements(observation_of("recorded", assembled.problem), diagnosis, candidates);
}

}  // namespace cpt::cli
