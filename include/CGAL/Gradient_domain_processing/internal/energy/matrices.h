// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_MATRICES_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_MATRICES_H

#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/parameters.h>
#include <CGAL/Gradient_domain_processing/internal/energy/assemble.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/read_parameters.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/point_map.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/read_graph.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// A mesh in the order of its index maps, with its metrics, all in the unit of the mesh.
struct Matrix_input
{
  Indexed_triangles mesh;
  Triangle_metrics metrics;
  std::vector<int> vertex_index; // of every vertex in the arrays
  std::vector<int> face_index;   // of every triangle
  bool parallel = true;
};

template <class TriangleMesh, class NamedParameters>
Error_code read_matrix_input(const TriangleMesh& tm, const NamedParameters& np, Matrix_input& input)
{
  using namespace CGAL::internal_np;
  Surface_elements<TriangleMesh> elements;
  Reading reading = reading_parameters(np);
  reading.welds = false; // matrices have a row for every vertex
  input.parallel = reading.parallel;
  if(const Error_code code = read_surface(tm, point_map(tm, np), np, reading, elements, input.mesh))
    return code;
  if(input.mesh.virtual_vertices.size() > 0)
    return error_non_triangular_mesh;

  const double squared_unit = input.mesh.unit() * input.mesh.unit();
  input.metrics.given.reserve(elements.faces.size());
  for(std::size_t f = 0; f < elements.faces.size(); ++f)
  {
    if constexpr (Has_parameter<face_metric_map_t, NamedParameters>::value)
    {
      const Triangle_metric metric = get(parameter(np, face_metric_map, 0), elements.faces[f]);
      if(!metric.is_valid())
        return error_invalid_metric;
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
  return ok;
}

inline int index_range(const std::vector<int>& indices)
{
  return indices.empty() ? 0 : 1 + *std::max_element(indices.begin(), indices.end());
}

// alpha M + beta S with a row for every index.
template <class TriangleMesh, class NamedParameters>
Error_code assemble_matrix(const TriangleMesh& tm, double value_weight, double gradient_weight, const NamedParameters& np,
                           Eigen::SparseMatrix<double>& matrix)
{
  Matrix_input input;
  if(const Error_code code = read_matrix_input(tm, np, input))
    return code;

  // indices without a vertex are those of vertices without a face: rows of zeros
  Degrees_of_freedom dofs;
  dofs.of_vertex = input.vertex_index;
  dofs.vertex.assign(index_range(input.vertex_index), -1);
  for(std::size_t v = 0; v < input.vertex_index.size(); ++v)
    dofs.vertex[input.vertex_index[v]] = int(v);
  for(int& v : dofs.vertex)
    if(v < 0)
    {
      v = input.mesh.number_of_vertices();
      input.mesh.points.push_back(Vec3::Zero());
      input.mesh.corners.offsets.push_back(input.mesh.corners.offsets.back());
      dofs.of_vertex.push_back(int(&v - dofs.vertex.data()));
    }

  Energy_weights weights;
  weights.value = value_weight;
  weights.gradient = gradient_weight;
  set_pattern(sparsity_pattern(input.mesh.one_rings(input.parallel), dofs, false, input.parallel), input.parallel, matrix);
  assemble(input.mesh, input.metrics, weights, dofs, input.parallel, matrix, false);
  return ok;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_MATRICES_H
