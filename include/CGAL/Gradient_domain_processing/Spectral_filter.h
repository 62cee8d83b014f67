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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_SPECTRAL_FILTER_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_SPECTRAL_FILTER_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Gradient_domain_processing/internal/spectrum/Rational_filter.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * The transfer function of `filter_spectrum()`: by what factor each wave of a signal is multiplied. A wave of length
 * \f$ \ell \f$ has the eigenvalue \f$ \mu = (2 \pi / \ell)^2 \f$. These are Butterworth's: with \f$ z \f$ the ratio of
 * \f$ \mu \f$ to that of the cut-off wavelength, a low-pass filter of order \f$ n \f$ has \f$ h = 1 / (1 + z^n) \f$: a
 * half at the cut-off, at a wavelength twice as long within \f$ 4^{-n} \f$ of one, at half of it within \f$ 4^{-n} \f$
 * of zero, and flat at both ends. They do not depend on the resolution of the mesh, and
 * \f$ h(0) \f$ is exactly 1 or 0.
 *
 * Wavelengths are in the unit of the mesh, positive and finite.
 */
class Spectral_filter
{
  internal::Rational_filter m_filter;
  bool m_is_valid = false;

public:
  /// keeps waves that are longer than the cut-off.
  static Spectral_filter low_pass(double wavelength, int order = 4)
  {
    return {internal::Rational_filter::low_pass(eigenvalue(wavelength), order), is_wavelength(wavelength) && order > 0};
  }

  /// keeps waves that are shorter than the cut-off.
  static Spectral_filter high_pass(double wavelength, int order = 4)
  {
    return {internal::Rational_filter::high_pass(eigenvalue(wavelength), order),
            is_wavelength(wavelength) && order > 0};
  }

  /// keeps waves between the two wavelengths, in any order.
  static Spectral_filter band_pass(double wavelength, double other_wavelength, int order = 4)
  {
    const double a = eigenvalue(wavelength), b = eigenvalue(other_wavelength);
    return {internal::Rational_filter::band_pass((std::min)(a, b), (std::max)(a, b), order),
            is_wavelength(wavelength) && is_wavelength(other_wavelength) && order > 0};
  }

  /// removes waves between the two wavelengths, in any order.
  static Spectral_filter band_stop(double wavelength, double other_wavelength, int order = 4)
  {
    const double a = eigenvalue(wavelength), b = eigenvalue(other_wavelength);
    return {internal::Rational_filter::band_stop((std::min)(a, b), (std::max)(a, b), order),
            is_wavelength(wavelength) && is_wavelength(other_wavelength) && order > 0};
  }

  /// returns the factor of waves with the eigenvalue \f$ \mu \f$, in 1 / squared lengths of the mesh.
  double operator()(double mu) const { return m_filter(mu); }

  /// returns the eigenvalue of a wavelength.
  static double eigenvalue(double wavelength)
  {
    const double wave_number = 8 * std::atan(1.) / wavelength;
    return wave_number * wave_number;
  }

  /// returns whether wavelengths are positive and finite, and the order is positive.
  bool is_valid() const { return m_is_valid; }

  /// \cond SKIP_IN_MANUAL
  const internal::Rational_filter& fractions() const { return m_filter; }
  /// \endcond

private:
  Spectral_filter(const internal::Rational_filter& filter, bool is_valid) : m_filter(filter), m_is_valid(is_valid) {}

  static bool is_wavelength(double x) { return x > 0 && std::isfinite(eigenvalue(x)) && eigenvalue(x) > 0; }
};

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_SPECTRAL_FILTER_H
