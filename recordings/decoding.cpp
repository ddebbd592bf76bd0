// From the bytes of a file to text: encodings, end-of-file marks, padding.
#include <algorithm>
#include <array>
#include <string_view>

#include "recordings/text.hpp"

namespace cpt::recordings {
namespace {

constexpr char end_mark = '\x1A';                          // Ctrl-Z, with which CP/M and DOS end a text
constexpr std::string_view no_character = "\xEF\xBF\xBD";  // U+FFFD

// What windows-1252 has in place of the control characters 0x80 to 0x9F of Latin-1 (WHATWG Encoding); 0:
// nothing.
constexpr std::array<char32_t, 32> windows_1252 = {
    0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0,      0x017D, 0,      0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178};

/// Length of the UTF-8 sequence that starts at `at`; 0 if there is none.
std::size_t sequence(std::string_view bytes, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[at + i]); };
  const unsigned char lead = byte(0);
  const std::size_t length = lead < 0x80                   ? 1
                             : lead >= 0xC2 && lead < 0xE0 ? 2
                             : lead >= 0xE0 && lead < 0xF0 ? 3
                             : lead >= 0xF0 && lead < 0xF5 ? 4
                                                           : 0;
  if (length == 0 || at + length > bytes.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  if (length > 2) {  // neither longer than needed, nor a surrogate, nor beyond U+10FFFF
    const unsigned char second = byte(1);
    if ((lead == 0xE0 && second < 0xA0) || (lead == 0xED && second >= 0xA0) ||
        (lead == 0xF0 && second < 0x90) || (lead == 0xF4 && second >= 0x90))
      return 0;
  }
  return length;
}

void append(std::string& text, char32_t c) {
  const auto add = [&](char32_t byte) { text += static_cast<char>(byte); };
  if (c < 0x80) return add(c);
  if (c < 0x800) {
    add(0xC0 | (c >> 6));
  } else {
    if (c < 0x10000) {
      add(0xE0 | (c >> 12));
    } else {
      add(0xF0 | (c >> 18));
      add(0x80 | ((c >> 12) & 0x3F));
    }
    add(0x80 | ((c >> 6) & 0x3F));
  }
  add(0x80 | (c & 0x3F));
}

/// Where in a text one is.
struct Position {
  int line = 1, column = 1;
  char before = '\0';
  void step(char c) {
    if (before == '\n' || (before == '\r' && c != '\n')) {
      ++line;
      column = 1;
    }
    if ((static_cast<unsigned char>(c) & 0xC0) != 0x80 && !(before == '\r' && c == '\n')) ++column;
    before = c;
  }
  /// Of the character that comes next.
  [[nodiscard]] Position next() const {
    return before == '\n' || before == '\r' ? Position{line + 1, 1, '\0'} : *this;
  }
};

Position position_at(std::string_view text, std::size_t at) {
  Position place;
  for (const char c : text.substr(0, at)) place.step(c);
  return place.next();
}

std::string text_of_utf16(std::string_view bytes, bool big_endian, Decoded& result) {
  std::string text;
  const auto unit = [&](std::size_t at) {
    const auto one = static_cast<unsigned char>(bytes[at]), two = static_cast<unsigned char>(bytes[at + 1]);
    return static_cast<char32_t>(big_endian ? one << 8 | two : two << 8 | one);
  };
  const std::size_t end = bytes.size() / 2 * 2;
  for (std::size_t at = 0; at < end; at += 2) {
    char32_t c = unit(at);
    if (c >= 0xD800 && c < 0xE000) {
      const char32_t low = c < 0xDC00 && at + 2 < end ? unit(at + 2) : 0;
      if (low < 0xDC00 || low >= 0xE000) {
        const Position place = position_at(text, text.size());
        result.problem = {place.line, place.column, "half a character of UTF-16", "whole ones",
                          "the file is damaged here"};
        return text;
      }
      c = 0x10000 + ((c - 0xD800) << 10) + (low - 0xDC00);
      at += 2;
    }
    append(text, c);
  }
  // Programs that know bytes alone end such a file with a mark or a zero of one byte.
  if (end < bytes.size() && bytes.back() != end_mark && bytes.back() != '\0' && bytes.back() != '\n') {
    const Position place = position_at(text, text.size());
    result.problem = {place.line, place.column, "half a character of UTF-16", "whole ones",
                      "the file seems to be cut off"};
  }
  return text;
}

/// UTF-8 for bytes that are UTF-16, by their byte order mark or by the zeros that ASCII has in it; else
/// nothing.
std::string from_utf16(std::string_view bytes, Decoded& result) {
  const auto zero = [&](std::size_t at) { return bytes[at] == '\0'; };
  const bool marked_big = bytes.starts_with("\xFE\xFF"), marked_little = bytes.starts_with("\xFF\xFE");
  const bool long_enough = bytes.size() >= 4;
  const bool big = marked_big || (long_enough && zero(0) && !zero(1) && zero(2) && !zero(3));
  const bool little = marked_little || (long_enough && !zero(0) && zero(1) && !zero(2) && zero(3));
  if (!big && !little) return {};
  result.utf_16 = true;
  return text_of_utf16(marked_big || marked_little ? bytes.substr(2) : bytes, big, result);
}

/// The text without what old systems put behind its end: a mark, and zeros, ones (erased memory) or further
/// marks up to the end of a block.
std::string_view without_tail(std::string_view bytes, Decoded& result) {
  constexpr std::string_view padding("\0\xFF\x1A", 3);
  constexpr std::string_view padding_and_blanks("\0\xFF\x1A \t\r\n", 7);
  const std::size_t last = bytes.find_last_not_of(padding_and_blanks);
  const std::size_t begin = bytes.find_first_of(padding, last == bytes.npos ? 0 : last + 1);
  if (begin == bytes.npos) return bytes;
  for (const char c : bytes.substr(begin)) {
    result.end_mark = result.end_mark || c == end_mark;
    result.padding += c == '\0' || c == '\xFF' ? 1 : 0;
  }
  return bytes.substr(0, begin);
}

void take(std::string_view bytes, Decoded& result) {
  result.text.reserve(bytes.size());
  Position place;
  const auto stop = [&](std::string found, std::string hint) {
    const Position here = place.next();
    result.problem = {here.line, here.column, std::move(found), "text", std::move(hint)};
  };
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t from = result.text.size();
    if (bytes[at] == end_mark)
      return stop("an end-of-file mark (0x1A, Ctrl-Z) with text behind it",
                  "were files joined? take them apart, or remove the mark");
    if (bytes[at] == '\0') {
      const std::size_t end = std::min(bytes.find_first_not_of('\0', at), bytes.size());
      if (end < bytes.size() && bytes[end] != '\r' && bytes[end] != '\n')
        return stop("zero bytes (0x00) inside the text",
                    "part of the file seems to be overwritten; is there another copy?");
      result.padded_lines.add(place.next().line);
      at = end;
      continue;
    }
    if (const std::size_t length = sequence(bytes, at); length > 0) {
      result.text += bytes.substr(at, length);
      at += length;
    } else {
      const auto byte = static_cast<unsigned char>(bytes[at++]);  // 0x80 to 0xFF
      const char32_t c = byte < 0xA0 ? windows_1252[byte - 0x80] : byte;
      if (c == 0)
        result.text += no_character;
      else
        append(result.text, c);
      ++result.replaced;
    }
    for (const char c : std::string_view(result.text).substr(from)) place.step(c);
  }
}

}  // namespace

Decoded decoded(std::string_view bytes) {
  Decoded result;
  constexpr std::string_view utf_32_little("\xFF\xFE\0\0", 4), utf_32_big("\0\0\xFE\xFF", 4);
  if (bytes.starts_with(utf_32_little) || bytes.starts_with(utf_32_big)) {
    result.problem = {1, 1, "text in UTF-32", "UTF-8, UTF-16 or windows-1252", "save it as UTF-8"};
    return result;
  }
  const std::string wide = from_utf16(bytes, result);
  std::string_view rest = result.utf_16 ? std::string_view(wide) : bytes;
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
  if (!result.problem) take(without_tail(rest, result), result);
  if (result.problem) result.text.clear();
  return result;
}

}  // namespace cpt::recordings
