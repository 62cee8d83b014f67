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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_SIGNAL_TRAITS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_SIGNAL_TRAITS_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Point_2.h>
#include <CGAL/Point_3.h>
#include <CGAL/Vector_2.h>
#include <CGAL/Vector_3.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * says how the values of a signal are made of numbers, so that they can be filtered channel by channel. It is there for
 * number types, `Point_2`, `Point_3`, `Vector_2`, `Vector_3`, `CGAL::IO::Color`, `std::array` and Eigen vectors of
 * fixed size. Integers are rounded to the nearest and clamped to their range, never wrapped. Specialize it for a value
 * type of your own:
 *
 * \code
 * template <> struct CGAL::Gradient_domain_processing::Signal_traits<My_value>
 * {
 *   static constexpr int dimension = 2;                                  // the number of channels
 *   static double channel(const My_value& value, int i);                 // 0 <= i < dimension
 *   static My_value make(const double* channels);
 * };
 * \endcode
 */
template <class Value, class = void>
struct Signal_traits
{
  static constexpr int dimension = 1;
  static double channel(const Value& value, int)
  {
    if constexpr (std::is_arithmetic<Value>::value)
      return static_cast<double>(value); // CGAL does not know all of them
    else
      return CGAL::to_double(value);
  }
  static Value make(const double* channels)
  {
    if constexpr (std::is_integral<Value>::value)
    {
      // compared as doubles: the limits of 64-bit integers are not representable
      const double rounded = std::round(channels[0]);
      if(!(rounded > double((std::numeric_limits<Value>::min)()))) return (std::numeric_limits<Value>::min)();
      if(rounded >= double((std::numeric_limits<Value>::max)())) return (std::numeric_limits<Value>::max)();
      return static_cast<Value>(rounded);
    }
    else
      return Value(channels[0]);
  }
};

/// \cond SKIP_IN_MANUAL
template <class Value, class Coordinate, int Dimension>
struct Cartesian_signal_traits
{
  static constexpr int dimension = Dimension;
  static double channel(const Value& value, int i) { return CGAL::to_double(value[i]); }
  static Value make(const double* c)
  {
    if constexpr (Dimension == 2)
      return Value(Coordinate(c[0]), Coordinate(c[1]));
    else
      return Value(Coordinate(c[0]), Coordinate(c[1]), Coordinate(c[2]));
  }
};

template <class K> struct Signal_traits<Point_2<K> > : Cartesian_signal_traits<Point_2<K>, typename K::FT, 2> {};
template <class K> struct Signal_traits<Point_3<K> > : Cartesian_signal_traits<Point_3<K>, typename K::FT, 3> {};
template <class K> struct Signal_traits<Vector_2<K> > : Cartesian_signal_traits<Vector_2<K>, typename K::FT, 2> {};
template <class K> struct Signal_traits<Vector_3<K> > : Cartesian_signal_traits<Vector_3<K>, typename K::FT, 3> {};

template <>
struct Signal_traits<IO::Color>
{
  static constexpr int dimension = 4;
  static double channel(const IO::Color& color, int i) { return color[i]; }
  static IO::Color make(const double* c)
  {
    typedef Signal_traits<unsigned char> Byte;
    return IO::Color(Byte::make(c), Byte::make(c + 1), Byte::make(c + 2), Byte::make(c + 3));
  }
};

template <class T, std::size_t N>
struct Signal_traits<std::array<T, N> >
{
  static constexpr int dimension = int(N) * Signal_traits<T>::dimension;
  static double channel(const std::array<T, N>& value, int i)
  {
    return Signal_traits<T>::channel(value[i / Signal_traits<T>::dimension], i % Signal_traits<T>::dimension);
  }
  static std::array<T, N> make(const double* c)
  {
    std::array<T, N> value;
    for(std::size_t i = 0; i < N; ++i)
      value[i] = Signal_traits<T>::make(c + i * Signal_traits<T>::dimension);
    return value;
  }
};

template <class T, int Rows, int Cols, int Options>
struct Signal_traits<Eigen::Matrix<T, Rows, Cols, Options, Rows, Cols> >
{
  typedef Eigen::Matrix<T, Rows, Cols, Options, Rows, Cols> Value;
  static_assert(Rows > 0 && Cols > 0, "the values of a signal have a fixed size");
  static constexpr int dimension = Rows * Cols;
  static double channel(const Value& value, int i) { return CGAL::to_double(value.coeff(i % Rows, i / Rows)); }
  static Value make(const double* c)
  {
    Value value;
    for(int i = 0; i < dimension; ++i)
      value.coeffRef(i % Rows, i / Rows) = Signal_traits<T>::make(c + i);
    return value;
  }
};
/// \endcond

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_SIGNAL_TRAITS_H
