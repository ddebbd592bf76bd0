// VTK files read back by a small reader of their own XML: structure, raw bytes, units and signs.
#include <cmath>
#include <cstring>
#include <sstream>

#include "results/push/field_series.hpp"
#include "tests/results/campaign_fixture.hpp"
#include "tests/results/push_recording.hpp"

namespace cpt::results {
namespace {

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Value of an attribute in the first tag that holds `mark`.
std::string attribute(const std::string& xml, const std::string& mark, const std::string& name) {
  const auto at = xml.find(mark);
  if (at == std::string::npos) return "";
  const auto begin = xml.rfind('<', at), end = xml.find('>', at);
  const auto value = xml.find(" " + name + "=\"", begin);
  if (value == std::string::npos || value > end) return "";
  const auto first = value + name.size() + 3;
  return xml.substr(first, xml.find('"', first) - first);
}

// The numbers of one array, from the appended block.
template <typename Number>
std::vector<Number> numbers(const std::string& vtu, const std::string& mark) {
  const std::string offset = attribute(vtu, mark, "offset");
  if (offset.empty()) return {};
  const auto block = vtu.find('_', vtu.find("<AppendedData")) + 1;
  const char* at = vtu.data() + block + std::stoul(offset);
  std::uint64_t size = 0;
  std::memcpy(&size, at, sizeof size);
  std::vector<Number> values(size / sizeof(Number));
  std::memcpy(values.data(), at + sizeof size, size);
  return values;
}

class Fields : public ScratchFolder {
 protected:
  Fields() {
    start = {point(3, 0.1, 0.2), point(8, 0.2, 0.3), point(9, 0.3, 0.4)};
    now = start;
    now[1].r += 0.004;
    now[1].z -= 0.003;
    now[1].e = 0.75;
    now[1].v_z = -0.04;
    now[2].material = 1;
  }
  std::vector<solver::PointState> start, now;
};

TEST_F(Fields, HoldEveryPointWithItsNumbers) {
  FieldSeries series(folder / "fields", "sand", "program 1, settings <a--b> & \"c\"",
                     point_quantities(solver::Setup{}));
  series.add(0.2, 0.20001, now, start);
  const std::string vtu = bytes_of(folder / "fields" / "sand-0.2m.vtu");
  EXPECT_EQ(attribute(vtu, "<Piece", "NumberOfPoints"), "3");
  EXPECT_EQ(attribute(vtu, "<Piece", "NumberOfCells"), "3");
  EXPECT_EQ(numbers<std::int64_t>(vtu, "\"id\""), (std::vector<std::int64_t>{3, 8, 9}));
  EXPECT_EQ(numbers<double>(vtu, "NumberOfComponents=\"3\" format"),
            (std::vector<double>{0.1, -0.2, 0, 0.2 + 0.004, -0.3 - 0.003, 0, 0.3, -0.4, 0}));
  const auto displacement = numbers<double>(vtu, "displacement_m");
  ASSERT_EQ(displacement.size(), 9U);
  for (const std::size_t i : {0U, 1U, 2U, 5U, 6U, 7U, 8U}) EXPECT_EQ(displacement[i], 0.0) << i;
  EXPECT_NEAR(displacement[3], 0.004, 1e-15);
  EXPECT_NEAR(displacement[4], -0.003, 1e-15);
  EXPECT_EQ(numbers<double>(vtu, "velocity_m_per_s")[4], -0.04);
  const auto stress = numbers<double>(vtu, "\"stress_Pa\"");
  ASSERT_EQ(stress.size(), 18U);
  EXPECT_EQ(stress[6], -8e3);
  EXPECT_EQ(stress[7], -16e3);
  EXPECT_EQ(attribute(vtu, "\"stress_Pa\"", "ComponentName3"), "rz");
  EXPECT_NEAR(numbers<double>(vtu, "\"p_Pa\"")[1], 32e3 / 3.0, 1e-9);
  EXPECT_NEAR(numbers<double>(vtu, "\"q_Pa\"")[1], 8e3, 1e-9);
  EXPECT_NEAR(numbers<double>(vtu, "\"void_ratio_change\"")[1], 0.05, 1e-15);
  EXPECT_EQ(numbers<double>(vtu, "\"material\""), (std::vector<double>{0, 0, 1}));
}

TEST_F(Fields, DescribeVerticesOfAnUnstructuredGrid) {
  FieldSeries series(folder, "sand", "origin", point_quantities(solver::Setup{}));
  series.add(0.2, 0.2, now, start);
  const std::string vtu = bytes_of(folder / "sand-0.2m.vtu");
  EXPECT_EQ(numbers<std::int64_t>(vtu, "\"connectivity\""), (std::vector<std::int64_t>{0, 1, 2}));
  EXPECT_EQ(numbers<std::int64_t>(vtu, "\"offsets\""), (std::vector<std::int64_t>{1, 2, 3}));
  EXPECT_EQ(numbers<std::uint8_t>(vtu, "\"types\""), (std::vector<std::uint8_t>{1, 1, 1}));
  EXPECT_EQ(attribute(vtu, "<VTKFile", "header_type"), "UInt64");
}

TEST_F(Fields, SeriesListsItsFilesInOrder) {
  FieldSeries series(folder, "sand", "origin", point_quantities(solver::Setup{}));
  series.add(0.2, 0.20001, now, start);
  series.add(0.35, 0.35002, now, start);
  const std::string pvd = bytes_of(series.file());
  EXPECT_EQ(attribute(pvd, "0.20001", "file"), "sand-0.2m.vtu");
  EXPECT_EQ(attribute(pvd, "0.35002", "file"), "sand-0.35m.vtu");
  EXPECT_TRUE(std::filesystem::exists(folder / "sand-0.35m.vtu"));
  EXPECT_EQ(series.size(), 2U);
}

TEST_F(Fields, AreReadBackToTheSameBits) {
  now[0].h_0 = std::numeric_limits<double>::quiet_NaN();
  FieldSeries series(folder, "sand", "settings <a--b>", point_quantities(solver::Setup{}));
  series.add(0.2, 0.20000000000000004, now, start);
  series.add(0.35, 0.35002, start, start);
  const std::vector<VtkFrame> frames = read_pvd(series.file());
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0].time, 0.20000000000000004);
  EXPECT_EQ(frames[1].file, "sand-0.35m.vtu");

