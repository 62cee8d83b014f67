// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_DENOISE_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_DENOISE_H

#include <CGAL/Gradient_domain_processing/internal/denoising/Face_system.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/Noise_estimate.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/filter_positions.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {

namespace internal {

struct Denoising_options
{
  static constexpr int most_passes = 20, border_passes = 5;

  int passes = -1; // chosen from the data
  double noise_level = -1; // estimated
  double value_weight, similarity, similarity_decay, similarity_min, similarity_max;
  double smoothing_weight, smoothing_growth, smoothing_weight_max;
  int normal_updates, position_updates;
  double residual_correlation, border_value_weight, border_normal_decay;

  template <class NamedParameters>
  explicit Denoising_options(const NamedParameters& np)
  {
    namespace tag = CGAL::internal_np;
    if constexpr (Has_parameter<tag::number_of_iterations_t, NamedParameters>::value)
      passes = int(parameter(np, tag::number_of_iterations, 0));
    noise_level = parameter(np, tag::noise_level, -1.);
    value_weight = parameter(np, tag::value_weight, 0.05);
    similarity = parameter(np, tag::normal_similarity, 2.8);
    similarity_decay = parameter(np, tag::normal_similarity_decay, 0.84);
    similarity_min = parameter(np, tag::normal_similarity_min, 0.2);
    similarity_max = parameter(np, tag::normal_similarity_max, 1.);
    smoothing_weight = parameter(np, tag::normal_smoothing_weight, 0.6);
    smoothing_growth = parameter(np, tag::normal_smoothing_growth, 1.05);
    smoothing_weight_max = parameter(np, tag::normal_smoothing_weight_max, 3.);
    normal_updates = int(parameter(np, tag::number_of_normal_updates, 2));
    position_updates = int(parameter(np, tag::number_of_position_updates, 3));
    residual_correlation = parameter(np, tag::residual_correlation, 0.07);
    border_value_weight = parameter(np, tag::border_value_weight, 3.);
    border_normal_decay = parameter(np, tag::border_normal_decay, 0.85);
  }

  bool are_valid() const
  {
    const auto is_positive = [](double x) { return x > 0 && std::isfinite(x); };
    return passes >= -1 && (noise_level == -1 || (noise_level >= 0 && std::isfinite(noise_level))) && is_positive(value_weight)
        && is_positive(similarity) && is_positive(similarity_decay) && is_positive(similarity_min) && is_positive(similarity_max)
        && is_positive(smoothing_weight) && is_positive(smoothing_growth) && is_positive(smoothing_weight_max)
        && normal_updates >= 1 && position_updates >= 1 && std::isfinite(residual_correlation)
        && is_positive(border_value_weight) && is_positive(border_normal_decay);
  }
};

// Normals and positions in turn. Normals are a signal on the faces, filtered by a graph Laplacian that similar normals weight;
// positions are fitted to the gradients whose part along the filtered normals is taken away.
template <class Solver, class FaceSystem>
class Denoiser
{
  Solver& m_solver;
  FaceSystem& m_face_system;
  Denoising_options m_options;
  Indexed_triangles& m_mesh;
  bool m_parallel;
  Signal m_input;
  std::vector<Vec3> m_face_normals;
  std::vector<char> m_is_near_border; // by face
  std::vector<char> m_is_held;        // by vertex

public:
  Denoiser(Solver& solver, FaceSystem& face_system, const Denoising_options& options)
    : m_solver(solver), m_face_system(face_system), m_options(options), m_mesh(solver.system().mesh)
    , m_parallel(solver.system().parallel), m_input(as_signal(m_mesh.points))
  {}

