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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_SPECTRUM_OF_SIGNAL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_SPECTRUM_OF_SIGNAL_H

#include <CGAL/Gradient_domain_processing/internal/filtering/Filter.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/write_back.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/signals.h>
#include <CGAL/Gradient_domain_processing/internal/spectrum/Spectral_system.h>

#include <cstddef>
#include <memory>
#include <utility>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// What a signal by vertex has beside the harmonic function that agrees with it at the constrained vertices: the part
// that harmonics, which are zero there, make up. In components without such vertices it is all of the signal.
Error_code subtract_harmonic_extension(Filter& filter, Signal& signal);

// `apply` filters a matrix of values by degree of freedom, given the system.
template <class InMap, class OutMap, class Surface, class Apply>
Error_code filter_spectrum_of_signal(InMap in, OutMap out, std::unique_ptr<Any_linear_solver> solver,
                                     const Surface_elements<Surface>& elements, Filter& filter, const Apply& apply)
{
  if(const Error_code code = filter.ready())
    return code;
  const Indexed_triangles& mesh = filter.mesh();
  Signal signal;
  {
    Stage_scope stage(filter.progress(), Stage::READ);
    if(const Error_code code = read_signal(in, elements, mesh, false, filter.culprit, signal))
      return code;
  }
  Signal part = mean_by_vertex(mesh, signal);
  if(const Error_code code = subtract_harmonic_extension(filter, part))
    return code;
  Spectral_system system(std::move(solver), filter.system.parallel);
  if(const Error_code code =
       system.assemble_matrices(mesh, filter.system.metrics(), filter.system.is_constrained, filter.progress()))
    return code;
  const Degrees_of_freedom& dofs = system.degrees_of_freedom();
  Signal change = Signal::Zero(mesh.number_of_vertices(), signal.cols());
  if(dofs.size() > 0)
  {
    Eigen::MatrixXd values(dofs.size(), signal.cols());
    for_each_degree_of_freedom(system.is_parallel(), dofs, [&](int v, int i) { values.row(i) = part.row(v); });
    if(const Error_code code = apply(system, values))
      return code;
    for_each_degree_of_freedom(system.is_parallel(), dofs,
                               [&](int v, int i) { change.row(v) = values.row(i) - part.row(v); });
  }
  filter.add(change, signal);
  return write_back(in, signal, out, elements, filter, [&](int v) {
    return mesh.corners.size(v) > 0 && !filter.system.is_constrained[std::size_t(v)];
  });
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/filtering/filter_spectrum_of_signal_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_SPECTRUM_OF_SIGNAL_H
