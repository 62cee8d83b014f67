// Copyright (c) 2026  The Gradient_domain_processing authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Gradient_domain_processing authors

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_POLYGON_FANS_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_POLYGON_FANS_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/mesh/polygon_fans.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <Eigen/LU>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE Eigen::VectorXd virtual_vertex_weights(const std::vector<Vec3>& polygon)
{
  const int n = int(polygon.size());
  Vec3 mean = Vec3::Zero();
  for(const Vec3& p : polygon)
    mean += p / n;

  // sum of |(p_i - x) x (p_j - x)|^2 over the sides is quadratic in x: x^T a x - 2 b^T x + c, with x relative to the
  // mean
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Vec3 b = Vec3::Zero();
  for(int i = 0; i < n; ++i)
  {
    const Vec3 p = polygon[i] - mean, side = polygon[(i + 1) % n] - polygon[i];
    const Eigen::Matrix3d projector = side.squaredNorm() * Eigen::Matrix3d::Identity() - side * side.transpose();
    a += projector;
    b += projector * p;
  }
  Eigen::VectorXd weights = Eigen::VectorXd::Constant(n, 1. / n);
  if(!(a.trace() > 0))
    return weights;
  a += 1e-12 * a.trace() * Eigen::Matrix3d::Identity(); // for a line
  const Vec3 x = a.inverse() * b;

  // the least change of equal weights that makes the mean of the corners this point; what is not in the corners' span
  // stays
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for(const Vec3& p : polygon)
    scatter += (p - mean) * (p - mean).transpose();
  scatter += 1e-12 * scatter.trace() * Eigen::Matrix3d::Identity();
  const Vec3 multiplier = scatter.inverse() * x;
  for(int i = 0; i < n; ++i)
    weights[i] += (polygon[i] - mean).dot(multiplier);
  return weights;
}

CGAL_GDP_INLINE void fan_polygons(const Lists& polygons, Indexed_triangles& mesh)
{
  std::vector<Vec3> polygon;
  mesh.triangles.clear();
  mesh.face_of_triangle.clear();
  mesh.virtual_vertices.corners.offsets.assign(1, 0);
  for(int f = 0; f < polygons.size(); ++f)
  {
    const int* const corner = polygons.begin(f);
    const int n = polygons.size(f);
    if(n == 3)
    {
      mesh.triangles.push_back({{corner[0], corner[1], corner[2]}});
      mesh.face_of_triangle.push_back(f);
      continue;
    }
    polygon.clear();
    for(int i = 0; i < n; ++i)
      polygon.push_back(mesh.points[corner[i]]);
    const Eigen::VectorXd weights = virtual_vertex_weights(polygon);
    Vec3 middle = Vec3::Zero();
    for(int i = 0; i < n; ++i)
    {
      middle += weights[i] * polygon[i];
      mesh.virtual_vertices.corners.items.push_back(corner[i]);
      mesh.virtual_vertices.weights.push_back(weights[i]);
      mesh.triangles.push_back({{corner[i], corner[(i + 1) % n], mesh.number_of_vertices()}});
      mesh.face_of_triangle.push_back(f);
    }
    mesh.virtual_vertices.corners.offsets.push_back(int(mesh.virtual_vertices.corners.items.size()));
    mesh.points.push_back(middle);
  }
}

CGAL_GDP_INLINE void interpolate_virtual_rows(const Indexed_triangles& mesh, Signal& signal)
{
  const Virtual_vertices& virtual_vertices = mesh.virtual_vertices;
  const int first = mesh.number_of_surface_vertices();
  for(int k = 0; k < virtual_vertices.size(); ++k)
  {
    auto row = signal.row(first + k);
    row.setZero();
    for(int i = virtual_vertices.corners.offsets[k]; i < virtual_vertices.corners.offsets[k + 1]; ++i)
      row += virtual_vertices.weights[i] * signal.row(virtual_vertices.corners.items[i]);
  }
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_POLYGON_FANS_IMPL_H
