#include "parameters/distributions/library.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace cpt::parameters {
namespace {

namespace fs = std::filesystem;

constexpr const char* module_file = "campaign-openturns.so";

// Beside the program in a build, under lib in an installation.
std::vector<fs::path> places() {
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  return {program / module_file, program.parent_path() / "lib" / "campaign" / module_file};
}

const OpenTurns* load() {
  std::string tried;
  for (const fs::path& file : places()) {
    std::error_code ignored;
    if (!fs::exists(file, ignored)) {
      tried += fmt::format("{}{}", tried.empty() ? "" : ", ", file.string());
      continue;
    }
    void* module = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* entry = module == nullptr ? nullptr : ::dlsym(module, openturns_entry);
    if (entry == nullptr) throw MissingLibrary(fmt::format("cannot load {}", ::dlerror()));
    return reinterpret_cast<const OpenTurns* (*)()>(entry)();
  }
  throw MissingLibrary(fmt::format(
      "distributions need OpenTURNS, which this program was built without (no {}); install libopenturns-dev "
      "and build again",
      tried));
}

}  // namespace

const OpenTurns& openturns() {
  static const OpenTurns* const loaded = load();
  return *loaded;
}

std::unique_ptr<const Marginal> marginal(const Distribution& distribution) {
  return openturns().marginal(distribution);
}

std::string_view to_string(Family family) {
  switch (family) {
    case Family::normal:
      return "normal";
    case Family::lognormal:
      return "lognormal";
    case Family::uniform:
      return "uniform";
    case Family::triangular:
      return "triangular";
    case Family::beta:
      return "beta";
    case Family::discrete:
      return "discrete";
  }
  return "";
}

}  // namespace cpt::parameters
