// A headless Chromium, driven by the Chrome DevTools protocol over a pipe, for tests of pages.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace cpt::reports {

class Browser {
 public:
  /// True where Debian's chromium is installed.
  [[nodiscard]] static bool installed();

  /// Starts it with its profile in a folder. Throws std::runtime_error here and below when it does not
  /// answer.
  explicit Browser(const std::filesystem::path& folder);
  ~Browser();
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  /// Opens a file and waits until it is loaded and drawn.
  void open(const std::filesystem::path& page);
  /// Value of a JavaScript expression, promises awaited; throws if it throws.
  [[nodiscard]] nlohmann::json value(const std::string& expression);
  /// Waits until what was changed is drawn.
  void settle();
  void run(const std::string& statements) { (void)value("(() => {" + statements + "})()"); }

  struct At {
    double x, y;  ///< CSS pixels from the window's upper left corner
  };
  /// Centre of the first element that a CSS selector finds, scrolled into view.
  [[nodiscard]] At centre(const std::string& selector);
  void move(At to);
  void click(At at, int count = 1);
  void drag(At from, At to);
  /// A key by its DOM name, such as "Tab" or "ArrowRight", or a text's characters one by one.
  void press(const std::string& key);
  void type(std::string_view text);

  void resize(int width, int height);
  /// CSS media type ("print" or "") and colour scheme ("light" or "dark").
  void set_media(const std::string& type, const std::string& scheme);
  void screenshot(const std::filesystem::path& png);
  /// The page as it is printed on A4; its bytes.
  [[nodiscard]] std::string pdf();

  /// Errors and warnings on the console, exceptions, and requests that are not for files.
  [[nodiscard]] const std::vector<std::string>& problems() const { return problems_; }

 private:
  nlohmann::json call(const std::string& method, const nlohmann::json& parameters = nlohmann::json::object());
  nlohmann::json next_message();
  void note(const nlohmann::json& event);
  void mouse(const char* type, At at, int buttons, int count);
  void wait_for(const std::string& event);

  pid_t pid_ = -1;
  int to_ = -1, from_ = -1;
  int calls_ = 0;
  std::string session_, unread_;
  std::vector<std::string> events_, problems_;
};

}  // namespace cpt::reports
