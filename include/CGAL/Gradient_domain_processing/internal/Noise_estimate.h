// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_NOISE_ESTIMATE_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_NOISE_ESTIMATE_H

#include <CGAL/Gradient_domain_processing/internal/Face_system.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Normals of length one, zero where there is none, and areas, of all faces. Areas are bounded below by a millionth of their
// mean, so that a system with them as masses is definite.
struct Face_geometry
{
  std::vector<Vec3> normals;
  std::vector<double> areas;

  explicit Face_geometry(const Mesh_arrays& mesh)
    : normals(mesh.triangles.size()), areas(mesh.triangles.size())
  {
    double sum = 0;
    for(std::size_t f = 0; f < normals.size(); ++f)
    {
      const auto& t = mesh.triangles[f];
      const Vec3 n = (mesh.points[t[1]] - mesh.points[t[0]]).cross(mesh.points[t[2]] - mesh.points[t[0]]);
      const double length = n.norm();
      normals[f] = length > 0 ? Vec3(n / length) : Vec3(0, 0, 0);
      sum += areas[f] = length / 2;
    }
    const double least = sum > 0 ? 1e-6 * sum / double(areas.size()) : 1.;
    for(double& a : areas)
      a = (std::max)(a, least);
  }
};

inline std::vector<Vec3> vertex_normals(const Mesh_arrays& mesh, const std::vector<double>& areas, const std::vector<Vec3>& normals)
{
  std::vector<Vec3> result(mesh.points.size());
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
  {
    Vec3 sum(0, 0, 0);
    for(const int* c = mesh.corners.begin(v); c != mesh.corners.end(v); ++c)
      sum += areas[*c / 3] * normals[*c / 3];
    const double length = sum.norm();
    result[v] = length > 0 ? Vec3(sum / length) : Vec3(0, 0, 0);
  }
  return result;
}

inline double median(std::vector<double> numbers)
{
  if(numbers.empty())
    return 0;
  const auto middle = numbers.begin() + numbers.size() / 2;
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

// What the positions tell of the noise on them.
struct Noise_estimate
{
  double level = 0;             // of face normals, in radians; zero for a clean mesh
  double share = 1;             // of the roughness: noise rather than detail
  double border_variance = 1;   // of the noise at the border, relative to that inside
};

// The roughness of a mesh is how far face normals are from the mean of their neighbours'. Whether it is noise shows in how the
// distances of vertices from the mean of their neighbours correlate along edges: white noise gives -0.17, surface detail 0.5 to 0.9.
// All of it is medians, so that creases do not count.
inline Noise_estimate estimate_noise(const Mesh_arrays& mesh, const Face_geometry& faces, const std::vector<Interior_edge>& edges,
                                     const Lists& rings)
{
  constexpr double noise_correlation = -0.17, detail_correlation = 0.8;
  constexpr double normal_noise_by_roughness = 1.5;
  constexpr double level_of_clean_meshes = 0.07; // curvature and coarse triangulation look like so much noise

  std::vector<Vec3> sum(faces.normals.size(), Vec3(0, 0, 0));
  std::vector<int> degree(faces.normals.size(), 0);
  for(const Interior_edge& e : edges)
  {
    sum[e.first] += faces.normals[e.second];
    sum[e.second] += faces.normals[e.first];
    ++degree[e.first];
    ++degree[e.second];
  }
  std::vector<double> roughness;
  for(std::size_t f = 0; f < sum.size(); ++f)
    if(degree[f] > 0 && faces.normals[f] != Vec3(0, 0, 0))
      roughness.push_back((faces.normals[f] - sum[f] / degree[f]).norm());

  const std::vector<Vec3> normals = vertex_normals(mesh, faces.areas, faces.normals);
  std::vector<double> offset(mesh.points.size(), 0), inside, border, differences, sums;
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
  {
    if(rings.size(v) == 0)
      continue;
    Vec3 mean(0, 0, 0), border_mean(0, 0, 0);
    int border_neighbors = 0;
    for(const int* w = rings.begin(v); w != rings.end(v); ++w)
    {
      mean += mesh.points[*w] / rings.size(v);
      if(mesh.is_on_border[*w])
      {
        border_mean += mesh.points[*w] / 2;
        ++border_neighbors;
      }
    }
    offset[v] = (mesh.points[v] - mean).dot(normals[v]);
    if(!mesh.is_on_border[v])
      inside.push_back(std::abs(offset[v]) / std::sqrt(1 + 1. / rings.size(v)));
    else if(border_neighbors == 2)
      border.push_back(std::abs((mesh.points[v] - border_mean).dot(normals[v])) / std::sqrt(1.5));
  }
  for(const Interior_edge& e : edges)
    if(!mesh.is_on_border[e.from] && !mesh.is_on_border[e.to])
    {
      differences.push_back(std::abs(offset[e.from] - offset[e.to]));
      sums.push_back(std::abs(offset[e.from] + offset[e.to]));
    }
  const double d = std::pow(median(differences), 2), s = std::pow(median(sums), 2);
  const double correlation = s + d > 0 ? (s - d) / (s + d) : 1;

  Noise_estimate noise;
  const double share = (detail_correlation - correlation) / (detail_correlation - noise_correlation);
  noise.share = std::sqrt((std::min)((std::max)(share, 0.), 1.));
  const double level = normal_noise_by_roughness * median(roughness) * noise.share;
  noise.level = std::sqrt((std::max)(0., level * level - level_of_clean_meshes * level_of_clean_meshes));
  const double of_inside = median(inside);
  if(!border.empty() && of_inside > 0)
    noise.border_variance = std::pow(median(border) / of_inside, 2);
  return noise;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_NOISE_ESTIMATE_H
