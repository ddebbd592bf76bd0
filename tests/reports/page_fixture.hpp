// The report's page in a headless Chromium, for tests of what it shows.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "reports/figure_files.hpp"
#include "reports/page.hpp"
#include "tests/reports/browser.hpp"
#include "tests/reports/made_up_campaigns.hpp"

namespace cpt::reports {

class Page : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!Browser::installed()) GTEST_SKIP() << "Debian's chromium is not installed";
    std::string name = (std::filesystem::temp_directory_path() / "cpt_page_XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder = name;
    browser.emplace(folder);
  }
  ~Page() override {
    browser.reset();
    std::error_code ignored;
    if (!folder.empty()) std::filesystem::remove_all(folder, ignored);
  }

  void TearDown() override {
    if (!browser) return;
    for (const char* word : {"null", "NaN", "[object"})
      EXPECT_EQ(value("document.getElementById('main').innerText").get<std::string>().find(word),
                std::string::npos)
          << word;
    for (const std::string& problem : browser->problems()) ADD_FAILURE() << problem;
  }

  void show(const results::Snapshot& campaign, const PageContext& context = {}) {
    write_text(folder / "page.html", page(campaign, context));
    browser->open(folder / "page.html");
  }
  nlohmann::json value(const std::string& expression) { return browser->value(expression); }
  std::string text(const std::string& selector) {
    return value("document.querySelector(" + nlohmann::json(selector).dump() + ").textContent");
  }
  int count(const std::string& selector) {
    return value("document.querySelectorAll(" + nlohmann::json(selector).dump() + ").length");
  }
  /// Where a realization's curve is at a depth, in the window.
  Browser::At on_curve(int id, double depth) {
    browser->run(
        "document.getElementById('profile-plot').scrollIntoView({block: 'center', behavior: 'instant'})");
    const nlohmann::json at =
        value("(() => { const path = document.querySelector('path.curve[data-id=\"" + std::to_string(id) +
              "\"]'), svg = path.ownerSVGElement, curve = curve_of.get(" + std::to_string(id) +
              "), depth = " + std::to_string(depth) + ";" +
              R"js(
           const p = new DOMPoint(svg.scale('x').apply(value_at(curve, depth)), svg.scale('y').apply(depth))
             .matrixTransform(svg.getScreenCTM());
           return [p.x, p.y]; })())js");
    return {at.at(0), at.at(1)};
  }
  nlohmann::json depths_shown() {
    return value("d3.extent(document.querySelector('#profile-plot svg').scale('y').domain)");
  }
  /// True once an expression is, within 5 min; over a change of page, too.
  bool eventually(const std::string& expression) {
    for (int k = 0; k < 3000; ++k) {
      try {
        if (value(expression) == true) return true;
      } catch (const std::runtime_error&) {
        // between two pages
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return false;
  }
  std::vector<int> rows() {
    return value("[...document.querySelectorAll('#table tbody tr')].map((row) => Number(row.dataset.id))");
  }

  std::filesystem::path folder;
  std::optional<Browser> browser;
};

}  // namespace cpt::reports
