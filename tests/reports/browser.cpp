#include "tests/reports/browser.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <stdexcept>

namespace cpt::reports {
namespace {

using nlohmann::json;

constexpr const char* program = "/usr/bin/chromium";
constexpr int patience_ms = 300'000;

/// Both ends above 9, so that they do not stand in the way of the two that Chromium wants: 3 and 4.
std::array<int, 2> make_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  for (int& end : ends) {
    const int moved = fcntl(end, F_DUPFD_CLOEXEC, 10);
    close(end);
    end = moved;
  }
  return ends;
}

std::string decoded(std::string_view base64) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned value = 0;
  int bits = 0;
  for (const char c : base64) {
    const std::size_t digit = digits.find(c);
    if (digit == std::string_view::npos) break;  // padding
    value = (value << 6) | static_cast<unsigned>(digit);
    if ((bits += 6) >= 8) bytes += static_cast<char>((value >> (bits -= 8)) & 0xFF);
  }
  return bytes;
}

}  // namespace

bool Browser::installed() { return access(program, X_OK) == 0; }

Browser::Browser(const std::filesystem::path& folder) {
  const auto down = make_pipe(), up = make_pipe();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, down[0], 3);
  posix_spawn_file_actions_adddup2(&actions, up[1], 4);
  posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
  // Its sandbox refuses to run as root, which containers often are; the pages are the test's own.
  std::vector<std::string> words = {program,
                                    "--headless=new",
                                    "--no-sandbox",
                                    "--disable-gpu",
                                    "--disable-dev-shm-usage",
                                    "--no-first-run",
                                    "--force-device-scale-factor=1",
                                    "--remote-debugging-pipe",
                                    "--user-data-dir=" + (folder / "browser").string()};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawnattr_t group;  // of its own, so that all of its processes can be ended together
  posix_spawnattr_init(&group);
  posix_spawnattr_setflags(&group, POSIX_SPAWN_SETPGROUP);
  const int error = posix_spawn(&pid_, program, &actions, &group, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&group);
  close(down[0]);
  close(up[1]);
  to_ = down[1];
  from_ = up[0];
  if (error != 0) throw std::runtime_error("chromium does not start");
  const json page = call("Target.createTarget", {{"url", "about:blank"}});
  session_ =
      call("Target.attachToTarget", {{"targetId", page.at("targetId")}, {"flatten", true}}).at("sessionId");
  for (const char* domain : {"Page", "Runtime", "Log", "Network"}) call(std::string(domain) + ".enable");
  resize(1280, 900);
}

Browser::~Browser() {
  close(to_);
  close(from_);
  kill(-pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
}

json Browser::next_message() {
  std::size_t end = 0;
  while ((end = unread_.find('\0')) == std::string::npos) {
    pollfd ready{from_, POLLIN, 0};
    if (poll(&ready, 1, patience_ms) <= 0) throw std::runtime_error("chromium is silent");
    std::array<char, 65536> part{};
    const ssize_t size = read(from_, part.data(), part.size());
    if (size <= 0) throw std::runtime_error("chromium has gone");
    unread_.append(part.data(), static_cast<std::size_t>(size));
  }
  json message = json::parse(unread_.substr(0, end));
  unread_.erase(0, end + 1);
  return message;
}

void Browser::note(const json& event) {
  const std::string method = event.at("method");
  const json& what = event.at("params");
  events_.push_back(method);
  if (method == "Runtime.exceptionThrown") problems_.push_back(what.at("exceptionDetails").dump());
  if (method == "Runtime.consoleAPICalled" && (what.at("type") == "error" || what.at("type") == "warning"))
    problems_.push_back(what.at("args").dump());
  if (method == "Log.entryAdded" && what.at("entry").at("level") != "info")
    problems_.push_back(what.at("entry").dump());
  if (method == "Network.requestWillBeSent") {
    const std::string url = what.at("request").at("url");
    if (!url.starts_with("file:") && !url.starts_with("data:")) problems_.push_back("request for " + url);
  }
}

json Browser::call(const std::string& method, const json& parameters) {
  json message = {{"id", ++calls_}, {"method", method}, {"params", parameters}};
  if (!session_.empty()) message["sessionId"] = session_;
  const std::string text = message.dump() + '\0';
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t size = write(to_, text.data() + sent, text.size() - sent);
    if (size <= 0) throw std::runtime_error("chromium does not listen");
    sent += static_cast<std::size_t>(size);
  }
  while (true) {
    json answer = next_message();
    if (answer.contains("method")) {
      note(answer);
    } else if (answer.at("id") == calls_) {
      if (answer.contains("error")) throw std::runtime_error(method + ": " + answer.at("error").dump());
      return answer.at("result");
    }
  }
}

