// From a study over its ledger to a stored emulator and to the points to run next.
#include "results/emulator/emulator.hpp"

#include <fmt/format.h>

#include <set>
#include <string_view>

#include "parameters/designs/propagation.hpp"
#include "parameters/read_study.hpp"
#include "results/emulator/emulator_file.hpp"
#include "results/emulator/training.hpp"
#include "tests/results/campaign_fixture.hpp"
#include "tests/results/emulator/test_functions.hpp"
#include "tests/solver/default_soils.hpp"

namespace cpt::results {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

// [Pa] of nu, H and wall (1: rigid).
double level(double nu, double h, double wall) {
  return 1e6 * nu + 1e4 * h + 5e4 * wall + 4e3 * nu * h + 2e3 * std::sin(h / 10.0);
}

class EmulatorOf : public ScratchFolder {
 protected:
  static std::string text_with(const std::string& design, const std::string& upper_nu = "0.3") {
    return "profile = \"homogeneous_sand\"\npreset = \"quick\"\n"
           "[parameters]\n"
           "sand.nu = { baseline = 0.2, lower = 0.1, upper = " +
           upper_nu +
           " }\n"
           "sand.H = { baseline = 25, upper = 75 }\n"
           "chamber.wall = { baseline = \"rigid\", alternative = \"flexible\" }\n"
           "[[windows]]\nname = \"deep\"\nfrom_m = 0.30\nto_m = 0.32\n" +
           design;
  }
  parameters::Study study_of(const std::string& text) const {
    auto parsed = parameters::parse_study(text, folder / "study.toml");
    if (const auto* errors = std::get_if<std::vector<parameters::StudyError>>(&parsed))
      throw std::runtime_error(parameters::format(*errors));
    return std::get<parameters::Study>(std::move(parsed));
  }
  // All runs end, but for those whose names are in `failing`.
  TrainingRuns trained(const std::string& text, const std::set<std::string>& failing = {}) const {
    const parameters::Study study = study_of(text);
    const auto realizations = parameters::all_realizations(study);
    const auto stored = [&] { return read_snapshot(study.database).realizations; };
    {
      Ledger ledger = Ledger::open_for_run(study, realizations, {text, false});
      std::set<int> ended;
      for (const RealizationRow& run : stored())
        if (!run.waiting()) ended.insert(run.id);
      for (const parameters::Realization& realization : realizations) {
        if (ended.contains(realization.id)) continue;
        const solver::Setup setup = make_setup(study, realization);
        const auto& sand = solver::sand_of(setup);
        const bool fails = failing.contains(std::string(parameter_name(study, realization)));
        ledger.record(
            realization.id,
            fails ? failed(solver::Status::did_not_converge, "made up")
                  : completed(level(sand.nu, sand.H, setup.chamber.wall == solver::Wall::rigid ? 1.0 : 0.0)));
      }
    }
    return training_runs(study, read_snapshot(study.database));
  }
};

const std::string hypercube_40 = "[design]\nkind = \"latin_hypercube\"\nruns = 40\n";

TEST_F(EmulatorOf, AStudyLearnsFromTheRunsThatVaryItsInputs) {
  const TrainingRuns runs = trained("repeats = 4\n" + text_with(hypercube_40), {"latin hypercube 7"});
  // Baseline, bounds of three rows (nu has two) and the design's but the one that failed; no repeats.
  EXPECT_EQ(runs.runs.size(), 1U + 4U + 39U);
  ASSERT_EQ(runs.notes.size(), 1U);
  EXPECT_EQ(runs.notes[0], "1 run left out: failed, or not finished");
  ASSERT_EQ(runs.inputs.size(), 3U);
  EXPECT_EQ(runs.inputs[0].name, "sand.nu");
  EXPECT_EQ(runs.inputs[0].range(), "0.1 to 0.3");
  EXPECT_EQ(runs.inputs[2].range(), "flexible or rigid");
  EXPECT_TRUE((runs.places.array() >= 0.0).all() && (runs.places.array() <= 1.0).all());
  EXPECT_DOUBLE_EQ(runs.places(0, 0), 0.5);  // the baseline
  EXPECT_DOUBLE_EQ(runs.places(0, 1), 0.0);
  EXPECT_DOUBLE_EQ(runs.places(0, 2), 1.0);
  ASSERT_EQ(runs.outputs.size(), 4U);
  EXPECT_EQ(runs.outputs[0].name, "deep.q_c_mean_kPa");
  EXPECT_EQ(runs.outputs[1].name, "deep.f_s_mean_kPa");
  EXPECT_EQ(runs.outputs[2].name, "q_c_kPa");
  EXPECT_EQ(runs.outputs[2].abscissa.size(), 800);
  EXPECT_EQ(runs.outputs[3].name, "f_s_kPa");
}

TEST_F(EmulatorOf, AStudyPredictsAverageAndCurve) {
  std::vector<std::string> notes;
  const Emulator emulator = make_emulator(trained(text_with(hypercube_40)), notes);
  EXPECT_TRUE(notes.empty());
  MatrixXd point(1, 3);
  point << 0.15, 60.0, 0.0;
  const solver::DepthProfile truth = curve(level(0.15, 60.0, 0.0));
  const EmulatedOutput& whole = *emulator.output("q_c_kPa");
  EXPECT_GT(whole.validation.q2, 0.99);
  EXPECT_EQ(whole.emulator.processes().size(), 1U);  // one shape times a level
  const OutputPrediction at = whole.emulator.predict(emulator.places(point));
  for (const std::size_t z : {100U, 300U, 700U})
    EXPECT_NEAR(at.value(static_cast<Index>(z), 0), truth.q_c[z] / 1e3, 0.01 * truth.q_c[z] / 1e3);
  double sum = 0.0;
  int bins = 0;
  for (std::size_t z = 0; z < truth.depth.size(); ++z)
    if (truth.depth[z] >= 0.30 && truth.depth[z] <= 0.32) sum += truth.q_c[z] / 1e3, ++bins;
  EXPECT_NEAR(emulator.output("deep.q_c_mean_kPa")->emulator.predict(emulator.places(point)).value(0),
              sum / bins, 0.01 * sum / bins);
}

TEST_F(EmulatorOf, AFileGivesTheSameBits) {
  std::vector<std::string> notes;
  const Emulator emulator = make_emulator(trained(text_with(hypercube_40)), notes);
  const auto file = emulator_file_of(folder / "study.sqlite");
  EXPECT_EQ(file, folder / "study-emulator.h5");
  write_emulator(file, emulator);
  const Emulator read = read_emulator(file);
  EXPECT_EQ(read.inputs, emulator.inputs);
  EXPECT_EQ(read.runs, emulator.runs);
  EXPECT_EQ(read.windows, emulator.windows);
  ASSERT_EQ(read.outputs.size(), emulator.outputs.size());
  const MatrixXd points = hypercube(3, 5, 8);
  for (std::size_t k = 0; k < read.outputs.size(); ++k) {
    EXPECT_EQ(read.outputs[k].name, emulator.outputs[k].name);
    EXPECT_EQ(read.outputs[k].validation.q2, emulator.outputs[k].validation.q2);
    const OutputPrediction a = emulator.outputs[k].emulator.predict(points),
                           b = read.outputs[k].emulator.predict(points);
    EXPECT_EQ(a.value, b.value);
    EXPECT_EQ(a.error, b.error);
  }
  EXPECT_THROW((void)read_emulator(folder / "none.h5"), Error);
  EXPECT_THROW((void)read_emulator(folder / "study.sqlite"), Error);
}

TEST_F(EmulatorOf, AnEditedStudyIsStaleAndTellsWhy) {
  std::vector<std::string> notes;
  const Emulator emulator = make_emulator(trained(text_with(hypercube_40)), notes);
  EXPECT_TRUE(stale(emulator, trained(text_with(hypercube_40))).empty());
  const auto wider = stale(emulator, trained(text_with(hypercube_40, "0.35")));
  ASSERT_EQ(wider.size(), 3U);
  EXPECT_EQ(wider[0], "inputs or their ranges are others: sand.nu");
  EXPECT_EQ(wider[1], "41 of its 45 runs are gone");
  const auto more = stale(emulator, trained(text_with(hypercube_40) +
                                            "[[points]]\nname = \"one\"\nsand.nu = 0.13\nsand.H = 41\n"));
  EXPECT_EQ(more, std::vector<std::string>{"1 more run is there"});
}

TEST_F(EmulatorOf, TooFewRunsAndRunsOneAtATimeAreRefused) {
  EXPECT_THROW((void)trained(text_with("")), Error);
  EXPECT_THROW((void)trained(text_with("[design]\nkind = \"latin_hypercube\"\nruns = 10\n")), Error);
}

TEST(EmulatorInputs, HavePlacesAndRanges) {
  EmulatorInput input{"a", "kPa", 10.0, 1000.0, 100.0, true, false, {}};
  EXPECT_NEAR(input.place(100.0), 0.5, 1e-12);
  EXPECT_EQ(out_of_range(input, 1001.0), "must be 10 to 1000 kPa");
  EXPECT_EQ(out_of_range(input, 1000.0), "");
  input.integer = true;
  EXPECT_EQ(out_of_range(input, 11.5), "must be whole, 10 to 1000 kPa");
  EXPECT_NE(out_of_range(input, std::nan("")), "");
}

// An emulator of one output of a function of the cube.
Emulator emulator_of(const MatrixXd& design, const Function& function) {
  Emulator emulator;
  emulator.outputs.push_back(
      {{"y"}, {}, OutputEmulator::fit(design, values(function, design).transpose(), false), {}});
  return emulator;
}

TEST(WorstPlaces, AreFarFromTheRunsAndTakenOnce) {
  MatrixXd design(8, 1), candidates(5, 1);
  design << 0.0, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 1.0;
  candidates << 0.65, 0.6, 0.1, 0.7, 0.3;
  const Emulator emulator = emulator_of(design, [](const RowVectorXd& u) { return std::sin(20.0 * u(0)); });
  const std::vector<Index> taken = worst_places(emulator, candidates, 5);
  ASSERT_EQ(taken.size(), 5U);
  EXPECT_EQ(std::set<Index>(taken.begin(), taken.end()).size(), 5U);
  EXPECT_EQ(taken[0], 0);
  EXPECT_EQ(worst_places(emulator, candidates, 9).size(), 5U);
}

// What a run takes off is what a process that has it lacks: it needs no value. Eight candidates, of which the
// first is the one reference.
TEST(WorstPlaces, TakeMostOffTheVariance) {
  const MatrixXd design = hypercube(2, 20, 4), candidates = hypercube(2, 8, 5);
  const Function function = [](const RowVectorXd& u) { return std::sin(6.0 * u(0)) * std::cos(4.0 * u(1)); };
  const Emulator emulator = emulator_of(design, function);
  const GaussianProcess& process = emulator.outputs[0].emulator.processes()[0];
  const auto variance_with = [&](const MatrixXd& more) {
    MatrixXd all(20 + more.rows(), 2);
    all << design, more;
    VectorXd any = VectorXd::LinSpaced(all.rows(), 0.0, 1.0);
    const GaussianProcess with(all, any, process.trend(), process.kernel());
    return with.mean_variance(candidates.row(0))(0) / with.variance();
  };
  const std::vector<Index> taken = worst_places(emulator, candidates, 2);
  for (Index i = 0; i < 8; ++i) {
    EXPECT_GE(variance_with(candidates.row(i)), variance_with(candidates.row(taken[0])) - 1e-9) << i;
    if (i == taken[0]) continue;
    const std::vector<Index> pair{taken[0], i};
    EXPECT_GE(variance_with(candidates(pair, Eigen::all)),
              variance_with(candidates(taken, Eigen::all)) - 1e-9)
        << i;
  }
}

// Ten more runs where the emulator knows least, against ten at random: mean over seeds of the error left.
TEST(WorstPlaces, BringTheErrorDownMoreThanRandomOnes) {
  const MatrixXd test = hypercube(3, 1000, 99);
  const VectorXd truth = values(ishigami, test);
  const auto error = [&](const MatrixXd& design) {
    const OutputPrediction at =
        OutputEmulator::fit(design, values(ishigami, design).transpose(), false).predict(test);
    return std::sqrt((at.value.row(0).transpose() - truth).squaredNorm() / 1000.0);
  };
  double before = 0.0, worst = 0.0, random = 0.0;
  constexpr int seeds = 10;
  for (int seed = 1; seed <= seeds; ++seed) {
    const MatrixXd design = hypercube(3, 60, static_cast<std::uint64_t>(seed));
    const MatrixXd candidates = parameters::propagation_places(3, 1024, static_cast<std::uint64_t>(seed));
    const std::vector<Index> taken = worst_places(emulator_of(design, ishigami), candidates, 10);
    MatrixXd with_worst(70, 3), with_random(70, 3);
    with_worst << design, candidates(taken, Eigen::all);
    with_random << design, hypercube(3, 1000, static_cast<std::uint64_t>(1000 + seed)).topRows(10);
    before += error(design) / seeds;
    worst += error(with_worst) / seeds;
    random += error(with_random) / seeds;
  }
  EXPECT_LT(worst, random);
  EXPECT_LT(random, before);
}

}  // namespace
}  // namespace cpt::results
