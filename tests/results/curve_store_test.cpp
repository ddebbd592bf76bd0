#include "results/ledger/curve_store.hpp"

#include "tests/results/campaign_fixture.hpp"

namespace cpt::results {
namespace {

class CurveStore : public ScratchFolder {
 protected:
  void SetUp() override {
    Ledger ledger = open(study);
    for (const int id : {1, 3, 6}) ledger.record(id, completed(1e6 * id));
    ASSERT_TRUE(sync_curves(study.curves, study.database));
  }
  static std::string bytes(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  parameters::Study study = sand_study(folder);
};

TEST_F(CurveStore, HoldsEveryCurveWithItsAttributes) {
  const auto curves = read_curves(study.curves);
  ASSERT_EQ(curves.size(), 3u);
  EXPECT_EQ(curves[0].realization, 1);
  EXPECT_EQ(curves[0].side, "baseline");
  EXPECT_FALSE(curves[0].value.has_value());
  EXPECT_EQ(curves[1].realization, 3);
  EXPECT_EQ(curves[1].parameter, "sand.H");
  EXPECT_EQ(curves[1].value, 75.0);
  EXPECT_EQ(curves[2].value_text, "flexible");
  const solver::DepthProfile expected = curve(6e6);
  EXPECT_EQ(curves[2].depth_m, expected.depth);
  for (std::size_t i = 0; i < expected.q_c.size(); ++i) {
    ASSERT_EQ(curves[2].channels_kPa.at("q_c")[i], expected.q_c[i] / 1e3);
    ASSERT_EQ(curves[2].channels_kPa.at("f_s")[i], expected.f_s[i] / 1e3);
  }
}

TEST_F(CurveStore, IsWrittenOnlyWhenBehind) {
  EXPECT_FALSE(sync_curves(study.curves, study.database));
  {
    Ledger ledger = open(study);
    ledger.record(2, completed(2e6));
  }
  EXPECT_TRUE(sync_curves(study.curves, study.database));
  EXPECT_EQ(read_curves(study.curves).size(), 4u);
  EXPECT_FALSE(std::filesystem::exists(study.curves.string() + ".tmp"));
}

TEST_F(CurveStore, EqualCampaignsGiveEqualBytes) {
  const std::string before = bytes(study.curves);
  std::filesystem::remove(study.curves);
  EXPECT_TRUE(sync_curves(study.curves, study.database));
  EXPECT_EQ(bytes(study.curves), before);
}

TEST_F(CurveStore, IsRebuiltFromTheLedgerWhenTruncatedOrOverwritten) {
  const std::string whole = bytes(study.curves);
  for (const std::size_t size : {std::size_t{0}, std::size_t{100}, whole.size() / 2, whole.size() - 1}) {
    std::filesystem::resize_file(study.curves, size);
    EXPECT_TRUE(sync_curves(study.curves, study.database)) << size;
    EXPECT_EQ(bytes(study.curves), whole);
  }
  std::ofstream(study.curves, std::ios::binary) << "not HDF5 at all";
  EXPECT_THROW((void)read_curves(study.curves), Error);
  EXPECT_TRUE(sync_curves(study.curves, study.database));
  EXPECT_EQ(bytes(study.curves), whole);
}

TEST_F(CurveStore, ChangedNumberIsNoticed) {
  std::string content = bytes(study.curves);
  const double wanted = curve(3e6).q_c[400] / 1e3;
  const auto at = content.find(std::string(reinterpret_cast<const char*>(&wanted), sizeof wanted));
  ASSERT_NE(at, std::string::npos);
  content[at] = static_cast<char>(content[at] ^ 1);
  std::ofstream(study.curves, std::ios::binary) << content;
  EXPECT_TRUE(sync_curves(study.curves, study.database));
}

TEST_F(CurveStore, LeftoverOfAKilledWriteDoesNoHarm) {
  std::ofstream(study.curves.string() + ".tmp") << "half a file";
  std::filesystem::remove(study.curves);
  EXPECT_TRUE(sync_curves(study.curves, study.database));
  EXPECT_FALSE(std::filesystem::exists(study.curves.string() + ".tmp"));
}

TEST_F(CurveStore, UnwritablePlaceIsNamedAndTheLedgerUntouched) {
  try {
    sync_curves(folder / "nowhere" / "x.h5", study.database);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("nowhere"), std::string::npos);
  }
}

}  // namespace
}  // namespace cpt::results
