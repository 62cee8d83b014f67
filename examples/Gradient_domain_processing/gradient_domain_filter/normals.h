// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_NORMALS_H
#define GRADIENT_DOMAIN_FILTER_NORMALS_H

#include "files/Mesh_file.h"

#include <vector>

// The normalized sums of the normals of the faces around every vertex, weighted by area; zero where there are none.
std::vector<Vector> vertex_normals(const std::vector<Point>& points, const Polygons& polygons);

// The normals of the file follow the points, which were at `before`: those of vertices, of corners with their seams,
// and of faces. One that has no reason to change stays as it was, and one of no length too. Returns how many there are
// that changed.
std::size_t update_normals(const std::vector<Point>& before, Mesh_file& file);

#endif // GRADIENT_DOMAIN_FILTER_NORMALS_H
