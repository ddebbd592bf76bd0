#include "validation/paper/page.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <sstream>

#include "drawing/markdown.hpp"
#include "tests/validation/paper/paper_campaigns.hpp"
#include "validation/paper/figures.hpp"
#include "validation/paper/index_tables.hpp"
#include "validation/paper/write_paper.hpp"

namespace cpt::validation::paper {
namespace {

namespace fs = std::filesystem;
using reports::NamedFigure;

std::string read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

bool has(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

TEST(Markdown, BarsInCellsDoNotMakeColumns) {
  EXPECT_EQ(drawing::table_line({"|SI|", "a\nb"}), "| \\|SI\\| | a b |\n");
  EXPECT_EQ(drawing::table_head({"a", "b"}), "| a | b |\n| --- | --- |\n");
}

TEST(PaperPage, LinksOnlyFilesThatAreThere) {
  const PaperCampaigns campaigns;
  Studies studies = campaigns.studies();
  std::erase_if(studies, [](const auto& study) {
    return study.first != clay_study && study.first != dense_rigid_study;
  });
  const auto files = write_paper({studies, {}}, {}, campaigns.folder() / "out.md");
  const std::string text = read(campaigns.folder() / "out.md");
  EXPECT_EQ(files.front(), campaigns.folder() / "out.md");
  std::size_t links = 0;
  for (auto at = text.find("]("); at != std::string::npos; at = text.find("](", at + 1)) {
    const fs::path link = campaigns.folder() / text.substr(at + 2, text.find(')', at) - at - 2);
    EXPECT_TRUE(fs::exists(link)) << link;
    EXPECT_TRUE(fs::exists(fs::path(link).replace_extension(".png"))) << link;
    ++links;
  }
  EXPECT_EQ(links, 4u + 4u + 4u + 2u);  // soil, two studies, the comparisons of the dense sand with itself
  EXPECT_EQ(files.size(), 1u + 2u * links);
}

TEST(PaperPage, TablesHaveAsManyCellsAsColumns) {
  const PaperCampaigns campaigns({{sand_study, {{13, "crashed"}, {14, "pending"}}}});
  const Runs runs{campaigns.studies(), {}};
  std::istringstream stream(page(runs, {}, {}, &runs));
  std::size_t columns = 0;
  int tables = 0;
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with("|")) {
      columns = 0;
      continue;
    }
    std::size_t cells = 0;
    for (std::size_t i = 1; i < line.size(); ++i)
      if (line[i] == '|' && line[i - 1] != '\\') ++cells;
    if (columns == 0) {
      columns = cells;
      ++tables;
    }
    EXPECT_EQ(cells, columns) << line;
  }
  EXPECT_EQ(tables, 4 + 8 + 1 + 2);  // findings, indices by study and window, what the text lacks, runs
}

TEST(PaperPage, SaysWhatWasRunAndAtWhichPreset) {
  const PaperCampaigns campaigns;
  Studies studies = campaigns.studies();
  studies.erase(studies.find(layered_study));
  const std::string text = page({studies, {}}, {}, {});
  EXPECT_TRUE(has(text, "| homogeneous_sand | quick | 21 of 21 realizations completed |"));
  EXPECT_TRUE(has(text, "| layered |  | not run |"));
  EXPECT_TRUE(has(text, "at another resolution than the paper's"));
  EXPECT_TRUE(has(text, "8542 kPa"));
  EXPECT_TRUE(has(text, "1: by far the parameter dominating"));
  EXPECT_FALSE(has(text, "nan"));
}

TEST(PaperPage, OtherRunsHaveColumnsOfTheirOwn) {
  const PaperCampaigns campaigns;
  const Runs runs{campaigns.studies(), {}};
  Runs other = runs;
  for (auto& [name, study] : other.studies) study.campaign.preset = "standard";
  results::Snapshot& clay = other.studies.find(clay_study)->second;
  for (results::WindowMeanRow& mean : clay.window_means)
    if (mean.realization == 1) mean.q_c_mean_kPa = 777.0;
  for (results::SensitivityRow& row : clay.sensitivity)
    if (row.parameter == "clay.G_kPa") row.si = 0.123;
  const std::string text = page(runs, {}, {}, &other);
  EXPECT_TRUE(has(text, "| # | what | paper | § | ours, quick | beside, standard | check | verdict |"));
  const std::string row = text.substr(text.find("| C1 |"), 300);
  EXPECT_TRUE(has(row.substr(0, row.find('\n')), "| 777.0 kPa (+194.3 %), **differs** | level")) << row;
  EXPECT_TRUE(has(text, "| SI | SI beside, standard | above noise |"));
  EXPECT_TRUE(has(text, " | 0.123 | yes | 1: dominate |"));
}

TEST(PaperPage, AFolderWithoutCampaignsIsAnError) {
  EXPECT_THROW((void)read_studies(fs::temp_directory_path() / "no-such-folder"), results::Error);
}

TEST(IndexInterval, ComesFromTheCurvesOfHomogeneousSoilOnly) {
  const PaperCampaigns campaigns;
  const Studies studies = campaigns.studies();
  const auto interval = index_interval(studies.find(sand_study)->second, "sand", "sand.H");
  ASSERT_TRUE(interval);
  EXPECT_FALSE(interval->from_repeats);
  EXPECT_GT(interval->half_width, 0.0);
  EXPECT_LT(interval->half_width, 0.02);  // bins scatter by about 1 %, averages over 40 by much less
  EXPECT_FALSE(index_interval(studies.find(layered_study)->second, "embedded_sand", "sand.H"));
  EXPECT_FALSE(index_interval(studies.find(dense_rigid_study)->second, "whole", "sand.D_r_percent"));
}

// One kind of interval: where the baseline was repeated, the row's own, in layered soil too; and the table
// says of which kind they are.
TEST(IndexInterval, IsThatOfTheRepeatsWhereThereAreSome) {
  const PaperCampaigns campaigns;
  Runs runs{campaigns.studies(), {}};
  EXPECT_TRUE(has(page(runs, {}, {}), "intervals by batch means"));
  EXPECT_FALSE(has(page(runs, {}, {}), "which gives the 95 % intervals"));
  for (auto& [name, study] : runs.studies)
    for (results::SensitivityRow& row : study.sensitivity) {
      row.si_half_width = 0.0625;
      row.above_si_noise = false;
      if (row.parameter == "sand.H") row.note = "upper run out of line: energy error -18 %";
    }
  results::Snapshot& sand = runs.studies.find(sand_study)->second;
  sand.repeat_noise.push_back({"sand", 7, 4000.0, 40.0, 0.0346});
  for (const std::string_view study : {sand_study, layered_study}) {
    const auto& snapshot = runs.studies.find(study)->second;
    const auto interval = index_interval(snapshot, snapshot.windows.front().name, "sand.H");
    ASSERT_TRUE(interval) << study;
    EXPECT_TRUE(interval->from_repeats);
    EXPECT_EQ(interval->half_width, 0.0625);
  }
  const std::string text = page(runs, {}, {});
  EXPECT_TRUE(
      has(text,
          "7 runs of the baseline with shifted material points average 4000 kPa and scatter by "
          "40.0 kPa, which gives the 95 % intervals and says what is noise: ±0.035 for an index near 0."));
  EXPECT_TRUE(has(text, " ± 0.062 | "));
  EXPECT_TRUE(has(text, "- H: upper run out of line: energy error -18 %"));
  EXPECT_TRUE(has(text, "| above noise | above SI<sub>noise</sub> (the paper's) |"));
}

TEST(PaperFigures, ChamberFiguresNeedTwoCurves) {
  const PaperCampaigns campaigns;
  Studies studies = campaigns.studies();
  for (const NamedFigure& figure : chamber_figures(studies)) {
    ASSERT_TRUE(figure.svg) << figure.name;
    EXPECT_FALSE(has(*figure.svg, "nan")) << figure.name;
  }
  EXPECT_TRUE(has(*chamber_figures(studies)[0].svg, "flexible, "));
  std::erase_if(studies, [](const auto& study) { return study.first != second_push_study; });
  EXPECT_FALSE(chamber_figures(studies)[0].svg);
}

TEST(PaperFigures, SoilFiguresShowTheirCurves) {
  const auto figures = soil_figures();
  ASSERT_EQ(figures.size(), 4u);
  const std::size_t curves[] = {6, 18 * 3, 3, 3};
  for (std::size_t i = 0; i < figures.size(); ++i) {
    ASSERT_TRUE(figures[i].svg);
    EXPECT_FALSE(has(*figures[i].svg, "nan")) << figures[i].name;
    std::size_t lines = 0;
    for (auto at = figures[i].svg->find("<path"); at != std::string::npos;
         at = figures[i].svg->find("<path", at + 1))
      ++lines;
    EXPECT_EQ(lines, curves[i]) << figures[i].name;
  }
}

}  // namespace
}  // namespace cpt::validation::paper
