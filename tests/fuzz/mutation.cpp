#include "tests/fuzz/mutation.hpp"

namespace cpt::fuzz {

std::string mutated(std::string bytes, std::span<const std::string> words, std::mt19937& random, int most) {
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
  for (std::size_t edits = 1 + below(static_cast<std::size_t>(most)); edits > 0 && !bytes.empty(); --edits) {
    const std::size_t at = below(bytes.size());
    const std::size_t before = at == 0 ? std::string::npos : bytes.rfind('\n', at - 1);
    const std::size_t line = before == std::string::npos ? 0 : before + 1;
    const std::size_t end = bytes.find('\n', at);
    const std::size_t length = end == std::string::npos ? std::string::npos : end + 1 - line;
    switch (below(9)) {
      case 0:
        bytes[at] = static_cast<char>(below(256));
        break;
      case 1:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
        break;
      case 2:
        bytes.erase(at, 1 + below(20));
        break;
      case 3:
      case 4:
        if (!words.empty()) bytes.insert(at, words[below(words.size())]);
        break;
      case 5:
        bytes.insert(line, bytes.substr(line, length));
        break;
      case 6:
        bytes.erase(line, length);
        break;
      case 7:
        if (below(4) == 0) bytes.resize(at);
        break;
      default:
        bytes.insert(at, 1, static_cast<char>('0' + below(10)));
    }
  }
  return bytes;
}

}  // namespace cpt::fuzz
