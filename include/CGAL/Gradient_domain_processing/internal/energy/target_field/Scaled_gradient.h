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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_TARGET_FIELD_SCALED_GRADIENT_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_TARGET_FIELD_SCALED_GRADIENT_H

#include <CGAL/Gradient_domain_processing/internal/energy/Energy_weights.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/signals.h>

#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// v = lambda grad f: smoothing and sharpening (2.1).
class Scaled_gradient
{
  const Indexed_triangles& m_mesh;
  const Energy_weights& m_weights;
  const Signal& m_signal;

public:
  Scaled_gradient(const Indexed_triangles& mesh, const Energy_weights& weights, const Signal& signal)
    : m_mesh(mesh), m_weights(weights), m_signal(signal)
  {}

  int channels() const { return int(m_signal.cols()); }
  Signal by_vertex() const { return mean_by_vertex(m_mesh, m_signal); }

  template <class Channels>
  void residual(int f, int i, int j, Channels& along) const
  {
    const auto& rows = m_mesh.rows_of(f);
    const double* const from = m_signal.data() + rows[i] * m_signal.cols();
    const double* const to = m_signal.data() + rows[j] * m_signal.cols();
    for(int channel = 0; channel < along.size(); ++channel)
      along[channel] = (m_weights.scale_at(f) - 1) * (to[channel] - from[channel]);
  }
};

// The same with the positions as signal.
class Scaled_gradient_of_positions
{
  const Indexed_triangles& m_mesh;
  const Energy_weights& m_weights;

public:
  Scaled_gradient_of_positions(const Indexed_triangles& mesh, const Energy_weights& weights)
    : m_mesh(mesh)
    , m_weights(weights)
  {
  }

  static constexpr int channels() { return 3; }
  Signal by_vertex() const { return as_signal(m_mesh.points); }

  template <class Channels>
  void residual(int f, int i, int j, Channels& along) const
  {
    const auto& t = m_mesh.triangles[f];
    const Vec3 &from = m_mesh.points[t[i]], &to = m_mesh.points[t[j]];
    for(int channel = 0; channel < 3; ++channel)
      along[channel] = (m_weights.scale_at(f) - 1) * (to[channel] - from[channel]);
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_TARGET_FIELD_SCALED_GRADIENT_H
