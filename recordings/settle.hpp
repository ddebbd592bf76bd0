// What is done with the rows of every format once they are read: which depth counts, order, marks, remarks.
#pragma once

#include "recordings/recording.hpp"
#include "recordings/recording_error.hpp"

namespace cpt::recordings {

/// Takes readings in the file's order, with `depth` where the file states one and `length` where it gives the
/// length along the rods. In this order, with a remark for each that changes or finds something:
///
/// 1. A depth or length that is nowhere positive counts downward with the wrong sign and is turned.
/// 2. Stated depths count if they can belong to the lengths (never longer, nor less than half). Rows without
///    one, and all rows of a file without, go on from the row before by length times the cosine of the
///    inclination; a void inclination stays what it was, vertical before the first. A file without any
///    inclination has depth = length.
/// 3. Rows that have neither depth nor length are set aside.
/// 4. Stops are marked: a depth that repeats, or a time more than 5 s beyond what the step takes on average.
/// 5. Rows are put in order of depth, equal ones as in the file.
/// 6. Rows above the predrilled depth are marked; voids are counted; values that look a thousandfold off and
///    the drift of the zeros are told. No value of a sensor is ever changed.
///
/// Adds an error where no row or no q_c is left.
void settle(Recording& recording, Problems& problems);

/// Steps 1 to 3 and 5; step 4, in between, needs the file's order.
void choose_depths(Recording& recording);
void put_in_order(Recording& recording);
void mark_stops(Recording& recording);
/// Step 6.
void remark_on_values(Recording& recording);

}  // namespace cpt::recordings
