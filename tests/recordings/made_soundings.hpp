// The same small sounding in each format, with what programs and systems do to files.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <string>

#include "tests/recordings/files.hpp"

namespace cpt::recordings {

enum class Format { gef, ags4, geotech, csv };
/// As the reader calls it.
inline std::string name_of(Format format) {
  return format == Format::gef       ? "GEF-CPT"
         : format == Format::ags4    ? "AGS4"
         : format == Format::geotech ? "Geotech CPT"
                                     : "CSV";
}

/// How a file is written.
struct Writing {
  std::function<std::string(std::string)> number = [](std::string text) { return text; };
  std::string third_q_c = {};  ///< in place of the third row's number
  std::string end = "\n";
  std::string row_end = {};  ///< behind each row, before its line's end
  double first_depth = 0.5;  // [m]
  std::string name = "Made";
  std::string pressure = "MPa";     ///< GEF: label of q_c; AGS4: of q_c too
  std::string csv_q_c = "q_c_MPa";  ///< CSV: its column's name
  std::string index_name = {};      ///< AGS4, CSV: name of a column of row numbers, where `index`
  bool index = false;
};

inline std::string lines(const std::vector<std::string>& lines, const std::string& end) {
  std::string text;
  for (const std::string& line : lines) text += line + end;
  return text;
}

inline constexpr int made_rows = 6;
/// Line of the third row.
inline int third_line(Format format) {
  return format == Format::gef ? 15 : format == Format::ags4 ? 11 : format == Format::geotech ? 6 : 5;
}

inline std::string made(Format format, const Writing& w = {}) {
  std::vector<std::string> text;
  switch (format) {
    case Format::gef:
      text = {"#GEFID= 1, 1, 0",
              "#TESTID= " + w.name,
              w.index ? "#COLUMN= 5" : "#COLUMN= 4",
              "#COLUMNINFO= 1, m, length, 1",
              "#COLUMNINFO= 2, " + w.pressure + ", cone, 2",
              "#COLUMNINFO= 3, kPa, friction, 3",
              "#COLUMNINFO= 4, kPa, pore pressure, 6",
              "#COLUMNVOID= 2, -9999",
              "#COLUMNSEPARATOR= ;",
              "#RECORDSEPARATOR= !",
              "#MEASUREMENTTEXT= 4, x, cone type",
              "#EOH="};
      break;
    case Format::ags4:
      text = {"\"GROUP\",\"LOCA\"",
              "\"HEADING\",\"LOCA_ID\"",
              "\"UNIT\",\"\"",
              "\"DATA\",\"" + w.name + "\"",
              "",
              "\"GROUP\",\"SCPT\"",
              "\"HEADING\",\"LOCA_ID\",\"SCPT_DPTH\",\"SCPT_RES\",\"SCPT_FRES\",\"SCPT_PWP2\"" +
                  std::string(w.index ? ",\"" + w.index_name + "\"" : ""),
              "\"UNIT\",\"\",\"m\",\"" + w.pressure + "\",\"kPa\",\"kPa\"" + (w.index ? ",\"\"" : "")};
      break;
    case Format::geotech:
      text = {"$", "HK=" + w.name + ",MA=0.8", "#"};
      break;
    case Format::csv:
      text = {"# id = " + w.name,
              (w.index ? w.index_name + ";" : "") + "depth_m;" + w.csv_q_c + ";f_s_kPa;u_2_kPa"};
      break;
  }
  for (int i = 0; i < made_rows; ++i) {
    const auto number = [&](double value) { return w.number(fmt::format("{:.3f}", value)); };
    const std::string depth = number(w.first_depth + 0.02 * i);
    const std::string q_c = i == 2 && !w.third_q_c.empty() ? w.third_q_c : number(1.25 + 0.05 * i);
    const std::string f_s = number(12.5 + 0.5 * i), u_2 = number(-30.25 + i);
    const std::string row = std::to_string(i);
    switch (format) {
      case Format::gef:
        text.push_back(fmt::format("{};{};{};{};{}!", depth, q_c, f_s, u_2, w.index ? row + ";" : ""));
        break;
      case Format::ags4:
        text.push_back(fmt::format("\"DATA\",\"{}\",\"{}\",\"{}\",\"{}\",\"{}\"{}", w.name, depth, q_c, f_s,
                                   u_2, w.index ? ",\"" + row + "\"" : ""));
        break;
      case Format::geotech:
        text.push_back(fmt::format("D={},QC={},FS={},U={},%{}", depth, q_c, f_s, u_2, 1000 * i));
        break;
      case Format::csv:
        text.push_back(fmt::format("{}{};{};{};{}", w.index ? row + ";" : "", depth, q_c, f_s, u_2));
        break;
    }
    text.back() += w.row_end;
  }
  if (format == Format::geotech) text.emplace_back("#$");
  return lines(text, w.end);
}

inline std::string file_of(Format format) {
  return format == Format::gef       ? "a.gef"
         : format == Format::ags4    ? "a.ags"
         : format == Format::geotech ? "a.cpt"
                                     : "a.csv";
}

/// Whether all readings are those that made() writes.
inline void expect_made(const Recording& r, double first_depth = 0.5) {
  ASSERT_EQ(r.readings.size(), static_cast<std::size_t>(made_rows));
  EXPECT_EQ(r.rows_read, made_rows);
  for (int i = 0; i < made_rows; ++i) {
    const Reading& reading = r.readings[static_cast<std::size_t>(i)];
    EXPECT_NEAR(reading.depth, first_depth + 0.02 * i, 1e-9) << i;
    EXPECT_NEAR(reading.q_c, (1.25 + 0.05 * i) * 1e6, 1e-3) << i;
    EXPECT_NEAR(reading.f_s, (12.5 + 0.5 * i) * 1e3, 1e-6) << i;
    EXPECT_NEAR(reading.u_2, (-30.25 + i) * 1e3, 1e-6) << i;
  }
}

}  // namespace cpt::recordings
