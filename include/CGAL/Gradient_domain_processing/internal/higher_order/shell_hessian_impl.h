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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_SHELL_HESSIAN_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_SHELL_HESSIAN_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/higher_order/shell_hessian.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/Element_matrices.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/edge_neighbors.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_for.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

static_assert(sizeof(Vec3) == 3 * sizeof(double), "the gradients below are read as numbers, end to end");

// Normal of a triangle whose length is twice its area, but for degenerate ones, where it is a bound from below.
struct Bounded_normal
{
  Vec3 normal;
  double length;

  Bounded_normal(const Vec3& a, const Vec3& b, const Vec3& c) : normal((b - a).cross(c - a))
  {
    const double largest = (std::max)({(b - a).squaredNorm(), (c - a).squaredNorm(), (c - b).squaredNorm()});
    length = (std::max)(normal.norm(), degeneracy_ratio * largest);
  }
};

// The gradient of the angle between triangles (c, a, b) and (d, b, a) at the edge (a, b), with respect to a, b, c, d.
CGAL_GDP_INLINE std::array<Vec3, 4> dihedral_gradient(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
  const Vec3 e = b - a;
  const double length = e.norm();
  const Bounded_normal at_c(c, a, b), at_d(d, b, a);
  if(!(length > 0 && at_c.length > 0 && at_d.length > 0))
    return {{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}};
  const Vec3 n1 = at_c.normal / (at_c.length * at_c.length), n2 = at_d.normal / (at_d.length * at_d.length);
  return {{(c - b).dot(e) / length * n1 + (d - b).dot(e) / length * n2,
           -(c - a).dot(e) / length * n1 - (d - a).dot(e) / length * n2,
           length * n1, length * n2}};
}

// The gradient of the area of a triangle.
CGAL_GDP_INLINE std::array<Vec3, 3> area_gradient(const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Bounded_normal normal(a, b, c);
  if(!(normal.length > 0))
    return {{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}};
  const Vec3 half = normal.normal / (2 * normal.length);
  return {{half.cross(c - b), half.cross(a - c), half.cross(b - a)}};
}

// The Hessian, at rest, of the deformation energy of a discrete shell (Hildebrandt et al. 2012, equation 13): with f
// the dihedral angles, edge lengths and areas, the sum of w grad f grad f^T. Coordinate k of vertex v is degree of
// freedom 3 v + k.
class Shell_hessian
{
  const Indexed_triangles& m_mesh;
  Shell_stiffness m_stiffness;
  std::vector<int> m_neighbors;
  std::vector<int> m_edges; // by the corner opposite to them, each once

public:
  Shell_hessian(const Indexed_triangles& mesh, const Shell_stiffness& stiffness, bool parallel)
    : m_mesh(mesh), m_stiffness(stiffness), m_neighbors(edge_neighbors(mesh, parallel))
  {
    for(int corner = 0; corner < int(m_neighbors.size()); ++corner)
      if(m_neighbors[std::size_t(corner)] < corner)
        m_edges.push_back(corner);
  }

  // An element each for every edge's angle and length, one for every triangle's area.
  Eigen::SparseMatrix<double> matrix(bool parallel) const
  {
    const int edges = int(m_edges.size());
    Element_matrices elements(stencils());
    parallel_for(parallel, std::size_t(edges), [&](std::size_t e) {
      const int edge = m_edges[e];
      set_bending(edge, int(e), elements);
      set_length(edge, edges + int(e), elements);
    });
    parallel_for(parallel, m_mesh.triangles.size(),
                 [&](std::size_t f) { set_area(int(f), 2 * edges + int(f), elements); });
    return elements.sum(3 * m_mesh.number_of_vertices(), parallel);
  }

private:
  int vertex(int corner) const { return m_mesh.triangles[std::size_t(corner / 3)][std::size_t(corner % 3)]; }
  const Vec3& point(int v) const { return m_mesh.points[std::size_t(v)]; }

  Lists stencils() const
  {
    Lists lists;
    lists.offsets.assign(1, 0);
    const auto end_element = [&] { lists.offsets.push_back(int(lists.items.size())); };
    const auto add = [&](int v) {
      for(int k = 0; k < 3; ++k)
        lists.items.push_back(3 * v + k);
    };
    for(int edge : m_edges)
    {
      const int across = m_neighbors[std::size_t(edge)];
      if(across >= 0)
      {
        for(int v : m_mesh.opposite_vertices(edge))
          add(v);
        add(vertex(edge));
        add(vertex(across));
      }
      end_element();
    }
    for(int edge : m_edges)
    {
      for(int v : m_mesh.opposite_vertices(edge))
        add(v);
      end_element();
    }
    for(const auto& t : m_mesh.triangles)
    {
      for(int v : t)
        add(v);
      end_element();
    }
    return lists;
  }

  void set_bending(int edge, int e, Element_matrices& elements) const
  {
    const int across = m_neighbors[std::size_t(edge)];
    if(across < 0)
      return;
    const auto ends = m_mesh.opposite_vertices(edge);
    const Vec3 &a = point(ends[0]), &b = point(ends[1]), &c = point(vertex(edge)), &d = point(vertex(across));
    const double areas = (Bounded_normal(a, b, c).length + Bounded_normal(a, b, d).length) / 2;
    const double weight = areas > 0 ? 3 * m_stiffness.bending * (b - a).squaredNorm() / areas : 0;
    elements.set_rank_one(e, weight, dihedral_gradient(a, b, c, d)[0].data());
  }

  // An edge of one or of three and more triangles is in m_edges once for each, as if the triangles were apart.
  void set_length(int edge, int e, Element_matrices& elements) const
  {
    const auto ends = m_mesh.opposite_vertices(edge);
    const Vec3 along = point(ends[1]) - point(ends[0]);
    const double length = along.norm();
    const Vec3 unit = length > 0 ? Vec3(along / length) : Vec3(0, 0, 0);
    const std::array<Vec3, 2> gradient = {{-unit, unit}};
    elements.set_rank_one(e, length > 0 ? m_stiffness.length / length : 0, gradient[0].data());
  }

  void set_area(int f, int e, Element_matrices& elements) const
  {
    const auto& t = m_mesh.triangles[std::size_t(f)];
    const Vec3 &a = point(t[0]), &b = point(t[1]), &c = point(t[2]);
    const double area = Bounded_normal(a, b, c).length / 2;
    elements.set_rank_one(e, area > 0 ? m_stiffness.area / area : 0, area_gradient(a, b, c)[0].data());
  }
};

CGAL_GDP_INLINE Eigen::SparseMatrix<double> shell_hessian(const Indexed_triangles& mesh,
                                                          const Shell_stiffness& stiffness, bool parallel)
{
  return Shell_hessian(mesh, stiffness, parallel).matrix(parallel);
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_SHELL_HESSIAN_IMPL_H
