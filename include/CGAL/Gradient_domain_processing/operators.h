// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_OPERATORS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_OPERATORS_H

#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/Triangle_metric.h>
#include <CGAL/Gradient_domain_processing/parameters.h>
#include <CGAL/Gradient_domain_processing/internal/energy/assembly.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/read_mesh.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {

namespace internal {

// A mesh whose arrays are in the order of its index maps, with its metrics, all in the unit of the mesh.
struct Operator_input
{
  Indexed_triangles mesh;
  Triangle_metrics metrics;
  std::vector<int> vertex_index; // of every vertex in the arrays
  std::vector<int> face_index;   // of every triangle
};

template <class TriangleMesh, class NamedParameters>
Error_code read_operator_input(const TriangleMesh& tm, const NamedParameters& np, Operator_input& input)
{
  using namespace CGAL::internal_np;
  Mesh_elements<TriangleMesh> elements;
  const auto vpm = parameter(np, CGAL::internal_np::vertex_point, get_const_property_map(CGAL::vertex_point, tm));
  const bool parallel = is_parallel<Parameter_type<concurrency_tag_t, NamedParameters, Parallel_if_available_tag> >();
  if(const Error_code code = read_mesh(tm, vpm, np, parallel, elements, input.mesh))
    return code;

  const double squared_unit = input.mesh.unit() * input.mesh.unit();
  input.metrics.given.reserve(elements.faces.size());
  for(std::size_t f = 0; f < elements.faces.size(); ++f)
  {
    if constexpr (Has_parameter<face_metric_map_t, NamedParameters>::value)
    {
      const Triangle_metric metric = get(parameter(np, face_metric_map, 0), elements.faces[f]);
      if(!metric.is_valid())
        return ERROR_INVALID_METRIC;
      input.metrics.given.push_back(metric.with_area_bounded_below(degeneracy_ratio));
    }
    else
      input.metrics.given.push_back(Triangle_metrics()(input.mesh, int(f)).scaled(squared_unit));
  }

  const auto vertex_index_map = CGAL::get_initialized_vertex_index_map(tm, np);
  for(auto v : elements.vertices)
    input.vertex_index.push_back(int(get(vertex_index_map, v)));
  const auto face_index_map = CGAL::get_initialized_face_index_map(tm, np);
  for(auto f : elements.faces)
    input.face_index.push_back(int(get(face_index_map, f)));
  return OK;
}

inline int index_range(const std::vector<int>& indices)
{
  return indices.empty() ? 0 : 1 + *std::max_element(indices.begin(), indices.end());
}

template <class TriangleMesh, class NamedParameters>
Error_code assemble_operator(const TriangleMesh& tm, double value_weight, double gradient_weight, const NamedParameters& np,
                             Eigen::SparseMatrix<double>& matrix)
{
  Operator_input input;
  if(const Error_code code = read_operator_input(tm, np, input))
    return code;
  const bool parallel = is_parallel<Parameter_type<CGAL::internal_np::concurrency_tag_t, NamedParameters, Parallel_if_available_tag> >();

  // indices without a vertex are those of vertices without a face: rows of zeros
  Degrees_of_freedom unknowns;
  unknowns.of_vertex = input.vertex_index;
  unknowns.vertex.assign(index_range(input.vertex_index), -1);
  for(std::size_t v = 0; v < input.vertex_index.size(); ++v)
    unknowns.vertex[input.vertex_index[v]] = int(v);
  for(int& v : unknowns.vertex)
    if(v < 0)
    {
      v = input.mesh.number_of_vertices();
      input.mesh.points.push_back(Vec3::Zero());
      input.mesh.corners.offsets.push_back(input.mesh.corners.offsets.back());
      unknowns.of_vertex.push_back(int(&v - unknowns.vertex.data()));
    }

  Weights weights;
  weights.value = value_weight;
  weights.gradient = gradient_weight;
  set_pattern(sparsity_pattern(input.mesh.one_rings(parallel), unknowns, false, parallel), parallel, matrix);
  assemble(input.mesh, input.metrics, weights, unknowns, parallel, matrix, false);
  return OK;
}

} // namespace internal

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * assembles the mass matrix \f$ M_{ij} = \int \phi_i \phi_j \f$ of the hat functions (paper, section 2.2 and appendix A.1). On a
 * triangle of area \f$ a \f$ it is \f$ \frac{a}{12} (2, 1, 1; 1, 2, 1; 1, 1, 2) \f$; all its entries together sum up to the area.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 *
 * \param tm the triangle mesh
 * \param mass the result, \f$ |V| \times |V| \f$, symmetric and stored as a whole, in squared lengths of the mesh; rows and columns are
 *        numbered by `vertex_index_map`. Vertices without a face have zero rows.
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{face_metric_map}
 *     \cgalParamDescription{the metric of every face}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with key `face_descriptor` and value `Triangle_metric`}
 *     \cgalParamDefault{the metric of the embedding}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the vertices}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with key `vertex_descriptor` and a `Point_3` as value}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_index_map}
 *     \cgalParamDescription{the number of every vertex}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with key `vertex_descriptor` and value `std::size_t`}
 *     \cgalParamDefault{an automatically indexed internal map}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{concurrency_tag}
 *     \cgalParamDescription{whether two or more threads work (with TBB)}
 *     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`}
 *     \cgalParamDefault{`CGAL::Parallel_if_available_tag`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return `OK`; or what is wrong, and then the matrix is as it was
 *
 * Complexity: proportional to the number of vertices.
 */
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code mass_matrix(const TriangleMesh& tm, Eigen::SparseMatrix<double>& mass, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::assemble_operator(tm, 1, 0, np, mass);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * assembles the stiffness matrix \f$ S_{ij} = \int \langle \nabla \phi_i, \nabla \phi_j \rangle \f$ (paper, appendix A.4), positive
 * semi-definite, the cotangent Laplacian with positive diagonal under the metric of the embedding. Its rows sum up to zero; \f$ S = D G \f$.
 *
 * \param tm the triangle mesh
 * \param stiffness the result, \f$ |V| \times |V| \f$, symmetric and stored as a whole, without unit
 * \param np as those of `mass_matrix()`
 *
 * \return `OK`; or what is wrong, and then the matrix is as it was
 */
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code stiffness_matrix(const TriangleMesh& tm, Eigen::SparseMatrix<double>& stiffness,
                            const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::assemble_operator(tm, 0, 1, np, stiffness);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * assembles the gradient matrix \f$ G \f$ (paper, appendix A.2). It takes the values at the vertices to covectors on the faces: rows
 * \f$ 2 f \f$ and \f$ 2 f + 1 \f$ are the differences along \f$ t_1 = v_1 - v_0 \f$ and \f$ t_2 = v_2 - v_0 \f$ (see `Triangle_metric`).
 * It does not depend on the metric.
 *
 * \param tm the triangle mesh
 * \param gradient the result, \f$ 2 |F| \times |V| \f$; faces are numbered by `face_index_map`, vertices by `vertex_index_map`
 * \param np as those of `mass_matrix()`, and `face_index_map`
 *
 * \return `OK`; or what is wrong, and then the matrix is as it was
 */
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code gradient_matrix(const TriangleMesh& tm, Eigen::SparseMatrix<double>& gradient,
                           const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::Operator_input input;
  if(const Error_code code = internal::read_operator_input(tm, np, input))
    return code;
  Eigen::SparseMatrix<double, Eigen::RowMajor> rows(2 * internal::index_range(input.face_index),
                                                    internal::index_range(input.vertex_index));
  rows.reserve(Eigen::VectorXi::Constant(rows.rows(), 2));
  for(int f = 0; f < input.mesh.number_of_triangles(); ++f)
    for(int i = 0; i < 2; ++i)
    {
      const auto& t = input.mesh.triangles[f];
      rows.insert(2 * input.face_index[f] + i, input.vertex_index[t[0]]) = -1;
      rows.insert(2 * input.face_index[f] + i, input.vertex_index[t[i + 1]]) = 1;
    }
  gradient = rows;
  return OK;
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * assembles the divergence matrix \f$ D_{ij} = \int \langle \nabla \phi_i, \omega_j \rangle \f$ (paper, section 2.2 and appendix A.3): on a
 * triangle \f$ D = a\, G^T g^{-1} \f$ with its area \f$ a \f$. It takes covectors on the faces, as `gradient_matrix()` makes
 * them, to the right-hand side of the energy's system.
 * A tangent vector \f$ w \f$ in space is the covector \f$ (\langle w, t_1 \rangle, \langle w, t_2 \rangle) \f$.
 *
 * \param tm the triangle mesh
 * \param divergence the result, \f$ |V| \times 2 |F| \f$
 * \param np as those of `mass_matrix()`, and `face_index_map`
 *
 * \return `OK`; or what is wrong, and then the matrix is as it was
 */
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code divergence_matrix(const TriangleMesh& tm, Eigen::SparseMatrix<double>& divergence,
                             const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::Operator_input input;
  if(const Error_code code = internal::read_operator_input(tm, np, input))
    return code;
  Eigen::SparseMatrix<double> columns(internal::index_range(input.vertex_index), 2 * internal::index_range(input.face_index));
  columns.reserve(Eigen::VectorXi::Constant(columns.cols(), 3));
  for(int f = 0; f < input.mesh.number_of_triangles(); ++f)
  {
    const auto& t = input.mesh.triangles[f];
    const Triangle_metric metric = input.metrics(input.mesh, f);
    const double at_0 = internal::conductance(metric, 0), at_1 = internal::conductance(metric, 1), at_2 = internal::conductance(metric, 2);
    const int first = 2 * input.face_index[f];
    const auto add = [&](int corner, double by_t1, double by_t2) {
      columns.insert(input.vertex_index[t[corner]], first) = by_t1;
      columns.insert(input.vertex_index[t[corner]], first + 1) = by_t2;
    };
    add(0, -at_2, -at_1);
    add(1, at_2 + at_0, -at_0);
    add(2, -at_0, at_1 + at_0);
  }
  columns.makeCompressed();
  divergence.swap(columns);
  return OK;
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_OPERATORS_H
