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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_MATRICES_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_MATRICES_H

#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/parameters.h>
#include <CGAL/Gradient_domain_processing/internal/energy/assemble.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/read_parameters.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/point_map.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/read_graph.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/read_soup.h>

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

// Numbers are those of the index maps, or the indices of a soup.
template <class Graph, class NamedParameters>
void number_elements(const Graph& graph, const Surface_elements<Graph>& elements, const NamedParameters& np,
                     Matrix_input& input)
{
  const auto vertex_index_map = CGAL::get_initialized_vertex_index_map(graph, np);
  for(auto v : elements.vertices)
    input.vertex_index.push_back(int(get(vertex_index_map, v)));
  const auto face_index_map = CGAL::get_initialized_face_index_map(graph, np);
  for(auto f : elements.faces)
    input.face_index.push_back(int(get(face_index_map, f)));
}

template <class PointRange, class PolygonRange, class NamedParameters>
void number_elements(const Polygon_soup<PointRange, PolygonRange>&,
                     const Surface_elements<Polygon_soup<PointRange, PolygonRange> >& elements, const NamedParameters&,
                     Matrix_input& input)
{
  input.vertex_index.assign(elements.vertices.begin(), elements.vertices.end());
  input.face_index.assign(elements.faces.begin(), elements.faces.end());
}

// Triangles only, unless polygons are taken as the fans around their virtual vertices.
template <class Surface, class NamedParameters>
Error_code read_matrix_input(const Surface& surface, const NamedParameters& np, Matrix_input& input,
                             bool takes_polygons = false)
{
  using namespace CGAL::internal_np;
  constexpr bool has_metrics = Has_parameter<face_metric_map_t, NamedParameters>::value;
  Surface_elements<Surface> elements;
  Reading reading = reading_parameters(np);
  reading.welds = false; // matrices have a row for every vertex
  input.parallel = reading.parallel;
  if(const Error_code code = read_surface(surface, point_map(surface, np), np, reading, elements, input.mesh))
    return code;
  if(input.mesh.virtual_vertices.size() > 0 && (has_metrics || !takes_polygons))
    return error_non_triangular_mesh;

  const double squared_unit = input.mesh.unit() * input.mesh.unit();
  input.metrics.given.reserve(input.mesh.triangles.size());
  for(std::size_t f = 0; f < input.mesh.triangles.size(); ++f)
  {
    if constexpr (has_metrics)
    {
      const Triangle_metric metric = get(parameter(np, face_metric_map, 0), elements.faces[f]);
      if(!metric.is_valid())
        return error_invalid_metric;
      input.metrics.given.push_back(metric.with_area_bounded_below(degeneracy_ratio));
    }
    else
      input.metrics.given.push_back(Triangle_metrics()(input.mesh, int(f)).scaled(squared_unit));
  }
  number_elements(surface, elements, np, input);
  return ok;
}

inline int index_range(const std::vector<int>& indices)
{
  return indices.empty() ? 0 : 1 + *std::max_element(indices.begin(), indices.end());
}

// Vertices by their numbers, then virtual vertices. Numbers without a vertex are those of vertices without a face,
// which the mesh gets: rows of zeros.
inline Degrees_of_freedom numbered_by_index(Matrix_input& input)
{
  Indexed_triangles& mesh = input.mesh;
  const int range = index_range(input.vertex_index), first_virtual = mesh.first_virtual_vertex();
  Degrees_of_freedom dofs;
  dofs.of_vertex = input.vertex_index;
  dofs.vertex.assign(std::size_t(range), -1);
  for(int v = 0; v < first_virtual; ++v)
    dofs.vertex[input.vertex_index[v]] = v;
  for(int k = 0; k < mesh.virtual_vertices.size(); ++k)
  {
    dofs.of_vertex.push_back(range + k);
    dofs.vertex.push_back(first_virtual + k);
  }
  for(int& v : dofs.vertex)
    if(v < 0)
    {
      v = mesh.number_of_vertices();
      mesh.points.push_back(Vec3::Zero());
      mesh.corners.offsets.push_back(mesh.corners.offsets.back());
      dofs.of_vertex.push_back(int(&v - dofs.vertex.data()));
    }
  return dofs;
}

// From the numbers of vertices to these and the virtual vertices, which are means of corners.
inline Eigen::SparseMatrix<double> means_of_corners(const Matrix_input& input)
{
  const Virtual_vertices& virtual_vertices = input.mesh.virtual_vertices;
  const int range = index_range(input.vertex_index);
  std::vector<Eigen::Triplet<double> > entries;
  for(int i = 0; i < range; ++i)
    entries.emplace_back(i, i, 1.);
  for(int k = 0; k < virtual_vertices.size(); ++k)
    for(int at = virtual_vertices.corners.offsets[k]; at < virtual_vertices.corners.offsets[k + 1]; ++at)
      entries.emplace_back(range + k, input.vertex_index[virtual_vertices.corners.items[at]],
                           virtual_vertices.weights[at]);
  Eigen::SparseMatrix<double> p(range + virtual_vertices.size(), range);
  p.setFromTriplets(entries.begin(), entries.end());
  return p;
}

inline Eigen::SparseMatrix<double> assembled_matrix(const Matrix_input& input, const Triangle_metrics& metrics,
                                                    const Energy_weights& weights, const Degrees_of_freedom& dofs)
{
  Eigen::SparseMatrix<double> assembled;
  set_pattern(sparsity_pattern(input.mesh.one_rings(input.parallel), dofs, false, input.parallel), input.parallel,
              assembled);
  assemble(input.mesh, metrics, weights, dofs, input.parallel, assembled, false);
  if(input.mesh.virtual_vertices.size() == 0)
    return assembled;
  const Eigen::SparseMatrix<double> p = means_of_corners(input);
  return p.transpose() * Eigen::SparseMatrix<double>(assembled * p);
}

template <class Surface, class NamedParameters>
Error_code assemble_matrix(const Surface& surface, double value_weight, double gradient_weight,
                           const NamedParameters& np, Eigen::SparseMatrix<double>& matrix)
{
  Matrix_input input;
  if(const Error_code code = read_matrix_input(surface, np, input, true))
    return code;
  const Degrees_of_freedom dofs = numbered_by_index(input);
  Energy_weights weights;
  weights.value = value_weight;
  weights.gradient = gradient_weight;
  Eigen::SparseMatrix<double> assembled = assembled_matrix(input, input.metrics, weights, dofs);
  matrix.swap(assembled);
  return ok;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_MATRICES_H
