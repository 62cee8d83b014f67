// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_MPI_FOLLOW_NORMALS_H
#define GRADIENT_DOMAIN_FILTER_MPI_FOLLOW_NORMALS_H

#include "Mesh_piece.h"

// The normals of the own rows after the vertices have moved: as gradient_domain_filter's update_normals(), where copies
// of a vertex that had the same normal go on having the same. `before`: the points of the vertices before; `places`:
// those of the rows, as they are in the file.
CGAL::Gradient_domain_processing::internal::Signal
followed_normals(const Ranks& ranks, const Mesh_piece& piece,
                 const std::vector<CGAL::Gradient_domain_processing::internal::Vec3>& before,
                 const std::vector<Eigen::Vector3d>& places,
                 const CGAL::Gradient_domain_processing::internal::Signal& normals);

#endif // GRADIENT_DOMAIN_FILTER_MPI_FOLLOW_NORMALS_H
