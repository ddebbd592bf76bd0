// Standard output and error of the whole program, made so that nothing that is printed can end it.
//
// A full disk, a pipe whose reader is gone or a closed descriptor must neither throw in the middle of a
// campaign (fmt::print does), nor kill it (SIGPIPE, SIGXFSZ), nor be passed over in silence. So stdout and
// stderr become streams that take everything; the first thing that stdout did not get is remembered, and told
// in the end.
#pragma once

#include <cstdio>

namespace cpt::campaign {

/// To be called before anything opens a file: closed descriptors 0 to 2 are filled, so that no database and
/// no lock comes to stand where messages go.
void open_output();

/// Writes out what waits. `code` if all of standard output arrived or `code` tells of something worse;
/// `if_lost` in place of 0 if some of it is lost, which stderr is then told, but of a reader that has gone:
/// `campaign query ... | head -1` is no reason for a message. Under mpirun the output is lost, too, where
/// mpirun itself cannot write it. No output after this.
[[nodiscard]] int close_output(int code, int if_lost);

/// The file descriptor behind stdout, stderr or another stream.
[[nodiscard]] int descriptor_of(std::FILE* stream);
/// Whether a person sits at it.
[[nodiscard]] bool is_terminal(std::FILE* stream);

}  // namespace cpt::campaign
