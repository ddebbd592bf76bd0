#include "validation/paper/write_paper.hpp"

#include "reports/figure_files.hpp"
#include "validation/paper/figures.hpp"
#include "validation/paper/page.hpp"

namespace cpt::validation::paper {

using reports::campaign_figures, reports::make_directory, reports::NamedFigure, reports::write_figure,
    reports::write_text;

std::vector<std::filesystem::path> write_paper(const Runs& runs, const std::vector<Cause>& causes,
                                               const std::filesystem::path& page_file, const Runs* beside) {
  const std::filesystem::path name = page_file.stem();
  const std::filesystem::path folder_of_figures = page_file.parent_path() / name;
  std::vector<std::filesystem::path> files = {page_file};
  std::vector<FigureGroup> groups;
  const auto write = [&](std::string title, const std::string& folder,
                         const std::vector<NamedFigure>& figures) {
    make_directory(folder_of_figures / folder);
    FigureGroup group{std::move(title), {}};
    for (const NamedFigure& figure : figures) {
      for (const std::filesystem::path& file : write_figure(figure, folder_of_figures / folder))
        files.push_back(file);
      if (figure.svg)
        group.figures.push_back({(name / folder / (figure.name + ".svg")).generic_string(), figure.caption});
    }
    groups.push_back(std::move(group));
  };
  write("Sand in the laboratory", "soil", soil_figures());
  for (const std::string_view study : study_names())
    if (const auto found = runs.studies.find(study); found != runs.studies.end())
      write(found->second.campaign.title, std::string(study), campaign_figures(found->second));
  std::vector<NamedFigure> chamber = chamber_figures(runs.studies);
  for (NamedFigure& figure : push_figures(runs.pushes)) chamber.push_back(std::move(figure));
  write("Walls, second push, void ratio", "chamber", chamber);
  write_text(page_file, page(runs, causes, groups, beside));
  return files;
}

}  // namespace cpt::validation::paper
