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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_TARGET_FIELD_NORMAL_FIT_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_TARGET_FIELD_NORMAL_FIT_H

#include <CGAL/Gradient_domain_processing/enum.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/signals.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The smallest rotation that takes the unit vector `from` to the unit vector `to`, of x.
inline Vec3 rotated(const Vec3& from, const Vec3& to, const Vec3& x)
{
  const double c = from.dot(to);
  if(1 + c < 1e-12)
    return -x; // any half turn
  const Vec3 sum = from + to;
  return x - sum.dot(x) / (1 + c) * sum + 2 * from.dot(x) * to;
}

// v = (I - m m^T) grad x: every triangle is asked to lie in a plane.
//
// Faces: the normal m is that of the triangle, turned as the wanted normals at its corners are against those that the
// mesh has there. So creases, where no vertex has the normal of a face, stay as they are unless the normals ask for
// something else. Where the wanted normals differ from the mesh's by as much as the triangle does from its corners,
// what it has of its own is an error as well: m is the mean of the wanted normals then.
//
// Edges: the authors' form (after Yu et al. 2004), with the sum of the wanted normals at the ends in place of m for
// every edge. Its targets do not add up to zero around a triangle; in caps, whose cotangents are large, that throws
// vertices far away, so these take the form of the faces.
class Normal_fit
{
  const Indexed_triangles& m_mesh;
  const Signal& m_normals; // wanted, by row
  std::vector<Vec3> m_planes; // by triangle: its normal m; zero where the triangle, or what is wanted, has none
  std::vector<char> m_is_by_edges;

public:
  Normal_fit(const Indexed_triangles& mesh, const Signal& normals_of_mesh, const Signal& wanted, Normal_fit_kind kind)
    : m_mesh(mesh), m_normals(wanted), m_planes(mesh.triangles.size()), m_is_by_edges(mesh.triangles.size())
  {
    constexpr double height_of_caps = 0.01; // the slivers of usual meshes are above it
    const std::vector<double> difference = squared_differences(normals_of_mesh);
    for(int f = 0; f < mesh.number_of_triangles(); ++f)
    {
      const Triangle_metric metric = mesh.embedding_metric(f);
      m_is_by_edges[f] =
        kind == Normal_fit_kind::EDGES && metric.sqrt_determinant() > height_of_caps * metric.max_squared_length();
      if(!m_is_by_edges[f])
        m_planes[f] = plane(f, normals_of_mesh, difference);
    }
  }

  static constexpr int channels() { return 3; }
  Signal by_vertex() const { return as_signal(m_mesh.points); }

  template <class Channels>
  void residual(int f, int i, int j, Channels& along) const
  {
    const auto& t = m_mesh.triangles[f];
    const auto& rows = m_mesh.rows_of(f);
    const Vec3 edge = m_mesh.points[t[j]] - m_mesh.points[t[i]];
    const Vec3 n = m_is_by_edges[f] ? Vec3((m_normals.row(rows[i]) + m_normals.row(rows[j])).transpose()) : m_planes[f];
    const double squared_length = n.squaredNorm();
    const double beyond = squared_length > 0 ? -n.dot(edge) / squared_length : 0.;
    for(int channel = 0; channel < 3; ++channel)
      along[channel] = beyond * n[channel];
  }

private:
  // Of the wanted normals from those of the mesh, in the mean over the triangles around every vertex.
  std::vector<double> squared_differences(const Signal& normals_of_mesh) const
  {
    std::vector<double> at_triangles(m_mesh.triangles.size(), 0.), result(m_mesh.points.size(), 0.);
    for(int f = 0; f < m_mesh.number_of_triangles(); ++f)
      for(int row : m_mesh.rows_of(f))
        at_triangles[f] += (m_normals.row(row) - normals_of_mesh.row(row)).squaredNorm() / 3;
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
      for(const int* c = m_mesh.corners.begin(v); c != m_mesh.corners.end(v); ++c)
        result[v] += at_triangles[*c / 3] / m_mesh.corners.size(v);
    return result;
  }

  Vec3 plane(int f, const Signal& normals_of_mesh, const std::vector<double>& squared_difference) const
  {
    // a triangle this many times further from its corners than these are wrong is believed by half
    constexpr double doubt = 6;
    const Vec3 normal = m_mesh.area_vector(f).stableNormalized();
    Vec3 has(0, 0, 0), wants(0, 0, 0);
    double wrong = 0;
    for(int i = 0; i < 3; ++i)
    {
      has += normals_of_mesh.row(m_mesh.rows_of(f)[i]).transpose();
      wants += m_normals.row(m_mesh.rows_of(f)[i]).transpose();
      wrong += squared_difference[m_mesh.triangles[f][i]] / 3;
    }
    if(!(normal.squaredNorm() > 0) || !(has.squaredNorm() > 0) || !(wants.squaredNorm() > 0))
      return Vec3(0, 0, 0);
    has = has.stableNormalized();
    wants = wants.stableNormalized();
    const Vec3 turned = rotated(has, wants, normal);
    const double own = std::pow((normal - has).squaredNorm(), 2), bound = std::pow(doubt * doubt * wrong, 2);
    return bound > 0 ? Vec3((wants + own / (own + bound) * (turned - wants)).stableNormalized()) : turned;
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_TARGET_FIELD_NORMAL_FIT_H
