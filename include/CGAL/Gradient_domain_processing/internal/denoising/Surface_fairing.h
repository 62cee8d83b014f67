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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_SURFACE_FAIRING_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_SURFACE_FAIRING_H

#include <CGAL/Gradient_domain_processing/internal/denoising/Dual_graph.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/conjugate_gradients.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/constants.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// What remains after normals were filtered are facets. They go by a term of second order, min |x - x_0|^2
// + sum_v gamma c_v |L x|_v^2, where (L x)_v is the difference of a vertex and the mean of its neighbors; c_v is 1 on a
// smooth surface, and near 0 at creases of another.
class Surface_fairing
{
  const Indexed_triangles& m_mesh;
  const Lists& m_rings;
  const Dual_graph& m_dual;
  bool m_parallel;
  double m_share;
  std::vector<float> m_weights; // gamma c_v

public:
  // Of nothing yet. `share` of the weight is for who wants to stay nearer to the input.
  Surface_fairing(const Indexed_triangles& mesh, const Lists& rings, const Dual_graph& dual, double share,
                  bool parallel)
    : m_mesh(mesh)
    , m_rings(rings)
    , m_dual(dual)
    , m_parallel(parallel)
    , m_share(share)
    , m_weights(mesh.points.size(), 0.f)
  {
  }

  // Of a smooth surface.
  void take_all()
  {
    m_weights.assign(m_mesh.points.size(), float(m_share * denoising::smooth_fairing));
    keep_lines();
  }

  // c_v = 1 / (1 + |g_a - g_b|^2 / sigma^2)^2, the least over the edges at v.
  void keep_creases(const std::vector<Vec3>& normals)
  {
    const double gamma = m_share * denoising::creased_fairing;
    m_weights.assign(m_mesh.points.size(), float(gamma));
    m_dual.for_each_edge(m_mesh, [&](int f, int g, int v, int w) {
      const double sigma = denoising::fairing_similarity;
      const double q = 1 + (normals[f] - normals[g]).squaredNorm() / (sigma * sigma);
      for(int end : {v, w})
        m_weights[end] = (std::min)(m_weights[end], float(gamma / (q * q)));
    });
    keep_lines();
  }

  // Vertices move along their normals: along the surface, the mean of the neighbors is no better place.
  template <class May_move>
  void operator()(const May_move& may_move, const std::vector<Vec3>& normals, std::vector<Vec3>& points) const
  {
    const std::size_t n = points.size();
    std::vector<float> inverse_diagonal(n, 0.f);
    std::vector<Vec3f> right(n), change(n, Vec3f(0, 0, 0, 0)), curvature(n);
    parallel_for(m_parallel, n,
                 [&](std::size_t v) { curvature[v] = m_weights[v] * single(difference(points, int(v))); });
    parallel_for(m_parallel, n, [&](std::size_t v) {
      right[v] = -transposed(curvature, int(v));
      float diagonal = 1 + m_weights[v];
      for(const int* w = m_rings.begin(int(v)); w != m_rings.end(int(v)); ++w)
      {
        const float size = float(m_rings.size(*w));
        diagonal += m_weights[*w] / (size * size);
      }
      if(may_move(int(v)))
        inverse_diagonal[v] = 1 / diagonal;
    });
    Conjugate_gradients<Vec3f> solve(m_parallel);
    solve(Row{*this, curvature}, inverse_diagonal, right, denoising::fairing_tolerance, denoising::most_solver_steps,
          change);
    parallel_for(m_parallel, n, [&](std::size_t v) {
      if(inverse_diagonal[v] != 0)
        points[v] += normals[v].dot(as_double(change[v])) * normals[v];
    });
  }

private:
  // of I + gamma L^T c L
  struct Row
  {
    const Surface_fairing& fairing;
    std::vector<Vec3f>& curvature; // gamma c L p

    void prepare(const std::vector<Vec3f>& p) const
    {
      parallel_for(fairing.m_parallel, p.size(), [&](std::size_t v) {
        curvature[v] = fairing.m_weights[v] * fairing.difference(p, int(v));
      });
    }

    Vec3f operator()(const std::vector<Vec3f>& p, int v) const { return p[v] + fairing.transposed(curvature, v); }
  };

  // The border, and where other than two triangles meet: the surface has no normal there.
  void keep_lines()
  {
    for(int f = 0; f < m_mesh.number_of_triangles(); ++f)
      for(int i = 0; i < 3; ++i)
        if(m_dual.neighbor(f, i) < 0)
          m_weights[m_mesh.triangles[f][i]] = m_weights[m_mesh.triangles[f][(i + 1) % 3]] = 0;
    for(std::size_t v = 0; v < m_weights.size(); ++v)
      if(m_rings.size(int(v)) == 0)
        m_weights[v] = 0;
  }

  // (L p)_v; zero where there is no neighbor
  template <class Vector>
  Vector difference(const std::vector<Vector>& p, int v) const
  {
    Vector sum = Vector::Zero();
    for(const int* w = m_rings.begin(v); w != m_rings.end(v); ++w)
      sum += p[v] - p[*w];
    return m_rings.size(v) > 0 ? Vector(sum / typename Vector::Scalar(m_rings.size(v))) : sum;
  }

  // (L^T q)_v
  Vec3f transposed(const std::vector<Vec3f>& q, int v) const
  {
    Vec3f sum = q[v];
    for(const int* w = m_rings.begin(v); w != m_rings.end(v); ++w)
      sum -= q[*w] / float(m_rings.size(*w));
    return sum;
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_SURFACE_FAIRING_H
