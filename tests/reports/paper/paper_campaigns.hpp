// Made-up campaigns under the names of the studies in examples/paper.
#pragma once

#include <filesystem>
#include <map>

#include "reports/paper/studies.hpp"
#include "tests/reports/made_up_campaigns.hpp"

namespace cpt::reports::paper {

/// A folder with all seven databases; `mishaps` by study name.
class PaperCampaigns {
 public:
  explicit PaperCampaigns(const std::map<std::string_view, Mishaps>& mishaps = {});
  ~PaperCampaigns();
  PaperCampaigns(const PaperCampaigns&) = delete;
  PaperCampaigns& operator=(const PaperCampaigns&) = delete;
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] Studies studies() const { return read_studies(folder_); }

 private:
  std::filesystem::path folder_;
};

}  // namespace cpt::reports::paper
