#include "cli/write_file.hpp"

#include <fmt/format.h>

#include <fstream>

#include "results/error.hpp"

namespace cpt::cli {

void write_file(const std::filesystem::path& file, std::string_view text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw results::Error(fmt::format("cannot write {}", file.string()));
}

}  // namespace cpt::cli
