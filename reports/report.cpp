#include "reports/report.hpp"

#include "reports/figure_files.hpp"
#include "reports/numbers.hpp"
#include "reports/picture_files.hpp"
#include "reports/supplement.hpp"
#include "results/tables/output_names.hpp"

namespace cpt::reports {

std::vector<std::filesystem::path> write_report(const results::Snapshot& campaign,
                                                const std::filesystem::path& directory, PageContext context,
                                                drawing::Column column) {
  make_directory(directory);
  std::vector<std::filesystem::path> files = {directory / "index.html"};
  context.effects = results::design_effects(campaign);
  results::add_index_convergence(campaign, context.effects);
  for (const NamedFigure& figure : campaign_figures(campaign, context.effects, column))
    for (const std::filesystem::path& file : write_figure(figure, directory)) files.push_back(file);

  const auto table = [&](const char* name, const results::Table& numbers) {
    files.push_back(directory / name);
    write_text(files.back(),
               results::format(results::named_for_outputs(numbers, campaign), results::Format::csv));
  };
  table("sensitivity.csv", sensitivity_table(campaign));
  table("realizations.csv", realization_table(campaign));
  table("window_means.csv", window_mean_table(campaign));
  table("curves.csv", curve_table(campaign));
  if (!context.effects.rows.empty()) table("effects.csv", results::effects_table(context.effects));
  if (!context.effects.bands.empty()) table("bands.csv", results::bands_table(context.effects));
  if (!context.effects.index_convergence.empty())
    table("convergence.csv", results::index_convergence_table(context.effects));
  files.push_back(directory / "report.json");
  write_text(files.back(), report_json(campaign, context.effects, Names::shown));
  files.push_back(directory / "report.pdf");
  write_pdf(supplement(campaign, campaign_figures(campaign, context.effects), context.effects, context.notes),
            campaign.campaign.title, campaign.campaign.created, files.back());
  for (auto file = files.begin() + 1; file != files.end(); ++file)
    context.files.push_back(file->filename().string());
  write_text(files.front(), page(campaign, context));
  return files;
}

std::filesystem::path write_page(const results::Snapshot& campaign, const std::filesystem::path& directory,
                                 PageContext context) {
  make_directory(directory);
  context.effects = results::design_effects(campaign);
  results::add_index_convergence(campaign, context.effects);
  const std::filesystem::path file = directory / "index.html";
  write_text(file, page(campaign, context));
  return file;
}

}  // namespace cpt::reports
