// What a campaign's JSON document says it is.
#pragma once

namespace cpt::cli {

inline constexpr const char* export_format = "campaign export";

}  // namespace cpt::cli
