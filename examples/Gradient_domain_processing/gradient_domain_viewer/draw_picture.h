// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_VIEWER_DRAW_PICTURE_H
#define GRADIENT_DOMAIN_VIEWER_DRAW_PICTURE_H

#include "files/Mesh_file.h"

#include <string>
#include <vector>

// The bytes of a PNG: the surface before, after, and how far its vertices have gone along their normals. Throws Failure
// where there is no screen to draw on, not even a virtual one.
std::string picture_of(const std::vector<Point>& before, const std::vector<Point>& after, const Polygons& polygons,
                       const std::vector<double>& displacements);

// The same, before any work is done for it.
void check_screen();

#endif // GRADIENT_DOMAIN_VIEWER_DRAW_PICTURE_H
