// Where what a rank prints ends up under mpirun: in mpirun's own standard output.
#pragma once

#include <string>

namespace cpt::campaign {

/// Why mpirun cannot write there, "" where it can, where this process is no child of an mpirun, or where it
/// cannot be known: a network's file system may be full for others than this machine. Linux; a rank on
/// another machine than mpirun knows nothing.
[[nodiscard]] std::string lost_by_mpirun();

}  // namespace cpt::campaign
