// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_DENOISE_POINTS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_DENOISE_POINTS_H

#include <CGAL/Gradient_domain_processing/Denoising_summary.h>
#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/Noise_correlation.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/Noise_estimate.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/Normal_filter.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/Outliers.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/Position_fit.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/connected_components.h>
#include <CGAL/Gradient_domain_processing/visitor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// What is not named is found from the data.
struct Denoising_options
{
  std::optional<int> number_of_iterations;
  std::optional<double> noise_level, noise_scale, value_weight;
  bool border_is_smoothed_as_curve = false;

  bool are_valid() const
  {
    const auto is_at_least = [](const std::optional<double>& x, double least) { return !x || (*x >= least && std::isfinite(*x)); };
    return (!number_of_iterations || *number_of_iterations >= 0) && is_at_least(noise_level, 0) && is_at_least(noise_scale, 0)
        && is_at_least(value_weight, 0) && (!value_weight || *value_weight > 0);
  }
};

// Normals and positions in turn. Normals are a signal on the faces, filtered by a graph Laplacian that similar normals weight;
// positions are fitted to the gradients whose part along the filtered normals is taken away.
class Denoiser
{
  const Indexed_triangles& m_mesh;
  const Denoising_options& m_options;
  Denoising_summary& m_summary;
  bool m_parallel;
  std::vector<char> m_is_constrained, m_is_outlier;
  Dual_graph m_dual;
  Lists m_rings;
  Noise_estimate m_noise;
  std::vector<Vec3> m_input, m_normals;
  std::vector<char> m_is_near_border; // by face
  double m_mean_edge_length = 0, m_reach = 1;

public:
  Denoiser(const Indexed_triangles& mesh, const std::vector<char>& is_constrained, const Denoising_options& options, bool parallel,
           const std::vector<Vec3>& points, Denoising_summary& summary)
    : m_mesh(mesh), m_options(options), m_summary(summary), m_parallel(parallel), m_is_constrained(is_constrained)
    , m_dual(mesh, parallel), m_rings(mesh.one_rings(parallel)), m_input(points)
  {}

  Error_code operator()(Progress& progress, std::vector<Vec3>& points)
  {
    repair_outliers(points);
    estimate(points);
    if(m_noise.level == 0)
      return ok;
    prepare_border();
    if(m_options.border_is_smoothed_as_curve)
      smooth_border(points);
    m_mean_edge_length = mean_edge_length(points);
    Normal_filter filter_normals(m_mesh, m_dual, m_parallel);
    Position_fit fit_positions(m_mesh, m_rings, m_parallel);
    weigh_positions(fit_positions);

    Normal_variation variation;
    std::vector<Vec3> before;
    const int passes = m_options.number_of_iterations.value_or(denoising::most_passes);
    m_summary.end = m_options.number_of_iterations ? Denoising_end::named_passes : Denoising_end::most_passes;
    for(int k = 0; k < passes; ++k)
    {
      before = points;
      const Face_geometry faces(m_mesh, m_dual, points, m_parallel);
      if(!progress.go_on(double(k) / passes))
        return error_cancelled;
      filter_normals(points, faces, [&](int f) { return smoothing(k, f); }, m_normals);
      if(k >= denoising::border_passes)
        keep_border_normals(faces);
      for(int i = 0; i < denoising::position_updates; ++i)
      {
        if(!progress.go_on((k + 0.5 + 0.5 * i / denoising::position_updates) / passes))
          return error_cancelled;
        fit_positions(m_input, m_normals, points);
      }
      if(!m_options.number_of_iterations && m_reach == 1 && is_at_end(k, before, variation, points))
        break;
      m_summary.number_of_iterations = k + 1;
      if(k + 1 == denoising::border_passes)
      {
        hold_border();
        weigh_positions(fit_positions);
      }
    }
    return ok;
  }

private:
  void repair_outliers(std::vector<Vec3>& points)
  {
    m_is_outlier.assign(points.size(), 0);
    for(int round = 0; round < denoising::outlier_rounds; ++round)
    {
      const Outliers outliers(m_mesh, m_rings, points, m_parallel);
      if(outliers.size == 0)
        break;
      outliers.repair(m_is_constrained, points);
      for(std::size_t v = 0; v < points.size(); ++v)
        if(outliers.is_outlier[v] && !m_is_constrained[v])
          m_is_outlier[v] = 1;
    }
    m_summary.number_of_outliers = std::size_t(std::count(m_is_outlier.begin(), m_is_outlier.end(), 1));
    m_input = points;
  }

