// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_STITCH_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_STITCH_H

#include <CGAL/Gradient_domain_processing/Gradient_domain_solver.h>

#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {

namespace internal {

// The gradient of every channel on a triangle, as columns.
inline Eigen::Matrix<double, 3, Eigen::Dynamic> gradient(const Indexed_triangles& mesh, const Signal& signal, int f)
{
  const auto& t = mesh.triangles[f];
  Eigen::Matrix<double, 3, 2> edges;
  edges.col(0) = mesh.points[t[1]] - mesh.points[t[0]];
  edges.col(1) = mesh.points[t[2]] - mesh.points[t[0]];
  Eigen::Matrix<double, 2, Eigen::Dynamic> differences(2, signal.cols());
  differences.row(0) = signal.row(t[1]) - signal.row(t[0]);
  differences.row(1) = signal.row(t[2]) - signal.row(t[0]);
  return edges.transpose().completeOrthogonalDecomposition().solve(differences);
}

// Marks the triangles across which the signals of two patches disagree. Along a whole seam between two patches, the gradients
// across it are compared with those of the triangles beside it; where the signals go on smoothly there is nothing to stitch.
inline std::vector<char> find_seams(const Indexed_triangles& mesh, const std::vector<int>& patch, const Signal& signal)
{
  const int n = mesh.number_of_triangles();
  const auto is_inside = [&](int f) {
    const auto& t = mesh.triangles[f];
    return patch[t[0]] == patch[t[1]] && patch[t[0]] == patch[t[2]];
  };
  const auto seam_of = [&](int f) {
    const auto& t = mesh.triangles[f];
    const auto range = std::minmax({patch[t[0]], patch[t[1]], patch[t[2]]});
    return std::pair<int, int>(range.first, range.second);
  };

  struct Sums { double difference = 0, expected = 0; };
  std::map<std::pair<int, int>, Sums> sums;
  for(int f = 0; f < n; ++f)
  {
    if(is_inside(f))
      continue;
    Eigen::Matrix<double, 3, Eigen::Dynamic> expected = Eigen::Matrix<double, 3, Eigen::Dynamic>::Zero(3, signal.cols());
    double area = 0;
    for(int v : mesh.triangles[f])
      for(const int* c = mesh.corners.begin(v); c != mesh.corners.end(v); ++c)
        if(is_inside(*c / 3))
        {
          const double a = mesh.embedding_metric(*c / 3).area();
          expected += a * gradient(mesh, signal, *c / 3);
          area += a;
        }
    if(area > 0)
      expected /= area;
    const double a = mesh.embedding_metric(f).area();
    Sums& seam = sums[seam_of(f)];
    seam.difference += a * (gradient(mesh, signal, f) - expected).squaredNorm();
    seam.expected += a * expected.squaredNorm();
  }

  std::vector<char> is_seam(n, 0);
  for(int f = 0; f < n; ++f)
    if(!is_inside(f))
    {
      const Sums& seam = sums[seam_of(f)];
      is_seam[f] = seam.difference > seam.expected / 4; // half of the gradient that is expected there
    }
  return is_seam;
}

template <class Solver, class VertexPatchMap, class InMap, class OutMap, class NamedParameters>
Error_code stitch(Solver solver, VertexPatchMap patch_map, InMap in, OutMap out, const NamedParameters&)
{
  using namespace CGAL::internal_np;
  if(!Has_parameter<gradient_weight_t, NamedParameters>::value && !Has_parameter<face_gradient_weight_map_t, NamedParameters>::value)
    solver.set_gradient_weight(1e4);
  Signal signal;
  if(const Error_code code = solver.read_signal(in, signal))
    return code;
  const Indexed_triangles& mesh = solver.system().mesh;
  std::vector<int> patch;
  std::map<typename boost::property_traits<VertexPatchMap>::value_type, int> numbers;
  for(auto v : solver.elements().vertices)
    patch.push_back(numbers.emplace(get(patch_map, v), int(numbers.size())).first->second);

  // On a seam the part of the gradient along the edge inside a patch is kept; a triangle between three patches has none.
  const std::vector<char> is_seam = find_seams(mesh, patch, signal);
  const auto excess = [&](int f, int i, int j) {
    const auto& t = mesh.triangles[f];
    int from = t[0], to = t[0]; // the edge inside a patch
    double part = 0;            // of it that goes along the edge asked for
    for(int k = 0; k < 3; ++k)
    {
      const int a = t[k], b = t[(k + 1) % 3];
      const Vec3 edge = mesh.points[b] - mesh.points[a];
      const double squared_length = edge.squaredNorm();
      if(is_seam[f] && patch[a] == patch[b] && squared_length > 0)
      {
        from = a;
        to = b;
        part = edge.dot(mesh.points[t[j]] - mesh.points[t[i]]) / squared_length;
      }
    }
    const int end = is_seam[f] ? t[j] : t[i]; // elsewhere nothing exceeds
    return part * (signal.row(to) - signal.row(from)) - (signal.row(end) - signal.row(t[i]));
  };
  Signal change;
  if(const Error_code code = solver.solve(excess, int(signal.cols()), change))
    return code;
  return solver.write_signal(in, signal + change, out);
}

} // namespace internal

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * fuses the signals of several patches of a mesh into one without seams, such as the colors of two photographs or the offsets of
 * two scans: the gradients inside each patch are kept, and across a seam none is wanted (paper, sections 1 and 2.1; Yu et al. 2004 for
 * positions). On triangles whose vertices belong to different patches the target \f$ v \f$ is the part of \f$ \nabla f \f$ along the edge that lies in one
 * patch (zero between three patches), on all others \f$ \nabla f \f$.
 * The values \f$ f \f$ determine only what is left open by that, the constants of the patches, by their small weight.
 *
 * A seam across which the signals agree, so that the gradients go on from patch to patch, is left as it is: patches that fit are
 * returned unchanged. They agree where the gradients across the seam differ by less than half (in the mean of squares) from those beside it.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam VertexPatchMap a model of `ReadablePropertyMap` with key `vertex_descriptor` and any value with `operator<`
 * \tparam InMap a model of `ReadablePropertyMap` with key `vertex_descriptor` and any value that `Signal_traits` knows
 * \tparam OutMap a model of `WritablePropertyMap` with a value of the same dimension
 *
 * \param tm the triangle mesh; it is not changed
 * \param patches the patch of every vertex
 * \param in the signal: at every vertex, that of its patch
 * \param out the result; may be `in`
 * \param np all the \ref bgl_namedparameters "Named Parameters" of `Gradient_domain_solver`, of which `gradient_weight` is by default `1e4`.
 *        With constrained vertices, `value_weight(0)` keeps nothing but gradients and constraints.
 *
 * \return `OK`; or what is wrong, and then `out` is as it was
 */
template <class TriangleMesh, class VertexPatchMap, class InMap, class OutMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code stitch(const TriangleMesh& tm, VertexPatchMap patches, InMap in, OutMap out,
                  const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::stitch(make_gradient_domain_solver(tm, np), patches, in, out, np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so in a region of the mesh, such as the surroundings of one seam. Vertices that have a face outside of the region keep their
 * values, to the bit, and `out` is written at the vertices of the region only.
 *
 * \param region a range of `face_descriptor`; may be empty
 * \param tm, patches, in, out, np as above
 */
template <class FaceRange, class TriangleMesh, class VertexPatchMap, class InMap, class OutMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code stitch(const FaceRange& region, const TriangleMesh& tm, VertexPatchMap patches, InMap in, OutMap out,
                  const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::stitch(make_gradient_domain_solver(tm, region, np), patches, in, out, np);
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_STITCH_H
