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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_CURVATURE_METRIC_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_CURVATURE_METRIC_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Gradient_domain_processing/Gradient_domain_solver.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/write_metrics.h>

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * writes the metric of every face that curvature stretches, as the functions of this package use it (paper, section
 * 2.3):
 * \f$ g = J^T (s_1 d_1 d_1^T + s_2 d_2 d_2^T) J \f$ with \f$ J = [t_1\ t_2] \f$, the principal directions \f$ d_i \f$
 * of the face and the stretches \f$ s_i \f$ of `Curvature_metric_kind`.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam FaceMetricMap a model of `WritablePropertyMap` with key `face_descriptor` and value `Triangle_metric`
 *
 * \param tm the triangle mesh; it is not changed
 * \param metrics the result, in squared lengths of the mesh
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among `curvature_metric_kind` (by
 *        default `Curvature_metric_kind::EDGE_AWARE`), `curvature_weight`, `curvature_estimator`, `jet_degree`,
 *        `presmoothing_weight`, `vertex_curvature_map`, `vertex_normal_map`, `area_normalization`,
 *        `sparse_linear_solver`, `concurrency_tag`, `visitor`, `vertex_point_map`, `vertex_index_map` of
 *        `Gradient_domain_solver`
 *
 * \return `ok`; or what is wrong, and then `metrics` is as it was
 */
template <class TriangleMesh, class FaceMetricMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code curvature_metric(const TriangleMesh& tm, FaceMetricMap metrics,
                            const CGAL_NP_CLASS& np = parameters::default_values())
{
  using namespace CGAL::internal_np;
  return internal::write_metrics(
    make_gradient_domain_solver(tm, parameters::with(np).curvature_metric_kind(
      internal::parameter(np, curvature_metric_kind, Curvature_metric_kind::EDGE_AWARE))), metrics);
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_CURVATURE_METRIC_H