void Browser::wait_for(const std::string& event) {
  while (std::find(events_.begin(), events_.end(), event) == events_.end()) {
    const json message = next_message();
    if (message.contains("method")) note(message);
  }
}

void Browser::open(const std::filesystem::path& page) {
  events_.clear();
  call("Page.navigate", {{"url", "file://" + page.string()}});
  wait_for("Page.loadEventFired");
  settle();
}

void Browser::settle() {
  // Two frames: sizes are known after the first, figures drawn in the second.
  (void)value(
      "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => "
      "requestAnimationFrame(() => done(1)))))");
}

json Browser::value(const std::string& expression) {
  const json answer =
      call("Runtime.evaluate", {{"expression", expression}, {"returnByValue", true}, {"awaitPromise", true}});
  if (answer.contains("exceptionDetails"))
    throw std::runtime_error(expression + ": " + answer.at("exceptionDetails").dump());
  return answer.at("result").value("value", json());
}

Browser::At Browser::centre(const std::string& selector) {
  const json at = value(fmt::format(
      "(() => {{ const e = document.querySelector({}); e.scrollIntoView({{block: 'center', behavior: "
      "'instant'}}); "
      "const b = e.getBoundingClientRect(); return [b.x + b.width / 2, b.y + b.height / 2]; }})()",
      json(selector).dump()));
  return {at.at(0), at.at(1)};
}

void Browser::mouse(const char* type, At at, int buttons, int count) {
  call("Input.dispatchMouseEvent",
       {{"type", type},
        {"x", at.x},
        {"y", at.y},
        {"button", std::string_view(type) == "mouseMoved" && buttons == 0 ? "none" : "left"},
        {"buttons", buttons},
        {"clickCount", count}});
}

void Browser::move(At to) { mouse("mouseMoved", to, 0, 0); }

void Browser::click(At at, int count) {
  move(at);
  for (int k = 1; k <= count; ++k) {
    mouse("mousePressed", at, 1, k);
    mouse("mouseReleased", at, 0, k);
  }
}

void Browser::drag(At from, At to) {
  move(from);
  mouse("mousePressed", from, 1, 1);
  mouse("mouseMoved", {0.5 * (from.x + to.x), 0.5 * (from.y + to.y)}, 1, 0);
  mouse("mouseMoved", to, 1, 0);
  mouse("mouseReleased", to, 0, 1);
}

void Browser::press(const std::string& key) {
  json event = {{"type", "keyDown"}, {"key", key}};
  if (key.size() == 1) event["text"] = key;
  if (key == "Enter") event["text"] = "\r";
  const std::map<std::string, int> codes = {{"Tab", 9},         {"Enter", 13},     {"Escape", 27},
                                            {" ", 32},          {"ArrowLeft", 37}, {"ArrowUp", 38},
                                            {"ArrowRight", 39}, {"ArrowDown", 40}};
  if (codes.contains(key)) event["windowsVirtualKeyCode"] = codes.at(key);
  call("Input.dispatchKeyEvent", event);
  event.erase("text");
  event["type"] = "keyUp";
  call("Input.dispatchKeyEvent", event);
}

void Browser::type(std::string_view text) {
  for (const char c : text) press(std::string(1, c));
}

void Browser::resize(int width, int height) {
  call("Emulation.setDeviceMetricsOverride",
       {{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", width < 500}});
  settle();
}

void Browser::set_media(const std::string& type, const std::string& scheme) {
  call("Emulation.setEmulatedMedia",
       {{"media", type}, {"features", {{{"name", "prefers-color-scheme"}, {"value", scheme}}}}});
  settle();
}

void Browser::screenshot(const std::filesystem::path& png) {
  const json answer = call("Page.captureScreenshot", {{"captureBeyondViewport", true}});
  std::ofstream(png, std::ios::binary) << decoded(answer.at("data").get<std::string>());
}

std::string Browser::pdf() {
  return decoded(call("Page.printToPDF", {{"preferCSSPageSize", true}}).at("data").get<std::string>());
}

}  // namespace cpt::reports
