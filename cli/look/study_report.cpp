#include "cli/look/study_report.hpp"

#include "reports/report.hpp"

namespace cpt::cli {
namespace {

reports::PageContext context_of(const results::Snapshot& campaign, const std::filesystem::path& database,
                                int reload_seconds) {
  const auto folder = database.has_parent_path() ? database.parent_path() : std::filesystem::path(".");
  reports::PageContext context;
  context.diagnoses = diagnosis::read_answers(folder, campaign.campaign.name);
  context.reload_seconds = reload_seconds;
  return context;
}

}  // namespace

std::vector<std::filesystem::path> write_study_report(const results::Snapshot& campaign,
                                                      const std::filesystem::path& database,
                                                      const std::filesystem::path& directory,
                                                      int reload_seconds, drawing::Column column,
                                                      const std::vector<std::string>& notes) {
  reports::PageContext context = context_of(campaign, database, reload_seconds);
  context.notes = notes;
  return reports::write_report(campaign, directory, context, column);
}

std::filesystem::path write_study_page(const results::Snapshot& campaign,
                                       const std::filesystem::path& database,
                                       const std::filesystem::path& directory, int reload_seconds) {
  return reports::write_page(campaign, directory, context_of(campaign, database, reload_seconds));
}

}  // namespace cpt::cli
