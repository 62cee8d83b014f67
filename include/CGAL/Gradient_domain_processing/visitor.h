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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_VISITOR_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_VISITOR_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/parameters.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/Surface_elements.h>

#include <algorithm>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingEnums
 *
 * The stages of a computation, in their usual order; several may occur more than once.
 */
enum class Stage
{
  READ,      ///< Copying mesh and signal into arrays, and checking them.
  CURVATURE, ///< Estimating curvatures. The presmoothing before it has its own stages from `ANALYZE` to `SOLVE`.
  METRIC,    ///< Building the metric of every face.
  ANALYZE,   ///< Ordering the degrees of freedom, sparsity pattern and symbolic factorization.
  ASSEMBLE,  ///< Filling the matrix; making a right-hand side.
  FACTOR,    ///< Numeric factorization.
  SOLVE,     ///< Solution for a right-hand side.
  WRITE      ///< Writing the output.
};

/*!
 * \ingroup PkgGradientDomainProcessingEnums
 *
 * returns the name of a stage in small letters.
 */
inline const char* get_stage_name(Stage stage)
{
  switch(stage)
  {
    case Stage::READ: return "read";
    case Stage::CURVATURE: return "curvature";
    case Stage::METRIC: return "metric";
    case Stage::ANALYZE: return "analyze";
    case Stage::ASSEMBLE: return "assemble";
    case Stage::FACTOR: return "factor";
    case Stage::SOLVE: return "solve";
    case Stage::WRITE: return "write";
  }
  return "";
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * A visitor that does nothing: the default, and a base to derive from. Pass your own by `std::ref` if it has a state.
 *
 * \cgalModels{GradientDomainVisitor}
 */
struct Default_visitor
{
  /// is called when a stage begins.
  void stage_begins(Stage) {}
  /// is called when a stage ends.
  void stage_ends(Stage) {}
  /// is called at the beginning of every stage, and regularly within long ones, with the part in [0,1] of the whole
  /// work that is done; it never decreases. The computation stops with `error_cancelled` where this returns `false`.
  bool go_on(double) { return true; }
  /// is called before an error is returned that a vertex is to blame for, with one such vertex.
  template <class vertex_descriptor>
  void invalid_vertex(Error_code, vertex_descriptor) {}
  /// is called before an error is returned that a face is to blame for, with one such face.
  template <class face_descriptor>
  void invalid_face(Error_code, face_descriptor) {}
  /// is called, if it is there, with a sentence where a user may be surprised: nothing was changed and why, vertices
  /// were welded or held back.
  void notice(const std::string&) {}
};

namespace internal {

// Seconds that stages take of each other's time, on a million vertices.
inline double usual_duration(Stage stage)
{
  switch(stage)
  {
    case Stage::READ: return 1;
    case Stage::CURVATURE: return 4;
    case Stage::METRIC: return 0.3;
    case Stage::ANALYZE: return 2.7;
    case Stage::ASSEMBLE: return 0.2;
    case Stage::FACTOR: return 2.5;
    case Stage::SOLVE: return 0.3;
    case Stage::WRITE: return 0.2;
  }
  return 0;
}

// What the array-level code sees of a visitor.
class Progress
{
  double m_planned = 1, m_done = 0, m_reported = 0;
  Stage m_stage = Stage::READ;

public:
  virtual ~Progress() {}

  // Announces work, in usual durations. What comes beyond it counts as the very last.
  void plan(double work)
  {
    m_planned = work;
    m_done = m_reported = 0;
  }

  void begin(Stage stage)
  {
    m_stage = stage;
    stage_begins(stage);
  }

  void end(Stage stage)
  {
    m_done += usual_duration(stage);
    stage_ends(stage);
  }

  // `part` of the current stage is done. Called by one thread at a time.
  bool go_on(double part = 0)
  {
    m_reported = (std::max)(m_reported, (std::min)(1., (m_done + part * usual_duration(m_stage)) / m_planned));
    return report(m_reported);
  }

  virtual void notice(const std::string&) {}

private:
  virtual void stage_begins(Stage) {}
  virtual void stage_ends(Stage) {}
  virtual bool report(double) { return true; }
};

// What the code sees that knows the surface.
template <class Surface>
class Surface_progress : public Progress
{
public:
  virtual void invalid_vertex(Error_code, typename Surface_traits<Surface>::vertex_descriptor) {}
  virtual void invalid_face(Error_code, typename Surface_traits<Surface>::face_descriptor) {}
};

template <class Visitor, class = void>
struct Has_notice : std::false_type {};
template <class Visitor>
struct Has_notice<Visitor, decltype(std::declval<Visitor&>().notice(std::string()))> : std::true_type {};

template <class Surface, class Visitor>
class Visitor_progress : public Surface_progress<Surface>
{
  Visitor m_visitor;

  template <class V> static V& unwrap(V& v) { return v; }
  template <class V> static V& unwrap(std::reference_wrapper<V>& v) { return v.get(); }
  auto& get() { return unwrap(m_visitor); }

public:
  explicit Visitor_progress(const Visitor& visitor) : m_visitor(visitor) {}
  void notice(const std::string& sentence) override
  {
    (void)sentence;
    if constexpr (Has_notice<typename std::decay<decltype(get())>::type>::value)
      get().notice(sentence);
  }
  void invalid_vertex(Error_code code, typename Surface_traits<Surface>::vertex_descriptor v) override
  {
    get().invalid_vertex(code, v);
  }
  void invalid_face(Error_code code, typename Surface_traits<Surface>::face_descriptor f) override
  {
    get().invalid_face(code, f);
  }

private:
  void stage_begins(Stage stage) override { get().stage_begins(stage); }
  void stage_ends(Stage stage) override { get().stage_ends(stage); }
  bool report(double done) override { return get().go_on(done); }
};

template <class Surface, class NamedParameters>
std::unique_ptr<Surface_progress<Surface> > make_progress(const NamedParameters& np)
{
  auto visitor = parameter(np, CGAL::internal_np::visitor, Default_visitor());
  return std::make_unique<Visitor_progress<Surface, decltype(visitor)> >(visitor);
}

// A stage for as long as it lives.
class Stage_scope
{
  Progress& m_progress;
  Stage m_stage;
  int m_exceptions = std::uncaught_exceptions();

public:
  Stage_scope(Progress& progress, Stage stage) : m_progress(progress), m_stage(stage) { progress.begin(stage); }
  // A visitor may throw as a stage ends, but not while an exception is on its way.
  ~Stage_scope() noexcept(false)
  {
    if(std::uncaught_exceptions() == m_exceptions)
      m_progress.end(m_stage);
    else
      try { m_progress.end(m_stage); }
      catch(...) {}
  }
  Stage_scope(const Stage_scope&) = delete;
  Stage_scope& operator=(const Stage_scope&) = delete;
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_VISITOR_H
