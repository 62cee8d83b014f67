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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FIT_GRADIENTS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FIT_GRADIENTS_H

#include <CGAL/Gradient_domain_processing/internal/energy/target_field/Given_gradient.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/write_back.h>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The caller's gradients along the edges from the first corner of every triangle to all three, three rows a triangle.
template <class FaceGradientMap, class Surface>
Error_code read_gradients(FaceGradientMap gradients, const Surface_elements<Surface>& elements,
                          const Indexed_triangles& mesh, Culprit& culprit, Signal& along)
{
  const int channels = int(along.cols());
  for(int f = 0; f < mesh.number_of_triangles(); ++f)
  {
    const auto& t = mesh.triangles[f];
    const auto& value = get(gradients, elements.faces[mesh.face_of(f)]);
    int channel = 0;
    for(const auto& vector : value)
    {
      if(channel == channels)
        break;
      const Vec3 v = mesh.unit() * to_vec3(vector);
      for(int i = 1; i < 3; ++i)
        along(3 * f + i, channel) = v.dot(mesh.points[t[i]] - mesh.points[t[0]]);
      ++channel;
    }
    if(channel < channels || !along.middleRows(3 * f, 3).allFinite())
    {
      culprit.face = mesh.face_of(f);
      return error_invalid_target;
    }
  }
  return ok;
}

template <class InMap, class FaceGradientMap, class OutMap, class Surface>
Error_code fit_gradients(InMap in, FaceGradientMap gradients, OutMap out, const Surface_elements<Surface>& elements,
                         Filter& filter)
{
  if(const Error_code code = filter.ready())
    return code;
  Signal signal, along;
  {
    Stage_scope stage(filter.progress(), Stage::READ);
    if(const Error_code code = read_signal(in, elements, filter.mesh(), false, filter.culprit, signal))
      return code;
    along = Signal::Zero(3 * filter.mesh().number_of_triangles(), signal.cols());
    if(const Error_code code = read_gradients(gradients, elements, filter.mesh(), filter.culprit, along))
      return code;
  }
  Signal change;
  if(const Error_code code = filter.solve(Given_gradient(filter.mesh(), signal, along), change))
    return code;
  filter.add(change, signal);
  return write_back(in, signal, out, elements, filter);
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FIT_GRADIENTS_H
