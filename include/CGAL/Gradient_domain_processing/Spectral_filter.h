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
 * \ingroup PkgGradientDomainProcessingEnums
 *
 * How the coefficients of a `Spectral_filter::windowed_low_pass()` decay. The first names are the steeper ones, the
 * last lets the least pass of what is to be stopped: at degree 40 and wavelengths 1.5 times beyond the cut-off 0.2 %,
 * 0.04 %, 0.01 %, and 0.0003 %.
 */
enum class Spectral_window
{
  HAMMING,  ///< \f$ 0.54 + 0.46 \cos \pi x \f$
  HANN,     ///< \f$ 0.5 + 0.5 \cos \pi x \f$
  BLACKMAN, ///< \f$ 0.42 + 0.5 \cos \pi x + 0.08 \cos 2 \pi x \f$
  NUTTALL   ///< \f$ 0.355768 + 0.487396 \cos \pi x + 0.144232 \cos 2 \pi x + 0.012604 \cos 3 \pi x \f$
};

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * The transfer function of `filter_spectrum()`: by what factor each wave of a signal is multiplied. A wave of length
 * \f$ \ell \f$ has the eigenvalue \f$ \mu = (2 \pi / \ell)^2 \f$. Filters do not depend on the resolution of the mesh,
 * and \f$ h(0) \f$ is kept exactly.
 *
 * No harmonics are computed for it: a filter is applied as a series of Chebyshev polynomials in \f$ t = (\mu - \mu_c) /
 * (\mu + \mu_c) \f$, a rational function with the pole \f$ -\mu_c \f$, by one factorization and as many solutions as
 * its `degree()`. It differs from the transfer function by no more than `error_bound()`, for all \f$ \mu \geq 0 \f$, so
 * that the error of the filtered signal is at most so much times the norm \f$ \sqrt{f^T M f} \f$ of the signal.
 *
 * Wavelengths are in the unit of the mesh, positive and finite.
 */
class Spectral_filter
{
  internal::Rational_filter m_filter;
  bool m_is_valid = false;

public:
  /// \name Butterworth's Filters
  /// With \f$ z \f$ the ratio of \f$ \mu \f$ to that of the cut-off wavelength, a low-pass filter of order \f$ n \f$
  /// has \f$ h = 1 / (1 + z^n) \f$: a half at the cut-off, at a wavelength twice as long within \f$ 4^{-n} \f$ of one,
  /// at half of it within \f$ 4^{-n} \f$ of zero, and flat at both ends. The bound is \f$ 10^{-8} \f$ for each cut-off
  /// of degree about 12 times the order. Orders are 1 to 70.
  /// @{

  /// keeps waves that are longer than the cut-off.
  static Spectral_filter low_pass(double wavelength, int order = 4)
  {
    if(!is_wavelength(wavelength) || order < 1)
      return Spectral_filter();
    return Spectral_filter(internal::Rational_filter::low_pass(eigenvalue(wavelength), order));
  }

  /// keeps waves that are shorter than the cut-off.
  static Spectral_filter high_pass(double wavelength, int order = 4)
  {
    return low_pass(wavelength, order).complement();
  }

  /// keeps waves between the two wavelengths, in any order.
  static Spectral_filter band_pass(double wavelength, double other_wavelength, int order = 4)
  {
    if(!is_wavelength(wavelength) || !is_wavelength(other_wavelength) || order < 1)
      return Spectral_filter();
    const double a = eigenvalue(wavelength), b = eigenvalue(other_wavelength);
    return Spectral_filter(internal::Rational_filter::band_pass((std::min)(a, b), (std::max)(a, b), order));
  }

  /// removes waves between the two wavelengths, in any order.
  static Spectral_filter band_stop(double wavelength, double other_wavelength, int order = 4)
  {
    return band_pass(wavelength, other_wavelength, order).complement();
  }

  /// @}
  /// \name Other Filters
  /// @{

  /// keeps waves that are longer than the cut-off, by the series of a step, its coefficients damped by a window: that
  /// of `vtkWindowedSincPolyDataFilter`, in another variable, so that the cut-off does not depend on the mesh. Steeper
  /// than Butterworth's filters of the same cost, with small ripples. This is the transfer function itself, and the
  /// error bound is 0.
  static Spectral_filter windowed_low_pass(double wavelength, int degree = 40,
                                           Spectral_window window = Spectral_window::HAMMING)
  {
    if(!is_wavelength(wavelength) || degree < 1 || degree > 10000)
      return Spectral_filter();
    const auto damping = [window](double x) { return damping_of(window, x); };
    return Spectral_filter(internal::Rational_filter::windowed_step(eigenvalue(wavelength), degree, damping));
  }

