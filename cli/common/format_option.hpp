// --format table|csv|json
#pragma once

#include "results/tables/table_format.hpp"

namespace CLI {
class App;
}

namespace cpt::cli {

void add_format_option(CLI::App& command, results::Format& format);

}  // namespace cpt::cli
