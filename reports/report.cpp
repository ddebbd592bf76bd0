#include "reports/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <set>
#include <string>

#include "reports/figures.hpp"
#include "reports/labels.hpp"
#include "reports/numbers.hpp"
#include "reports/page.hpp"
#include "reports/png.hpp"

namespace cpt::reports {
namespace {

namespace fs = std::filesystem;

/// Part of a file name: letters and digits of ASCII, '_' for all else; numbered where two windows come out
/// equal.
std::string file_part(const std::string& name, std::set<std::string>& taken) {
  std::string part;
  for (const char c : name) {
    const bool keep = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
    if (keep || part.empty() || part.back() != '_') part += keep ? c : '_';
  }
  part.resize(std::min<std::size_t>(part.size(), 60));
  if (part.empty() || part == "_") part = "window";
  std::string unique = part;
  for (int k = 2; !taken.insert(unique).second; ++k) unique = fmt::format("{}-{}", part, k);
  return unique;
}

void write_text(const fs::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  if (!out) throw results::Error(file.string() + ": cannot be written");
}

}  // namespace

std::vector<fs::path> write_report(const results::Snapshot& campaign, const fs::path& directory) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error)
    throw results::Error(fmt::format("{}: cannot be made ({})", directory.string(), error.message()));

  std::vector<fs::path> files = {directory / "index.html"};
  std::vector<PageFigure> figures;
  const auto draw = [&](const std::string& name, const std::optional<std::string>& svg,
                        const std::string& caption) {
    for (const char* ending : {".svg", ".png"}) {
      const fs::path file = directory / (name + ending);
      if (svg)
        files.push_back(file);
      else
        fs::remove(file, error);  // left by a report that had more results
    }
    if (!svg) return;
    write_text(directory / (name + ".svg"), *svg);
    write_png(*svg, directory / (name + ".png"));
    figures.push_back({*svg, caption});
  };

  std::set<std::string> taken;
  for (const results::WindowRow& window : campaign.windows) {
    const std::string part = file_part(window.name, taken);
    draw("tornado_" + part, tornado_figure(campaign, window),
         fmt::format("Range of the average cone resistance in window {} between each input's lower and upper "
                     "bound, whose values "
                     "stand at the bar's ends.",
                     window.name));
    draw("sensitivity_" + part, sensitivity_figure(campaign, window),
         fmt::format(
             "Sensitivity index of each input in window {}; the dashed line is the noise of the baseline.",
             window.name));
  }
  draw("profiles", profiles_figure(campaign),
       "Cone resistance of all realizations; those furthest from the baseline in a window are told apart.");
  draw("baseline", baseline_figure(campaign),
       "Cone resistance of the baseline and the windows it is averaged in.");

  const auto table = [&](const char* name, const results::Table& numbers) {
    files.push_back(directory / name);
    write_text(files.back(), results::format(numbers, results::Format::csv));
  };
  table("sensitivity.csv", sensitivity_table(campaign));
  table("realizations.csv", realization_table(campaign));
  table("window_means.csv", window_mean_table(campaign));
  table("curves.csv", curve_table(campaign));
  files.push_back(directory / "report.json");
  write_text(files.back(), report_json(campaign));
  write_text(files.front(), page(campaign, figures));
  return files;
}

}  // namespace cpt::reports
