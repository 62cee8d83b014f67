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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_JET_CURVATURE_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_JET_CURVATURE_H

#include <CGAL/Gradient_domain_processing/internal/curvature/Jet_fitter.h>
#include <CGAL/Gradient_domain_processing/internal/curvature/Ring_collector.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/tbb_parallel_for.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/enumerable_thread_specific.h>
#include <tbb/task_group.h>

#include <mutex>
#endif

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The curvatures at the vertices of a mesh, one vertex at a time. One object serves one thread.
template <class Fitter>
class Jet_curvature_estimator
{
public:
  Jet_curvature_estimator(const std::vector<Vec3>& points, const std::vector<int>& offsets,
                          const std::vector<int>& neighbors, const std::vector<Vec3>& normals, int degree)
    : m_points(points), m_normals(normals), m_rings(offsets, neighbors, normals), m_fit(degree)
    , m_number_of_rings(degree <= 3 ? 2 : 3), m_wanted_number_of_points(number_of_jet_coefficients(degree) * 3 / 2)
  { }

  Principal_curvatures operator()(int v)
  {
    Principal_curvatures result = flat_curvatures(frame_of_normal(m_normals[v]));

    m_rings.start(v);
    bool can_grow = true;
    for(int ring = 1; ring <= m_number_of_rings + max_number_of_additional_rings && can_grow; ++ring)
    {
      can_grow = m_rings.add_ring(max_number_of_points) && m_rings.vertices().size() < max_number_of_points;
      const bool is_enough = ring >= m_number_of_rings && m_rings.vertices().size() >= m_wanted_number_of_points;
      if(!is_enough && can_grow)
        continue;
      const double size = place_at_origin();
      if(size > 0 && m_fit(m_neighborhood, m_normals[v], result))
      {
        result.min_curvature /= size;
        result.max_curvature /= size;
        break;
      }
    }
    return result;
  }

private:
  static constexpr std::size_t max_number_of_points = Fitter::max_number_of_points;
  static constexpr int max_number_of_additional_rings = 4;

  // The neighborhood relative to its vertex and divided by its extent, which is returned.
  double place_at_origin()
  {
    const Vec3& origin = m_points[m_rings.vertices().front()];
    double size = 0;
    for(int w : m_rings.vertices())
      size = (std::max)(size, (m_points[w] - origin).cwiseAbs().maxCoeff());

    m_neighborhood.clear();
    for(int w : m_rings.vertices())
    {
      const Vec3 p = (m_points[w] - origin) / size;
      m_neighborhood.emplace_back(p.x(), p.y(), p.z());
    }
    return size;
  }

  const std::vector<Vec3>& m_points;
  const std::vector<Vec3>& m_normals;
  Ring_collector m_rings;
  Fitter m_fit;
  typename Fitter::Points m_neighborhood;

  // Two rings around a vertex of degree six hold 19 points, three hold 37: enough to average some noise away at degree
  // 2 and 3 (6 and 10 coefficients) and at degree 4 (15). Where valences are low, or a border cuts the rings, more
  // rings follow.
  int m_number_of_rings;
  std::size_t m_wanted_number_of_points;
};

// Vertices between two calls of `go_on`.
constexpr std::size_t jet_curvature_grain = 1024;

template <class Fitter>
bool jet_curvatures_in_sequence(const std::vector<Vec3>& points, const std::vector<int>& offsets,
                                const std::vector<int>& neighbors, const std::vector<Vec3>& normals, int degree,
                                const std::function<bool(double)>& go_on, std::vector<Principal_curvatures>& result)
{
  Jet_curvature_estimator<Fitter> estimate(points, offsets, neighbors, normals, degree);
  for(std::size_t begin = 0; begin < points.size(); begin += jet_curvature_grain)
  {
    const std::size_t end = (std::min)(begin + jet_curvature_grain, points.size());
    for(std::size_t v = begin; v < end; ++v)
      result[v] = estimate(static_cast<int>(v));
    if(!go_on(double(end) / double(points.size())))
      return false;
  }
  return true;
}

#ifdef CGAL_LINKED_WITH_TBB
template <class Fitter>
bool jet_curvatures_in_parallel(const std::vector<Vec3>& points, const std::vector<int>& offsets,
                                const std::vector<int>& neighbors, const std::vector<Vec3>& normals, int degree,
                                const std::function<bool(double)>& go_on, std::vector<Principal_curvatures>& result)
{
  typedef Jet_curvature_estimator<Fitter> Estimator;
  tbb::enumerable_thread_specific<Estimator> estimators(
    [&] { return Estimator(points, offsets, neighbors, normals, degree); });
  std::mutex mutex;
  std::size_t done = 0;
  bool is_cancelled = false;
  tbb::task_group_context context;

  tbb_parallel_for(Loop_range(0, points.size(), jet_curvature_grain),
    [&](const Loop_range& range)
    {
      Estimator& estimate = estimators.local();
      for(std::size_t v = range.begin(); v != range.end(); ++v)
        result[v] = estimate(static_cast<int>(v));

      const std::lock_guard<std::mutex> lock(mutex);
      done += range.size();
      if(!is_cancelled && !go_on(double(done) / double(points.size())))
      {
        is_cancelled = true;
        context.cancel_group_execution();
      }
    }, tbb::simple_partitioner(), context);
  return !is_cancelled;
}
#endif

// Principal curvatures at the vertices from jets of `degree` 2, 3 or 4 (others count as the nearest of these) fitted to
// rings of neighbors. Rings are given end to end: those of v are neighbors[offsets[v] .. offsets[v+1]). Normals are
// unit outward normals and tell the sign; zero where unknown. A vertex without a well determined jet is flat.
// `go_on(progress)` is called by one thread at a time; once it answers false, so does this function, and `result` is
// not complete. The answer is the same to the bit whatever the concurrency.
template <class Fitter = Jet_fitter<> >
bool jet_curvatures(bool parallel, const std::vector<Vec3>& points, const std::vector<int>& offsets,
                    const std::vector<int>& neighbors, const std::vector<Vec3>& normals, int degree,
                    const std::function<bool(double)>& go_on, std::vector<Principal_curvatures>& result)
{
  degree = (std::min)((std::max)(degree, 2), 4);
  result.resize(points.size());
#ifdef CGAL_LINKED_WITH_TBB
  if(parallel)
    return jet_curvatures_in_parallel<Fitter>(points, offsets, neighbors, normals, degree, go_on, result);
#else
  (void)parallel;
#endif
  return jet_curvatures_in_sequence<Fitter>(points, offsets, neighbors, normals, degree, go_on, result);
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_JET_CURVATURE_H
