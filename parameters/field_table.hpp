// A table as a file has it: texts with their place, to be read with errors that name it.
#pragma once

#include <string>
#include <vector>

#include "parameters/document.hpp"

namespace cpt::parameters {

struct Field {
  std::string text;
  Place place;
};

struct FieldTable {
  std::string file;  ///< for messages
  std::string name;  ///< what the table is called: a file's name without its ending, a key of a document
  std::vector<Field> names;              ///< of the columns, each once
  std::vector<std::vector<Field>> rows;  ///< each as long as `names`
};

}  // namespace cpt::parameters
