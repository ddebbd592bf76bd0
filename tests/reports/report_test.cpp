#include "reports/report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

#include "drawing/text.hpp"
#include "reports/supplement.hpp"
#include "tests/reports/made_up_campaigns.hpp"

namespace cpt::reports {
namespace {

namespace fs = std::filesystem;

class Report : public ::testing::Test {
 protected:
  Report() {
    std::string name = (fs::temp_directory_path() / "cpt_report_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no scratch folder");
    folder = name;
  }
  ~Report() override { fs::remove_all(folder); }

  static std::string read(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  static std::size_t lines(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  }
  static bool has(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
  }
  static int png_width(const fs::path& file) {
    const std::string bytes = read(file);
    int value = 0;
    for (int i = 16; i < 20; ++i) value = value * 256 + static_cast<unsigned char>(bytes.at(i));
    return value;
  }
  fs::path folder;
};

TEST_F(Report, WritesEveryFileItNames) {
  const auto campaign = run_made_up(layered_study(folder));
  const auto files = write_report(campaign, folder / "report");
  ASSERT_EQ(files.size(), 1u + 2u * (2u * 2u + 2u) + 6u);
  for (const fs::path& file : files) EXPECT_GT(fs::file_size(file), 100u) << file;
  EXPECT_TRUE(read(folder / "report" / "tornado_embedded_sand.png").starts_with("\x89PNG"));
  EXPECT_NEAR(png_width(folder / "report" / "profiles.png"),
              drawing::width_of(drawing::Column::one_and_half) / 72.0 * 300.0, 1.0);
}

TEST_F(Report, PdfHasEveryFigureAtColumnWidthWithLegibleType) {
  const auto campaign = run_made_up(layered_study(folder), {{5, "crashed"}});
  write_report(campaign, folder / "report");
  const std::string pdf = read(folder / "report" / "report.pdf");
  EXPECT_TRUE(pdf.starts_with("%PDF-1."));
  const auto figures = campaign_figures(campaign);
  const auto pages = supplement(campaign, figures);
  EXPECT_TRUE(has(pdf, "/Count " + std::to_string(pages.size()))) << pages.size();
  std::size_t drawn = 0;
  for (const auto& page : pages) drawn += page.size() - 1;
  EXPECT_EQ(drawn, static_cast<std::size_t>(std::count_if(figures.begin(), figures.end(),
                                                          [](const auto& f) { return f.svg.has_value(); })));
  const std::regex size("font-size=\"([0-9.]+)\""), view("viewBox=\"0 0 ([0-9.]+) ([0-9.]+)\"");
  for (const auto& page : pages)
    for (const auto& part : page) {
      std::smatch box;
      ASSERT_TRUE(std::regex_search(part.svg, box, view));
      const double scale =
          std::min(part.place.width / std::stod(box[1]), part.place.height / std::stod(box[2]));
      const bool is_figure = part.place.width < 594.0;
      if (is_figure) {
        EXPECT_NEAR(scale * std::stod(box[1]), 190.0 / 25.4 * 72.0, 1.0);
      }
      for (std::sregex_iterator it(part.svg.begin(), part.svg.end(), size), end; it != end; ++it)
        EXPECT_GE(scale * std::stod((*it)[1]), 5.4) << it->str();  // subscripts; ordinary type from 7.5 pt
    }
}

TEST_F(Report, NumbersAgreeWithTheDatabase) {
  const auto campaign = run_made_up(sand_study(folder));
  write_report(campaign, folder / "report");
  EXPECT_EQ(lines(read(folder / "report" / "sensitivity.csv")), 1u + campaign.sensitivity.size());
  EXPECT_EQ(lines(read(folder / "report" / "realizations.csv")), 22u);
  EXPECT_EQ(lines(read(folder / "report" / "window_means.csv")), 22u);
  EXPECT_EQ(lines(read(folder / "report" / "curves.csv")),
            1u + 21u * campaign.curves[0].profile.depth.size());
  const std::string json = read(folder / "report" / "report.json");
  EXPECT_TRUE(has(json, "\"parameter\": \"sand.H\""));
  EXPECT_TRUE(has(json, "\"solver_version\""));
}

// What the supplement says of noise and audit, against the numbers.
TEST_F(Report, SupplementsSentencesAgreeWithTheNumbers) {
  auto study = sand_study(folder);
  add_repeats(study, 4);
  auto campaign = run_made_up(study);
  const auto words = [&] {
    std::string all;
    for (const auto& page : supplement(campaign, {})) all += page.front().svg;
    // What one line of type breaks is one text again.
    return std::regex_replace(all, std::regex("<[^>]*>|\\s+"), " ");
  };
  const auto flat = [](const std::string& text) { return std::regex_replace(text, std::regex(" +"), " "); };
  std::size_t paper = 0;
  for (const auto& row : campaign.sensitivity) paper += row.above_si_noise == true ? 1 : 0;
  std::string text = flat(words());
  EXPECT_TRUE(has(text, "from 5 runs of the baseline")) << text;
  EXPECT_TRUE(has(text, "Above the noise of the repeats: "));
  EXPECT_TRUE(has(text, "definition, " + std::to_string(paper) + " would be."));
  EXPECT_FALSE(has(text, "Runs out of line"));
  EXPECT_FALSE(has(text, "so far"));
  for (auto& row : campaign.sensitivity) row.above_noise = false;
  std::ranges::find(campaign.realizations, "repeat", &results::RealizationRow::side)->status = "pending";
  EXPECT_TRUE(has(flat(words()), "points, 3 of 4 repeats so far, which scatter"));
  campaign.realizations[2].out_of_line = "energy error -18 %";
  campaign.realizations[2].audit.energy_error = -0.18;
  text = flat(words());
  EXPECT_TRUE(has(text, "No input is above the noise of the repeats."));
  EXPECT_TRUE(has(text, "Runs out of line"));
  EXPECT_TRUE(has(text, "energy error -18 %"));
}

TEST_F(Report, UnfinishedCampaignSaysSoWithItsFailures) {
  const auto campaign = run_made_up(sand_study(folder), {{5, "crashed"}, {6, "pending"}});
  write_report(campaign, folder / "report");
  const std::string page = read(folder / "report" / "index.html");
  EXPECT_TRUE(has(page, "19 of 21 realizations completed, 1 failed, 1 still to run"));
  EXPECT_TRUE(has(page, "energy error 0.31 at 0.212 m exceeds 0.1"));
}

TEST_F(Report, CampaignWithoutResultsStillHasAPageAndNoStaleFigure) {
  const auto complete = run_made_up(sand_study(folder));
  write_report(complete, folder / "report");
  ASSERT_TRUE(fs::exists(folder / "report" / "profiles.png"));
  auto empty = complete;
  empty.curves.clear();
  empty.window_means.clear();
  empty.sensitivity.clear();
  const auto files = write_report(empty, folder / "report");
  EXPECT_EQ(files.size(), 7u);
  EXPECT_FALSE(fs::exists(folder / "report" / "profiles.png"));
  EXPECT_FALSE(fs::exists(folder / "report" / "tornado_deep_sand.svg"));
}

TEST_F(Report, HostileNamesStayText) {
  auto study = sand_study(folder);
  study.title = "<script>alert('x')</script> & \"more\"";
  study.windows[0].name = "../../<img src=x onerror=alert(1)>";
  study.windows.push_back(study.windows[0]);
  study.windows[1].name = "..-..-<img src=x onerror=alert(1)>";
  const auto campaign = run_made_up(study, {{3, "crashed"}});
  const auto files = write_report(campaign, folder / "report");
  for (const fs::path& file : files) EXPECT_EQ(file.parent_path(), folder / "report") << file;
  for (const fs::path& file : files) {
    if (file.extension() != ".svg" && file.extension() != ".html") continue;
    const std::string text = read(file);
    EXPECT_FALSE(has(text, "<script>alert")) << file;
    EXPECT_FALSE(has(text, "<img")) << file;
  }
}

TEST_F(Report, WindowsWithTheSameFileNameAreKeptApart) {
  auto study = sand_study(folder);
  study.windows.push_back(study.windows[0]);
  study.windows[0].name = "a b";
  study.windows[1].name = "a/b";
  write_report(run_made_up(study), folder / "report");
  EXPECT_TRUE(fs::exists(folder / "report" / "tornado_a_b.svg"));
  EXPECT_TRUE(fs::exists(folder / "report" / "tornado_a_b-2.svg"));
}

TEST_F(Report, SameDatabaseGivesTheSameBytes) {
  const auto campaign = run_made_up(clay_study(folder));
  const auto first = write_report(campaign, folder / "one");
  const auto second = write_report(campaign, folder / "two");
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(read(first[i]), read(second[i])) << first[i];
}

TEST_F(Report, ShowsWhatTheDesignSays) {
  for (const char* design : {"kind = \"pairs\"", "kind = \"morris\"\ntrajectories = 4",
                             "kind = \"latin_hypercube\"\nruns = 40", "kind = \"sobol\"\nruns = 16"}) {
    const auto campaign = run_made_up_design(folder / "study.toml", design);
    write_report(campaign, folder / "report");
    const std::string svg = read(folder / "report" / "effects_deep.svg");
    EXPECT_TRUE(has(svg, ">H<") && has(svg, ">wall<")) << design;
    EXPECT_FALSE(has(svg, "nan")) << design;
    EXPECT_TRUE(fs::exists(folder / "report" / "effects_deep.png"));
    auto effects = results::design_effects(campaign);
    EXPECT_EQ(lines(read(folder / "report" / "effects.csv")), 1u + effects.rows.size()) << design;
    results::add_index_convergence(campaign, effects);
    const fs::path steps = folder / "report" / "convergence_deep.svg",
                   numbers = folder / "report" / "convergence.csv";
    EXPECT_EQ(fs::exists(steps), effects.design != "pairs");
    EXPECT_EQ(fs::exists(numbers), effects.design != "pairs");
    if (effects.design != "pairs") {
      EXPECT_TRUE(has(read(steps), ">H<") && has(read(steps), "runs with results that were used")) << design;
      EXPECT_FALSE(has(read(steps), "nan")) << design;
      EXPECT_EQ(lines(read(numbers)), 1u + effects.index_convergence.size()) << design;
    }
    EXPECT_TRUE(has(read(folder / "report" / "report.json"), "\"design\": \"" + effects.design + "\""));
    fs::remove_all(folder / "report");
    fs::remove(folder / "study.sqlite");
  }
}

// A point of the study that is called like its runs is none of them.
TEST_F(Report, ShowsHowAPropagationIsDistributed) {
  const auto campaign = run_made_up_design(
      folder / "study.toml",
      "kind = \"propagation\"\nruns = 40\n[[points]]\nname = \"propagation by hand\"\nsand.H = 60");
  write_report(campaign, folder / "report");
  const std::string svg = read(folder / "report" / "effects_deep.svg");
  const auto effects = results::design_effects(campaign);
  const auto mean = std::ranges::find(effects.rows, "mean", &results::EffectRow::quantity);
  EXPECT_EQ(mean->used, 36);  // every tenth run fails
  EXPECT_TRUE(has(svg, "36 runs: mean " + drawing::number(mean->value, 4) + " ± "));
  EXPECT_TRUE(has(svg, "share of the runs (%)"));
  EXPECT_FALSE(has(svg, "nan"));
  EXPECT_EQ(lines(read(folder / "report" / "effects.csv")), 1u + effects.rows.size());
  EXPECT_EQ(lines(read(folder / "report" / "bands.csv")), 1u + effects.bands.size());
  const std::string bands = read(folder / "report" / "bands_q_c.svg");
  EXPECT_TRUE(has(bands, "36 runs; each depth stands alone"));
  EXPECT_TRUE(has(bands, "5 to 95 %"));
  EXPECT_FALSE(has(bands, "nan"));
  const std::string convergence = read(folder / "report" / "convergence_deep.svg");
  EXPECT_TRUE(has(convergence, "95 % quantile"));
  EXPECT_FALSE(has(convergence, "nan"));
}

TEST_F(Report, PdfCutsNoNoteReasonOrTitle) {
  const std::string words =
      "negative: q_c is larger at the lower bound; noise undefined: only the average of the baseline was "
      "imported, and aVeryLongWordWithoutAnyBlankInItThatIsWiderThanTheColumnItStandsInSoThatItMustBeBroken";
  auto campaign = run_made_up(sand_study(folder), {{5, "crashed"}});
  campaign.campaign.title = "A title that is longer than a line of the page is wide: " + words;
  campaign.sensitivity[0].note = words;
  campaign.realizations[4].reason = words;
  std::string letters;  // of all pages, without blanks and line ends
  const std::regex text(">([^<>]+)</t(?:ext|span)>");
  for (const auto& page : supplement(campaign, {}))
    for (std::sregex_iterator it(page[0].svg.begin(), page[0].svg.end(), text), end; it != end; ++it)
      for (const char c : (*it)[1].str())
        if (c != ' ') letters += c;
  std::string wanted = words;
  std::erase(wanted, ' ');
  std::size_t found = 0;
  for (std::size_t at = 0; (at = letters.find(wanted, at)) != std::string::npos; ++at) ++found;
  EXPECT_EQ(found, 3U) << letters;
  EXPECT_FALSE(has(letters, "…"));
}

TEST_F(Report, UnwritableFolderIsNamed) {
  const auto campaign = run_made_up(clay_study(folder));
  std::ofstream(folder / "file") << "in the way";
  try {
    write_report(campaign, folder / "file" / "report");
    FAIL();
  } catch (const results::Error& error) {
    EXPECT_TRUE(has(error.what(), "report"));
  }
}

}  // namespace
}  // namespace cpt::reports
