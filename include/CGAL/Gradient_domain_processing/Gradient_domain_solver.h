// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_GRADIENT_DOMAIN_SOLVER_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_GRADIENT_DOMAIN_SOLVER_H

#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/Signal_traits.h>
#include <CGAL/Gradient_domain_processing/Triangle_metric.h>
#include <CGAL/Gradient_domain_processing/enum.h>
#include <CGAL/Gradient_domain_processing/parameters.h>
#include <CGAL/Gradient_domain_processing/visitor.h>
#include <CGAL/Gradient_domain_processing/internal/energy/border_energy.h>
#include <CGAL/Gradient_domain_processing/internal/metric/curvature_metric.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/read_mesh.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/restore_volumes.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * prepares the gradient-domain energy of a mesh once and minimizes it for as many signals and target gradients as wanted:
 *
 * \f[ E(g) = \alpha \|f - g\|^2 + \beta \|v - \nabla g\|^2, \qquad (\alpha M + \beta S)\, g = \alpha M f + \beta D v \f]
 *
 * (paper, equations 1 and 2, and section 2.2). Every function of this package is made of it.
 *
 * Mesh, weights and metric are copied on construction; later changes of the mesh are not seen. What is computed is kept:
 * - the order of the unknowns, the sparsity pattern and the symbolic factorization: once;
 * - the numeric factorization: once for every metric, \f$ \alpha \f$ and \f$ \beta \f$, when it is first needed;
 * - a new \f$ \lambda \f$, signal or target costs one right-hand side and one back-substitution for all channels.
 *
 * The solution is found as the change \f$ g - f \f$ of the signal: a signal that need not change does not, and rounding errors
 * are relative to the change. Vertices without a face keep their values.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam SparseLinearSolver a model of `SparseLinearAlgebraWithFactorTraits_d`. For an `Eigen_solver_traits` the
 *         symbolic analysis is kept and all channels are solved together.
 *
 * \sa `process_signal()`
 * \sa `make_gradient_domain_solver()`
 */
template <class TriangleMesh, class SparseLinearSolver = Default_sparse_linear_solver>
class Gradient_domain_solver
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef internal::Vec3 Vec3;

public:
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;

private:
  internal::Mesh_elements<TriangleMesh> m_elements;
  internal::Linear_system<SparseLinearSolver> m_system;
  std::shared_ptr<internal::Mesh_progress<TriangleMesh> > m_progress;
  double m_squared_length_unit = 1; // weights times it are in units of the arrays
  Border_condition m_border_condition = Border_condition::FREE;
  std::vector<char> m_is_held; // constrained by a map or by the region, not by the border condition
  bool m_has_constraints = false;
  Error_code m_error = OK;

