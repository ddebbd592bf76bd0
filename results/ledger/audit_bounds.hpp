// What a completed run may leave open of its balances before it is called out of line. No run ends for it and
// no index is left out: it is told beside the number. The solver's own limits, at which a run ends, are in
// solver/audit.cpp.
#pragma once

namespace cpt::results {

/// Size of energy_error [-]: work of penetrometer and weight that is not found again, over the penetrometer's
/// work. That work is q_c over the travel, so q_c can be wrong by as much; a tenth is the size of the smaller
/// indices that studies are made for. The presets close to a few per cent.
inline constexpr double most_energy_error = 0.10;

/// momentum_error [-], over the penetrometer's impulse. The presets leave 0.02 to 0.03 of half a metre's
/// push.
inline constexpr double most_momentum_error = 0.10;

/// kinetic_fraction [-]: largest kinetic energy over the penetrometer's work. The push stands for a slow one;
/// explicit quasi-static simulations are commonly held to 5 to 10 %.
inline constexpr double most_kinetic_fraction = 0.10;

/// Cells inside the soil without a material point, over the number of material points [-], of which the
/// presets put about five into a cell: 0.1 % of the cells. The presets leave none.
inline constexpr double most_empty_share = 2.0e-4;

/// limited_share [-]: steps of cells of several soils in which the soils could not part their motion at once,
/// over all such steps (solver/mixed_cells.hpp).
inline constexpr double most_limited_share = 1.0e-3;

/// safeguarded_share [-]: points whose state a safeguard of their law holds where the law itself would be
/// undefined, over the points of soil, at worst. The presets have none.
inline constexpr double most_safeguarded_share = 1.0e-3;

}  // namespace cpt::results
