// Checkpoints on disk: whole and of the same settings, or refused with the reason.
#include "results/push/checkpoint.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "results/files/hdf5_file.hpp"
#include "results/ledger/provenance.hpp"
#include "solver/presets.hpp"
#include "tests/results/campaign_fixture.hpp"
#include "tests/solver/default_soils.hpp"

namespace cpt::results {
namespace {

const solver::PushState state{{"push.depth", {0.0312}},
                              {"points.slots", {1.0, -0.0, 5e-324, 1.0 / 3.0, -1e300}},
                              {"before.sigma_h_ratio", {}}};

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

class Checkpoint : public ScratchFolder {
 protected:
  [[nodiscard]] std::filesystem::path file() const { return folder / "state.h5"; }
  [[nodiscard]] std::string bytes() const {
    std::ifstream stream(file(), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  void put(const std::string& text) const { std::ofstream(file(), std::ios::binary) << text; }
  // Why the file is refused; empty if it is not.
  [[nodiscard]] std::string refusal(const solver::Setup& wanted) const {
    try {
      EXPECT_EQ(read_checkpoint(file(), wanted), state);
      return {};
    } catch (const Error& error) {
      return error.what();
    }
  }
  const solver::Setup setup = solver::make_setup(solver::Profile::homogeneous_sand, solver::Preset::quick);
};

TEST_F(Checkpoint, KeepsEveryBit) {
  EXPECT_EQ(read_checkpoint(file(), setup), std::nullopt);
  write_checkpoint(file(), setup, state);
  const auto read = read_checkpoint(file(), setup);
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, state);
  EXPECT_TRUE(std::signbit(read->at("points.slots")[1]));
  EXPECT_FALSE(std::filesystem::exists(file().string() + ".tmp"));
}

TEST_F(Checkpoint, OfOtherSettingsIsRefused) {
  write_checkpoint(file(), setup, state);
  solver::Setup other = setup;
  solver::sand_of(other).nu += 1e-15;
  EXPECT_TRUE(says(refusal(other), "made with the settings " + settings_hash(setup))) << refusal(other);
  EXPECT_EQ(refusal(setup), "");
}

TEST_F(Checkpoint, WithAnyBitFlippedIsRefused) {
  write_checkpoint(file(), setup, state);
  const std::string good = bytes();
  // Every bit of the seal's text, then some of everything.
  for (std::size_t bit = 0; bit < 8 * good.size(); bit += bit < 8 * 120 ? 1 : 4099) {
    std::string bad = good;
    bad[bit / 8] = static_cast<char>(bad[bit / 8] ^ (1 << bit % 8));
    put(bad);
    const std::string why = refusal(setup);
    EXPECT_TRUE(says(why, bit < 8 * 42 ? "does not start with a checksum" : "do not match their checksum"))
        << bit << ": " << why;
  }
}

TEST_F(Checkpoint, CutShortAnywhereIsRefused) {
  write_checkpoint(file(), setup, state);
  const std::string good = bytes();
  for (std::size_t size = 0; size < good.size(); size += size < 100 ? 1 : 97) {
    put(good.substr(0, size));
    EXPECT_NE(refusal(setup), "") << size;
  }
}

TEST_F(Checkpoint, ThatIsAnotherFileIsRefused) {
  put("not HDF5");
  EXPECT_NE(refusal(setup), "");
  write_hdf5(file(), [](const Hdf5Group& root) { root.put_text("title", "something else"); });
  EXPECT_NE(refusal(setup), "");
}

TEST_F(Checkpoint, ThatCannotBeWrittenSaysWhy) {
  try {
    write_checkpoint(folder / "missing" / "state.h5", setup, state);
    FAIL();
  } catch (const Error& error) {
    EXPECT_TRUE(says(error.what(), "state.h5: cannot be written (No such file or directory)"))
        << error.what();
  }
}

TEST_F(Checkpoint, FolderHoldsWhatIsUnfinishedAndGoesWhenEmpty) {
  const std::string wanted(64, 'a'), stale(64, 'b');
  const std::filesystem::path database = folder / "some.sqlite", checkpoints = folder / "some.checkpoints";
  {
    const CheckpointFolder empty(database, {});
    EXPECT_TRUE(std::filesystem::is_directory(checkpoints));
    EXPECT_EQ(empty.file(wanted), checkpoints / (wanted + ".h5"));
    for (const std::string& name : {wanted + ".h5", wanted + ".h5.tmp", stale + ".h5", std::string("notes")})
      std::ofstream(checkpoints / name) << "x";
  }
  {
    const CheckpointFolder kept(database, {wanted});
    EXPECT_TRUE(std::filesystem::exists(kept.file(wanted)));
    EXPECT_FALSE(std::filesystem::exists(kept.file(wanted).string() + ".tmp"));
    EXPECT_FALSE(std::filesystem::exists(kept.file(stale)));
    EXPECT_TRUE(std::filesystem::exists(checkpoints / "notes")) << "not ours";
    std::filesystem::remove(checkpoints / "notes");
    kept.remove(wanted);
    kept.remove(stale);
  }
  EXPECT_FALSE(std::filesystem::exists(checkpoints));
}

}  // namespace
}  // namespace cpt::results
