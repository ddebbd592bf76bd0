// campaign-program: the process of a realization that another program runs. It loads few libraries, so that
// it starts in milliseconds where the whole program takes a tenth of a second.
#include "campaign/external/run_program.hpp"
#include "campaign/order_server.hpp"

int main() { return cpt::campaign::serve_order(cpt::campaign::run_ordered_program); }
