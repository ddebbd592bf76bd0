#include "campaign/progress_display.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>

#include <cmath>

#include "campaign/output.hpp"

namespace cpt::campaign {
namespace {

constexpr double terminal_interval = 0.5;  // [s]
constexpr double plain_interval = 10.0;    // [s]

std::size_t terminal_width(std::FILE* out) {
  winsize size{};
  if (::ioctl(descriptor_of(out), TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
  return size.ws_col;
}

}  // namespace

std::string format_duration(double seconds) {
  const auto whole = std::llround(std::max(seconds, 0.0));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02d} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02d} min", whole / 3600, whole % 3600 / 60);
}

std::string progress_line(const Standing& standing) {
  const Tally& tally = standing.tally;
  std::string line = fmt::format("{}/{} done, {} running, {} failed", tally.finished + tally.failed,
                                 tally.total(), tally.running, tally.failed);
  if (tally.pending + tally.running > 0)
    line += standing.remaining_seconds ? ", ETA " + format_duration(*standing.remaining_seconds)
                                       : ", ETA not known yet";
  if (standing.point_steps_per_second > 0.0)
    line += fmt::format(", {:.1f} million material-point steps/s", standing.point_steps_per_second * 1e-6);
  return line;
}

ProgressDisplay::Style ProgressDisplay::style_of(std::FILE* out) {
  return is_terminal(out) ? Style::terminal : Style::plain;
}

void ProgressDisplay::note(std::string_view line) {
  if (style_ == Style::silent) return;
  const std::string shown = shown_;
  erase_line();
  fmt::print(out_, "{}\n", line);
  if (style_ == Style::terminal && !shown.empty()) {
    fmt::print(out_, "{}", shown);
    shown_ = shown;
  }
  std::fflush(out_);
}

void ProgressDisplay::update(std::string line, double now) {
  if (style_ == Style::silent) return;
  const double interval = style_ == Style::terminal ? terminal_interval : plain_interval;
  if (last_update_ && now < *last_update_ + interval) return;
  last_update_ = now;
  if (style_ == Style::plain) {
    fmt::print(out_, "{}\n", line);
  } else {
    line.resize(std::min(line.size(), terminal_width(out_) - 1));
    erase_line();
    fmt::print(out_, "{}", line);
    shown_ = line;
  }
  std::fflush(out_);
}

void ProgressDisplay::finish() { erase_line(); }

void ProgressDisplay::erase_line() {
  if (shown_.empty()) return;
  fmt::print(out_, "\r\033[K");
  std::fflush(out_);
  shown_.clear();
}

}  // namespace cpt::campaign
