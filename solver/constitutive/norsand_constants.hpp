// NorSand's parameters in the form its kernels read: derived once, plain numbers, no library types.
#pragma once

namespace cpt::solver {

struct NorSandConstants {
  // Critical state line: e_c(p) = e_cs0 - lambda (p / p_a)^m.
  double e_cs0;        // [-]
  double lambda;       // [-]
  double m;            // [-]
  double crushing;     // [-] slope of the crushing branch (solver/mechanisms/grain_crushing.hpp), 0 for none
  double log_p_crush;  // [-] ln(p / 1 Pa) where it begins
  double log_p_a;      // [-] ln(p_a / 1 Pa)
  // Elasticity: G = G_ref p_a / (e - e_min_star) (p / p_a)^b.
  double G_scale;     // [Pa] G_ref p_a
  double b;           // [-]
  double power_b[8];  // [-] binomial coefficients of (1 + u)^b
  double secant[7];   // [-] series of the elastic path's secant modulus (norsand_elastic_path.hpp)
  double power_m[8];  // [-] the same of (1 + u)^m
  double e_min_star;  // [-]
  double K_over_G;    // [-]
  // Strength and dilatancy.
  double M_tc;          // [-]
  double lode;          // [-] M_tc / (3 + M_tc) over the smoothed corner's range
  double M_lowest;      // [-] least value of M(theta) / M_tc, at triaxial extension
  double yield_corner;  // [-] half width of the rounded corner of the yield surface at triaxial compression
  double flow_corner;   // [-] the same in the gradient of F
  double near_axis;     // [-] stress ratio below which the direction of flow is that of the trial stress
  double N;             // [-]
  double chi_tc;        // [-]
  double chi_over_M;    // [-] chi_tc / M_tc
  // Hardening and limits.
  double H;                   // [-]
  double hardening_exponent;  // [-]
  double log_cap;             // [-] ln(cap_ratio)
  double p_min;               // [Pa]
  double p_i_min;             // [Pa] smallest image pressure: isotropic yield at p_min
  double associated;          // [-] 1 associated, 0 radial deviatoric flow
  double tolerance;           // [-] relative error of one sub-step
};

/// What NorSand makes of one state; pressures and stress ratios are compression-positive.
struct NorSandState {
  double p;          // [Pa] mean effective stress
  double q;          // [Pa] deviatoric stress sqrt(3 J2)
  double sin3theta;  // [-] 13.5 J3 / q^3, 1 in triaxial compression
  double psi;        // [-] state parameter e - e_c(p)
  double psi_i;      // [-] state parameter at the image pressure
  double chi_i;      // [-] dilatancy coefficient at the image pressure
  double M_itc;      // [-] image stress ratio in triaxial compression
  double M_i;        // [-] image stress ratio at this Lode angle
  double p_mx;       // [Pa] limit of the image pressure
  double D_p;        // [-] plastic dilatancy M_i - q/p
  double G, K;       // [Pa] elastic moduli
  double yield;      // [-] F / p: positive outside the yield surface
  bool limited;      // a limit that keeps the law defined is what holds D, M_itc, e - e_min_star or, on the
                     // yield surface, the plastic stiffness
};

}  // namespace cpt::solver