  Error_code operator()()
  {
    if(const Error_code code = m_face_system.analyze(m_mesh, m_parallel, m_solver.progress()))
      return code;
    const Lists rings = m_mesh.one_rings(m_parallel);
    Noise_estimate noise = estimate_noise(m_mesh, Face_geometry(m_mesh, m_parallel), m_face_system.edges(), rings, m_parallel);
    if(m_options.noise_level >= 0)
    {
      noise.level = m_options.noise_level;
      noise.share = 1;
    }
    if(noise.level == 0)
      return OK;
    prepare_positions(noise);
    prepare_border();

    Normal_variation variation;
    const int passes = m_options.passes >= 0 ? m_options.passes : Denoising_options::most_passes;
    for(int k = 0; k < passes; ++k)
    {
      const Signal before = as_signal(m_mesh.points);
      if(const Error_code code = filter_normals(noise, k))
        return code;
      for(int i = 0; i < m_options.position_updates; ++i)
        if(const Error_code code = fit_positions())
          return code;
      const Face_geometry faces(m_mesh, m_parallel);
      const Normal_variation last = variation;
      variation = Normal_variation(faces, m_face_system.edges(), m_parallel);
      if(m_options.passes < 0 && !variation.is_of_folded_surface())
      {
        if(removes_detail(noise, rings, faces))
        {
          m_solver.set_points(before);
          break;
        }
        if((k == 5 || k == 6) && variation.is_of_smooth_surface(last))
          break;
      }
      if(k + 1 == Denoising_options::border_passes)
        hold_border();
    }
    return OK;
  }

private:
  // Every face is an equilateral triangle of edge length one: the system does not depend on the positions and is factorized
  // once. Border vertices are held the more, the less noise there is on the border.
  void prepare_positions(const Noise_estimate& noise)
  {
    auto& system = m_solver.system();
    system.set_metrics(Untouched_vector<Triangle_metric>(m_mesh.triangles.size(), Triangle_metric::equilateral()));
    Weights weights;
    weights.value = m_options.value_weight;
    weights.gradient = 1;
    const double least = m_options.border_value_weight;
    const double at_border = (std::min)(least / (std::max)(noise.border_variance, 1e-12), (std::max)(100., least));
    weights.value_at_vertex.assign(m_mesh.points.size(), m_options.value_weight);
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if(m_mesh.is_on_border[v])
        weights.value_at_vertex[v] *= (std::max)(least, at_border);
    system.set_weights(weights);
  }

  void prepare_border()
  {
    m_is_near_border.resize(m_mesh.triangles.size());
    for(std::size_t f = 0; f < m_is_near_border.size(); ++f)
      m_is_near_border[f] = touches_border(m_mesh, m_mesh.triangles[f]);
    m_is_held.assign(m_mesh.points.size(), 0);
  }

  // At the border there is less to tell shape from noise by, and further passes would wear it off: its faces stay.
  void hold_border()
  {
    for(std::size_t f = 0; f < m_is_near_border.size(); ++f)
      if(m_is_near_border[f])
        for(int v : m_mesh.triangles[f])
        {
          m_is_held[v] = 1;
          m_input.row(v) = m_mesh.points[v].transpose();
        }
  }

  double mean_edge_length() const
  {
    const std::size_t n = m_mesh.triangles.size();
    return sum_over_blocks(m_parallel, n, 4096, 0., [&](std::size_t begin, std::size_t end) {
      double sum = 0;
      for(std::size_t f = begin; f < end; ++f)
      {
        const auto& t = m_mesh.triangles[f];
        for(int i = 0; i < 3; ++i)
          sum += (m_mesh.points[t[i]] - m_mesh.points[t[(i + 1) % 3]]).norm();
      }
      return sum;
    }) / (3. * double(n));
  }

  // g = normalize((A + beta L)^-1 A n), with weights l / (1 + |g_a - g_b|^2 / sigma^2)^2 (Geman and McClure) from the last g.
  Error_code filter_normals(const Noise_estimate& noise, int pass)
  {
    const Face_geometry faces(m_mesh, m_parallel);
    const double sigma = (std::min)(m_options.similarity_max, (std::max)(m_options.similarity_min,
                           m_options.similarity * noise.level * std::pow(m_options.similarity_decay, pass)));
    const double beta = mean_edge_length() * (std::min)(m_options.smoothing_weight_max,
                          m_options.smoothing_weight * noise.level * std::pow(m_options.smoothing_growth, pass));
    const bool border_is_held = pass >= Denoising_options::border_passes;
    // half as much again, for a face at the border has two neighbors instead of three
    const double near_border = border_is_held ? 1 : 1.5 * noise.border_level * std::pow(m_options.border_normal_decay, pass);
    const auto& edges = m_face_system.edges();

    Signal right(faces.normals.size(), 3), solution;
    parallel_for(m_parallel, faces.normals.size(), [&](std::size_t f) { right.row(f) = faces.areas[f] * faces.normals[f].transpose(); });

    m_face_normals = faces.normals;
    std::vector<double> weights(edges.size());
    for(int i = 0; i < m_options.normal_updates; ++i)
    {
      parallel_for(m_parallel, edges.size(), [&](std::size_t e) {
        const Interior_edge& edge = edges[e];
        const double q = 1 + (m_face_normals[edge.first] - m_face_normals[edge.second]).squaredNorm() / (sigma * sigma);
        weights[e] = beta * (m_mesh.points[edge.from] - m_mesh.points[edge.to]).norm() / (q * q);
        if(m_is_near_border[edge.first] || m_is_near_border[edge.second])
          weights[e] *= near_border;
      });
      if(const Error_code code = m_face_system.factorize(faces.areas, weights, m_solver.progress()))
        return code;
      if(const Error_code code = m_face_system.solve(right, solution, m_solver.progress()))
        return code;
      parallel_for(m_parallel, m_face_normals.size(), [&](std::size_t f) {
        const double length = solution.row(f).norm();
        if(length > 0 && !(border_is_held && m_is_near_border[f]))
          m_face_normals[f] = solution.row(f).transpose() / length;
      });
    }
    return OK;
  }

