// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_SURVEY_H
#define GRADIENT_DOMAIN_FILTER_SURVEY_H

#include "files/Mesh_file.h"

#include <string>
#include <vector>

// What there is to know of polygons before they are filtered.
struct Survey
{
  std::size_t vertices = 0, unused_vertices = 0, faces = 0, edges = 0, border_edges = 0;
  std::size_t crowded_edges = 0;     // with more than two faces
  std::size_t flipped_edges = 0;     // with two faces of which one is turned over
  std::size_t repeated_faces = 0;    // with the same vertices as one before
  std::size_t flat_faces = 0;        // without area
  std::size_t needles = 0;           // more than twenty times as long as wide
  std::size_t components = 0, lone_faces = 0; // connected at vertices
  std::size_t seam_vertices = 0;     // at the border, at the same place as another one
  struct Part { std::size_t first_face, faces; double area; };
  std::vector<Part> parts;           // the components, in the order of their first faces
  std::vector<int> part_of_vertex;   // negative without a face; empty if there is one part only
  double area = 0, smallest_extent = 0, largest_extent = 0; // of components

  // What a stranger will trip over, a line each. Where vertices that are near are welded, too, parts are not what they
  // seem here.
  std::vector<std::string> remarks(bool seams_are_welded, bool near_ones_are_welded, bool has_one_weight) const;
};

// Needles are counted where somebody wants to know.
Survey survey(const std::vector<Point>& points, const Polygons& polygons, bool counts_needles);

#endif // GRADIENT_DOMAIN_FILTER_SURVEY_H
