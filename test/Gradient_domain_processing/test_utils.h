// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_TEST_UTILS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_TEST_UTILS_H

#include <cmath>
#include <cstdlib>
#include <iostream>

// Checks that fire in every build type: plain assert() is empty in Release. A failure is printed and counted, and the
// program goes on.
namespace gdp_test {

inline int& number_of_failures()
{
  static int n = 0;
  return n;
}

inline bool check(bool holds, const char* expression, const char* file, int line)
{
  if(!holds)
  {
    ++number_of_failures();
    std::cerr << file << ":" << line << ": check failed: " << expression << std::endl;
  }
  return holds;
}

// NaN is near nothing.
inline bool check_near(double a, double b, double tolerance, const char* expression, const char* file, int line)
{
  const bool holds = std::abs(a - b) <= tolerance;
  check(holds, expression, file, line);
  if(!holds)
    std::cerr << "  " << a << " against " << b << ", difference " << a - b << ", tolerance " << tolerance << std::endl;
  return holds;
}

inline int result()
{
  if(number_of_failures() == 0)
    return EXIT_SUCCESS;
  std::cerr << number_of_failures() << " checks failed" << std::endl;
  return EXIT_FAILURE;
}

} // namespace gdp_test

#define GDP_CHECK(condition) ::gdp_test::check(static_cast<bool>(condition), #condition, __FILE__, __LINE__)
#define GDP_CHECK_NEAR(a, b, tolerance) \
  ::gdp_test::check_near((a), (b), (tolerance), #a " near " #b, __FILE__, __LINE__)
#define GDP_TEST_RESULT() ::gdp_test::result()

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_TEST_UTILS_H
