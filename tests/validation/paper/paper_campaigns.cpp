#include "tests/validation/paper/paper_campaigns.hpp"

#include <cstdlib>
#include <stdexcept>

#include "solver/quantities.hpp"

namespace cpt::validation::paper {
namespace {

using parameters::Study;
using parameters::Window;
using reports::Mishaps;
using reports::run_made_up;

Study named(Study study, std::string_view name, const std::vector<std::string>& windows) {
  study.name = name;
  study.database = study.file.parent_path() / (study.name + ".sqlite");
  for (std::size_t i = 0; i < windows.size(); ++i) study.windows[i].name = windows[i];
  return study;
}

// A sand study with one-sided rows, averaged over the whole push.
Study dense(const std::filesystem::path& folder, std::string_view name,
            const std::vector<std::string_view>& rows) {
  Study study = named(reports::sand_study(folder), name, {"whole"});
  study.windows[0].from = 0.1;
  study.windows[0].to = 0.5;
  study.rows.clear();
  for (const std::string_view row : rows) {
    const solver::Quantity* quantity = solver::find_quantity(row);
    const double baseline = quantity->value(study.baseline);
    study.rows.push_back({quantity, baseline, baseline, 1.2 * baseline});
  }
  return study;
}

}  // namespace

PaperCampaigns::PaperCampaigns(const std::map<std::string_view, Mishaps>& mishaps) {
  std::string name = (std::filesystem::temp_directory_path() / "cpt_paper_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no scratch folder");
  folder_ = name;

  Study flexible = named(reports::sand_study(folder_), flexible_study, {"sand"});
  std::erase_if(flexible.rows, [](const parameters::Row& row) {
    return row.quantity->name != "initial.sigma_h0_kPa" && row.quantity->name != "chamber.radius_m";
  });
  for (const Study& study :
       {named(reports::sand_study(folder_), paper::sand_study, {"sand"}),
        named(reports::clay_study(folder_), paper::clay_study, {"clay"}),
        named(reports::layered_study(folder_), paper::layered_study, {"embedded_sand", "embedded_clay"}),
        flexible, dense(folder_, dense_rigid_study, {"initial.sigma_h0_kPa", "sand.D_r_percent"}),
        dense(folder_, dense_flexible_study, {"initial.sigma_h0_kPa"}),
        dense(folder_, second_push_study, {"sand.D_r_percent"})}) {
    const auto mishap = mishaps.find(study.name);
    (void)run_made_up(study, mishap == mishaps.end() ? Mishaps{} : mishap->second);
  }
}

PaperCampaigns::~PaperCampaigns() { std::filesystem::remove_all(folder_); }

}  // namespace cpt::validation::paper
