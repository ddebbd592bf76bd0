#include "solver/mechanisms/overconsolidation.hpp"

#include "solver/mechanisms/mechanism.hpp"
#include "solver/quantity_builders.hpp"

namespace cpt::solver {

Mechanism overconsolidation_mechanism() {
  return {
      .name = "overconsolidation",
      .title = "overconsolidated sand",
      .equation = "p_i = (1 + excess) p_i(K0 state)",
      .source = "Jefferies & Been (2015), chapter 3",
      .signature = "q_c is higher throughout, more so at a higher sigma'_h0.",
      .acts_on = norsand_only,
      .parameters = {{number<&Setup::mechanisms, &Mechanisms::overconsolidation, &Overconsolidation::excess>(
                          "overconsolidation.excess", "OCR-1", none, 0.0, 20.0, norsand_only,
                          "over-consolidation ratio of the image pressure, less one",
                          "one unloading from two to three times the test's stress"),
                      0.0, 2.0}}};
}

}  // namespace cpt::solver
