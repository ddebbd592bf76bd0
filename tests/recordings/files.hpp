// The small files of tests/recordings/corpus, and what a test reads from them or from a text of its own.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "recordings/read_recording.hpp"

namespace cpt::recordings {

inline std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  EXPECT_TRUE(stream.is_open()) << file;
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline std::string corpus(const std::string& name) {
  return bytes_of(std::filesystem::path(RECORDINGS_CORPUS) / name);
}

/// The options that corpus/chamber.csv needs.
inline ReadOptions chamber() {
  return {.format = {},
          .columns = {{"depth_m", "z_m"}, {"q_c_MPa", "tip_MPa"}, {"f_s_kPa", "sleeve"}},
          .voids = {-9999.0},
          .push = {}};
}

inline Recording recording(const std::string& text, const std::string& name,
                           const ReadOptions& options = {}) {
  const RecordingOrErrors read = parse_recording(text, name, options);
  if (const auto* errors = std::get_if<1>(&read)) {
    ADD_FAILURE() << format(*errors);
    return {};
  }
  return std::get<Recording>(read);
}

inline Recording from_corpus(const std::string& name, const ReadOptions& options = {}) {
  return recording(corpus(name), name, options);
}

/// The errors as one text; "" and a failure where there are none.
inline std::string refusal(const std::string& text, const std::string& name,
                           const ReadOptions& options = {}) {
  const RecordingOrErrors read = parse_recording(text, name, options);
  if (const auto* errors = std::get_if<1>(&read)) return format(*errors);
  ADD_FAILURE() << name << " was read";
  return {};
}

/// The remark whose `found` holds a text; rows = -1 if there is none.
inline Remark remark(const Recording& recording, const std::string& found) {
  for (const Remark& remark : recording.remarks)
    if (remark.found.find(found) != std::string::npos) return remark;
  return {{-1, 0, 0}, {}, {}, {}};
}

inline void expect_has(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in:\n" << text;
}

/// A text with its first occurrence of a part replaced.
inline std::string with(std::string text, const std::string& part, const std::string& instead) {
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return at == std::string::npos ? text : text.replace(at, part.size(), instead);
}

}  // namespace cpt::recordings
