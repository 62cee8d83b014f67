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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_TARGET_FIELD_SEAM_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_TARGET_FIELD_SEAM_H

#include <CGAL/Gradient_domain_processing/internal/curvature/tangent_frame.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/signals.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// v = grad f inside the patches and none across their seams (1, 2.1; Yu et al. 2004). On a seam the part of the
// gradient along the edge inside a patch is kept; a triangle between three patches has none.
class Seam
{
  typedef Eigen::Matrix<double, 3, Eigen::Dynamic> Gradient; // a column a channel

  const Indexed_triangles& m_mesh;
  const Signal& m_signal;
  const std::vector<int>& m_patch; // by row
  std::vector<char> m_is_seam;     // by triangle

public:
  Seam(const Indexed_triangles& mesh, const Signal& signal, const std::vector<int>& patch)
    : m_mesh(mesh), m_signal(signal), m_patch(patch)
  {
    find_seams();
  }

  int channels() const { return int(m_signal.cols()); }
  Signal by_vertex() const { return mean_by_vertex(m_mesh, m_signal); }

  template <class Channels>
  void residual(int f, int i, int j, Channels& along) const
  {
    const auto& rows = m_mesh.rows_of(f);
    const auto& t = m_mesh.triangles[f];
    int from = rows[0], to = rows[0]; // the edge inside a patch
    double part = 0;                  // of it that goes along the edge asked for
    for(int k = 0; k < 3; ++k)
    {
      const int next = (k + 1) % 3;
      const Vec3 edge = m_mesh.points[t[next]] - m_mesh.points[t[k]];
      const double squared_length = edge.squaredNorm();
      if(m_is_seam[f] && m_patch[rows[k]] == m_patch[rows[next]] && squared_length > 0)
      {
        from = rows[k];
        to = rows[next];
        part = edge.dot(m_mesh.points[t[j]] - m_mesh.points[t[i]]) / squared_length;
      }
    }
    const int end = m_is_seam[f] ? rows[j] : rows[i]; // elsewhere nothing is beyond the gradient
    for(int channel = 0; channel < along.size(); ++channel)
      along[channel] = part * (m_signal(to, channel) - m_signal(from, channel))
                       - (m_signal(end, channel) - m_signal(rows[i], channel));
  }

private:
  bool is_inside(int f) const
  {
    const auto& rows = m_mesh.rows_of(f);
    return m_patch[rows[0]] == m_patch[rows[1]] && m_patch[rows[0]] == m_patch[rows[2]];
  }

  // Of the least and the greatest patch of a triangle.
  std::pair<int, int> seam_of(int f) const
  {
    const auto& rows = m_mesh.rows_of(f);
    const auto range = std::minmax({m_patch[rows[0]], m_patch[rows[1]], m_patch[rows[2]]});
    return {range.first, range.second};
  }

  // Along the longest side of a degenerate triangle only.
  Gradient gradient(int f) const
  {
    const auto& t = m_mesh.triangles[f];
    const auto& rows = m_mesh.rows_of(f);
    const Planar_triangle plane = planar_triangle(m_mesh.points[t[0]], m_mesh.points[t[1]], m_mesh.points[t[2]]);
    const int origin = rows[plane.first], along = rows[(plane.first + 1) % 3], apex = rows[(plane.first + 2) % 3];
    Gradient result = Gradient::Zero(3, channels());
    if(!(plane.length > 0))
      return result;
    for(int channel = 0; channel < channels(); ++channel)
    {
      const double by_length = (m_signal(along, channel) - m_signal(origin, channel)) / plane.length;
      result.col(channel) = by_length * plane.frame.e1;
      if(!plane.is_degenerate)
        result.col(channel) +=
          (m_signal(apex, channel) - m_signal(origin, channel) - plane.x * by_length) / plane.height * plane.frame.e2;
    }
    return result;
  }

  // The mean gradient of the triangles inside patches around a triangle.
  Gradient gradient_beside(int f) const
  {
    Gradient sum = Gradient::Zero(3, channels());
    double area = 0;
    for(int v : m_mesh.triangles[f])
      for(const int* c = m_mesh.corners.begin(v); c != m_mesh.corners.end(v); ++c)
        if(is_inside(*c / 3))
        {
          const double a = m_mesh.embedding_metric(*c / 3).area();
          sum += a * gradient(*c / 3);
          area += a;
        }
    return area > 0 ? Gradient(sum / area) : sum;
  }

  // Marks the triangles across which the signals of two patches disagree. Along a whole seam between two patches, the
  // gradients across it are compared with those of the triangles beside it; where the signals go on smoothly there is
  // nothing to stitch.
  void find_seams()
  {
    struct Sums { double difference = 0, expected = 0; };
    std::map<std::pair<int, int>, Sums> sums;
    for(int f = 0; f < m_mesh.number_of_triangles(); ++f)
    {
      if(is_inside(f))
        continue;
      const Gradient expected = gradient_beside(f);
      const double a = m_mesh.embedding_metric(f).area();
      Sums& seam = sums[seam_of(f)];
      seam.difference += a * (gradient(f) - expected).squaredNorm();
      seam.expected += a * expected.squaredNorm();
    }
    m_is_seam.assign(m_mesh.triangles.size(), 0);
    for(int f = 0; f < m_mesh.number_of_triangles(); ++f)
      if(!is_inside(f))
      {
        const Sums& seam = sums[seam_of(f)];
        m_is_seam[f] = seam.difference > seam.expected / 4; // half of the gradient that is expected there
      }
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_TARGET_FIELD_SEAM_H
