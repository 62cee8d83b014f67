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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_SURFACE_FILTER_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_SURFACE_FILTER_H

#include <CGAL/Gradient_domain_processing/visitor.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/chosen_region.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/counted.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/prepare_filter.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// A surface, its arrays with what filters them, and the caller's visitor: all state of a Gradient_domain_solver.
template <class Surface, class Solver>
class Surface_filter
{
protected:
  std::unique_ptr<Surface_progress<Surface> > m_progress; // the filter has its address
  Surface_elements<Surface> m_elements;
  Filter m_filter;
  std::vector<char> m_has_face_outside; // by vertex, of what was read; none: the whole surface
  std::vector<char> m_is_outside;       // these, and those of the region that was set last
  int m_number_of_welded_vertices = 0;
  bool m_may_values_be_missing = false;
  Error_code m_error = ok;

  template <typename CGAL_NP_TEMPLATE_PARAMETERS>
  explicit Surface_filter(const CGAL_NP_CLASS& np)
    : m_progress(make_progress<Surface>(np))
    , m_filter(any_linear_solver<Solver>(parameter(np, CGAL::internal_np::sparse_linear_solver, Solver())), *m_progress)
    , m_may_values_be_missing(parameter(np, CGAL::internal_np::missing_values, false))
  {
    m_progress->plan(planned_work(np));
  }

  template <class NamedParameters, class Read>
  void initialize(const Surface& surface, const NamedParameters& np, const Read& read)
  {
    m_error = m_filter.ready();
    if(m_error != ok)
      return;
    {
      Stage_scope stage(*m_progress, Stage::READ);
      Reading reading = reading_parameters(np);
      m_error = read(reading);
      m_number_of_welded_vertices = reading.number_of_welded_vertices;
      m_error = checked(prepare_filter(surface, np, reading, m_error, m_elements, m_has_face_outside, m_filter));
    }
    m_is_outside = m_has_face_outside;
    if(m_error == ok)
      m_error = checked(set_metric(np, m_elements, m_filter));
    if(m_error == ok && m_number_of_welded_vertices > 0)
      m_progress->notice(counted(std::size_t(m_number_of_welded_vertices), "vertex at a seam was welded to another",
                                 "vertices at seams were welded to others"));
  }

  template <class Set>
  Error_code set_weight(double weight, const Set& set)
  {
    if(!is_weight(weight))
      return error_invalid_weight;
    Energy_weights weights = m_filter.system.weights();
    set(weights, weight);
    m_filter.system.set_weights(weights);
    return ok;
  }

  Error_code set_scale(double lambda)
  {
    if(!std::isfinite(lambda))
      return error_invalid_weight;
    m_filter.system.set_scale(lambda);
    return ok;
  }

  template <class FaceRange, class NamedParameters>
  Error_code constrain_outside_of(const FaceRange& region, const NamedParameters& np)
  {
    if(m_error != ok)
      return m_error;
    std::vector<char> is_outside = m_has_face_outside;
    if(const Error_code code = choose_region(region, m_elements.faces, m_filter.mesh(), is_outside))
      return code;
    read_constraints(np, m_elements, is_outside, m_filter);
    m_is_outside.swap(is_outside);
    return ok;
  }

public:
  Filter& arrays() { return m_filter; }
  const Surface_elements<Surface>& elements() const { return m_elements; }
  Surface_progress<Surface>& progress() { return *m_progress; }

  // Tells the visitor whom an error is about, and returns it.
  Error_code checked(Error_code code)
  {
    const Culprit culprit = std::exchange(m_filter.culprit, Culprit());
    if(code != ok && culprit.row >= 0)
      m_progress->invalid_vertex(code, m_elements.vertices[std::size_t(culprit.row)]);
    if(code != ok && culprit.face >= 0)
      m_progress->invalid_face(code, m_elements.faces[std::size_t(culprit.face)]);
    return code;
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_SURFACE_FILTER_H
