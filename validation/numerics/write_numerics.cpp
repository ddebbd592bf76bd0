#include "validation/numerics/write_numerics.hpp"

#include "reports/figure_files.hpp"
#include "validation/numerics/page.hpp"
#include "validation/numerics/settings_figure.hpp"

namespace cpt::validation::numerics {

std::vector<std::filesystem::path> write_numerics(const std::vector<NumericsStudy>& studies,
                                                  const std::filesystem::path& page_file) {
  const std::filesystem::path folder = page_file.parent_path() / page_file.stem();
  reports::make_directory(folder);
  std::vector<std::filesystem::path> files = {page_file};
  for (const NumericsStudy& study : studies) {
    if (study.settings.empty()) continue;
    for (const std::filesystem::path& file :
         reports::write_figure({study.campaign.campaign.name, "", settings_figure(study)}, folder))
      files.push_back(file);
  }
  reports::write_text(page_file, page(studies, page_file.stem().string()));
  return files;
}

}  // namespace cpt::validation::numerics
