// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_MPI_PARTITION_H
#define GRADIENT_DOMAIN_FILTER_MPI_PARTITION_H

#include "Ply_slices.h"
#include "Ranks.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

// A triangle of the file by the rows of its corners.
struct Row_triangle
{
  Global face;
  std::array<Global, 3> rows;
};

// The vertices of the file along a space-filling curve: their places on it are the numbers of their rows. Every rank
// owns a range of rows, and copies of a vertex in the same place belong to the same rank.
struct Partition
{
  std::vector<Global> first_row; // of every rank, and the end
  Eigen::Vector3d low, extent;   // of the box of all vertices
  std::vector<Eigen::Vector3d> points; // of the own rows
  std::vector<Global> file_vertices;   // of the own rows
  std::vector<std::vector<double> > columns; // of the own rows, one a property that was asked for
  std::vector<Row_triangle> triangles;       // at an own row, by increasing face
};

Partition read_partition(const Ranks& ranks, const Ply_slices& file, const std::vector<std::string>& properties);

#endif // GRADIENT_DOMAIN_FILTER_MPI_PARTITION_H
