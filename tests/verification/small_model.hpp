// Small models for tests: any lines, any uniform fill of one material, no penetrometer.
#pragma once

#include <functional>
#include <vector>

#include "solver/model.hpp"
#include "solver/soils/elastic.hpp"

namespace cpt::solver::test {

/// Equally spaced lines.
inline std::vector<double> lines(double from, double to, int cells) {
  std::vector<double> x;
  for (int i = 0; i <= cells; ++i) x.push_back(from + (to - from) * i / cells);
  return x;
}

/// Straight mesh on these lines, rows joined nowhere.
inline MeshLayout plain_layout(std::vector<double> r, std::vector<double> z) {
  MeshLayout layout;
  layout.offset.assign(r.size(), 0.0);
  layout.shear.assign(z.size(), 0.0);
  layout.i_joined = static_cast<std::int32_t>(r.size()) - 1;
  layout.j_face = static_cast<std::int32_t>(z.size()) - 1;
  layout.j_zone_top = layout.j_face;
  layout.r = std::move(r);
  layout.y = std::move(z);
  return layout;
}

/// `per_cell` x `per_cell` points in each cell, in the centres of equal parts of natural coordinates; volumes
/// add up to the cell's.
inline std::vector<Point> fill(
    const Mesh& mesh, int per_cell, double density, const std::function<void(Point&)>& set = [](Point&) {}) {
  std::vector<Point> points;
  for (const Cell& cell : mesh.cells()) {
    const CellShape s = mesh.shape(cell);
    for (int i = 0; i < per_cell; ++i)
      for (int j = 0; j < per_cell; ++j) {
        const double xi = -1.0 + (2.0 * i + 1.0) / per_cell, eta = -1.0 + (2.0 * j + 1.0) / per_cell;
        const double zb = s.zb0 + s.zb1 * xi, zt = s.zt0 + s.zt1 * xi;
        Point p{};
        p.r = s.r_c + s.a * xi;
        p.z = 0.5 * ((1.0 - eta) * zb + (1.0 + eta) * zt);
        const double volume = p.r * (2.0 * s.a / per_cell) * ((zt - zb) / per_cell);
        p.mass = density * volume;
        p.volume = volume;
        p.e = 0.7;
        p.h_0 = 1e4;
        p.id = static_cast<double>(points.size());
        set(p);
        points.push_back(p);
      }
  }
  return points;
}

/// Material 0.
inline SoilModels one_soil(std::unique_ptr<const SoilModel> soil) {
  SoilModels soils;
  soils.push_back(std::move(soil));
  return soils;
}

/// A model of one linear elastic material.
inline Model elastic_model(
    const MeshLayout& layout, double E, double nu, double density, const ModelSettings& settings,
    int per_cell = 3, const std::function<void(Point&)>& set = [](Point&) {}) {
  Mesh mesh(layout);
  const std::vector<Point> points = fill(mesh, per_cell, density, set);
  return Model(mesh, points, std::vector<std::int32_t>(points.size(), 0), one_soil(elastic_soil(E, nu)),
               settings);
}

/// Gives a node this velocity at the end of the step, in which it also moves and strains the points.
inline void drive(Model& model, std::int32_t node, double v_r, double v_z) {
  model.set_velocity(node, v_r, v_z);
  model.hold({node, 1.0, 0.0, v_r, false});
  model.hold({node, 0.0, 1.0, v_z, false});
}

/// Calls function(fields, index in bucket) for every material point.
template <typename Function>
void for_each_point(const Model& model, const Function& function) {
  for (std::int32_t b = 0; b < model.points().bucket_count(); ++b) {
    const PointFields p = model.points().fields(model.points().bucket(b));
    for (std::int32_t k = 0; k < model.points().bucket(b).count; ++k) function(p, k);
  }
}

}  // namespace cpt::solver::test
