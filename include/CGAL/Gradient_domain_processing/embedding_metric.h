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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_EMBEDDING_METRIC_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_EMBEDDING_METRIC_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Gradient_domain_processing/Gradient_domain_solver.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/write_metrics.h>

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * writes the metric of the embedding of every face, \f$ g_{ij} = \langle t_i, t_j \rangle \f$ (paper, appendix A): a
 * start for metrics of your own.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam FaceMetricMap a model of `WritablePropertyMap` with key `face_descriptor` and value `Triangle_metric`
 *
 * \param tm the triangle mesh; it is not changed
 * \param metrics the result, in squared lengths of the mesh. The area of a degenerate face is raised to \f$ 0.75 \cdot
 *        10^{-8} \f$ times its largest squared edge length, so that every tensor is positive definite (unless all three
 *        vertices coincide).
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among `vertex_point_map`,
 *        `vertex_index_map`
 *
 * \return `ok`; or what is wrong, and then `metrics` is as it was
 */
template <class TriangleMesh, class FaceMetricMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code embedding_metric(const TriangleMesh& tm, FaceMetricMap metrics,
                            const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::write_metrics(
    make_gradient_domain_solver(tm, parameters::with(np).curvature_metric_kind(Curvature_metric_kind::EMBEDDING)),
    metrics);
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_EMBEDDING_METRIC_H