public:
  /// \name Construction
  /// @{

  /*!
   * prepares the whole mesh.
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{value_weight}
   *     \cgalParamDescription{\f$ \alpha \f$, how strongly values are kept; at least 0. With 0, every component needs a constrained vertex.}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{`1`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{gradient_weight}
   *     \cgalParamDescription{\f$ \beta \f$, how strongly gradients are fitted; at least 0. A squared length: relative to the area of the mesh, or absolute, as `area_normalization` says. Useful: `1e-6` (fine noise) to `1e-2` (everything but the gross shape).}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{`1e-4`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{gradient_scale}
   *     \cgalParamDescription{\f$ \lambda \f$, the factor of the signal's gradients in the target \f$ v = \lambda \nabla f \f$: below 1 smooths, above 1 sharpens.}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{`0`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{vertex_value_weight_map}
   *     \cgalParamDescription{\f$ \alpha \f$ at every vertex, in place of `value_weight`; linear between vertices.}
   *     \cgalParamType{a class model of `ReadablePropertyMap` with key `vertex_descriptor` and a number type as value}
   *     \cgalParamDefault{none}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{face_gradient_weight_map}
   *     \cgalParamDescription{\f$ \beta \f$ on every face, in place of `gradient_weight` and in the same units}
   *     \cgalParamType{a class model of `ReadablePropertyMap` with key `face_descriptor` and a number type as value}
   *     \cgalParamDefault{none}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{face_gradient_scale_map}
   *     \cgalParamDescription{\f$ \lambda \f$ on every face, in place of `gradient_scale`}
   *     \cgalParamType{a class model of `ReadablePropertyMap` with key `face_descriptor` and a number type as value}
   *     \cgalParamDefault{none}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{area_normalization}
   *     \cgalParamDescription{Whether \f$ \beta \f$, \f$ \epsilon \f$ and \f$ \gamma \f$ are those of the mesh scaled to unit area, so that results do not depend on the unit of length. Otherwise they are squared lengths in the unit of the mesh. The area is that of the whole mesh in its embedding, whatever the region and the metric.}
   *     \cgalParamType{`bool`}
   *     \cgalParamDefault{`true`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{face_metric_map}
   *     \cgalParamDescription{the metric of every face, in squared lengths of the mesh; wins over the parameters of curvature}
   *     \cgalParamType{a class model of `ReadablePropertyMap` with key `face_descriptor` and value `Triangle_metric`}
   *     \cgalParamDefault{none}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{curvature_metric_kind}
   *     \cgalParamDescription{how curvature stretches the metric}
   *     \cgalParamType{`Curvature_metric_kind`, or a functor model of `CurvatureStretch`: from \f$ (\kappa_1, \kappa_2) \f$ in the unit of the mesh to a `std::pair<double, double>` \f$ (s_1, s_2) \f$}
   *     \cgalParamDefault{`Curvature_metric_kind::EDGE_AWARE` if a `curvature_weight` is named, else `Curvature_metric_kind::EMBEDDING`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{curvature_weight}
   *     \cgalParamDescription{\f$ \epsilon \f$, how strongly curvature stretches the metric; at least 0. A squared length, as `gradient_weight`. A functor has its own and ignores it.}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{`0.02`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{curvature_estimator}
   *     \cgalParamDescription{how curvature is estimated}
   *     \cgalParamType{`Curvature_estimator`}
   *     \cgalParamDefault{`Curvature_estimator::JETS`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{jet_degree}
   *     \cgalParamDescription{degree of the fitted jets, 2 to 4}
   *     \cgalParamType{`int`}
   *     \cgalParamDefault{`2`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{presmoothing_weight}
   *     \cgalParamDescription{\f$ \gamma \f$, the gradient weight with which a copy of the positions (jets) or normals (normals) is smoothed before curvature is estimated; 0 switches it off. A squared length, as `gradient_weight`.}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{`1e-4`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{vertex_curvature_map}
   *     \cgalParamDescription{principal curvatures (convex positive, in the unit of the mesh) and directions, in place of an estimate}
   *     \cgalParamType{a class model of `ReadablePropertyMap` with key `vertex_descriptor` and a value type with members `min_curvature`, `max_curvature`, `min_direction`, `max_direction`, such as `CGAL::Polygon_mesh_processing::Principal_curvatures_and_directions`}
   *     \cgalParamDefault{none}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{vertex_normal_map}
   *     \cgalParamDescription{outward vertex normals, used as they are in place of computed ones wherever normals are needed}
   *     \cgalParamType{a class model of `ReadablePropertyMap` with key `vertex_descriptor` and a `Vector_3` as value}
   *     \cgalParamDefault{none}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{vertex_is_constrained_map}
   *     \cgalParamDescription{the vertices whose values are kept, to the bit}
   *     \cgalParamType{a class model of `ReadablePropertyMap` with key `vertex_descriptor` and value `bool`}
   *     \cgalParamDefault{no vertex is constrained}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{border_condition}
   *     \cgalParamDescription{what happens at the border of the mesh}
   *     \cgalParamType{`Border_condition`}
   *     \cgalParamDefault{`Border_condition::FREE`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{sparse_linear_solver}
   *     \cgalParamDescription{the linear solver; copied, so hand over one that shares its state to look at it later}
   *     \cgalParamType{`SparseLinearSolver`}
   *     \cgalParamDefault{`Default_sparse_linear_solver`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{concurrency_tag}
   *     \cgalParamDescription{whether two or more threads work on curvature, metric and assembly (with TBB). The result is the same to the bit.}
   *     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`}
   *     \cgalParamDefault{`CGAL::Parallel_if_available_tag`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{visitor}
   *     \cgalParamDescription{is told of the stages and may cancel}
   *     \cgalParamType{a model of `GradientDomainVisitor`, or a `std::reference_wrapper` of one}
   *     \cgalParamDefault{`Default_visitor`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{vertex_point_map}
   *     \cgalParamDescription{the points of the vertices}
   *     \cgalParamType{a class model of `ReadablePropertyMap` with key `vertex_descriptor` and a `Point_3` as value}
   *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{vertex_index_map}
   *     \cgalParamDescription{an index for every vertex}
   *     \cgalParamType{a class model of `ReadablePropertyMap` with key `vertex_descriptor` and value `std::size_t`}
   *     \cgalParamDefault{an automatically indexed internal map}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * What went wrong, if anything did, is said by `error()` and by every later call.
   */
  template <typename CGAL_NP_TEMPLATE_PARAMETERS>
  explicit Gradient_domain_solver(const TriangleMesh& tm, const CGAL_NP_CLASS& np = parameters::default_values())
    : m_system(internal::parameter(np, CGAL::internal_np::sparse_linear_solver, SparseLinearSolver()))
    , m_progress(internal::make_progress<TriangleMesh>(np))
  {
    initialize(tm, np, [&](std::vector<char>& is_fixed) {
      const Error_code code = internal::read_mesh(tm, vertex_points(tm, np), np, m_system.parallel, m_elements, m_system.mesh);
      is_fixed.assign(m_elements.vertices.size(), 0);
      return code;
    });
  }

  /*!
   * prepares a region of the mesh: a range of faces. Vertices that have a face outside of it keep their values, to the bit.
   * Time and memory are proportional to the region (with `area_normalization`, the area of the mesh is summed up as well).
   * An empty region is no error.
   *
   * \param tm the mesh
   * \param region a range of `face_descriptor`
   * \param np as above
   */
  template <class FaceRange, typename CGAL_NP_TEMPLATE_PARAMETERS>
  Gradient_domain_solver(const TriangleMesh& tm, const FaceRange& region, const CGAL_NP_CLASS& np = parameters::default_values())
    : m_system(internal::parameter(np, CGAL::internal_np::sparse_linear_solver, SparseLinearSolver()))
    , m_progress(internal::make_progress<TriangleMesh>(np))
  {
    initialize(tm, np, [&](std::vector<char>& is_fixed) {
      return internal::read_region(tm, region, vertex_points(tm, np), m_elements, m_system.mesh, is_fixed);
    });
  }

  /// @}
  /// \name State
  /// @{

  /// returns what went wrong during construction, or `OK`.
  Error_code error() const { return m_error; }

  /// returns the number of vertices that are solved for; known after `factorize()`.
  std::size_t number_of_unknowns() const { return std::size_t(m_system.unknowns().size()); }

  /// @}
  /// \name Weights and Metric
  /// A new value or gradient weight, or a new metric, costs one numeric factorization with the next solution.
  /// @{

  /// sets \f$ \alpha \f$, at all vertices.
  Error_code set_value_weight(double alpha)
  {
    if(!is_weight(alpha))
      return ERROR_INVALID_WEIGHT;
    internal::Weights weights = m_system.weights();
    weights.value = alpha;
    weights.value_at_vertex.clear();
    m_system.set_weights(weights);
    return OK;
  }

  /// sets \f$ \beta \f$, on all faces, in the units that were chosen on construction.
  Error_code set_gradient_weight(double beta)
  {
    if(!is_weight(beta))
      return ERROR_INVALID_WEIGHT;
    internal::Weights weights = m_system.weights();
    weights.gradient = beta * m_squared_length_unit;
    weights.gradient_at_face.clear();
    m_system.set_weights(weights);
    return OK;
  }

  /// sets \f$ \lambda \f$, on all faces. Costs nothing.
  Error_code set_gradient_scale(double lambda)
  {
    if(!std::isfinite(lambda))
      return ERROR_INVALID_WEIGHT;
    m_system.set_scale(lambda);
    return OK;
  }

  /// sets the metric to that of the embedding.
  Error_code set_embedding_metric()
  {
    if(const Error_code code = ready())
      return code;
    internal::Stage_scope stage(*m_progress, Stage::METRIC);
    m_system.set_embedding_metric();
    return OK;
  }

  /// sets the metric of every face.
  /// \tparam FaceMetricMap a model of `ReadablePropertyMap` with key `face_descriptor` and value `Triangle_metric`
  /// \return `ERROR_INVALID_METRIC` where a tensor is not positive definite; the metric is then what it was
  template <class FaceMetricMap>
  Error_code set_metric(FaceMetricMap map)
  {
    if(const Error_code code = ready())
      return code;
    internal::Stage_scope stage(*m_progress, Stage::METRIC);
    internal::Untouched_vector<Triangle_metric> metrics(m_elements.faces.size());
    const double factor = 1 / (m_system.mesh.unit() * m_system.mesh.unit());
    for(std::size_t f = 0; f < metrics.size(); ++f)
    {
      const Triangle_metric metric = get(map, m_elements.faces[f]);
      metrics[f] = metric.scaled(factor).with_area_bounded_below(internal::degeneracy_ratio);
      if(!metric.is_valid() || !metrics[f].is_valid())
        return invalid_face(ERROR_INVALID_METRIC, f);
    }
    m_system.set_metrics(std::move(metrics));
    return OK;
  }

  /// sets the metric that the parameters of curvature in `np` describe, estimating the curvature where none is given.
  /// Costs, where `presmoothing_weight` is not 0, a numeric factorization of its own.
  template <typename CGAL_NP_TEMPLATE_PARAMETERS>
  Error_code set_metric_from_parameters(const CGAL_NP_CLASS& np = parameters::default_values())
  {
    using namespace CGAL::internal_np;
    typedef CGAL_NP_CLASS NP;
    if(m_error != OK)
      return m_error;
    if constexpr (internal::Has_parameter<face_metric_map_t, NP>::value)
      return set_metric(internal::parameter(np, face_metric_map, 0));
    else if constexpr (!internal::Has_parameter<curvature_weight_t, NP>::value && !internal::Has_parameter<curvature_metric_kind_t, NP>::value)
      return set_embedding_metric(); // known when compiled, which spares compiling the estimators
    else
    {
      const auto kind = internal::parameter(np, curvature_metric_kind,
                                            internal::Has_parameter<curvature_weight_t, NP>::value
                                              ? Curvature_metric_kind::EDGE_AWARE : Curvature_metric_kind::EMBEDDING);
      if constexpr (std::is_same<typename std::decay<decltype(kind)>::type, Curvature_metric_kind>::value)
      {
        const double weight = internal::parameter(np, curvature_weight, 0.02);
        if(!is_weight(weight))
          return ERROR_INVALID_WEIGHT;
        if(kind == Curvature_metric_kind::EMBEDDING || weight == 0)
          return set_embedding_metric();
        return set_curvature_metric(internal::Curvature_stretch{kind, weight * m_squared_length_unit}, np);
      }
      else
      {
        const double unit = m_system.mesh.unit();
        return set_curvature_metric([&](double k1, double k2) { return kind(k1 / unit, k2 / unit); }, np);
      }
    }
  }

  /// @}
  /// \name Solution
  /// @{

  /// factorizes the system now rather than with the first solution.
  Error_code factorize()
  {
    return m_error != OK ? m_error : m_system.factorize(*m_progress);
  }

  /*!
   * filters a signal: \f$ v = \lambda \nabla f \f$.
   *
   * \param in the signal \f$ f \f$: a model of `ReadablePropertyMap` with key `vertex_descriptor` and any value that `Signal_traits` knows
   * \param out the result \f$ g \f$: a model of `WritablePropertyMap` with a value of the same dimension; may be `in`
   * \param number_of_iterations how often the filter is applied, to the last result each time; `ERROR_INVALID_PARAMETER` if negative
   */
  template <class InMap, class OutMap>
  Error_code filter(InMap in, OutMap out, int number_of_iterations = 1)
  {
    if(number_of_iterations < 0)
      return ERROR_INVALID_PARAMETER;
    internal::Signal signal;
    if(const Error_code code = read_signal(in, signal))
      return code;
    internal::Signal result = signal;
    for(int i = 0; i < number_of_iterations; ++i)
      if(const Error_code code = filter_in_place(result))
        return code;
    return write_signal(in, result, out);
  }

  /*!
   * finds the signal whose gradients are closest to given ones.
   *
   * \param in the signal \f$ f \f$ whose values are kept with weight \f$ \alpha \f$
   * \param gradients the target \f$ v \f$: a model of `ReadablePropertyMap` with key `face_descriptor` whose value is a range of
   *        as many `Vector_3` as the signal has channels, such as `std::array<Vector_3, 3>` for positions; in units of the signal per length.
   *        Only the tangential part of each counts.
   * \param out the result; may be `in`
   */
  template <class InMap, class FaceGradientMap, class OutMap>
  Error_code fit_to_gradients(InMap in, FaceGradientMap gradients, OutMap out)
  {
    internal::Signal signal;
    if(const Error_code code = read_signal(in, signal))
      return code;
    const internal::Indexed_triangles& mesh = m_system.mesh;
    const int channels = int(signal.cols());

    // the target integrated along the edges from the first corner of every triangle to all three
    internal::Signal along = internal::Signal::Zero(3 * mesh.number_of_triangles(), channels);
    for(int f = 0; f < mesh.number_of_triangles(); ++f)
    {
      const auto& t = mesh.triangles[f];
      const auto value = get(gradients, m_elements.faces[f]);
      int channel = 0;
      for(const auto& vector : value)
      {
        if(channel == channels)
          break;
        const Vec3 v = mesh.unit() * internal::to_vec3(vector);
        for(int i = 1; i < 3; ++i)
          along(3 * f + i, channel) = v.dot(mesh.points[t[i]] - mesh.points[t[0]]);
        ++channel;
      }
      if(channel < channels || !along.middleRows(3 * f, 3).allFinite())
        return invalid_face(ERROR_INVALID_TARGET, std::size_t(f));
    }

    const auto excess = [&](int f, int i, int j) {
      const auto& t = mesh.triangles[f];
      return (along.row(3 * f + j) - along.row(3 * f + i)) - (signal.row(t[j]) - signal.row(t[i]));
    };
    internal::Signal change;
    if(const Error_code code = solve(excess, channels, change))
      return code;
    return write_signal(in, signal + change, out);
  }

  /// @}

  /// \cond SKIP_IN_MANUAL
  // For the functions of this package, which work on the arrays.

  internal::Linear_system<SparseLinearSolver>& system() { return m_system; }
  const internal::Mesh_elements<TriangleMesh>& elements() const { return m_elements; }
  internal::Progress& progress() { return *m_progress; }

  // Tell the visitor whom an error is about, and return it.
  Error_code invalid_vertex(Error_code code, std::size_t v) const
  {
    m_progress->invalid_vertex(code, m_elements.vertices[v]);
    return code;
  }
  Error_code invalid_face(Error_code code, std::size_t f) const
  {
    m_progress->invalid_face(code, m_elements.faces[f]);
    return code;
  }
  double squared_length_unit() const { return m_squared_length_unit; }
  bool is_held(int v) const { return m_is_held[v] != 0; }
  bool is_moved(int v) const
  {
    return m_system.mesh.corners.size(v) > 0
        && (!m_system.is_constrained[v] || (m_border_condition == Border_condition::ALONG_BORDER && !m_is_held[v]));
  }

  template <class Excess>
  Error_code solve(const Excess& excess, int channels, internal::Signal& change)
  {
    if(m_error != OK)
      return m_error;
    if(m_border_condition != Border_condition::ALONG_BORDER)
      return m_system.solve(excess, channels, *m_progress, change);
    change.setZero(m_system.mesh.number_of_vertices(), channels);
    if(const Error_code code = internal::displace_border(m_system.mesh, m_system.weights(), m_is_held, excess, channels, change))
      return code;
    return m_system.solve(excess, channels, *m_progress, change, true);
  }

  Error_code filter_in_place(internal::Signal& signal)
  {
    internal::Signal change;
    if(const Error_code code = solve(m_system.excess_of_filter(signal), int(signal.cols()), change))
      return code;
    signal += change;
    return OK;
  }

  // One pass over the positions in the arrays.
  Error_code filter_points()
  {
    std::vector<Vec3>& points = m_system.mesh.points;
    internal::Signal change;
    if(const Error_code code = solve(m_system.excess_of_filter(points), 3, change))
      return code;
    for(std::size_t v = 0; v < points.size(); ++v)
      points[v] += change.row(v).transpose();
    return OK;
  }

  void set_points(const internal::Signal& positions)
  {
    for(int v = 0; v < m_system.mesh.number_of_vertices(); ++v)
      m_system.mesh.points[v] = positions.row(v).transpose();
  }

  template <class VertexPointMap>
  Error_code write_points(VertexPointMap vpm)
  {
    if(const Error_code code = ready())
      return code;
    internal::Stage_scope stage(*m_progress, Stage::WRITE);
    typedef typename boost::property_traits<VertexPointMap>::value_type Point;
    const double unit = m_system.mesh.unit();
    std::vector<Point> moved;
    moved.reserve(m_elements.vertices.size());
    for(std::size_t v = 0; v < m_elements.vertices.size(); ++v)
    {
      const Vec3 p = unit * m_system.mesh.points[v];
      moved.push_back(Signal_traits<Point>::make(p.data()));
      if(!internal::to_vec3(moved.back()).allFinite())
        return ERROR_RESULT_OUT_OF_RANGE;
    }
    for(std::size_t v = 0; v < m_elements.vertices.size(); ++v)
      if(is_moved(int(v)))
        put(vpm, m_elements.vertices[v], moved[v]);
    return OK;
  }

  // The volume has a meaning where all of a closed mesh moves freely.
  bool encloses_volume() const
  {
    for(int v = 0; v < m_system.mesh.number_of_vertices(); ++v)
      if(m_system.mesh.is_on_border[v] && m_system.mesh.corners.size(v) > 0)
        return false;
    return !m_has_constraints;
  }

  template <class Map>
  Error_code read_vectors(Map map, std::vector<Vec3>& vectors) const
  {
    vectors.resize(m_elements.vertices.size());
    for(std::size_t v = 0; v < vectors.size(); ++v)
    {
      vectors[v] = internal::to_vec3(get(map, m_elements.vertices[v]));
      if(!vectors[v].allFinite())
        return invalid_vertex(ERROR_INVALID_TARGET, v);
    }
    return OK;
  }

  // The caller's normals, or none.
  template <class NamedParameters>
  Error_code given_normals(const NamedParameters& np, std::unique_ptr<std::vector<Vec3> >& normals) const
  {
    if constexpr (internal::Has_parameter<CGAL::internal_np::vertex_normal_map_t, NamedParameters>::value)
    {
      normals = std::make_unique<std::vector<Vec3> >();
      return read_vectors(internal::parameter(np, CGAL::internal_np::vertex_normal_map, 0), *normals);
    }
    else
      return OK;
  }

  template <class NamedParameters>
  Error_code curvature_options(const NamedParameters& np, internal::Curvature_options& options) const
  {
    using namespace CGAL::internal_np;
    options.estimator = internal::parameter(np, curvature_estimator, Curvature_estimator::JETS);
    options.jet_degree = internal::parameter(np, jet_degree, 2);
    const double weight = internal::parameter(np, presmoothing_weight, 1e-4);
    options.presmoothing_weight = weight * m_squared_length_unit;
    if(options.jet_degree < 2 || options.jet_degree > 4)
      return ERROR_INVALID_PARAMETER;
    return is_weight(weight) ? OK : ERROR_INVALID_WEIGHT;
  }

  template <class InMap>
  Error_code read_signal(InMap in, internal::Signal& signal)
  {
    if(const Error_code code = ready())
      return code;
    internal::Stage_scope stage(*m_progress, Stage::READ);
    typedef Signal_traits<typename boost::property_traits<InMap>::value_type> Traits;
    signal.resize(m_elements.vertices.size(), Traits::dimension);
    for(std::size_t v = 0; v < m_elements.vertices.size(); ++v)
    {
      const auto& value = get(in, m_elements.vertices[v]);
      for(int i = 0; i < Traits::dimension; ++i)
        signal(v, i) = Traits::channel(value, i);
      if(!signal.row(v).allFinite())
        return invalid_vertex(ERROR_INVALID_SIGNAL, v);
    }
    return OK;
  }

  // Values that were not solved for are copied, so that they stay the same to the bit.
  template <class InMap, class OutMap>
  Error_code write_signal(InMap in, const internal::Signal& result, OutMap out)
  {
    if(const Error_code code = ready())
      return code;
    internal::Stage_scope stage(*m_progress, Stage::WRITE);
    typedef typename boost::property_traits<InMap>::value_type In_value;
    typedef typename boost::property_traits<OutMap>::value_type Out_value;
    typedef Signal_traits<Out_value> Traits;
    static_assert(Signal_traits<In_value>::dimension == Traits::dimension, "input and output have as many channels");

    std::vector<Out_value> values;
    values.reserve(m_elements.vertices.size());
    for(std::size_t v = 0; v < m_elements.vertices.size(); ++v)
    {
      values.push_back(Traits::make(result.row(v).data()));
      for(int i = 0; i < Traits::dimension; ++i)
        if(!std::isfinite(Traits::channel(values.back(), i)))
          return invalid_vertex(ERROR_RESULT_OUT_OF_RANGE, v);
      if constexpr (std::is_same<In_value, Out_value>::value)
        if(!is_moved(int(v)))
          values.back() = get(in, m_elements.vertices[v]);
    }
    for(std::size_t v = 0; v < values.size(); ++v)
      put(out, m_elements.vertices[v], values[v]);
    return OK;
  }
  /// \endcond

