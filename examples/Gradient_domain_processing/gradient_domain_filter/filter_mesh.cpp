// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "filter_mesh.h"
#include "choose_solver.h"
#include "signal.h"

#include <cstddef>
#include <utility>
#include <vector>

using CGAL::Gradient_domain_processing::Error_code;

namespace {

// Conjugate gradients that do not converge leave everything as it was.
Error_code filter_with_best(const Options& options, Mesh_file& file, Stage_clock& clock, Filter_facts& facts)
{
  if(!prefers_conjugate_gradients(options, file))
    return filter_with_default(options, file, clock, facts);
  const std::size_t notices_before = clock.notices().size();
  const auto code = filter_with_cg(options, file, clock, facts);
  if(code != CGAL::Gradient_domain_processing::error_not_converged)
    return code;
  clock.forget_notices_after(notices_before); // the next run tells them again
  clock.notice("conjugate gradients did not converge; the system is solved by Cholesky factorization");
  facts = Filter_facts();
  return filter_with_default(options, file, clock, facts);
}

// On failure the points are what they were.
class Restored_points
{
  Mesh_file& m_file;
  std::vector<Point> m_points;

public:
  explicit Restored_points(Mesh_file& file) : m_file(file), m_points(file.points) {}
  ~Restored_points()
  {
    if(!m_points.empty())
      m_file.points = std::move(m_points);
  }
  void forget() { m_points.clear(); }
};

Error_code filter(const Options& options, Mesh_file& file, Stage_clock& clock, Filter_facts& facts)
{
  if(options.operation == Operation::DENOISE)
    return denoise_mesh(options, file, clock, facts);
  if(options.operation == Operation::FAIR)
    return fair_mesh(options, file, clock, facts);
  if(options.operation == Operation::SPECTRUM)
    return write_spectrum(options, file, clock, facts);
  if(options.is_band())
    return filter_bands(options, file, clock, facts);
  if(options.signal == Signal_kind::PROPERTY && property_signal(options, file).is_at_faces)
    return filter_face_properties(options, file, clock, facts);
  switch(options.solver)
  {
#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD
    case Solver_kind::EIGEN: return filter_with_eigen(options, file, clock, facts);
#endif
    case Solver_kind::CG: return filter_with_cg(options, file, clock, facts);
    case Solver_kind::AUTO: return filter_with_best(options, file, clock, facts);
    default: return filter_with_default(options, file, clock, facts);
  }
}

} // namespace

Error_code filter_mesh(const Options& options, Mesh_file& file, Stage_clock& clock, Filter_facts& facts)
{
  if(!options.fills_heights())
    return filter(options, file, clock, facts);
  Restored_points before(file);
  Error_code code = fill_missing_heights(options, file, clock);
  if(code == CGAL::Gradient_domain_processing::ok)
    code = filter(options, file, clock, facts);
  if(code == CGAL::Gradient_domain_processing::ok)
    before.forget();
  return code;
}
