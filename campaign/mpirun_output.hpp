// Where what a rank prints ends up under mpirun: in mpirun's own standard output.
#pragma once

#include <string>

namespace cpt::campaign {

/// Why mpirun cannot write there: it is closed, its reader has gone, its disk is full by now. "" where it
/// can, and where that cannot be known: this process is no child of an mpirun, or mpirun runs on another
/// machine.
[[nodiscard]] std::string lost_by_mpirun();

}  // namespace cpt::campaign