  const VtkPoints points = read_vtu(folder / frames[0].file);
  EXPECT_NE(points.comment.find("tip at 0.20000000000000004 m"), std::string::npos) << points.comment;
  EXPECT_EQ(points.ids, (std::vector<std::int64_t>{3, 8, 9}));
  EXPECT_EQ(points.positions,
            (std::vector<double>{0.1, -0.2, 0, 0.2 + 0.004, -0.3 - 0.003, 0, 0.3, -0.4, 0}));
  ASSERT_NE(find_array(points, "stress_Pa"), nullptr);
  EXPECT_EQ(find_array(points, "stress_Pa")->components, 6U);
  EXPECT_EQ(find_array(points, "stress_Pa")->component_names[3], "rz");
  EXPECT_EQ(find_array(points, "stress_Pa")->values[7], -16e3);
  EXPECT_EQ(find_array(points, "void_ratio")->values[1], 0.75);
  EXPECT_TRUE(std::isnan(find_array(points, "p_i_Pa")->values[0]));
  EXPECT_EQ(find_array(points, "pressure"), nullptr);
}

TEST_F(Fields, DamagedFilesAreNamed) {
  FieldSeries series(folder, "sand", "origin", point_quantities(solver::Setup{}));
  series.add(0.2, 0.2, now, start);
  const std::filesystem::path good = folder / "sand-0.2m.vtu", bad = folder / "bad.vtu";
  const std::string whole = bytes_of(good);
  const auto refused = [&](const std::string& content) {
    std::ofstream(bad, std::ios::binary) << content;
    try {
      (void)read_vtu(bad);
      return std::string();
    } catch (const Error& error) {
      return std::string(error.what());
    }
  };
  EXPECT_EQ(refused(whole), "");
  for (const std::string& content :
       {std::string(), std::string("<a></b>"), whole.substr(0, 300), whole.substr(0, whole.size() / 2),
        "x" + whole, std::string(whole).replace(whole.find("Points=\"3\""), 10, "Points=\"4\"")})
    EXPECT_NE(refused(content).find("bad.vtu"), std::string::npos) << content.substr(0, 80);
  EXPECT_THROW((void)read_vtu(folder / "missing.vtu"), Error);
  EXPECT_THROW((void)read_pvd(good), Error);
  EXPECT_THROW((void)read_pvd(folder), Error);
}

TEST_F(Fields, UnwritablePlaceIsNamed) {
  std::ofstream(folder / "file") << "no folder";
  try {
    FieldSeries(folder / "file" / "fields", "sand", "origin", point_quantities(solver::Setup{}));
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("fields"), std::string::npos) << error.what();
  }
  FieldSeries series(folder / "fields", "sand", "origin", point_quantities(solver::Setup{}));
  std::filesystem::create_directories(folder / "fields" / "sand-0.2m.vtu");
  EXPECT_THROW(series.add(0.2, 0.2, now, start), Error);
}

}  // namespace
}  // namespace cpt::results
