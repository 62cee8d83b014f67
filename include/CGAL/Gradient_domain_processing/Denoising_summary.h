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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_DENOISING_SUMMARY_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_DENOISING_SUMMARY_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <cstddef>

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingEnums
 *
 * Why the passes of `denoise()` ended.
 */
enum class Denoising_end
{
  no_noise,         ///< No noise was found: the mesh is as it was, but for its outliers.
  named_passes,     ///< As many passes as were named are done.
  most_passes,      ///< As many passes as there are at most are done.
  detail,           ///< The next pass would have taken detail away.
  smooth_surface    ///< The surface is smooth, and its normals have settled.
};

/*!
 * \ingroup PkgGradientDomainProcessingEnums
 *
 * returns why the passes ended, in words.
 */
inline const char* get_denoising_end_message(Denoising_end end)
{
  switch(end)
  {
    case Denoising_end::no_noise: return "no noise was found";
    case Denoising_end::named_passes: return "the named number of passes is done";
    case Denoising_end::most_passes: return "the largest number of passes is done";
    case Denoising_end::detail: return "a further pass would take detail away";
    case Denoising_end::smooth_surface: return "the surface is smooth and its normals have settled";
  }
  return "";
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * What `denoise()` found in a mesh, and what it did.
 */
struct Denoising_summary
{
  /// The noise of the face normals, in radians, named or estimated: the largest of all components.
  double noise_level = 0;
  double noise_share = 0;             ///< The part of the roughness that is noise rather than detail, from 0 to 1.
  double noise_scale = 0;             ///< Over how many mean edge lengths the noise is correlated; 0 where it is not.
  /// What `noise_level` would be if all of the roughness were noise: a value to name where none was found.
  double roughness_level = 0;
  std::size_t number_of_outliers = 0; ///< Vertices whose input position was given no weight.
  unsigned int number_of_iterations = 0; ///< The passes that were done.
  Denoising_end end = Denoising_end::no_noise; ///< Why there were no more.
};

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_DENOISING_SUMMARY_H