  // The values are those of the noisy input, the target gradients the tangential part of the current ones.
  Error_code fit_positions()
  {
    const auto excess = [&](int f, int i, int j) -> Vec3 {
      const auto& t = m_mesh.triangles[f];
      const Vec3 edge = m_mesh.points[t[j]] - m_mesh.points[t[i]];
      const Vec3& n = m_face_normals[f];
      return edge - n.dot(edge) * n - (m_input.row(t[j]) - m_input.row(t[i])).transpose();
    };
    Signal change;
    if(const Error_code code = m_solver.solve(excess, 3, change))
      return code;
    parallel_for(m_parallel, m_mesh.points.size(), [&](std::size_t v) {
      if(!m_is_held[v])
        m_mesh.points[v] = (m_input.row(v) + change.row(v)).transpose();
    });
    return OK;
  }

  // What was taken away should look like noise: uncorrelated from vertex to vertex.
  bool removes_detail(const Noise_estimate& noise, const Lists& rings, const Face_geometry& faces) const
  {
    const std::vector<Vec3> normals = vertex_normals(m_mesh, faces.areas, m_face_normals, m_parallel);
    std::vector<double> removed(m_mesh.points.size());
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
      removed[v] = (m_input.row(v).transpose() - m_mesh.points[v]).dot(normals[v]);
    double squares = 0, products = 0;
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
    {
      squares += removed[v] * removed[v];
      for(const int* w = rings.begin(v); w != rings.end(v); ++w)
        products += removed[v] * removed[*w] / rings.size(v);
    }
    // the first, strong passes over heavy noise look correlated and recover
    const double bound = m_options.residual_correlation * (std::max)(noise.share, 0.4) * (1 + 2 * (std::max)(0., noise.level - 0.5));
    return products > bound * squares;
  }
};

template <class Solver, class TriangleMesh, class NamedParameters>
Error_code denoise(Solver solver, TriangleMesh& tm, const NamedParameters& np)
{
  typedef Parameter_type<CGAL::internal_np::sparse_linear_solver_t, NamedParameters, Default_sparse_linear_solver> Linear_solver_type;
  if(solver.error() != OK)
    return solver.error();
  const Denoising_options options(np);
  if(!options.are_valid())
    return ERROR_INVALID_PARAMETER;
  return change_positions(solver, tm, np, [&] {
    if(solver.system().mesh.triangles.empty())
      return OK;
    // two systems are factorized at a time: each has a solver of its own
    Face_system<Linear_solver_type> face_system{Linear_solver_type()};
    return Denoiser<Solver, Face_system<Linear_solver_type> >(solver, face_system, options)();
  }, solver.encloses_volume());
}

} // namespace internal

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * removes noise from the positions of a mesh and keeps its creases, without a parameter to choose. Normals and positions are
 * filtered in turn:
 * - the face normals, a signal on the faces, by a Laplacian of the dual mesh whose weights fall with the distance of
 *   neighboring normals (Geman and McClure's function; twice a pass). The distance \f$ \sigma \f$ that counts as similar and the
 *   weight \f$ \beta \f$ of the smoothing follow from the noise that is estimated on the input;
 * - the positions by equation 1 of the paper, under the metric of equilateral triangles, with the values of the noisy input and the
 *   target \f$ v = (I - n n^T) \nabla x \f$, the tangential part of the current gradients. So vertices do not slide.
 *
 * The passes go on while what they remove looks like noise, 20 times at most; where no flat pieces between creases have come out
 * after 6 or 7 passes and normals have settled, the surface is smooth and they end. After the fifth pass the faces at a border stay
 * as they are. A clean mesh is returned as it is: its roughness is not taken for noise where neighboring vertices stand out
 * together, or lie in the planes of larger facets.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, with a vertex point map that can be written
 *
 * \param tm the triangle mesh; its points are moved
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among `vertex_is_constrained_map`, `border_condition`,
 *        `sparse_linear_solver`, `concurrency_tag`, `visitor`, `vertex_point_map`, `vertex_index_map` of `Gradient_domain_solver` (a solver
 *        with a state is used for the positions; the normals get one of the same type), and
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{number_of_iterations}
 *     \cgalParamDescription{the number of passes: about 5 to 7 suit smooth scans, 15 to 20 creased parts}
 *     \cgalParamType{`unsigned int`}
 *     \cgalParamDefault{chosen from the data, at most 20}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{noise_level}
 *     \cgalParamDescription{the noise of the face normals, in radians; 0 to 1}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{estimated}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{value_weight}
 *     \cgalParamDescription{how strongly the input positions are kept; useful: 0.02 (smoother, vertices move more) to 0.1}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{`0.05`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{normal_similarity}
 *     \cgalParamDescription{\f$ \sigma \f$ of the first pass, relative to the noise level; useful: 2 to 3}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{`2.8`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{normal_similarity_decay}
 *     \cgalParamDescription{by which \f$ \sigma \f$ is multiplied from pass to pass; useful: 0.8 to 0.9}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{`0.84`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{normal_similarity_min}
 *     \cgalParamDescription{the least \f$ \sigma \f$, in radians; useful: 0.15 to 0.25}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{`0.2`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{normal_similarity_max}
 *     \cgalParamDescription{the largest \f$ \sigma \f$, in radians; useful: 0.8 to 1, beyond it strong noise takes creases with it}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{`1`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{normal_smoothing_weight}
 *     \cgalParamDescription{\f$ \beta \f$ of the first pass, in mean edge lengths, relative to the noise level; useful: 0.4 to 1}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{`0.6`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{normal_smoothing_growth}
 *     \cgalParamDescription{by which \f$ \beta \f$ is multiplied from pass to pass; useful: 1 to 1.07}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{`1.05`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{normal_smoothing_weight_max}
 *     \cgalParamDescription{the largest \f$ \beta \f$, in mean edge lengths; useful: 1 to 3}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{`3`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_normal_updates}
 *     \cgalParamDescription{how often the normals are filtered in a pass, each with weights from the last; 1 to 3}
 *     \cgalParamType{`unsigned int`}
 *     \cgalParamDefault{`2`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_position_updates}
 *     \cgalParamDescription{how often the positions are fitted in a pass; 1 to 5}
 *     \cgalParamType{`unsigned int`}
 *     \cgalParamDefault{`3`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{residual_correlation}
 *     \cgalParamDescription{the correlation between neighboring vertices of what was removed, beyond which it is taken for detail and the passes end; useful: 0.05 to 0.1. Without a meaning where a number of passes is named.}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{`0.07`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{border_value_weight}
 *     \cgalParamDescription{by which `value_weight` is multiplied at border vertices, at least; more where the border has less noise than the inside; 1 to 10}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{`3`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{border_normal_decay}
 *     \cgalParamDescription{by which the smoothing of normals at the border is multiplied from pass to pass; 0.8 to 1. After the fifth pass the faces at the border stay, to the bit.}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{`0.85`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{restore_volume}
 *     \cgalParamDescription{whether the enclosed volume of every component is restored}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`true` where the mesh is closed and has no constraint}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return `OK`; or what is wrong, and then the mesh is as it was
 *
 * Complexity: a pass costs two factorizations of the normals' system, analyzed once, and four or five back-substitutions.
 */
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code denoise(TriangleMesh& tm, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::denoise(make_gradient_domain_solver(tm, np), tm, np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so to a region of the mesh. Vertices that have a face outside of the region do not move, to the bit.
 *
 * \param tm the triangle mesh
 * \param region a range of `face_descriptor`; may be empty
 * \param np as above
 */
template <class FaceRange, class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS, class = internal::Enable_if_mesh<TriangleMesh> >
Error_code denoise(const FaceRange& region, TriangleMesh& tm, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::denoise(make_gradient_domain_solver(tm, region, np), tm, np);
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_DENOISE_H
