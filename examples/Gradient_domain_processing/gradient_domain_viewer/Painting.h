// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_VIEWER_PAINTING_H
#define GRADIENT_DOMAIN_VIEWER_PAINTING_H

#include "files/Mesh_file.h"

#include <array>
#include <cstddef>
#include <vector>

// What a brush paints: where the filter works at all, which vertices are kept, where gradients are scaled.
enum class Brush { REGION, CONSTRAINED, MASK };
constexpr std::size_t number_of_brushes = 3;

// Vertices painted with a brush.
class Painting
{
  std::vector<std::size_t> m_first_neighbor; // of every vertex, and the end
  std::vector<int> m_neighbors;
  std::array<std::vector<char>, number_of_brushes> m_painted; // empty: nothing is

public:
  explicit Painting(const std::vector<Point>& points, const Polygons& polygons);

  // Paints the vertices that are connected with the one nearest to the center inside of the ball, or wipes the paint
  // off. Says whether anything has changed.
  bool dab(Brush brush, const std::vector<Point>& points, const Point& center, double radius, bool is_painted = true);
  void wipe_off();

  bool has(Brush brush) const { return !m_painted[std::size_t(brush)].empty(); }
  bool has_any() const;
  bool is_painted(Brush brush, std::size_t vertex) const { return has(brush) && painted(brush)[vertex]; }
  const std::vector<char>& painted(Brush brush) const { return m_painted[std::size_t(brush)]; }
};

#endif // GRADIENT_DOMAIN_VIEWER_PAINTING_H
