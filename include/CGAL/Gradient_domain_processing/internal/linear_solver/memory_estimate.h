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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MEMORY_ESTIMATE_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MEMORY_ESTIMATE_H

#include <cmath>
#include <cstddef>
#include <fstream>
#include <limits>
#include <string>

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Entries of the Cholesky factor of a triangle mesh with so many unknowns. Nested dissection of a surface leaves O(n
// log n) of them; on meshes of 8 thousand to 4 million vertices CHOLMOD keeps 3.4 to 4.1 n log2 n, the zeros in its
// dense blocks included.
inline double cholesky_factor_entries(std::size_t unknowns)
{
  return 4.1 * double(unknowns) * std::log2(double(unknowns) + 1);
}

// Bytes that a Cholesky factorization needs at most, beside the mesh itself: the factor, a tenth of it as work space,
// and arrays linear in the mesh: mesh arrays and matrix were measured at 290 bytes a vertex, three channels at 100; 60
// are to spare.
inline double cholesky_memory(std::size_t unknowns)
{
  return 1.1 * sizeof(double) * cholesky_factor_entries(unknowns) + 450. * double(unknowns);
}

// Bytes that can be had without swapping, or infinity where the system does not tell.
inline double available_memory()
{
  std::ifstream file("/proc/meminfo");
  std::string line;
  while(std::getline(file, line))
    if(line.compare(0, 13, "MemAvailable:") == 0)
      return 1024. * std::stod(line.substr(13));
#if defined(_SC_AVPHYS_PAGES) && defined(_SC_PAGESIZE)
  const long pages = sysconf(_SC_AVPHYS_PAGES), page_size = sysconf(_SC_PAGESIZE);
  if(pages > 0 && page_size > 0)
    return double(pages) * double(page_size);
#elif defined(_SC_PHYS_PAGES) && defined(_SC_PAGESIZE)
  const long pages = sysconf(_SC_PHYS_PAGES), page_size = sysconf(_SC_PAGESIZE);
  if(pages > 0 && page_size > 0)
    return double(pages) * double(page_size);
#endif
  return std::numeric_limits<double>::infinity();
}

// Whether a Cholesky factorization with so many unknowns is expected to fit in memory, and its entries in the `int`
// that counts them. To be asked when the mesh has been read.
inline bool cholesky_fits(std::size_t unknowns, double memory = available_memory())
{
  return cholesky_memory(unknowns) < 0.9 * memory
      && cholesky_factor_entries(unknowns) < double((std::numeric_limits<int>::max)());
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MEMORY_ESTIMATE_H
