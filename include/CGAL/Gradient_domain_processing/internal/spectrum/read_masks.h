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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_READ_MASKS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_READ_MASKS_H

#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/parameters.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/read_graph.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/read_soup.h>
#include <CGAL/Gradient_domain_processing/internal/spectrum/Laplace_spectrum.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The vertices and faces of a mesh with their numbers, those of the index maps.
template <class Graph>
struct Numbered_elements
{
  const Graph& graph;

  // visit(v, its number), of all vertices
  template <class NamedParameters, class Visit>
  void for_each_vertex(const NamedParameters& np, const Visit& visit) const
  {
    const auto map = CGAL::get_initialized_vertex_index_map(graph, np);
    for(auto v : vertices(graph))
      visit(v, std::size_t(get(map, v)));
  }

  template <class NamedParameters, class Visit>
  void for_each_face(const NamedParameters& np, const Visit& visit) const
  {
    const auto map = CGAL::get_initialized_face_index_map(graph, np);
    for(auto f : faces(graph))
      visit(f, std::size_t(get(map, f)));
  }

  // visit(number) of the vertices of all faces of which is_chosen(f)
  template <class NamedParameters, class Is_chosen, class Visit>
  void for_each_corner(const NamedParameters& np, const Is_chosen& is_chosen, const Visit& visit) const
  {
    const auto map = CGAL::get_initialized_vertex_index_map(graph, np);
    for(auto f : faces(graph))
      if(is_chosen(f))
        for(auto v : CGAL::vertices_around_face(halfedge(f, graph), graph))
          visit(std::size_t(get(map, v)));
  }
};

// Of a soup, the indices.
template <class PointRange, class PolygonRange>
struct Numbered_elements<Polygon_soup<PointRange, PolygonRange> >
{
  const Polygon_soup<PointRange, PolygonRange>& soup;

  template <class NamedParameters, class Visit>
  void for_each_vertex(const NamedParameters&, const Visit& visit) const
  {
    for(std::size_t v = 0; v < std::size_t(soup.points.size()); ++v)
      visit(v, v);
  }

  template <class NamedParameters, class Visit>
  void for_each_face(const NamedParameters&, const Visit& visit) const
  {
    for(std::size_t f = 0; f < std::size_t(soup.polygons.size()); ++f)
      visit(f, f);
  }

  template <class NamedParameters, class Is_chosen, class Visit>
  void for_each_corner(const NamedParameters&, const Is_chosen& is_chosen, const Visit& visit) const
  {
    for(std::size_t f = 0; f < std::size_t(soup.polygons.size()); ++f)
      if(is_chosen(f))
        for(const auto& index : soup.polygons[f])
          visit(std::size_t(index));
  }
};

// Constrained vertices and weights, by number.
template <class Surface, class NamedParameters>
Error_code read_masks(const Surface& surface, const NamedParameters& np, const Matrix_input& input,
                      Spectrum_masks& masks)
{
  using namespace CGAL::internal_np;
  const Numbered_elements<Surface> elements{surface};
  const std::size_t n = std::size_t(index_range(input.vertex_index));
  bool is_good = true;
  masks.is_constrained.resize(n, 0);
  if constexpr(Has_parameter<vertex_is_constrained_t, NamedParameters>::value)
    elements.for_each_vertex(np, [&](const auto& v, std::size_t i) {
      if(i < n && get(parameter(np, vertex_is_constrained, 0), v))
        masks.is_constrained[i] = 1;
    });
  const auto read = [&](const auto& map, const auto& element, std::size_t i, std::vector<double>& weights) {
    if(i >= weights.size())
      return;
    weights[i] = CGAL::to_double(get(map, element));
    is_good = is_good && is_weight(weights[i]);
  };
  if constexpr(Has_parameter<vertex_value_weight_map_t, NamedParameters>::value)
  {
    masks.value_weight.assign(n, 0.);
    elements.for_each_vertex(np, [&](const auto& v, std::size_t i) {
      read(parameter(np, vertex_value_weight_map, 0), v, i, masks.value_weight);
    });
  }
  if constexpr(Has_parameter<face_gradient_weight_map_t, NamedParameters>::value)
  {
    masks.gradient_weight.assign(std::size_t(index_range(input.face_index)), 0.);
    elements.for_each_face(np, [&](const auto& f, std::size_t i) {
      read(parameter(np, face_gradient_weight_map, 0), f, i, masks.gradient_weight);
    });
  }
  (void)read;
  return is_good ? ok : error_invalid_weight;
}

// Vertices with a face outside of a region are constrained.
template <class FaceRange, class Surface, class NamedParameters>
Error_code constrain_outside(const FaceRange& region, const Surface& surface, const NamedParameters& np,
                             const Matrix_input& input, Spectrum_masks& masks)
{
  typedef typename Surface_traits<Surface>::face_descriptor Face;
  const Numbered_elements<Surface> elements{surface};
  std::vector<Face> all, inside;
  elements.for_each_face(np, [&](const Face& f, std::size_t) { all.push_back(f); });
  std::sort(all.begin(), all.end());
  for(const auto& f : region)
    inside.push_back(Face(f));
  std::sort(inside.begin(), inside.end());
  inside.erase(std::unique(inside.begin(), inside.end()), inside.end());
  if(!std::includes(all.begin(), all.end(), inside.begin(), inside.end()))
    return error_invalid_region;
  masks.is_constrained.assign(std::size_t(index_range(input.vertex_index)), 0);
  elements.for_each_corner(
    np, [&](const Face& f) { return !std::binary_search(inside.begin(), inside.end(), f); },
    [&](std::size_t i) { masks.is_constrained[i] = 1; });
  return ok;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_READ_MASKS_H
