// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_POSITIONS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_POSITIONS_H

#include <CGAL/Gradient_domain_processing/Gradient_domain_solver.h>

#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

template <class TriangleMesh, class NamedParameters>
auto writable_points(TriangleMesh& tm, const NamedParameters& np)
{
  return parameter(np, CGAL::internal_np::vertex_point, get_property_map(CGAL::vertex_point, tm));
}

// Runs passes over the positions in the solver's arrays and writes the mesh when all went well.
template <class Solver, class TriangleMesh, class NamedParameters, class Passes>
Error_code change_positions(Solver& solver, TriangleMesh& tm, const NamedParameters& np, const Passes& passes,
                            bool restores_volume_by_default = false)
{
  if(solver.error() != OK)
    return solver.error();
  const bool restores_volume = parameter(np, CGAL::internal_np::restore_volume, restores_volume_by_default);
  if(restores_volume && !solver.encloses_volume())
    return ERROR_NO_VOLUME;
  Indexed_triangles& mesh = solver.system().mesh;
  const std::vector<Vec3> before = restores_volume ? mesh.points : std::vector<Vec3>();

  if(const Error_code code = passes())
    return code;

  if(restores_volume)
    restore_volumes(mesh, before, mesh.points);
  return solver.write_points(writable_points(tm, np));
}

// v = lambda grad f with the positions as signal; the metric follows the positions from pass to pass.
template <class Solver, class TriangleMesh, class NamedParameters>
Error_code filter_positions(Solver solver, TriangleMesh& tm, double default_scale, const NamedParameters& np)
{
  using namespace CGAL::internal_np;
  const int iterations = int(parameter(np, number_of_iterations, 1));
  if(iterations < 0)
    return ERROR_INVALID_PARAMETER;
  if(!Has_parameter<gradient_scale_t, NamedParameters>::value && !Has_parameter<face_gradient_scale_map_t, NamedParameters>::value)
    solver.set_gradient_scale(default_scale);

  return change_positions(solver, tm, np, [&] {
    for(int i = 0; i < iterations; ++i)
    {
      if(i > 0)
        if(const Error_code code = solver.set_metric_from_parameters(np))
          return code;
      if(const Error_code code = solver.filter_points())
        return code;
    }
    return OK;
  });
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_POSITIONS_H
