// campaign view from the command line: the fields of a push of a few millimetres, drawn.
#include <gtest/gtest.h>

#include "tests/cli/program.hpp"

namespace cpt::tests {
namespace {

namespace fs = std::filesystem;

void expect_has(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in:\n" << text;
}

// The push is run once for all tests.
class View : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = new StudyFolder;
    const Result result = run(campaign({"push", folder->study(), "--fields-every", "0.002", "--set",
                                        "penetrometer.final_depth_m=0.026", "--out", folder->file("out")}));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    expect_has(result.out, "fields at 4 depth(s)");  // the start at 21.9 mm, then 22, 24 and 26 mm
  }
  static void TearDownTestSuite() { delete folder; }
  static Result view(std::vector<std::string> more) {
    more.insert(more.begin(), {"view", folder->file("out")});
    return run(campaign(more));
  }
  static int count(const std::string& name, const std::string& ending) {
    int files = 0;
    for (const auto& entry : fs::directory_iterator(folder->file(name)))
      files += entry.path().extension() == ending;
    return files;
  }
  // [pixels] of a PNG, which has its width at byte 16.
  static int width_of(const std::string& name) {
    const std::string png = folder->read(name);
    return png.size() < 24 ? 0
                           : static_cast<unsigned char>(png[18]) * 256 + static_cast<unsigned char>(png[19]);
  }
  static inline StudyFolder* folder = nullptr;
};

TEST_F(View, DrawsOneFrameADepthAndAnAnimation) {
  const Result result = view({});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  expect_has(result.out, "4 frame(s)");
  expect_has(result.out, "displacement: 0 to");
  EXPECT_EQ(count("out/small-view", ".png"), 4);
  EXPECT_EQ(width_of("out/small-view/small-0.024m.png"), 1000);
  EXPECT_TRUE(folder->read("out/small-view/small-view.gif").starts_with("GIF89a"));
}

TEST_F(View, TakesQuantitiesRangesSizeAndNumberOfFrames) {
  const Result result =
      view({"--whole", "--show", "p,void_ratio", "--show", "q", "--range", "p=1,2000", "--width", "700",
            "--frames", "2", "--grid", "0", "--seconds", "0.5", "--out", folder->file("drawn/here")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  expect_has(result.out, "p: 1 to 2000 kPa, logarithmic");
  EXPECT_EQ(count("drawn/here", ".png"), 2);
  EXPECT_EQ(width_of("drawn/here/small-0m.png"), 700);
  EXPECT_EQ(width_of("drawn/here/small-0.026m.png"), 700) << "the first and the last";
}

TEST_F(View, OneFrameIsNoAnimation) {
  const Result result = view({"--frames", "1", "--around", "0.08m", "--out", folder->file("one")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(count("one", ".png"), 1);
  EXPECT_EQ(count("one", ".gif"), 0);
}

TEST_F(View, SameFieldsSamePictures) {
  ASSERT_EQ(view({"--frames", "2", "--out", folder->file("a")}).exit_code, 0);
  ASSERT_EQ(run(campaign({"view", folder->file("out/small-fields/small.pvd"), "--frames", "2", "--out",
                          folder->file("b")}))
                .exit_code,
            0);
  for (const char* file : {"small-0m.png", "small-0.026m.png", "small-view.gif"})
    EXPECT_EQ(folder->read(std::string("a/") + file), folder->read(std::string("b/") + file)) << file;
}

TEST_F(View, BadInputIsExitCode2AndSaysWhatIsValid) {
  const auto refused = [](std::vector<std::string> more, const std::string& why) {
    const Result result = view(std::move(more));
    EXPECT_EQ(result.exit_code, 2);
    expect_has(result.err, why);
  };
  refused({"--show", "voidratio"},
          "did you mean void_ratio?; there are void_ratio, void_ratio_change, p, q,");
  refused({"--show", "p,q,p_i,sigma_r,sigma_v"}, "1 to 4 fit");
  refused({"--range", "p"}, "QUANTITY=LOW,HIGH");
  refused({"--range", "p=10"}, "LOW,HIGH");
  refused({"--range", "p=0,10"}, "logarithmic");
  refused({"--range", "displacement=3,2"}, "the smaller one");
  refused({"--range", "void_ratio_change=-0.1,0.2"}, "e.g. void_ratio_change=-0.2,0.2");
  refused({"--range", "q=1,10"}, "not shown");
  refused({"--around", "0.4"}, "1 to 17.79 cone diameters");
  refused({"--around", "2m"}, "0.0253m to 0.45m");
  refused({"--around", "x"}, "not a number");
  refused({"--around", "3", "--whole"}, "--whole");
  refused({"--width", "100"}, "400 to 4000");
  refused({"--grid", "-1"}, "0 (no grid)");
  refused({"--seconds", "0"}, "0.02 to 60");
  refused({"--frames", "0"}, "--frames");
}

TEST(ViewOfNothing, IsExitCode6) {
  const StudyFolder folder;
  const Result nowhere = run(campaign({"view", folder.file("nowhere")}));
  EXPECT_EQ(nowhere.exit_code, 6);
  expect_has(nowhere.err, "there is no such folder or file");
  fs::create_directories(folder.file("empty"));
  const Result empty = run(campaign({"view", folder.file("empty")}));
  EXPECT_EQ(empty.exit_code, 6);
  expect_has(empty.err, "no fields are stored here; campaign push STUDY --fields-every");
}

TEST(FieldsEvery, MustFitThePush) {
  const StudyFolder folder;
  const Result result = run(campaign({"push", folder.study(), "--fields-every", "2"}));
  EXPECT_EQ(result.exit_code, 2);
  expect_has(result.err, "--fields-every 2: must be 0.0001 to 0.53 m");
}

}  // namespace
}  // namespace cpt::tests
