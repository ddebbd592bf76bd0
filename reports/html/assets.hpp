// The parts of the report's page that are no C++: files of this folder, inside the program since its build.
#pragma once

#include <string_view>

namespace cpt::reports::assets {

extern const std::string_view page;      ///< report.html, with {{name}} where the other parts go
extern const std::string_view style;     ///< report.css
extern const std::string_view script;    ///< the .js files, one after the other
extern const std::string_view d3;        ///< D3, which Plot builds on
extern const std::string_view plot;      ///< Observable Plot
extern const std::string_view licences;  ///< of the libraries, for the page that carries them

}  // namespace cpt::reports::assets
