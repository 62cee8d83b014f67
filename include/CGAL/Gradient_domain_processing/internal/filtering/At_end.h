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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_AT_END_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_AT_END_H

#include <utility>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Does something at the end of its life: gives back what was exchanged, whatever happens.
template <class Body>
class At_end
{
  Body m_body;

public:
  explicit At_end(Body body) : m_body(std::move(body)) {}
  ~At_end() { m_body(); }
  At_end(const At_end&) = delete;
  At_end& operator=(const At_end&) = delete;
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_AT_END_H
