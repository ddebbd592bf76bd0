#include "recordings/read_recording.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "recordings/ags4.hpp"
#include "recordings/csv.hpp"
#include "recordings/gef.hpp"
#include "recordings/geotech.hpp"
#include "recordings/settle.hpp"
#include "recordings/text.hpp"

namespace cpt::recordings {
namespace {

struct Reader {
  std::string_view name;
  std::vector<std::string_view> endings;
  bool (*recognizes)(std::string_view first_line);
  void (*read)(const std::vector<Line>&, const ReadOptions&, Recording&, Problems&);
};

// The known formats: their names, the endings of their files, how they are known and read. CSV has no mark of
// its own, so it comes last.
const std::vector<Reader>& readers() {
  static const std::vector<Reader> list = {
      {"GEF-CPT", {".gef"}, is_gef, read_gef},
      {"AGS4", {".ags"}, is_ags4, read_ags4},
      {"Geotech CPT", {".cpt"}, is_geotech, read_geotech},
      {"CSV", {".csv", ".txt", ".dat", ".tsv"}, [](std::string_view) { return false; }, read_csv},
  };
  return list;
}

const Reader* by_ending(const std::filesystem::path& file) {
  const std::string ending = lower_case(file.extension().string());
  for (const Reader& reader : readers())
    if (std::find(reader.endings.begin(), reader.endings.end(), ending) != reader.endings.end())
      return &reader;
  return nullptr;
}

const Reader* by_content(const std::vector<Line>& lines) {
  const auto first =
      std::find_if(lines.begin(), lines.end(), [](const Line& line) { return !trimmed(line.text).empty(); });
  if (first == lines.end()) return nullptr;
  for (const Reader& reader : readers())
    if (reader.recognizes(trimmed(first->text))) return &reader;
  return nullptr;
}

const Reader* find_reader(const std::vector<Line>& lines, const std::filesystem::path& file,
                          const ReadOptions& options, Recording& recording) {
  for (const Reader& reader : readers())
    if (options.format == reader.name) return &reader;
  const Reader* content = by_content(lines);
  const Reader* ending = by_ending(file);
  if (content != nullptr && ending != nullptr && content != ending)
    recording.remarks.push_back(
        {{},
         fmt::format("the ending {} is that of a {} file", file.extension().string(), ending->name),
         fmt::format("read as {}", content->name),
         "the first line is that of this format"});
  return content != nullptr ? content : ending;
}

void remark_on_text(const Decoded& content, Recording& recording) {
  if (content.utf_16)
    recording.remarks.push_back(
        {{}, "text in UTF-16", "read as such", "some programs save tables as \"Unicode text\""});
  if (content.replaced > 0)
    recording.remarks.push_back({{},
                                 fmt::format("{} bytes that are not UTF-8", content.replaced),
                                 "read as windows-1252",
                                 "older programs write it; only texts are concerned, no numbers"});
  if (content.end_mark)
    recording.remarks.push_back({{},
                                 "an end-of-file mark (0x1A, Ctrl-Z)",
                                 "the file ends there; nothing but padding is behind it",
                                 "old systems end texts so"});
  if (content.padding > 0)
    recording.remarks.push_back({{},
                                 fmt::format("{} bytes 0x00 or 0xFF behind the text", content.padding),
                                 "left out",
                                 "padding up to the end of a block; is the last row whole?"});
  if (content.padded_lines.rows > 0)
    recording.remarks.push_back({content.padded_lines, "zero bytes at the ends of lines", "left out",
                                 "padding of lines of fixed length; are the rows whole?"});
}

RecordingOrErrors refused(const std::filesystem::path& file, std::string found, std::string expected,
                          std::string hint = {}) {
  return std::vector<RecordingError>{
      {file.string(), 0, 0, std::move(found), std::move(expected), std::move(hint)}};
}

}  // namespace

RecordingOrErrors parse_recording(std::string_view bytes, const std::filesystem::path& file,
                                  const ReadOptions& options) {
  const Decoded content = decoded(bytes);
  if (const auto& problem = content.problem)
    return std::vector<RecordingError>{
        {file.string(), problem->line, problem->column, problem->found, problem->expected, problem->hint}};
  const std::vector<Line> lines = lines_of(content.text);
  Recording recording;
  recording.file = file.string();
  recording.id = file.stem().string();
  remark_on_text(content, recording);
  const Reader* reader = find_reader(lines, file, options, recording);
  if (reader == nullptr)
    return refused(
        file, "a file of unknown format", "GEF-CPT, AGS4, Geotech .cpt or CSV",
        "name a table of columns NAME.csv and say which column is what with --column QUANTITY=NAME");
  recording.format = reader->name;
  Problems problems(file.string());
  reader->read(lines, options, recording, problems);
  if (!problems.any()) settle(recording, problems);
  if (problems.any()) return problems.errors();
  return recording;
}

}  // namespace cpt::recordings
