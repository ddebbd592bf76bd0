#include "campaign/realization_command.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <system_error>

namespace cpt::campaign {
namespace {

namespace fs = std::filesystem;

// Held open: the file is the same even if it is replaced while the campaign runs. Empty where there is none.
std::string program_process() {
  std::error_code ignored;
  const fs::path folder = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  constexpr const char* name = "campaign-program";
  for (const fs::path& file : {folder / name, folder.parent_path() / "lib" / "campaign" / name}) {
    const int descriptor = ::open(file.c_str(), O_PATH | O_CLOEXEC);
    if (descriptor >= 0) return fmt::format("/proc/{}/fd/{}", ::getpid(), descriptor);
  }
  return "";
}

}  // namespace

RealizationCommand own_realization_command() {
  // The link holds even if the program's file is replaced while the campaign runs.
  RealizationCommand command{{"/proc/self/exe", "realize"}, {"/proc/self/exe", "realize"}};
  static const std::string program = program_process();
  if (!program.empty()) command.program = {program};
  return command;
}

}  // namespace cpt::campaign
