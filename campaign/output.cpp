#include "campaign/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "campaign/mpirun_output.hpp"

namespace cpt::campaign {
namespace {

int loss = 0;                    // errno of the first piece of standard output that could not be written
bool closed_from_start = false;  // standard output
bool printed = false;            // there

// A pipe may have been made non-blocking by whoever else holds it; then its reader is waited for.
bool write_all(int descriptor, const char* bytes, std::size_t size) {
  while (size > 0) {
    const ssize_t written = ::write(descriptor, bytes, size);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0 && errno == EAGAIN) {
      pollfd writable{descriptor, POLLOUT, 0};
      ::poll(&writable, 1, -1);
      continue;
    }
    if (written <= 0) return false;
    bytes += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

// What comes after a gap would make no sense, so nothing follows a loss.
ssize_t to_stdout(void*, const char* bytes, std::size_t size) {
  printed = true;
  if (loss == 0 && !write_all(STDOUT_FILENO, bytes, size)) loss = errno;
  return static_cast<ssize_t>(size);
}

// A log that is full now may have room for later lines.
ssize_t to_stderr(void*, const char* bytes, std::size_t size) {
  (void)write_all(STDERR_FILENO, bytes, size);
  return static_cast<ssize_t>(size);
}

std::FILE* stream(cookie_write_function_t* write, int buffering) {
  std::FILE* made = ::fopencookie(nullptr, "w", {nullptr, write, nullptr, nullptr});
  if (made != nullptr) std::setvbuf(made, nullptr, buffering, BUFSIZ);
  return made;
}

// The lowest free number is the one that open() gives. Opened the wrong way round, so that to use it is an
// error and not a success.
bool fill(int descriptor) {
  if (::fcntl(descriptor, F_GETFD) >= 0) return false;
  return ::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY) == descriptor;
}

}  // namespace

void open_output() {
  (void)fill(STDIN_FILENO);
  closed_from_start = fill(STDOUT_FILENO);
  (void)fill(STDERR_FILENO);
  for (const int signal : {SIGPIPE, SIGXFSZ}) ::signal(signal, SIG_IGN);
  // The GNU C library's streams are variables that a program may set (glibc manual, "Standard Streams").
  if (std::FILE* out = stream(to_stdout, ::isatty(STDOUT_FILENO) != 0 ? _IOLBF : _IOFBF)) stdout = out;
  if (std::FILE* err = stream(to_stderr, _IONBF)) stderr = err;
}

int close_output(int code, int if_lost) {
  std::fflush(stdout);
  // Some file systems tell only now that a disk is full.
  if (loss == 0 && !closed_from_start && ::close(STDOUT_FILENO) != 0 && errno != EBADF) loss = errno;
  if (loss == 0) {
    const std::string why = printed ? lost_by_mpirun() : "";
    if (why.empty()) return code;
    fmt::print(stderr,
               "mpirun's standard output cannot be written ({}): what is printed there is not whole\n", why);
    return code == 0 ? if_lost : code;
  }
  if (loss != EPIPE)
    fmt::print(stderr, "standard output cannot be written ({}): what is printed there is not whole\n",
               closed_from_start ? "it is closed" : std::strerror(loss));
  return code == 0 ? if_lost : code;
}

int descriptor_of(std::FILE* stream) {
  if (stream == stdout) return STDOUT_FILENO;
  if (stream == stderr) return STDERR_FILENO;
  return ::fileno(stream);
}

bool is_terminal(std::FILE* stream) { return ::isatty(descriptor_of(stream)) != 0; }

}  // namespace cpt::campaign
