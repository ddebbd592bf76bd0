#include "reports/view/view_quantity.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace cpt::reports::view {
namespace {

using Components = std::span<const double>;

double itself(Components c) { return c[0]; }
double length(Components c) { return std::hypot(c[0], c[1]); }
// Stresses are stored tension-positive.
double radial_pressure(Components c) { return -c[0]; }
double vertical_pressure(Components c) { return -c[1]; }

constexpr auto viridis = ColourMap::viridis;
constexpr auto log_scale = ScaleKind::log;

constexpr std::array list = {
    ViewQuantity{"void_ratio", "e", "void ratio", "", 1.0, "void_ratio", itself, viridis, ScaleKind::linear},
    ViewQuantity{"void_ratio_change", "Δe", "change of void ratio", "", 1.0, "void_ratio_change", itself,
                 ColourMap::red_blue, ScaleKind::diverging},
    ViewQuantity{"p", "p'", "mean effective stress", "kPa", 1e3, "p_Pa", itself, viridis, log_scale},
    ViewQuantity{"q", "q", "deviatoric stress", "kPa", 1e3, "q_Pa", itself, viridis, log_scale},
    ViewQuantity{"p_i", "p_i", "image pressure of NorSand", "kPa", 1e3, "p_i_Pa", itself, viridis, log_scale},
    ViewQuantity{"sigma_r", "σ'_r", "radial stress", "kPa", 1e3, "stress_Pa", radial_pressure, viridis,
                 log_scale},
    ViewQuantity{"sigma_v", "σ'_v", "vertical stress", "kPa", 1e3, "stress_Pa", vertical_pressure, viridis,
                 log_scale},
    ViewQuantity{"displacement", "u", "displacement", "mm", 1e-3, "displacement_m", length, ColourMap::magma,
                 ScaleKind::from_zero},
};

}  // namespace

std::span<const ViewQuantity> view_quantities() { return list; }

const ViewQuantity* find_view_quantity(std::string_view name) {
  const auto found = std::ranges::find(list, name, &ViewQuantity::name);
  return found == list.end() ? nullptr : &*found;
}

}  // namespace cpt::reports::view
