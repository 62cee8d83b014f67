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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_DENOISE_POINTS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_DENOISE_POINTS_H

#include <CGAL/Gradient_domain_processing/Denoising_summary.h>
#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/Denoiser.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/Denoising_options.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/Mesh_part.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/split_polygons.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/points.h>
#include <CGAL/Gradient_domain_processing/visitor.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

inline void merge(const Denoising_summary& part, Denoising_summary& whole)
{
  whole.noise_level = (std::max)(whole.noise_level, part.noise_level);
  whole.noise_share = (std::max)(whole.noise_share, part.noise_share);
  whole.noise_scale = (std::max)(whole.noise_scale, part.noise_scale);
  whole.roughness_level = (std::max)(whole.roughness_level, part.roughness_level);
  whole.number_of_outliers += part.number_of_outliers;
  if(part.number_of_iterations >= whole.number_of_iterations && part.end != Denoising_end::no_noise)
    whole.end = part.end;
  whole.number_of_iterations = (std::max)(whole.number_of_iterations, part.number_of_iterations);
}

// A part may be smaller than single precision, as the whole has it, can tell.
inline Error_code denoise_parts(const Indexed_triangles& mesh, const std::vector<std::vector<int> >& parts,
                                const std::vector<char>& is_constrained, const Denoising_options& options,
                                bool parallel, Progress& progress, std::vector<Vec3>& points,
                                Denoising_summary& summary)
{
  std::vector<int> place(mesh.points.size());
  for(const std::vector<int>& vertices : parts)
  {
    Mesh_part part(mesh, vertices, place);
    std::vector<char> constrained;
    for(std::size_t i = 0; i < vertices.size(); ++i)
    {
      constrained.push_back(is_constrained[vertices[i]]);
      part.mesh.points[i] = points[vertices[i]];
    }
    normalize_extent(part.mesh);
    std::vector<Vec3> moved = part.mesh.points;
    Denoising_summary of_part;
    if(const Error_code code = Denoiser(part.mesh, constrained, options, parallel, moved, of_part)(progress, moved))
      return code;
    const double unit = std::ldexp(1., part.mesh.exponent - mesh.exponent);
    for(std::size_t i = 0; i < vertices.size(); ++i)
      points[vertices[i]] = unit * moved[i];
    merge(of_part, summary);
  }
  return ok;
}

inline Error_code denoise_triangles(const Indexed_triangles& mesh, const std::vector<char>& is_constrained,
                                    const Denoising_options& options, bool parallel, Progress& progress,
                                    std::vector<Vec3>& points, Denoising_summary& summary)
{
  const std::vector<std::vector<int> > parts = parts_to_denoise(mesh);
  if(parts.size() > 1)
    return denoise_parts(mesh, parts, is_constrained, options, parallel, progress, points, summary);
  return Denoiser(mesh, is_constrained, options, parallel, points, summary)(progress, points);
}

// Constrained vertices stay where they are, to the bit. Every component of the mesh has noise of its own. On an error,
// `points` are to be thrown away; they may be those of the mesh.
inline Error_code denoise_points(const Indexed_triangles& mesh, const std::vector<char>& is_constrained,
                                 const Denoising_options& options, bool parallel, Progress& progress,
                                 std::vector<Vec3>& points, Denoising_summary& summary)
{
  summary = Denoising_summary();
  if(!options.are_valid())
    return error_invalid_parameter;
  if(mesh.triangles.empty())
    return ok;
  if(!progress.go_on(0))
    return error_cancelled;
  Stage_scope stage(progress, Stage::SOLVE);
  const int number_of_polygons = mesh.virtual_vertices.size();
  if(number_of_polygons == 0)
    return denoise_triangles(mesh, is_constrained, options, parallel, progress, points, summary);
  if(const Error_code code =
       denoise_triangles(split_polygons(mesh), is_constrained, options, parallel, progress, points, summary))
    return code;
  for(int k = 0; k < number_of_polygons; ++k)
    points[std::size_t(mesh.first_virtual_vertex() + k)] = mesh.virtual_vertices.mean(k, [&](int row) {
      return points[std::size_t(mesh.vertex_of(row))];
    });
  return ok;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_DENOISE_POINTS_H
