// Entries of a header whose value is not known, or not written as a number. The readings are whole without
// them, so that one remark tells all.
#pragma once

#include <string>
#include <string_view>

#include "recordings/recording.hpp"

namespace cpt::recordings {

class UnknownFacts {
 public:
  void add(int line, std::string_view name, std::string_view text);
  /// The remark, if there is anything to tell.
  void tell(Recording& recording) const;

 private:
  Lines lines_;
  std::string list_;
};

}  // namespace cpt::recordings
