#include "cli/study_report.hpp"

#include "reports/report.hpp"

namespace cpt::cli {

std::vector<std::filesystem::path> write_study_report(const results::Snapshot& campaign,
                                                      const std::filesystem::path& database,
                                                      const std::filesystem::path& directory,
                                                      int reload_seconds, reports::Column column,
                                                      const std::vector<std::string>& notes) {
  const auto folder = database.has_parent_path() ? database.parent_path() : std::filesystem::path(".");
  return reports::write_report(
      campaign, directory,
      {diagnosis::read_answers(folder, campaign.campaign.name), {}, reload_seconds, {}, notes}, column);
}

}  // namespace cpt::cli
