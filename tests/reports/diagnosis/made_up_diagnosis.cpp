#include "tests/reports/diagnosis/made_up_diagnosis.hpp"

#include <cmath>

#include "diagnosis/quadrature.hpp"
#include "reports/diagnosis/errors.hpp"
#include "solver/mechanisms/catalogue.hpp"

namespace cpt::reports::diagnosed {
namespace {

constexpr int cells_each = 40;
constexpr double height = 0.0075;  // [m]

double q_c(double depth) { return 2.2e6 * (1.0 - 0.75 * std::exp(-depth / 0.05)); }
double compaction(double depth) { return std::log(1.0 + 0.5 * std::exp(-depth / 0.06)); }
double ripple(double depth) { return 0.015 * std::sin(310.0 * depth) + 0.01 * std::cos(97.0 * depth); }

Curve curve(const auto& ln_factor, int points) {
  Curve c;
  for (int i = 0; i < points; ++i) {
    const double depth = (i + 0.5) * cells_each * height / points;
    c.depth.push_back(depth);
    c.q_c.push_back(q_c(depth) * std::exp(ln_factor(depth)));
  }
  return c;
}

VectorXd vector(std::initializer_list<double> values) {
  VectorXd v(static_cast<Index>(values.size()));
  Index i = 0;
  for (const double value : values) v(i++) = value;
  return v;
}

// A normal posterior on the nodes of a tensor grid.
diagnosis::MechanismEvidence evidence(const std::string& name, double log_evidence, const VectorXd& mean,
                                      const VectorXd& deviation) {
  diagnosis::MechanismEvidence e;
  e.name = name;
  e.log_evidence = log_evidence;
  e.mean = e.mode = mean;
  e.deviation = deviation;
  e.lower = (mean - 1.645 * deviation).cwiseMax(0.0);
  e.upper = (mean + 1.645 * deviation).cwiseMin(1.0);
  const VectorXd low = (mean - 4.0 * deviation).cwiseMax(0.0);
  const VectorXd high = (mean + 4.0 * deviation).cwiseMin(1.0);
  const auto rule = diagnosis::box_rule(low, high, mean.size() == 3 ? 15 : 33);
  e.nodes = rule.nodes;
  e.probability = rule.weights;
  for (Index i = 0; i < e.nodes.rows(); ++i) {
    const VectorXd away = (e.nodes.row(i).transpose() - mean).cwiseQuotient(deviation);
    e.probability(i) *= std::exp(-0.5 * away.squaredNorm());
  }
  e.probability /= e.probability.sum();
  return e;
}

std::vector<solver::Mechanism> catalogue() {
  std::vector<solver::Mechanism> mechanisms;
  for (const char* name : {"surface_compaction", "density_lens", "depth_datum"})
    mechanisms.push_back(*solver::find_mechanism(name));
  return mechanisms;
}

void add_cells(DiagnosisInput& input, diagnosis::Recalibration& with, int soundings) {
  diagnosis::Diagnosis& d = input.diagnosis;
  d.compared.cells = diagnosis::cells_of(
      std::vector<diagnosis::SoundingGrid>(static_cast<std::size_t>(soundings), {0.0, height, cells_each}));
  const auto n = static_cast<Index>(d.compared.cells.size());
  input.recorded.resize(n);
  input.baseline.resize(n);
  d.null.recalibrated.curve.resize(n);
  with.curve.resize(n);
  for (Index i = 0; i < n; ++i) {
    const double depth = d.compared.cells[static_cast<std::size_t>(i)].depth;
    const double ln = std::log(q_c(depth));
    d.compared.rows.push_back(i);
    input.baseline(i) = ln;
    input.recorded(i) = ln + compaction(depth) + ripple(depth);
    d.null.recalibrated.curve(i) = ln + 0.06;
    with.curve(i) = ln + 0.97 * compaction(depth);
  }
}

}  // namespace

DiagnosisInput named_case(int soundings) {
  DiagnosisInput input;
  input.name = "chamber";
  input.title = "Chamber test CC-3";
  for (int s = 0; s < soundings; ++s)
    input.soundings.push_back({soundings == 1 ? "push" : "push " + std::to_string(s + 1),
                               curve([](double z) { return compaction(z) + ripple(z); }, 600),
                               curve([](double) { return 0.0; }, 120),
                               curve([](double z) { return 0.95 * compaction(z); }, 120)});
  input.parameters = {{solver::find_quantity("sand.D_r_percent"), 60.0, 50.0, 70.0},
                      {solver::find_quantity("initial.sigma_h0_kPa"), 35.0, 30.0, 40.0},
                      {solver::find_quantity("chamber.wall"), 0.0, 0.0, 1.0}};
  input.mechanisms = catalogue();
  diagnosis::Recalibration with;  // the null beside any mechanism
  add_cells(input, with, soundings);

  diagnosis::Diagnosis& d = input.diagnosis;
  d.compared.measurement = {diagnosis::Kernel::ar1, 0.02, 0.012};
  const auto n = static_cast<Index>(d.compared.cells.size());
  d.compared.numerical =
      diagnosis::ShrunkCovariance{4e-4 * MatrixXd::Identity(n, n), {diagnosis::Kernel::ar1, 0.02, 0.02}, 0.4};
  d.null.recalibrated.place = vector({0.7, 0.55, 0.0});
  d.null.recalibrated.deviation = vector({0.12, 0.2, 0.3});
  d.null.recalibrated.rmse = rmse(input.recorded, d.null.recalibrated.curve);
  with.place = vector({0.52, 0.5, 0.0});
  with.deviation = vector({0.1, 0.2, 0.3});
  with.rmse = rmse(input.recorded, with.curve);
  d.null.check = {95.0, 0.001, 40.0, 0.001, 0.002};
  d.location = {11.3, 42.0, 0.000999, {{0, 0.03, 0.1125, std::log(1.38), 38.0, 410e3, 42.0, 0.000999}}};
  d.verdict.hypotheses = {{0, "surface_compaction", 1.0 / 6.0, 71.4, 0.93},
                          {1, "density_lens", 1.0 / 6.0, 66.9, 0.01},
                          {2, "depth_datum", 1.0 / 6.0, 62.0, 0.0002},
                          {Explanation::nothing(), diagnosis::nothing_is_missing, 0.3, 60.1, 0.0004},
                          {Explanation::unknown(), diagnosis::none_of_these, 0.2, 68.5, 0.06}};
  d.mechanisms = {{evidence("surface_compaction", 71.4, vector({0.35, 0.4}), vector({0.075, 0.1})), with},
                  {evidence("density_lens", 66.9, vector({0.8, 0.1, 0.6}), vector({0.1, 0.05, 0.25})), with},
                  {evidence("depth_datum", 62.0, vector({0.3}), vector({0.08})), with}};
  d.pairs = {{"surface_compaction", "depth_datum", 70.2, vector({0.3, 0.4}), vector({0.5})}};
  d.verdict.winner = d.verdict.answer = 0;
  d.verdict.gate = diagnosis::PredictiveCheck{41.0, 0.42, 6.0, 0.5, 0.84};
  d.verdict.set = {0};
  d.isolability.between.resize(3, 3);
  d.isolability.between << 0.0, 4.1, 5.6, 3.2, 0.0, 4.4, 1.9, 2.7, 0.0;
  d.isolability.strength = vector({7.9, 3.6, 2.2});
  d.best = diagnosis::BestMechanism{
      0, diagnosis::HeldOutGain{std::log(1.21), std::log(1.06), 33.2, 0.83, 0.51, 1.18}};
  d.variations = {{"parameter ranges x 1/2", "surface_compaction", false},
                  {"parameter ranges x 2", "surface_compaction", false}};
  input.noise = {false, 5, 1.0, 12};
  input.provenance = {"0.1.0", "7",   {1, 2}, {{"recording", "cc3.csv", "ab12"}, {"study", "cc3.toml", ""}},
                      184,     5400.0};
  return input;
}

DiagnosisInput nothing_missing_case() {
  DiagnosisInput input = named_case();
  diagnosis::Diagnosis& d = input.diagnosis;
  input.recorded = d.null.recalibrated.curve;
  for (Index i = 0; i < input.recorded.size(); ++i)
    input.recorded(i) += ripple(d.compared.cells[static_cast<std::size_t>(i)].depth);
  d.null.recalibrated.rmse = rmse(input.recorded, d.null.recalibrated.curve);
  d.location = {11.3, 6.4, 0.34, {}};
  d.verdict.hypotheses[0].probability = 0.05;
  d.verdict.hypotheses[3].probability = 0.87;
  d.verdict.winner = d.verdict.answer = Explanation::nothing();
  d.null.check = {38.0, 0.4, 6.4, 0.34, 0.68};
  d.verdict.gate = d.null.check;
  d.verdict.set = {Explanation::nothing(), Explanation::unknown()};
  d.best->held_out = diagnosis::HeldOutGain{0.04, 0.04, -0.4, -0.01, -0.05, 0.02};
  input.soundings[0].recorded = curve([](double z) { return 0.06 + ripple(z); }, 600);
  input.soundings[0].solver.reset();
  return input;
}

DiagnosisInput none_of_these_case() {
  DiagnosisInput input = named_case();
  diagnosis::Diagnosis& d = input.diagnosis;
  d.verdict.hypotheses[0].probability = 0.1;
  d.verdict.hypotheses[4].probability = 0.83;
  d.verdict.winner = d.verdict.answer = Explanation::unknown();
  d.verdict.gate.reset();
  d.verdict.set = {Explanation::unknown()};
  d.pairs[0].log_evidence = 75.6;
  return input;
}

DiagnosisInput gate_failed_case() {
  DiagnosisInput input = named_case();
  input.diagnosis.verdict.answer = Explanation::unknown();
  input.diagnosis.verdict.gate = diagnosis::PredictiveCheck{90.0, 0.001, 21.0, 0.004, 0.002};
  return input;
}

DiagnosisInput indistinguishable_case() {
  DiagnosisInput input = named_case();
  diagnosis::Diagnosis& d = input.diagnosis;
  d.verdict.hypotheses[0].probability = 0.52;
  d.verdict.hypotheses[1].probability = 0.41;
  d.isolability.between(0, 1) = 1.2;
  d.verdict.set = {0, 1};
  d.next = {{"a second push at 100 kPa", 4.3}, {"the sleeve friction", 1.9}};
  d.variations[1] = {"parameter ranges x 2", "density_lens", true};
  return input;
}

}  // namespace cpt::reports::diagnosed
