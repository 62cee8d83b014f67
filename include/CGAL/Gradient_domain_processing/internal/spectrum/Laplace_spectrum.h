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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_LAPLACE_SPECTRUM_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_LAPLACE_SPECTRUM_H

#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/internal/energy/matrices.h>
#include <CGAL/Gradient_domain_processing/internal/energy/prolongation.h>
#include <CGAL/Gradient_domain_processing/internal/energy/second_order.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/read_parameters.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/ordering/elimination_order.h>
#include <CGAL/Gradient_domain_processing/internal/spectrum/eigenpairs.h>

#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

struct Eigenpair_request
{
  int count = 0;
  bool is_lowest = true;
  double shift = 0; // else
  bool parallel = true;
};

// By the numbers of vertices and faces; no weights: one everywhere.
struct Spectrum_masks
{
  std::vector<char> is_constrained;
  std::vector<double> value_weight, gradient_weight;
};

inline bool are_finite_and_square(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& b)
{
  for(const Eigen::SparseMatrix<double>* m : {&a, &b})
    for(int j = 0; j < m->outerSize(); ++j)
      for(Eigen::SparseMatrix<double>::InnerIterator it(*m, j); it; ++it)
        if(!std::isfinite(it.value()))
          return false;
  return a.rows() == a.cols() && b.rows() == b.cols() && a.rows() == b.rows();
}

// Eigenpairs of the rows and columns of some degrees of freedom, in their order; the rows of others are zero.
inline Error_code restricted_spectrum(const Eigen::SparseMatrix<double>& matrix,
                                      const Eigen::SparseMatrix<double>& mass, const Degrees_of_freedom& dofs,
                                      const Eigenpair_request& request, Eigenpairs& result)
{
  if(request.count < 0 || request.count > dofs.size() || !std::isfinite(request.shift)
     || !are_finite_and_square(matrix, mass))
    return error_invalid_parameter;
  const Eigen::SparseMatrix<double> a = restricted(matrix, dofs), b = restricted(mass, dofs);
  Eigenpairs of_free;
  Error_code code = ok;
  try
  {
    code = request.is_lowest ? lowest_eigenpairs(a, b, request.count, of_free, request.parallel)
                             : nearest_eigenpairs(a, b, request.shift, request.count, of_free, request.parallel);
  }
  catch(const std::bad_alloc&) { code = error_cannot_solve_linear_system; }
  if(code != ok)
    return code;
  result.values = of_free.values;
  result.vectors.setZero(matrix.rows(), request.count);
  for(int i = 0; i < dofs.size(); ++i)
    result.vectors.row(dofs.vertex[std::size_t(i)]) = of_free.vectors.row(i);
  return ok;
}

// The numbers of vertices that are not constrained and have a mass, in an order of elimination.
inline Degrees_of_freedom free_numbers(const Matrix_input& input, const std::vector<char>& is_constrained,
                                       const Eigen::SparseMatrix<double>& mass)
{
  const Indexed_triangles& mesh = input.mesh;
  std::vector<char> is_free(mesh.points.size(), 0);
  for(int v = 0; v < mesh.first_virtual_vertex(); ++v)
  {
    const int index = input.vertex_index[std::size_t(v)];
    is_free[std::size_t(v)] =
      mesh.corners.size(v) > 0 && !is_constrained[std::size_t(index)] && mass.coeff(index, index) > 0;
  }
  const Lists rings = mesh.one_rings(input.parallel);
  std::vector<int> order =
    elimination_order(mesh.points, mesh.virtual_vertices.size() > 0 ? rings_of_polygons(rings, mesh) : rings, is_free,
                      input.parallel)
      .vertex;
  for(int& v : order)
    v = input.vertex_index[std::size_t(v)];
  return numbered(std::move(order), is_constrained.size());
}

// Of the masks, at the vertices and triangles of the mesh.
inline void set_weights(const Matrix_input& input, const Spectrum_masks& masks, Energy_weights& of_values,
                        Energy_weights& of_gradients)
{
  of_gradients.value = 0;
  of_gradients.gradient = 1;
  const Indexed_triangles& mesh = input.mesh;
  if(!masks.value_weight.empty())
  {
    std::vector<double> weights;
    for(int index : input.vertex_index)
      weights.push_back(masks.value_weight[std::size_t(index)]);
    of_values.value_at_vertex = at_vertices(mesh, std::move(weights));
  }
  if(!masks.gradient_weight.empty())
    for(std::size_t f = 0; f < mesh.triangles.size(); ++f)
      of_gradients.gradient_at_triangle.push_back(
        masks.gradient_weight[std::size_t(input.face_index[std::size_t(mesh.face_of(int(f)))])]);
}

// S and M as the metrics and masks have them; or, if areas shall be those of the embedding, S with its triangles' part
// divided by what the metric makes of their areas, and M of the embedding.
inline Error_code laplace_spectrum(Matrix_input& input, const Spectrum_masks& masks, bool has_embedding_measure,
                                   const Eigenpair_request& request, Eigenpairs& result)
{
  Energy_weights of_values, of_gradients;
  set_weights(input, masks, of_values, of_gradients);
  const Degrees_of_freedom all = numbered_by_index(input);
  Triangle_metrics metrics_of_values = input.metrics;
  if(has_embedding_measure)
  {
    of_gradients.gradient_at_triangle.resize(input.mesh.triangles.size(), 1.);
    for(std::size_t f = 0; f < input.mesh.triangles.size(); ++f)
    {
      const Triangle_metric embedding =
        Triangle_metrics()(input.mesh, int(f)).scaled(input.mesh.unit() * input.mesh.unit());
      of_gradients.gradient_at_triangle[f] *= embedding.area() / input.metrics.given[f].area();
      metrics_of_values.given[f] = embedding;
    }
  }
  const Eigen::SparseMatrix<double> stiffness = assembled_matrix(input, input.metrics, of_gradients, all);
  const Eigen::SparseMatrix<double> mass = assembled_matrix(input, metrics_of_values, of_values, all);
  return restricted_spectrum(stiffness, mass, free_numbers(input, masks.is_constrained, mass), request, result);
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_LAPLACE_SPECTRUM_H
