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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_DENOISER_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_DENOISER_H

#include <CGAL/Gradient_domain_processing/Denoising_summary.h>
#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/Denoising_options.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/Noise_correlation.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/Noise_estimate.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/Normal_filter.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/Outliers.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/Position_fit.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/Removed_heights.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/Smoothing_schedule.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/Surface_fairing.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/smooth_border.h>
#include <CGAL/Gradient_domain_processing/visitor.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Normals and positions in turn. Normals are a signal on the faces, filtered by a graph Laplacian that similar normals
// weight; positions are fitted to the gradients whose part along the filtered normals is taken away.
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
  double m_reach = 1; // in edges: the scale of the noise

public:
  Denoiser(const Indexed_triangles& mesh, const std::vector<char>& is_constrained, const Denoising_options& options,
           bool parallel, const std::vector<Vec3>& points, Denoising_summary& summary)
    : m_mesh(mesh)
    , m_options(options)
    , m_summary(summary)
    , m_parallel(parallel)
    , m_is_constrained(is_constrained)
    , m_dual(mesh, parallel)
    , m_rings(mesh.one_rings(parallel))
    , m_input(points)
  {}

  Error_code operator()(Progress& progress, std::vector<Vec3>& points)
  {
    repair_outliers(points);
    estimate(points);
    if(m_noise.level == 0)
      return ok;
    prepare_border();
    if(m_options.border_is_smoothed_as_curve)
      smooth_border_as_curve(points);
    return run_passes(progress, points);
  }