  void estimate(const std::vector<Vec3>& points)
  {
    const Face_geometry faces(m_mesh, m_dual, points, m_parallel);
    m_noise = estimate_noise(m_mesh, faces, m_dual, m_rings, m_parallel);
    const bool is_white = m_noise.level > 0;
    const bool is_correlated = has_correlated_noise(m_mesh, m_dual, m_rings, points, faces, m_parallel);
    const bool is_named = m_options.noise_level || m_options.noise_scale || m_options.number_of_iterations;
    if(is_correlated || (m_options.noise_scale && *m_options.noise_scale > 1))
      m_noise.level = denoising::correlated_level;
    else if(!is_white && is_named)
      m_noise.level = m_noise.roughness_level; // somebody knows better
    if(m_options.noise_level)
      m_noise.level = *m_options.noise_level;
    if(is_named && !is_white)
      m_noise.share = 1;
    m_reach = (std::max)(1., m_options.noise_scale.value_or(is_correlated ? denoising::correlated_scale : is_white ? 1 : denoising::rest_scale));
    m_summary.noise_level = m_noise.level;
    m_summary.noise_share = m_noise.share;
    m_summary.noise_scale = m_noise.level > 0 && m_reach > 1 ? m_reach : 0;
    m_summary.roughness_level = m_noise.roughness_level;
  }

  Normal_smoothing smoothing(int pass, int f) const
  {
    using namespace denoising;
    Normal_smoothing s;
    s.similarity = (std::min)(similarity_max, (std::max)(similarity_min, similarity * m_noise.level * std::pow(similarity_decay, pass)));
    // what is correlated over L edges takes L squared times the diffusion
    s.weight = m_mean_edge_length * m_reach * m_reach
             * (std::min)(smoothing_max, denoising::smoothing * m_noise.level * std::pow(smoothing_growth, pass));
    // half as much again, for a face at the border has two neighbors instead of three
    if(m_is_near_border[f] && pass < border_passes)
      s.weight *= 1.5 * m_noise.border_level * std::pow(border_normal_decay, pass);
    return s;
  }

  // Border vertices are held the more, the less noise there is on the border.
  void weigh_positions(Position_fit& fit) const
  {
    const double weight = m_options.value_weight.value_or(denoising::value_weight / m_reach);
    const double least = denoising::border_value_weight;
    const double at_border = (std::max)(least, (std::min)(least / (std::max)(m_noise.border_variance, 1e-12), (std::max)(100., least)));
    fit.set_weights([&](int v) { return m_is_outlier[v] ? 0 : m_mesh.is_on_border[v] ? weight * at_border : weight; },
                    [&](int v) { return !m_is_constrained[v]; });
  }

  void prepare_border()
  {
    m_is_near_border.resize(m_mesh.triangles.size());
    for(std::size_t f = 0; f < m_is_near_border.size(); ++f)
      m_is_near_border[f] = touches_border(m_mesh, m_mesh.triangles[f]);
  }

