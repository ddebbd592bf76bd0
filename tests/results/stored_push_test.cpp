// A push found again from its folder or its series, and what is said where that cannot be.
#include "results/push/stored_push.hpp"

#include "results/ledger/provenance.hpp"
#include "solver/quantities.hpp"
#include "tests/results/campaign_fixture.hpp"
#include "tests/results/push_recording.hpp"

namespace cpt::results {
namespace {

class Stored : public ScratchFolder {
 protected:
  // FOLDER/NAME-fields with two depths, and the histories beside it.
  void store(const std::string& name, const std::string& hash = "abc") const {
    const std::vector<solver::PointState> points = {point(1, 0.1, 0.2)};
    FieldSeries series(folder / (name + "-fields"), name, "settings " + hash,
                       point_quantities(solver::Setup{}));
    series.add(0.1, 0.1, points, points);
    series.add(0.2, 0.2001, points, points);
    Histories histories;
    histories.origin["setup"] = solver::canonical_text(short_push());
    histories.origin["settings_hash"] = "abc";
    write_histories(folder / (name + "-histories.h5"), histories);
  }
  // What reading says; empty if it reads.
  static std::string complaint(const std::filesystem::path& place) {
    try {
      const StoredPush push = read_stored_push(place);
      for (const StoredField& field : push.fields) (void)read_field(push, field);
      return "";
    } catch (const Error& error) {
      return error.what();
    }
  }
};

void expect_has(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST_F(Stored, IsFoundFromItsFolderAndFromItsSeries) {
  store("sand");
  for (const auto& place : {folder, folder / "sand-fields" / "sand.pvd"}) {
    const StoredPush push = read_stored_push(place);
    EXPECT_EQ(push.name, "sand");
    EXPECT_EQ(push.folder, folder);
    ASSERT_EQ(push.fields.size(), 2U);
    EXPECT_EQ(push.fields[1].depth, 0.2001);
    EXPECT_EQ(read_field(push, push.fields[1]).ids, std::vector<std::int64_t>{1});
    EXPECT_EQ(push.number("penetrometer.final_depth_m"), 0.0239);
    EXPECT_EQ(push.setting("chamber.wall"), "rigid");
    EXPECT_EQ(push.setting("layers"), "0 to 1 sand");
    EXPECT_THROW((void)push.setting("chamber.colour"), Error);
    EXPECT_THROW((void)push.number("chamber.wall"), Error);
  }
}

TEST_F(Stored, SaysWhatIsMissing) {
  expect_has(complaint(folder / "nowhere"), "no such folder");
  expect_has(complaint(folder), "no fields are stored here");
  std::ofstream(folder / "notes.txt") << "x";
  expect_has(complaint(folder / "notes.txt"), "not the folder of a push");
  store("sand");
  std::filesystem::remove(folder / "sand-fields" / "sand-0.2m.vtu");
  expect_has(complaint(folder), "sand-0.2m.vtu");
  std::filesystem::remove(folder / "sand-histories.h5");
  expect_has(complaint(folder), "sand-histories.h5: missing");
}

TEST_F(Stored, OfOtherSettingsOrOfSeveralPushesIsRefused) {
  store("sand", "other");
  expect_has(complaint(folder), "other settings");
  store("sand");
  EXPECT_EQ(complaint(folder), "");
  store("sand-2");
  expect_has(complaint(folder), "2 pushes");
  EXPECT_EQ(complaint(folder / "sand-2-fields" / "sand-2.pvd"), "");
}

}  // namespace
}  // namespace cpt::results
