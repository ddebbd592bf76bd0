#include "reports/calibration/write_calibration.hpp"

#include "reports/calibration/figures.hpp"
#include "reports/calibration/posterior_study.hpp"
#include "reports/calibration/tables.hpp"
#include "reports/figure_files.hpp"

namespace cpt::reports::calibrated {
namespace {

namespace fs = std::filesystem;

fs::path add_table(const fs::path& file, const results::Table& table) {
  results::write_csv(file, table);
  return file;
}

void add_figure(const NamedFigure& figure, const fs::path& folder, std::vector<fs::path>& files) {
  for (const fs::path& file : write_figure(figure, folder)) files.push_back(file);
}

}  // namespace

std::vector<fs::path> write_calibration(const CalibrationReport& report, const fs::path& folder) {
  make_directory(folder);
  std::vector<fs::path> files = {add_table(folder / "posterior.csv", posterior_table(report)),
                                 add_table(folder / "draws.csv", draws_table(report)),
                                 add_table(folder / "correlation.csv", correlation_table(report)),
                                 add_table(folder / "bands.csv", bands_table(report)),
                                 folder / "posterior.toml"};
  write_text(files.back(), posterior_study(report));
  add_figure({"marginals", "Each unknown before and after the recordings.", marginals_figure(report)}, folder,
             files);
  add_figure({"bands", "Recording and simulation over depth, and the discrepancy.", bands_figure(report)},
             folder, files);
  return files;
}

std::vector<fs::path> write_rank_check(const RankReport& report, const fs::path& folder) {
  make_directory(folder);
  std::vector<fs::path> files = {add_table(folder / "uniformity.csv", uniformity_table(report)),
                                 add_table(folder / "ranks.csv", ranks_table(report))};
  add_figure({"ranks", "Ranks of the truths, less uniform ones.", ranks_figure(report)}, folder, files);
  return files;
}

}  // namespace cpt::reports::calibrated
