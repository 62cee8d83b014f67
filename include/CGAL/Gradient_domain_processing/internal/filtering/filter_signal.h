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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_SIGNAL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_SIGNAL_H

#include <CGAL/Gradient_domain_processing/internal/filtering/write_back.h>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// So many passes.
template <class Void = void>
Error_code filter_repeatedly(int number_of_iterations, Filter& filter, Signal& signal);

// Fills missing values in first, by the energy without a value weight, all others constrained: as smoothly as the
// metric has it. No gradient is asked for on their faces. Constraints and weights are the caller's again afterwards,
// whatever happens.
template <class Void = void>
Error_code fill_and_filter(int number_of_iterations, Filter& filter, Signal& signal);

template <class InMap, class OutMap, class Surface>
Error_code filter_signal(InMap in, OutMap out, int number_of_iterations, bool may_be_missing,
                         const Surface_elements<Surface>& elements, Filter& filter)
{
  if(number_of_iterations < 0)
    return error_invalid_parameter;
  if(const Error_code code = filter.ready())
    return code;
  Signal signal;
  {
    Stage_scope stage(filter.progress(), Stage::READ);
    if(const Error_code code = read_signal(in, elements, filter.mesh(), may_be_missing, filter.culprit, signal))
      return code;
  }
  const bool has_missing = may_be_missing && !signal.allFinite();
  if(const Error_code code = has_missing ? fill_and_filter(number_of_iterations, filter, signal)
                                         : filter_repeatedly(number_of_iterations, filter, signal))
    return code;
  return write_back(in, signal, out, elements, filter);
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/filtering/filter_signal_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_SIGNAL_H
