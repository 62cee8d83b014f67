// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_SEAMS_H
#define GRADIENT_DOMAIN_FILTER_SEAMS_H

#include "files/Mesh_file.h"

#include <vector>

// For every vertex itself or, on a border, the first one there in the same place: for functions that weld nothing.
std::vector<int> first_in_place(const std::vector<Point>& points, const Polygons& polygons);

#endif // GRADIENT_DOMAIN_FILTER_SEAMS_H
