// Made-up campaigns under the names of the studies in examples/paper.
#pragma once

#include <filesystem>
#include <map>

#include "tests/reports/made_up_campaigns.hpp"
#include "validation/paper/studies.hpp"

namespace cpt::validation::paper {

/// A folder with all seven databases; `mishaps` by study name.
class PaperCampaigns {
 public:
  explicit PaperCampaigns(const std::map<std::string_view, reports::Mishaps>& mishaps = {});
  ~PaperCampaigns();
  PaperCampaigns(const PaperCampaigns&) = delete;
  PaperCampaigns& operator=(const PaperCampaigns&) = delete;
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] Studies studies() const { return read_studies(folder_); }

 private:
  std::filesystem::path folder_;
};

}  // namespace cpt::validation::paper
