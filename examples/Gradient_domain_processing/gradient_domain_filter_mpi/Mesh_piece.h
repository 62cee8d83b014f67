// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_MPI_MESH_PIECE_H
#define GRADIENT_DOMAIN_FILTER_MPI_MESH_PIECE_H

#include "Halo.h"
#include "Partition.h"

#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>

#include <vector>

// What a rank has of the mesh, the seam between the processes and the package: to the left of it numbers are those of
// the whole mesh, to the right of it there is an indexed triangle soup with owned and ghost vertices, and every
// function of the package that works on arrays works on this one.
//
//  - A vertex of the soup is one or, where copies in the same place were welded at a border, several vertices of the
//    file, its rows. Vertices and rows are numbered apart; of both the owned ones come first, then the ghosts, and a
//    halo gives the ghosts the values of their owners.
//  - Every triangle at an owned vertex is there, so that sums over the triangles around an owned vertex are complete.
//    With more layers than one, so are those around the vertices of the layers before the last.
//  - Triangles are sorted by their lowest vertex, as the assembly expects them.
//  - Vertices without a triangle are rows only: nothing is solved for them.
struct Mesh_piece
{
  CGAL::Gradient_domain_processing::internal::Indexed_triangles mesh;
  Halo vertices, rows;
  std::vector<int> vertex_of_row;  // of the owned rows; -1: no triangle
  std::vector<char> is_counted;    // by triangle: this rank is the one that counts it in sums over the mesh
  std::vector<char> is_near;       // by triangle: it is at an owned vertex, and so its rows are known
  int number_of_welded_rows = 0;   // all ranks

  double unit() const { return mesh.unit(); }
};

// Consumes points and triangles of the partition. `welds`: whether copies of border vertices are one.
Mesh_piece make_piece(const Ranks& ranks, Partition& partition, bool welds, int layers);

#endif // GRADIENT_DOMAIN_FILTER_MPI_MESH_PIECE_H
