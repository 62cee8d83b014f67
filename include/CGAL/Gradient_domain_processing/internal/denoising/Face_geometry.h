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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_FACE_GEOMETRY_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_FACE_GEOMETRY_H

#include <CGAL/Gradient_domain_processing/internal/denoising/Dual_graph.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Normals of length one, zero where there is none, and areas, of all faces. Where the triangles are not oriented alike,
// normals are. Areas are bounded below by a millionth of their mean, so that a system with them as masses is definite.
struct Face_geometry
{
  std::vector<Vec3> normals;
  std::vector<double> areas;

  Face_geometry(const Indexed_triangles& mesh, const Dual_graph& dual, const std::vector<Vec3>& points, bool parallel)
    : normals(mesh.triangles.size()), areas(mesh.triangles.size())
  {
    parallel_for(parallel, normals.size(), [&](std::size_t f) {
      const auto& t = mesh.triangles[f];
      const Vec3 n = dual.sign(int(f)) * (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]);
      const double length = n.norm();
      normals[f] = length > 0 ? Vec3(n / length) : Vec3(0, 0, 0);
      areas[f] = length / 2;
    });
    const double sum = std::accumulate(areas.begin(), areas.end(), 0.);
    const double least = sum > 0 ? 1e-6 * sum / double(areas.size()) : 1.;
    for(double& a : areas)
      a = (std::max)(a, least);
  }
};

inline std::vector<Vec3> vertex_normals(const Indexed_triangles& mesh, const std::vector<double>& areas,
                                        const std::vector<Vec3>& normals, bool parallel)
{
  std::vector<Vec3> result(mesh.points.size());
  parallel_for(parallel, result.size(), [&](std::size_t v) {
    Vec3 sum(0, 0, 0);
    for(const int* c = mesh.corners.begin(int(v)); c != mesh.corners.end(int(v)); ++c)
      sum += areas[*c / 3] * normals[*c / 3];
    const double length = sum.norm();
    result[v] = length > 0 ? Vec3(sum / length) : Vec3(0, 0, 0);
  });
  return result;
}

inline bool touches_border(const Indexed_triangles& mesh, const std::array<int, 3>& triangle)
{
  return mesh.is_on_border[triangle[0]] || mesh.is_on_border[triangle[1]] || mesh.is_on_border[triangle[2]];
}

inline double median(std::vector<double> numbers)
{
  if(numbers.empty())
    return 0;
  const auto middle = numbers.begin() + numbers.size() / 2;
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

// How normals vary from face to face.
struct Normal_variation
{
  double median = 0, root_mean_square = 0;

  Normal_variation() {}

  Normal_variation(const std::vector<Vec3>& normals, const Dual_graph& dual, const Indexed_triangles& mesh)
  {
    std::vector<double> differences;
    differences.reserve(normals.size() * 3 / 2);
    dual.for_each_edge(mesh, [&](int f, int g, int, int) {
      differences.push_back((normals[f] - normals[g]).norm());
      root_mean_square += differences.back() * differences.back();
    });
    root_mean_square = differences.empty() ? 0 : std::sqrt(root_mean_square / double(differences.size()));
    median = internal::median(std::move(differences));
  }

  bool is_settled(const Normal_variation& before) const { return before.median > 0 && median > 0.9 * before.median; }

  // 40 degrees from face to face: noise has folded what is there, and creases come out of it late if at all.
  bool is_of_folded_surface() const { return root_mean_square > 0.7; }

  // Flat pieces between creases have a small median, and go on to become flatter; where nothing stands out, there is no
  // detail to lose, but facets may come of a further pass. Folds that stay look like creases, which become sharper.
  bool is_of_smooth_surface(const Normal_variation& before) const
  {
    const bool has_less_detail = median < 0.6 * root_mean_square;
    const bool gets_facets = root_mean_square > before.root_mean_square;
    const bool has_folds = has_less_detail && median > 0.94 * before.median && root_mean_square < 0.6
                        && root_mean_square < 1.01 * before.root_mean_square;
    return (median > 0.22 * root_mean_square || has_folds) && (has_less_detail || gets_facets) && is_settled(before)
        && root_mean_square > 0.9 * before.root_mean_square;
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_FACE_GEOMETRY_H
