#include "drawing/markdown.hpp"

namespace cpt::drawing {

std::string table_line(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) {
    line += ' ';
    for (const char c : cell) {
      if (c == '|') line += '\\';
      line += c == '\n' || c == '\r' ? ' ' : c;
    }
    line += " |";
  }
  return line + '\n';
}

std::string table_head(const std::vector<std::string>& columns) {
  return table_line(columns) + table_line(std::vector<std::string>(columns.size(), "---"));
}

}  // namespace cpt::drawing