private:
  // At the beginning of every stage the visitor is asked.
  Error_code ready()
  {
    return m_error != OK ? m_error : m_progress->go_on(0) ? OK : ERROR_CANCELLED;
  }

  static bool is_weight(double w) { return w >= 0 && std::isfinite(w); }

  template <class NamedParameters>
  static auto vertex_points(const TriangleMesh& tm, const NamedParameters& np)
  {
    return internal::parameter(np, CGAL::internal_np::vertex_point, get_const_property_map(CGAL::vertex_point, tm));
  }

  template <class NamedParameters, class Read>
  void initialize(const TriangleMesh& tm, const NamedParameters& np, const Read& read)
  {
    using namespace CGAL::internal_np;
    m_system.parallel = internal::is_parallel<
      internal::Parameter_type<concurrency_tag_t, NamedParameters, Parallel_if_available_tag> >();
    if(!m_progress->go_on(0))
      m_error = ERROR_CANCELLED;
    else
    {
      internal::Stage_scope stage(*m_progress, Stage::READ);
      std::vector<char> is_fixed;
      m_error = read(is_fixed);
      if(m_error == ERROR_NON_TRIANGULAR_MESH) // reading ended at the first of these
        invalid_face(m_error, m_system.mesh.triangles.size());
      if(m_error == ERROR_INVALID_POINT)
        invalid_vertex(m_error, m_system.mesh.points.size() - 1);
      if(m_error == OK)
        m_error = read_unit(tm, np);
      if(m_error == OK)
        m_error = read_constraints(is_fixed, np);
      if(m_error == OK)
        m_error = read_weights(np);
    }
    if(m_error == OK)
      m_error = set_metric_from_parameters(np);
  }

  template <class NamedParameters>
  Error_code read_unit(const TriangleMesh& tm, const NamedParameters& np)
  {
    m_squared_length_unit = internal::parameter(np, CGAL::internal_np::area_normalization, true)
                          ? internal::total_area(tm, vertex_points(tm, np), m_system.mesh, m_system.parallel)
                          : 1 / (m_system.mesh.unit() * m_system.mesh.unit());
    return std::isfinite(m_squared_length_unit) ? OK : ERROR_INVALID_POINT;
  }

  template <class NamedParameters>
  Error_code read_constraints(std::vector<char>& is_fixed, const NamedParameters& np)
  {
    using namespace CGAL::internal_np;
    if constexpr (internal::Has_parameter<vertex_is_constrained_t, NamedParameters>::value)
    {
      const auto map = internal::parameter(np, vertex_is_constrained, 0);
      for(std::size_t v = 0; v < is_fixed.size(); ++v)
        if(get(map, m_elements.vertices[v]))
          is_fixed[v] = 1;
    }
    m_has_constraints = std::find(is_fixed.begin(), is_fixed.end(), 1) != is_fixed.end();
    m_border_condition = internal::parameter(np, CGAL::internal_np::border_condition, Border_condition::FREE);
    m_system.is_constrained = is_fixed;
    m_is_held = std::move(is_fixed);
    if(m_border_condition != Border_condition::FREE)
      for(std::size_t v = 0; v < m_is_held.size(); ++v)
        if(m_system.mesh.is_on_border[v])
          m_system.is_constrained[v] = 1;
    return OK;
  }

  template <class NamedParameters>
  Error_code read_weights(const NamedParameters& np)
  {
    using namespace CGAL::internal_np;
    internal::Weights weights;
    const double beta = internal::parameter(np, gradient_weight, 1e-4);
    weights.value = internal::parameter(np, value_weight, 1.);
    weights.gradient = beta * m_squared_length_unit;
    weights.scale = internal::parameter(np, gradient_scale, 0.);
    if(!is_weight(weights.value) || !is_weight(beta) || !std::isfinite(weights.scale))
      return ERROR_INVALID_WEIGHT;

    if constexpr (internal::Has_parameter<vertex_value_weight_map_t, NamedParameters>::value)
      if(!read_numbers(internal::parameter(np, vertex_value_weight_map, 0), m_elements.vertices, true, weights.value, weights.value_at_vertex))
        return invalid_vertex(ERROR_INVALID_WEIGHT, weights.value_at_vertex.size() - 1);
    if constexpr (internal::Has_parameter<face_gradient_weight_map_t, NamedParameters>::value)
    {
      double same = beta;
      if(!read_numbers(internal::parameter(np, face_gradient_weight_map, 0), m_elements.faces, true, same, weights.gradient_at_face))
        return invalid_face(ERROR_INVALID_WEIGHT, weights.gradient_at_face.size() - 1);
      weights.gradient = same * m_squared_length_unit;
      for(double& w : weights.gradient_at_face)
        w *= m_squared_length_unit;
    }
    if constexpr (internal::Has_parameter<face_gradient_scale_map_t, NamedParameters>::value)
      if(!read_numbers(internal::parameter(np, face_gradient_scale_map, 0), m_elements.faces, false, weights.scale, weights.scale_at_face))
        return invalid_face(ERROR_INVALID_WEIGHT, weights.scale_at_face.size() - 1);
    m_system.set_weights(weights);
    return OK;
  }

  // Numbers that are all the same make `same`, and none of their own: that is what costs least. Ends with the first bad one.
  template <class Map, class Elements>
  static bool read_numbers(Map map, const Elements& elements, bool non_negative, double& same, std::vector<double>& numbers)
  {
    numbers.reserve(elements.size());
    for(auto element : elements)
    {
      numbers.push_back(CGAL::to_double(get(map, element)));
      if(!std::isfinite(numbers.back()) || (non_negative && numbers.back() < 0))
        return false;
    }
    if(std::equal(numbers.begin() + !numbers.empty(), numbers.end(), numbers.begin()))
    {
      if(!numbers.empty())
        same = numbers.front();
      numbers = std::vector<double>();
    }
    return true;
  }

  template <class Stretch, class NamedParameters>
  Error_code set_curvature_metric(const Stretch& stretch, const NamedParameters& np)
  {
    std::vector<internal::Principal_curvatures> curvatures;
    if(const Error_code code = face_curvatures(np, curvatures))
      return code;
    if(const Error_code code = ready())
      return code;
    internal::Stage_scope stage(*m_progress, Stage::METRIC);
    internal::Untouched_vector<Triangle_metric> metrics;
    const Error_code code = internal::stretched_metrics(m_system.mesh, curvatures, stretch, m_system.parallel, metrics);
    if(code == OK)
      m_system.set_metrics(std::move(metrics));
    if(code == ERROR_INVALID_METRIC)
      for(std::size_t f = 0; f < curvatures.size(); ++f)
        if(!internal::is_valid_stretch(stretch(curvatures[f].min_curvature, curvatures[f].max_curvature)))
          return invalid_face(code, f);
    return code;
  }

  template <class NamedParameters>
  Error_code face_curvatures(const NamedParameters& np, std::vector<internal::Principal_curvatures>& curvatures)
  {
    using namespace CGAL::internal_np;
    if constexpr (internal::Has_parameter<vertex_curvature_map_t, NamedParameters>::value)
    {
      const auto map = internal::parameter(np, vertex_curvature_map, 0);
      const double unit = m_system.mesh.unit();
      std::vector<internal::Principal_curvatures> at_vertices;
      at_vertices.reserve(m_elements.vertices.size());
      for(auto v : m_elements.vertices)
      {
        const auto& k = get(map, v);
        at_vertices.push_back({unit * CGAL::to_double(k.min_curvature), unit * CGAL::to_double(k.max_curvature),
                               internal::to_vec3(k.min_direction), internal::to_vec3(k.max_direction)});
        const auto& last = at_vertices.back();
        if(!std::isfinite(last.min_curvature) || !std::isfinite(last.max_curvature) || !last.min_direction.allFinite()
           || !last.max_direction.allFinite())
          return invalid_vertex(ERROR_INVALID_TARGET, at_vertices.size() - 1);
      }
      curvatures = internal::face_curvatures(m_system.mesh, at_vertices, m_system.parallel);
      return OK;
    }
    else
    {
      internal::Curvature_options options;
      if(const Error_code code = curvature_options(np, options))
        return code;
      std::unique_ptr<std::vector<Vec3> > normals;
      if(const Error_code code = given_normals(np, normals))
        return code;

      const internal::Weights weights = m_system.weights();
      Error_code code;
      if(options.estimator == Curvature_estimator::NORMALS)
        code = internal::face_curvatures_by_normals(m_system, normals.get(), options, *m_progress, curvatures);
      else
      {
        std::vector<internal::Principal_curvatures> at_vertices;
        code = internal::vertex_curvatures_by_jets(m_system, normals.get(), options, *m_progress, at_vertices);
        if(code == OK)
          curvatures = internal::face_curvatures(m_system.mesh, at_vertices, m_system.parallel);
      }
      m_system.set_weights(weights);
      return code;
    }
  }
};

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * returns a `Gradient_domain_solver` for the mesh, with the linear solver that is named in `np`.
 */
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
auto make_gradient_domain_solver(const TriangleMesh& tm, const CGAL_NP_CLASS& np = parameters::default_values())
{
  typedef internal::Parameter_type<CGAL::internal_np::sparse_linear_solver_t, CGAL_NP_CLASS, Default_sparse_linear_solver> Solver;
  return Gradient_domain_solver<TriangleMesh, Solver>(tm, np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * returns a `Gradient_domain_solver` for a region of the mesh, with the linear solver that is named in `np`.
 */
template <class TriangleMesh, class FaceRange, typename CGAL_NP_TEMPLATE_PARAMETERS>
auto make_gradient_domain_solver(const TriangleMesh& tm, const FaceRange& region,
                                 const CGAL_NP_CLASS& np = parameters::default_values())
{
  typedef internal::Parameter_type<CGAL::internal_np::sparse_linear_solver_t, CGAL_NP_CLASS, Default_sparse_linear_solver> Solver;
  return Gradient_domain_solver<TriangleMesh, Solver>(tm, region, np);
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_GRADIENT_DOMAIN_SOLVER_H
