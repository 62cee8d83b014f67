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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_MOVE_POSITIONS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_MOVE_POSITIONS_H

#include <CGAL/Gradient_domain_processing/parameters.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/Filter.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/counted.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/point_map.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/restore_volumes.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/signals.h>

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// What all verbs on positions understand.
struct Position_options
{
  bool restores_volume = false;
  double max_displacement = std::numeric_limits<double>::infinity(); // in the unit of the mesh
  std::array<bool, 3> is_movable{{true, true, true}};                // by axis
  bool are_valid = true;

  bool moves_along_all_axes() const { return is_movable[0] && is_movable[1] && is_movable[2]; }
};

template <class NamedParameters>
Position_options read_position_options(const NamedParameters& np, bool restores_volume_by_default)
{
  using namespace CGAL::internal_np;
  Position_options options;
  options.restores_volume = parameter(np, restore_volume, restores_volume_by_default);
  options.max_displacement = parameter(np, max_displacement, options.max_displacement);
  options.are_valid = options.max_displacement >= 0;
  if constexpr (Has_parameter<movable_axes_t, NamedParameters>::value)
  {
    options.is_movable.fill(false);
    for(char axis : std::string(parameter(np, movable_axes, "")))
      if(axis >= 'x' && axis <= 'z')
        options.is_movable[axis - 'x'] = true;
      else
        options.are_valid = false;
  }
  if(!Has_parameter<restore_volume_t, NamedParameters>::value && !options.moves_along_all_axes())
    options.restores_volume = false; // scaling would move vertices along the others
  return options;
}

// Vertices that went too far are held back on their way; virtual ones do not count. Answers how many.
int limit_displacements(const std::vector<Vec3>& before, double limit, Indexed_triangles& mesh);

// Runs passes over the positions in the solver's arrays and writes the surface when all went well. passes(end_of_pass)
// calls end_of_pass() after each.
template <class Solver, class PointMap, class NamedParameters, class Passes>
Error_code move_positions(Solver& solver, PointMap point_map, const NamedParameters& np, const Passes& passes,
                          bool restores_volume_by_default = false)
{
  if(solver.error() != ok)
    return solver.error();
  auto& filter = solver.arrays();
  const Position_options options = read_position_options(np, restores_volume_by_default);
  if(!options.are_valid)
    return error_invalid_parameter;
  if(options.restores_volume && !(filter.encloses_volume() && options.moves_along_all_axes()))
    return error_no_volume;
  Indexed_triangles& mesh = filter.system.mesh;
  const std::vector<Vec3> before = mesh.points;

  const auto end_of_pass = [&]() -> Error_code {
    for(int axis = 0; axis < 3; ++axis)
      for(std::size_t v = 0; v < before.size() && !options.is_movable[axis]; ++v)
        mesh.points[v][axis] = before[v][axis];
    return options.restores_volume && !restore_volumes(mesh, before, mesh.points) ? error_no_volume : ok;
  };
  if(const Error_code code = passes(end_of_pass))
    return solver.checked(code);

  if(std::isfinite(options.max_displacement))
    if(const int count = limit_displacements(before, options.max_displacement / mesh.unit(), mesh))
      solver.progress().notice(counted(std::size_t(count), "vertex was", "vertices were")
                               + " held back at the largest displacement");
  if(mesh.points == before)
    solver.progress().notice("no vertex was moved");
  if(const Error_code code = filter.ready())
    return code;
  Stage_scope stage(solver.progress(), Stage::WRITE);
  return solver.checked(write_points(
    point_map, solver.elements(), mesh, before, [&](int v) { return filter.is_moved(v); }, filter.culprit));
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/filtering/move_positions_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_MOVE_POSITIONS_H