  /// approximates any function \f$ h(\mu) \f$ that is finite and continuous for \f$ \mu \geq 0 \f$ and has a limit at
  /// infinity. `wavelength` tells about where it varies; the center that needs the least degree is looked for within a
  /// factor of 16 of it. The bound is checked on points of all scales, four times as many as were interpolated, and is
  /// twice the largest difference there. Where it takes a degree above 1000, the filter is not valid.
  template <class TransferFunction>
  static Spectral_filter approximation(const TransferFunction& h, double wavelength, double largest_error = 1e-6)
  {
    if(!is_wavelength(wavelength) || !(largest_error > 0))
      return Spectral_filter();
    const auto function = [h](double mu) { return double(h(mu)); };
    return Spectral_filter(
      internal::Rational_filter::approximation_near(eigenvalue(wavelength), function, largest_error));
  }

  /// returns \f$ 1 - h \f$: lets pass what this one stops.
  Spectral_filter complement() const { return m_is_valid ? Spectral_filter(m_filter.complement()) : *this; }

  /// returns \f$ h - h' \f$: lets pass what this one does and the other does not.
  Spectral_filter without(const Spectral_filter& other) const
  {
    return m_is_valid && other.m_is_valid ? Spectral_filter(m_filter.minus(other.m_filter)) : Spectral_filter();
  }

  /// @}

  /// returns the factor \f$ h \f$ of waves with the eigenvalue \f$ \mu \f$, in 1 / squared lengths of the mesh; NaN if
  /// the filter is not valid.
  double operator()(double mu) const { return m_is_valid ? m_filter(mu) : std::nan(""); }

  /// returns the factor that is applied.
  double approximation(double mu) const { return m_is_valid ? m_filter.approximation(mu) : std::nan(""); }

  /// returns how far the two are apart at most, infinity for an invalid filter. It is measured at 16,000 points on all
  /// scales: a function that is other than it looks at these, as a band of a thousandth of its place, is not seen.
  double error_bound() const { return m_is_valid ? m_filter.error_bound() : HUGE_VAL; }

  /// returns how many solutions the filter takes for every channel.
  int degree() const { return m_filter.degree(); }

  /// returns how many times the relative error of one solution the filtered signal is off at most, to first order and
  /// in the norm \f$ \sqrt{f^T M f} \f$ of the signal: \f$ \sum 2 k^2 |c_k| \f$ over the coefficients of the series. It
  /// grows with the square of the degree, some hundred for Butterworth's filters and some thousand for windows of
  /// degree 40: nothing for a factorization, but an iterative solver's tolerance should be as much smaller than the
  /// error that may be made.
  double sensitivity() const { return m_is_valid ? m_filter.sensitivity() : HUGE_VAL; }

  /// returns the eigenvalue of a wavelength.
  static double eigenvalue(double wavelength)
  {
    const double wave_number = 8 * std::atan(1.) / wavelength;
    return wave_number * wave_number;
  }

  /// returns whether there is such a filter: wavelengths are positive and finite, order and degree positive, and the
  /// bound is kept.
  bool is_valid() const { return m_is_valid; }

  /// \cond SKIP_IN_MANUAL
  const internal::Rational_filter& rational() const { return m_filter; }
  /// \endcond

private:
  Spectral_filter() {}
  explicit Spectral_filter(const internal::Rational_filter& filter)
    : m_filter(filter)
    , m_is_valid(std::isfinite(filter.error_bound()))
  {
  }

  static bool is_wavelength(double x) { return x > 0 && std::isfinite(eigenvalue(x)) && eigenvalue(x) > 0; }

  static double damping_of(Spectral_window window, double x)
  {
    const double angle = 4 * std::atan(1.) * x;
    switch(window)
    {
      case Spectral_window::HANN: return 0.5 + 0.5 * std::cos(angle);
      case Spectral_window::BLACKMAN: return 0.42 + 0.5 * std::cos(angle) + 0.08 * std::cos(2 * angle);
      case Spectral_window::NUTTALL:
        return 0.355768 + 0.487396 * std::cos(angle) + 0.144232 * std::cos(2 * angle) + 0.012604 * std::cos(3 * angle);
      default: return 0.54 + 0.46 * std::cos(angle);
    }
  }
};

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_SPECTRAL_FILTER_H
