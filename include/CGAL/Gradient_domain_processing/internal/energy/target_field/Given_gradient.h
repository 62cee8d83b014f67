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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_TARGET_FIELD_GIVEN_GRADIENT_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_TARGET_FIELD_GIVEN_GRADIENT_H

#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/signals.h>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// v as the caller gave it (1.1, eq. 1): its integrals along the edges from the first corner of every triangle to all
// three, three rows a triangle.
class Given_gradient
{
  const Indexed_triangles& m_mesh;
  const Signal& m_signal;
  const Signal& m_along;

public:
  Given_gradient(const Indexed_triangles& mesh, const Signal& signal, const Signal& along)
    : m_mesh(mesh), m_signal(signal), m_along(along)
  {}

  int channels() const { return int(m_signal.cols()); }
  Signal by_vertex() const { return mean_by_vertex(m_mesh, m_signal); }

  template <class Channels>
  void residual(int f, int i, int j, Channels& along) const
  {
    const auto& rows = m_mesh.rows_of(f);
    for(int channel = 0; channel < along.size(); ++channel)
      along[channel] = (m_along(3 * f + j, channel) - m_along(3 * f + i, channel))
                     - (m_signal(rows[j], channel) - m_signal(rows[i], channel));
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_TARGET_FIELD_GIVEN_GRADIENT_H
