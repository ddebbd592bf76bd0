#include "results/files/refusal.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

namespace cpt::results {
namespace {

std::string_view advice(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return "; free some space, or have the limit raised, and run the same command again";
    case EACCES:
    case EPERM:
      return "; give permission on it and its folder, or name another place";
    case EROFS:
      return "; this folder can only be read: name another place, or copy the study to one";
    case ENAMETOOLONG:
      return "; a name may have 255 bytes and a path 4095: take shorter ones";
    case ENOTDIR:
    case EEXIST:
      return "; a file is where a folder is needed: move it away, or name another place";
    case EISDIR:
      return "; a folder is where the file is to be: move it away, or name another place";
    case ENOENT:
      return "; its folder does not exist";
    case ENOLCK:
      return "; this file system knows no locks: name a place on another";
    default:
      return "";
  }
}

}  // namespace

std::string refusal(const std::filesystem::path& file, std::string_view what, int error) {
  return fmt::format("{}: {} ({}){}", file.string(), what, std::strerror(error), advice(error));
}

std::string refusal(const std::filesystem::path& file, std::string_view what, const std::error_code& error) {
  return refusal(file, what, error.value());
}

}  // namespace cpt::results
