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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_GRADIENT_DOMAIN_SOLVER_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_GRADIENT_DOMAIN_SOLVER_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Gradient_domain_processing/Default_sparse_linear_solver.h>
#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/Signal_traits.h>
#include <CGAL/Gradient_domain_processing/Triangle_metric.h>
#include <CGAL/Gradient_domain_processing/enum.h>
#include <CGAL/Gradient_domain_processing/parameters.h>
#include <CGAL/Gradient_domain_processing/visitor.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/filter_signal.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/fit_gradients.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/Surface_filter.h>

#include <cstddef>

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * prepares the gradient-domain energy of a mesh once and minimizes it for many signals and target gradients:
 *
 * \f[ E(g) = \alpha \|f - g\|^2 + \beta \|v - \nabla g\|^2, \quad (\alpha M + \beta S) g = \alpha M f + \beta D v \f]
 *
 * (paper, equations 1 and 2, and section 2.2). Every function of this package is made of it.
 *
 * Mesh, weights and metric are copied on construction; later changes of the mesh are not seen. Kept are:
 * - order of the degrees of freedom, sparsity pattern and symbolic factorization: once for the constrained vertices;
 * - the numeric factorization: once for every metric, \f$ \alpha \f$ and \f$ \beta \f$, when it is first needed;
 * - a new \f$ \lambda \f$, signal or target costs one right-hand side and one back-substitution for all channels.
 *
 * The solution is found as the change \f$ g - f \f$ of the signal: a signal that need not change does not, and rounding
 * errors are relative to the change. Vertices without a face keep their values, whatever these are.
 *
 * A solver can be moved, not copied: a factorization has one owner. Where two are given copies of one linear solver
 * that share a state, each notices that the other has replaced its factor, and makes it again.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`; faces that are not triangles take part
 *         through a virtual vertex inside of them. For soups, see `make_gradient_domain_solver()`.
 * \tparam SparseLinearSolver a model of `SparseLinearAlgebraWithFactorTraits_d`. For an `Eigen_solver_traits` the
 *         symbolic analysis is kept and all channels are solved together.
 *
 * \sa `process_signal()`, `make_gradient_domain_solver()`
 */
template <class TriangleMesh, class SparseLinearSolver = Default_sparse_linear_solver>
class Gradient_domain_solver : internal::Surface_filter<TriangleMesh, SparseLinearSolver>
{
  typedef internal::Surface_filter<TriangleMesh, SparseLinearSolver> Base;
  using Base::m_elements, Base::m_error, Base::m_filter, Base::m_has_face_outside, Base::m_is_outside;

public:
  typedef typename internal::Surface_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  typedef typename internal::Surface_traits<TriangleMesh>::face_descriptor face_descriptor;

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
   *   \cgalParamNBegin{hessian_weight}
   *     \cgalParamDescription{\f$ \gamma \f$, the weight of second derivatives: \f$ \gamma \|\nabla \nabla g\|^2 \f$ joins the energy. A length to the fourth, in the unit that the square of `gradient_weight` has. With `gradient_weight(0)` it smooths without pulling borders in, and keeps slopes; the matrix has two to three times as many entries. Where `value_weight` and `gradient_weight` are 0, three vertices of every component have to be constrained: four for `Hessian_kind::TRACE_FREE_HESSIAN`, one for `BILAPLACIAN`; where `value_weight` alone is 0, one.}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{`0`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{hessian_kind}
   *     \cgalParamDescription{which energy of second derivatives}
   *     \cgalParamType{`Hessian_kind`}
   *     \cgalParamDefault{`Hessian_kind::SQUARED_HESSIAN`}
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
   *   \cgalParamNBegin{non_manifold_condition}
   *     \cgalParamDescription{what happens where three faces or more share an edge, as at the triple lines of label maps. The sheets stay together in any case; `ALONG_BORDER` filters these lines first, as curves of their own, which `denoise()` does not know.}
   *     \cgalParamType{`Border_condition`}
   *     \cgalParamDefault{`Border_condition::FREE`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{weld_tolerance}
   *     \cgalParamDescription{joins border vertices that are not further apart than this, relative to the extent of the surface, as the two sides of a texture seam or the corners of an STL file are. They become one degree of freedom; each gets the same change, so that signals that differ at a seam go on doing so.}
   *     \cgalParamType{`double`, `0` for vertices in the same place, negative for none}
   *     \cgalParamDefault{nothing is welded}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{missing_values}
   *     \cgalParamDescription{whether NaN in a signal means that there is no value. Such values are filled in first, as smoothly as the metric has it, and no gradient is asked for on their faces. Otherwise NaN is an error.}
   *     \cgalParamType{`bool`}
   *     \cgalParamDefault{`false`}
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
    : Base(np)
  {
    this->initialize(tm, np, [&](internal::Reading& reading) {
      return internal::read_surface(tm, internal::point_map(tm, np), np, reading, m_elements, m_filter.system.mesh);
    });
  }

  /*!
   * prepares a region of the mesh. Vertices with a face outside keep their values, to the bit. Time and memory are
   * proportional to the region (`area_normalization` sums up the area of all). An empty region is no error.
   *
   * \param region a range of `face_descriptor`; `error_invalid_region` where one is none of the mesh
   * \param tm the mesh
   * \param np as above
   */
  template <class FaceRange, typename CGAL_NP_TEMPLATE_PARAMETERS>
  Gradient_domain_solver(const FaceRange& region, const TriangleMesh& tm,
                         const CGAL_NP_CLASS& np = parameters::default_values())
    : Base(np)
  {
    this->initialize(tm, np, [&](internal::Reading& reading) {
      return internal::read_region(region, tm, internal::point_map(tm, np), np, reading, m_elements,
                                   m_filter.system.mesh, m_has_face_outside);
    });
  }

  /// takes over what another solver has prepared.
  Gradient_domain_solver(Gradient_domain_solver&&) = default;
  /// takes over what another solver has prepared.
  Gradient_domain_solver& operator=(Gradient_domain_solver&&) = default;

  /// @}
  /// \name State
  /// @{

  /// returns what went wrong during construction, or `ok`.
  Error_code error() const { return m_error; }

  /// returns the number of vertices that are solved for; known after `factorize()`.
  std::size_t number_of_degrees_of_freedom() const { return std::size_t(m_filter.system.degrees_of_freedom().size()); }

  /// returns how many vertices were welded to others.
  std::size_t number_of_welded_vertices() const { return std::size_t(this->m_number_of_welded_vertices); }

  /// @}
  /// \name Weights, Constraints and Metric
  /// A new value or gradient weight, or a new metric, costs one numeric factorization with the next solution; new
  /// constraints cost an analysis as well. Where one of these functions fails or throws, all is as it was.
  /// @{

  /// sets \f$ \alpha \f$, at all vertices.
  Error_code set_value_weight(double alpha)
  {
    return this->set_weight(alpha, [](internal::Energy_weights& weights, double w) { weights.set_value(w); });
  }

  /// sets \f$ \beta \f$, on all faces, in the units that were chosen on construction.
  Error_code set_gradient_weight(double beta)
  {
    return this->set_weight(beta, [unit = m_filter.squared_length_unit](internal::Energy_weights& weights, double w) {
      weights.set_gradient(w * unit);
    });
  }

  /// sets \f$ \lambda \f$, on all faces. Costs nothing.
  Error_code set_gradient_scale(double lambda) { return this->set_scale(lambda); }

  /// sets all weights as the named parameters say, also by vertex and face; one that is not named gets its default.
  template <typename CGAL_NP_TEMPLATE_PARAMETERS>
  Error_code set_weights_from_parameters(const CGAL_NP_CLASS& np = parameters::default_values())
  {
    return m_error != ok ? m_error : checked(internal::read_weights(np, m_elements, m_filter));
  }

  /// sets the constrained vertices and the border condition as the named parameters say; the region stays.
  template <typename CGAL_NP_TEMPLATE_PARAMETERS>
  Error_code set_constraints_from_parameters(const CGAL_NP_CLASS& np = parameters::default_values())
  {
    if(m_error == ok)
      internal::read_constraints(np, m_elements, m_is_outside, m_filter);
    return m_error;
  }

  /// sets another region, a range of `face_descriptor`, with constraints and border condition as the named parameters
  /// say; weights and metric stay. Costs what new constraints do, of the region: the mesh is not read again.
  /// \return `error_invalid_region` where a face is none of those the solver was made for
  template <class FaceRange, typename CGAL_NP_TEMPLATE_PARAMETERS>
  Error_code set_region(const FaceRange& region, const CGAL_NP_CLASS& np = parameters::default_values())
  {
    return this->constrain_outside_of(region, np);
  }

  /// sets the metric to that of the embedding.
  Error_code set_embedding_metric()
  {
    if(m_error == ok)
      m_filter.system.set_embedding_metric();
    return m_error;
  }

  /// sets the metric of every face.
  /// \tparam FaceMetricMap a model of `ReadablePropertyMap` with key `face_descriptor` and value `Triangle_metric`
  /// \return `error_invalid_metric` where a tensor is not positive definite, `error_non_triangular_mesh` for polygons
  template <class FaceMetricMap>
  Error_code set_metric(FaceMetricMap map)
  {
    return m_error != ok ? m_error : checked(internal::read_metrics(map, m_elements, m_filter));
  }

  /// sets the metric that the parameters of curvature describe; costs, with presmoothing, a factorization of its own.
  template <typename CGAL_NP_TEMPLATE_PARAMETERS>
  Error_code set_metric_from_parameters(const CGAL_NP_CLASS& np = parameters::default_values())
  {
    return m_error != ok ? m_error : checked(internal::set_metric(np, m_elements, m_filter));
  }

  /// @}
  /// \name Solution
  /// @{

  /// factorizes the system now rather than with the first solution.
  Error_code factorize() { return m_error != ok ? m_error : m_filter.system.factorize(progress()); }

  /*!
   * filters a signal: \f$ v = \lambda \nabla f \f$.
   *
   * \param in the signal \f$ f \f$: a model of `ReadablePropertyMap` with key `vertex_descriptor` and any value that
   *        `Signal_traits` knows
   * \param out the result \f$ g \f$: a model of `WritablePropertyMap` with a value of the same dimension; may be `in`
   * \param number_of_iterations how often the filter is applied, to the last result each time;
   *        `error_invalid_parameter` if negative
   */
  template <class InMap, class OutMap>
  Error_code filter(InMap in, OutMap out, int number_of_iterations = 1)
  {
    return m_error != ok ? m_error
                         : checked(internal::filter_signal(in, out, number_of_iterations, this->m_may_values_be_missing,
                                                           m_elements, m_filter));
  }

  /*!
   * finds the signal whose gradients are closest to given ones.
   *
   * \param in the signal \f$ f \f$ whose values are kept with weight \f$ \alpha \f$
   * \param gradients the target \f$ v \f$: a model of `ReadablePropertyMap` with key `face_descriptor` whose value is a
   *        range of as many `Vector_3` as the signal has channels, such as `std::array<Vector_3, 3>` for positions; in
   *        units of the signal per length. Only the tangential part of each counts.
   * \param out the result; may be `in`
   */
  template <class InMap, class FaceGradientMap, class OutMap>
  Error_code fit_to_gradients(InMap in, FaceGradientMap gradients, OutMap out)
  {
    return m_error != ok ? m_error : checked(internal::fit_gradients(in, gradients, out, m_elements, m_filter));
  }

  /// @}

  /// \cond SKIP_IN_MANUAL
  // For the functions of this package, which work on the arrays.
  using Base::arrays, Base::checked, Base::elements, Base::progress;
  /// \endcond
};

} // namespace Gradient_domain_processing
} // namespace CGAL

#include <CGAL/Gradient_domain_processing/make_gradient_domain_solver.h>

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_GRADIENT_DOMAIN_SOLVER_H