  // Border vertices between two others follow the curve, an implicit smoothing with edges of length one; they and all others of the
  // border are constrained then.
  void smooth_border(std::vector<Vec3>& points)
  {
    const std::size_t n = points.size();
    std::vector<std::array<int, 2> > sides(n, {{-1, -1}});
    std::vector<double> inverse_diagonal(n, 0);
    for(int f = 0; f < m_mesh.number_of_triangles(); ++f)
      for(int i = 0; i < 3; ++i)
        if(m_dual.is_border(m_mesh, f, i))
          for(int j = 0; j < 2; ++j)
          {
            const int v = m_mesh.triangles[f][(i + j) % 3];
            sides[v][sides[v][0] < 0 ? 0 : 1] = m_mesh.triangles[f][(i + 1 - j) % 3];
          }
    const double weight = denoising::border_curve_weight;
    std::vector<Vec3> right(n, Vec3(0, 0, 0)), change = right;
    const auto differences = [&](const std::vector<Vec3>& p, int v) {
      return Vec3(p[v] - p[sides[v][0]] + p[v] - p[sides[v][1]]);
    };
    for(int v = 0; v < int(n); ++v)
      if(sides[v][1] >= 0 && !m_is_constrained[v])
      {
        right[v] = -differences(points, v);
        inverse_diagonal[v] = 1 / (weight + 2);
      }
    Conjugate_gradients<Vec3> solve(m_parallel);
    solve([&](const std::vector<Vec3>& p, int v) {
      return inverse_diagonal[v] == 0 ? Vec3(0, 0, 0) : Vec3(weight * p[v] + differences(p, v));
    }, inverse_diagonal, right, denoising::normal_tolerance, denoising::most_solver_steps, change);
    for(std::size_t v = 0; v < n; ++v)
    {
      if(inverse_diagonal[v] != 0)
        points[v] += change[v];
      if(m_mesh.is_on_border[v])
        m_is_constrained[v] = 1;
    }
    m_input = points;
  }

  // At the border there is less to tell shape from noise by, and further passes would wear it off: its faces stay.
  void hold_border()
  {
    for(std::size_t f = 0; f < m_is_near_border.size(); ++f)
      if(m_is_near_border[f])
        for(int v : m_mesh.triangles[f])
          m_is_constrained[v] = 1;
  }

  void keep_border_normals(const Face_geometry& faces)
  {
    for(std::size_t f = 0; f < m_is_near_border.size(); ++f)
      if(m_is_near_border[f])
        m_normals[f] = faces.normals[f];
  }

  double mean_edge_length(const std::vector<Vec3>& points) const
  {
    const std::size_t n = m_mesh.triangles.size();
    return sum_over_blocks(m_parallel, n, 4096, 0., [&](std::size_t begin, std::size_t end) {
      double sum = 0;
      for(std::size_t f = begin; f < end; ++f)
      {
        const auto& t = m_mesh.triangles[f];
        for(int i = 0; i < 3; ++i)
          sum += (points[t[i]] - points[t[(i + 1) % 3]]).norm();
      }
      return sum;
    }) / (3. * double(n));
  }

  bool is_at_end(int k, const std::vector<Vec3>& before, Normal_variation& variation, std::vector<Vec3>& points) const
  {
    const Face_geometry faces(m_mesh, m_dual, points, m_parallel);
    const Normal_variation last = variation;
    variation = Normal_variation(faces.normals, m_dual, m_mesh);
    if(variation.is_of_folded_surface())
      return false;
    if(removes_detail(faces, points))
    {
      points = before;
      m_summary.end = Denoising_end::detail;
      return true;
    }
    if((k == 5 || k == 6) && variation.is_of_smooth_surface(last))
    {
      m_summary.end = Denoising_end::smooth_surface;
      m_summary.number_of_iterations = k + 1;
      return true;
    }
    return false;
  }

  // What was taken away should look like noise: uncorrelated from vertex to vertex.
  bool removes_detail(const Face_geometry& faces, const std::vector<Vec3>& points) const
  {
    const std::vector<Vec3> normals = vertex_normals(m_mesh, faces.areas, m_normals, m_parallel);
    std::vector<double> removed(points.size());
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
      removed[v] = (m_input[v] - points[v]).dot(normals[v]);
    double squares = 0, products = 0;
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
    {
      squares += removed[v] * removed[v];
      for(const int* w = m_rings.begin(v); w != m_rings.end(v); ++w)
        products += removed[v] * removed[*w] / m_rings.size(v);
    }
    // the first, strong passes over heavy noise look correlated and recover
    const double bound = denoising::residual_correlation * (std::max)(m_noise.share, 0.4) * (1 + 2 * (std::max)(0., m_noise.level - 0.5));
    return products > bound * squares;
  }
};

