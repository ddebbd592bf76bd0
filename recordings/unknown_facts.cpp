#include "recordings/unknown_facts.hpp"

#include <fmt/format.h>

#include "recordings/text.hpp"

namespace cpt::recordings {

void UnknownFacts::add(int line, std::string_view name, std::string_view text) {
  constexpr std::size_t longest = 300;
  lines_.add(line);
  if (list_.size() > longest) return;
  list_ += fmt::format("{}{} {}", list_.empty() ? "" : ", ", name, in_quotes(text));
  if (list_.size() > longest) list_ += ", ...";
}

void UnknownFacts::tell(Recording& recording) const {
  if (lines_.rows == 0) return;
  Lines where = lines_;
  where.rows = 0;  // lines of the header, no rows of readings
  recording.remarks.push_back({where, "no number where the header should have one: " + list_,
                               "left out as not known", "the readings are whole without"});
}

}  // namespace cpt::recordings