private:
  // Of a vertex.
  auto may_get_detail_back() const
  {
    return [this](int v) { return !m_is_constrained[v] && !m_is_outlier[v] && !m_mesh.is_on_border[v]; };
  }

  Error_code run_passes(Progress& progress, std::vector<Vec3>& points)
  {
    Smoothing_schedule smoothing(m_is_near_border, m_noise, mean_edge_length(points), m_reach);
    Normal_filter filter_normals(m_mesh, m_dual, m_parallel);
    Position_fit fit_positions(m_mesh, m_rings, m_parallel);
    weigh_positions(fit_positions);
    Removed_heights removed(m_rings, m_parallel);
    Face_geometry faces(m_mesh, m_dual, points, m_parallel);
    Normal_variation variation;
    bool is_smooth = false;
    std::vector<Vec3> before;
    const bool is_named = m_options.number_of_iterations.has_value();
    const int passes = m_options.number_of_iterations.value_or(denoising::most_passes);
    m_summary.end = is_named ? Denoising_end::named_passes : Denoising_end::most_passes;
    for(int k = 0; k < passes; ++k)
    {
      before = points;
      if(!progress.go_on(double(k) / passes))
        return error_cancelled;
      smoothing.begin(k);
      filter_normals(points, faces, smoothing, m_normals);
      if(k >= denoising::border_passes)
        keep_border_normals(faces);
      for(int i = 0; i < denoising::position_updates; ++i)
      {
        if(!progress.go_on((k + 0.5 + 0.5 * i / denoising::position_updates) / passes))
          return error_cancelled;
        fit_positions(m_input, m_normals, points);
      }
      bool removes_detail = false;
      if(m_reach == 1)
        removes_detail = give_back_detail(k, faces, removed, points);
      faces = Face_geometry(m_mesh, m_dual, points, m_parallel);
      if(!is_named && m_reach == 1 && is_at_end(k + 1, removes_detail, before, faces, variation, points))
        break;
      if(is_named && k + 2 >= passes)
        is_smooth = is_smooth_surface(faces, variation);
      m_summary.number_of_iterations = unsigned(k + 1);
      if(k + 1 == denoising::border_passes)
      {
        hold_border();
        weigh_positions(fit_positions);
      }
    }
    is_smooth = is_smooth || m_summary.end == Denoising_end::smooth_surface;
    if(passes > 0 && m_reach == 1 && m_summary.end != Denoising_end::detail
       && !fair(is_smooth, faces, removed, progress, points))
      return error_cancelled;
    return ok;
  }

  // The variation is that of the last pass, and then of this.
  bool is_smooth_surface(const Face_geometry& faces, Normal_variation& variation) const
  {
    const Normal_variation last = variation;
    variation = Normal_variation(faces.normals, m_dual, m_mesh);
    return !variation.is_of_folded_surface() && variation.is_of_smooth_surface(last);
  }

  // False where it is cancelled.
  bool fair(bool is_smooth, const Face_geometry& last_faces, Removed_heights& removed, Progress& progress,
            std::vector<Vec3>& points) const
  {
    const double weight = m_options.value_weight.value_or(denoising::value_weight);
    const double share = (std::min)(1., denoising::value_weight / weight);
    Surface_fairing fairing(m_mesh, m_rings, m_dual, share, m_parallel);
    if(is_smooth)
      fairing.take_all();
    else
      fairing.keep_creases(last_faces.normals);
    std::optional<Face_geometry> own;
    for(int round = 0; round < (is_smooth ? denoising::fairing_rounds : 1); ++round)
    {
      if(!progress.go_on(1))
        return false;
      const Face_geometry& faces = round == 0 ? last_faces : own.emplace(m_mesh, m_dual, points, m_parallel);
      const std::vector<Vec3> normals = vertex_normals(m_mesh, faces.areas, faces.normals, m_parallel);
      fairing([&](int v) { return !m_is_constrained[v]; }, normals, points);
      if(!is_smooth)
        continue;
      removed.measure(m_input, points, normals);
      removed.give_back_detail(may_get_detail_back(), denoising::detail_threshold_of_fairing, normals, points);
    }
    return true;
  }

  // Says whether too much of what was taken away is detail.
  bool give_back_detail(int pass, const Face_geometry& faces, Removed_heights& removed, std::vector<Vec3>& points) const
  {
    const std::vector<Vec3> normals = vertex_normals(m_mesh, faces.areas, m_normals, m_parallel);
    removed.measure(m_input, points, normals);
    if(pass + 1 >= denoising::first_detail_pass || removed.correlation() > most_correlation())
    {
      removed.give_back_detail(may_get_detail_back(), denoising::detail_threshold, normals, points);
      removed.measure(m_input, points, normals);
    }
    return removed.correlation() > most_correlation();
  }

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
    const bool is_correlated =
      has_correlated_noise(m_mesh, m_dual, m_rings, points, faces, mean_edge_length(points), m_parallel);
    const bool is_named = m_options.noise_level || m_options.noise_scale || m_options.number_of_iterations;
    if(is_correlated || (m_options.noise_scale && *m_options.noise_scale > 1))
      m_noise.level = denoising::correlated_level;
    else if(!is_white && is_named)
      m_noise.level = m_noise.roughness_level; // somebody knows better
    if(m_options.noise_level)
      m_noise.level = *m_options.noise_level;
    if(is_named && !is_white)
      m_noise.share = 1;
    m_reach = (std::max)(1., m_options.noise_scale.value_or(is_correlated ? denoising::correlated_scale
                                                            : is_white    ? 1
                                                                          : denoising::rest_scale));
    m_summary.noise_level = m_noise.level;
    m_summary.noise_share = m_noise.share;
    m_summary.noise_scale = m_noise.level > 0 && m_reach > 1 ? m_reach : 0;
    m_summary.roughness_level = m_noise.roughness_level;
  }

  // Border vertices are held the more, the less noise there is on the border.
  void weigh_positions(Position_fit& fit) const
  {
    constexpr double of_constraint = 1e12; // as good as one
    const double weight =
      (std::min)(m_options.value_weight.value_or(denoising::value_weight / m_reach), of_constraint);
    const double least = denoising::border_value_weight;
    const double at_border =
      (std::max)(least, (std::min)(least / (std::max)(m_noise.border_variance, 1e-12), (std::max)(100., least)));
    fit.set_weights([&](int v) { return m_is_outlier[v] ? 0 : m_mesh.is_on_border[v] ? weight * at_border : weight; },
                    [&](int v) { return !m_is_constrained[v]; });
  }

  void prepare_border()
  {
    m_is_near_border.resize(m_mesh.triangles.size());
    for(std::size_t f = 0; f < m_is_near_border.size(); ++f)
      m_is_near_border[f] = touches_border(m_mesh, m_mesh.triangles[f]);
  }

  // All vertices of the border are constrained then.
  void smooth_border_as_curve(std::vector<Vec3>& points)
  {
    smooth_border(m_mesh, m_dual, m_is_constrained, m_parallel, points);
    for(std::size_t v = 0; v < points.size(); ++v)
      if(m_mesh.is_on_border[v])
        m_is_constrained[v] = 1;
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

  // The farthest pass of a smooth surface that pays is one of two; as long as heavy noise keeps all differences small,
  // no pass tells creases.
  bool may_be_last(int passes) const
  {
    using namespace denoising;
    const double first = similarity * m_noise.level / similarity_max;
    const int blind = first > 1 ? int(std::log(first) / -std::log(similarity_decay)) : 0;
    return passes == smooth_passes + blind || passes == smooth_passes + blind + 1;
  }

  bool is_at_end(int passes, bool removes_detail, const std::vector<Vec3>& before, const Face_geometry& faces,
                 Normal_variation& variation, std::vector<Vec3>& points) const
  {
    const bool is_smooth = is_smooth_surface(faces, variation);
    if(variation.is_of_folded_surface())
      return false;
    if(removes_detail)
    {
      points = before;
      m_summary.end = Denoising_end::detail;
      return true;
    }
    if(may_be_last(passes) && is_smooth)
    {
      m_summary.end = Denoising_end::smooth_surface;
      m_summary.number_of_iterations = unsigned(passes);
      return true;
    }
    return false;
  }

  // The first, strong passes over heavy noise look correlated and recover.
  double most_correlation() const
  {
    return denoising::residual_correlation * (std::max)(m_noise.share, 0.4)
           * (1 + 2 * (std::max)(0., m_noise.level - 0.5));
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_DENOISER_H