// The part of a mesh that lies at some of its vertices, all of their triangles included.
struct Mesh_part
{
  Indexed_triangles mesh;
  std::vector<int> vertices; // in the whole mesh

  Mesh_part(const Indexed_triangles& whole, std::vector<int> of_whole, std::vector<int>& place) : vertices(std::move(of_whole))
  {
    mesh.exponent = whole.exponent;
    std::vector<int> triangles;
    for(std::size_t i = 0; i < vertices.size(); ++i)
    {
      const int v = vertices[i];
      place[v] = int(i);
      mesh.points.push_back(whole.points[v]);
      mesh.is_on_border.push_back(whole.is_on_border[v]);
      for(const int* c = whole.corners.begin(v); c != whole.corners.end(v); ++c)
        if(*c % 3 == 0)
          triangles.push_back(*c / 3);
    }
    std::sort(triangles.begin(), triangles.end());
    for(int f : triangles)
      mesh.triangles.push_back({{place[whole.triangles[f][0]], place[whole.triangles[f][1]], place[whole.triangles[f][2]]}});
    mesh.index_corners();
  }
};

// Vertices by component; those of small components, which tell little of their noise, are one part.
inline std::vector<std::vector<int> > parts_to_denoise(const Indexed_triangles& mesh)
{
  const Components components = connected_components(mesh);
  std::vector<int> sizes(std::size_t(components.count), 0), part(std::size_t(components.count), -1);
  for(int c : components.of_vertex)
    ++sizes[c];
  std::vector<std::vector<int> > parts;
  int small = -1;
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
  {
    const int c = components.of_vertex[v];
    const bool is_small = sizes[c] < denoising::least_component;
    int& p = is_small ? small : part[c];
    if(mesh.corners.size(v) == 0)
      continue;
    if(p < 0)
    {
      p = int(parts.size());
      parts.emplace_back();
    }
    parts[p].push_back(v);
  }
  return parts;
}

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

inline Error_code denoise_parts(const Indexed_triangles& mesh, const std::vector<std::vector<int> >& parts,
                                const std::vector<char>& is_constrained, const Denoising_options& options, bool parallel,
                                Progress& progress, std::vector<Vec3>& points, Denoising_summary& summary)
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
    std::vector<Vec3> moved = part.mesh.points;
    Denoising_summary of_part;
    if(const Error_code code = Denoiser(part.mesh, constrained, options, parallel, moved, of_part)(progress, moved))
      return code;
    for(std::size_t i = 0; i < vertices.size(); ++i)
      points[vertices[i]] = moved[i];
    merge(of_part, summary);
  }
  return ok;
}

// Constrained vertices stay where they are, to the bit. Every component of the mesh has noise of its own. On an error, `points` are
// to be thrown away; they may be those of the mesh.
inline Error_code denoise_points(const Indexed_triangles& mesh, const std::vector<char>& is_constrained, const Denoising_options& options,
                                 bool parallel, Progress& progress, std::vector<Vec3>& points, Denoising_summary& summary)
{
  summary = Denoising_summary();
  if(!options.are_valid())
    return error_invalid_parameter;
  if(mesh.triangles.empty())
    return ok;
  if(!progress.go_on(0))
    return error_cancelled;
  Stage_scope stage(progress, Stage::SOLVE);
  const std::vector<std::vector<int> > parts = parts_to_denoise(mesh);
  if(parts.size() > 1)
    return denoise_parts(mesh, parts, is_constrained, options, parallel, progress, points, summary);
  return Denoiser(mesh, is_constrained, options, parallel, points, summary)(progress, points);
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_DENOISE_POINTS_H
