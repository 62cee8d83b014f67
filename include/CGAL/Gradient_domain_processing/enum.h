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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_ENUM_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_ENUM_H

#include <CGAL/license/Gradient_domain_processing.h>

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingEnums
 *
 * How principal curvatures \f$ \kappa_1, \kappa_2 \f$ (convex positive) stretch the metric of a face (paper, section
 * 2.3).
 * \f$ s_i \f$ multiplies squared length along the \f$ i \f$-th principal direction; \f$ \epsilon \f$ is the curvature
 * weight.
 */
enum class Curvature_metric_kind
{
  EMBEDDING,       ///< \f$ s_i = 1 \f$: the metric of the embedding.
  /// \f$ s_i = 1 + \epsilon (\kappa_1^2 + \kappa_2^2) \f$: less filtering where the surface is curved.
  EDGE_AWARE,
  ANISOTROPIC,     ///< \f$ s_i = 1 + \epsilon \kappa_i^2 \f$: filtering along edges, less across them.
  PRESERVE_CONVEX, ///< \f$ s_i = 1 + \epsilon \max(0, \kappa_i)^2 \f$: convex features are kept.
  PRESERVE_CONCAVE ///< \f$ s_i = 1 + \epsilon \min(0, \kappa_i)^2 \f$: concave features are kept.
};

/*!
 * \ingroup PkgGradientDomainProcessingEnums
 *
 * How curvatures are estimated.
 */
enum class Curvature_estimator
{
  JETS,   ///< `CGAL::Monge_via_jet_fitting` at every vertex, averaged over the corners of a face.
  NORMALS ///< From the change of the smoothed vertex normals along the edges of a face; cheaper, no fitting.
};

/*!
 * \ingroup PkgGradientDomainProcessingEnums
 *
 * How `fit_to_normals()` asks for normals.
 */
enum class Normal_fit_kind
{
  /// Every face is turned as the wanted normals at its corners are against those of the mesh. The mesh's own normals
  /// change nothing.
  FACES,
  /// Every edge shall be orthogonal to the sum of the wanted normals at its ends: the form of the paper's authors.
  /// Creases become round.
  EDGES
};

/*!
 * \ingroup PkgGradientDomainProcessingEnums
 *
 * What happens at the border of an open mesh.
 */
enum class Border_condition
{
  /// The natural condition of the energy: border vertices are filtered like all others, and a border of positions
  /// shrinks.
  FREE,
  FIXED,       ///< Border vertices keep their values, to the bit.
  /// Border vertices are filtered first, by the same energy on the border curves alone; the interior then follows.
  ALONG_BORDER
};

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_ENUM_H
