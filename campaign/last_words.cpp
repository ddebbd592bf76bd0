#include "campaign/last_words.hpp"

#include <fmt/format.h>
#include <signal.h>

#include <algorithm>
#include <cstring>

namespace cpt::campaign {

std::string last_line(std::string_view text) {
  const auto end = text.find_last_not_of(" \t\r\n");
  if (end == std::string_view::npos) return {};
  text = text.substr(0, end + 1);
  if (const auto newline = text.rfind('\n'); newline != std::string_view::npos)
    text = text.substr(newline + 1);
  text = text.substr(std::min(text.find_first_not_of(" \t"), text.size()));
  std::string line(text.substr(0, 300));
  for (char& c : line)
    if (c < ' ' || c > '~') c = '?';
  return line;
}

std::string killed_by(int signal) {
  const char* name = ::sigdescr_np(signal);
  return fmt::format("killed by signal {} ({}){}", signal, name != nullptr ? name : "unknown",
                     signal == SIGKILL ? ", as the system does when memory runs out" : "");
}

}  // namespace cpt::campaign
