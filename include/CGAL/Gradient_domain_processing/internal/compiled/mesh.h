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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_COMPILED_MESH_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_COMPILED_MESH_H

#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles_impl.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/arrange_impl.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/border_edges_impl.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/connected_components_impl.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/is_oriented_impl.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/morton_order_impl.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/offset_to_volumes_impl.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/points_impl.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/polygon_fans_impl.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/read_graph_impl.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/read_soup_impl.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/restore_volumes_impl.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/signals_impl.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/weld_impl.h>

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_COMPILED_MESH_H
