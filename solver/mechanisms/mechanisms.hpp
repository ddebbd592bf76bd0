// Every mechanism of a setup; all are off by default. A new one is two new files, a line here and one in
// catalogue.cpp.
#pragma once

#include "solver/mechanisms/clay_crust.hpp"
#include "solver/mechanisms/compliant_wall.hpp"
#include "solver/mechanisms/cushion_transfer.hpp"
#include "solver/mechanisms/density_lens.hpp"
#include "solver/mechanisms/density_trend.hpp"
#include "solver/mechanisms/depth_datum.hpp"
#include "solver/mechanisms/gain_drift.hpp"
#include "solver/mechanisms/grain_crushing.hpp"
#include "solver/mechanisms/inclination.hpp"
#include "solver/mechanisms/interface_mixing.hpp"
#include "solver/mechanisms/layer_shift.hpp"
#include "solver/mechanisms/layer_thickness.hpp"
#include "solver/mechanisms/overconsolidation.hpp"
#include "solver/mechanisms/previous_push.hpp"
#include "solver/mechanisms/push_speed.hpp"
#include "solver/mechanisms/rate_dependence.hpp"
#include "solver/mechanisms/sleeve_load.hpp"
#include "solver/mechanisms/strain_softening.hpp"
#include "solver/mechanisms/strength_gradient.hpp"
#include "solver/mechanisms/stress_ratio_trend.hpp"
#include "solver/mechanisms/surface_compaction.hpp"
#include "solver/mechanisms/wall_friction.hpp"
#include "solver/mechanisms/worn_cone.hpp"
#include "solver/mechanisms/zero_drift.hpp"
#include "solver/mechanisms/zero_offset.hpp"

namespace cpt::solver {

struct Mechanisms {
  SurfaceCompaction surface_compaction;
  DensityLens density_lens;
  PreviousPush previous_push;
  CompliantWall compliant_wall;
  WallFriction wall_friction;
  CushionTransfer cushion_transfer;
  Overconsolidation overconsolidation;
  GrainCrushing grain_crushing;
  StrainSoftening strain_softening;
  RateDependence rate_dependence;
  StrengthGradient strength_gradient;
  ClayCrust clay_crust;
  DepthDatum depth_datum;
  LayerShift layer_shift;
  InterfaceMixing interface_mixing;
  WornCone worn_cone;
  ZeroOffset zero_offset;
  ZeroDrift zero_drift;
  GainDrift gain_drift;
  SleeveLoad sleeve_load;
  Inclination inclination;
  LayerThickness layer_thickness;
  DensityTrend density_trend;
  PushSpeed push_speed;
  StressRatioTrend stress_ratio_trend;
};

}  // namespace cpt::solver
