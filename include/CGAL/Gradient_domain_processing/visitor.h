// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_VISITOR_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_VISITOR_H

#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <functional>
#include <memory>

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
  ANALYZE,   ///< Ordering the unknowns, sparsity pattern and symbolic factorization.
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
 * \cgalModels `GradientDomainVisitor`
 */
struct Default_visitor
{
  /// is called when a stage begins.
  void stage_begins(Stage) {}
  /// is called when a stage ends.
  void stage_ends(Stage) {}
  /// is called at the beginning of every stage, and regularly within long ones, with the part in [0,1] of the current
  /// stage that is done. The computation stops with `ERROR_CANCELLED` where this returns `false`.
  bool go_on(double) { return true; }
  /// is called before an error is returned that a vertex is to blame for, with one such vertex.
  template <class vertex_descriptor>
  void invalid_vertex(Error_code, vertex_descriptor) {}
  /// is called before an error is returned that a face is to blame for, with one such face.
  template <class face_descriptor>
  void invalid_face(Error_code, face_descriptor) {}
};

namespace internal {

// What the array-level code sees of a visitor.
class Progress
{
public:
  virtual ~Progress() {}
  virtual void begin(Stage) {}
  virtual void end(Stage) {}
  virtual bool go_on(double) { return true; }
};

// What the code sees that knows the mesh.
template <class Graph>
class Mesh_progress : public Progress
{
public:
  virtual void invalid_vertex(Error_code, typename boost::graph_traits<Graph>::vertex_descriptor) {}
  virtual void invalid_face(Error_code, typename boost::graph_traits<Graph>::face_descriptor) {}
};

template <class Graph, class Visitor>
class Visitor_progress : public Mesh_progress<Graph>
{
  Visitor m_visitor;

public:
  explicit Visitor_progress(const Visitor& visitor) : m_visitor(visitor) {}
  void begin(Stage stage) override { get().stage_begins(stage); }
  void end(Stage stage) override { get().stage_ends(stage); }
  bool go_on(double done) override { return get().go_on(done); }
  void invalid_vertex(Error_code code, typename boost::graph_traits<Graph>::vertex_descriptor v) override { get().invalid_vertex(code, v); }
  void invalid_face(Error_code code, typename boost::graph_traits<Graph>::face_descriptor f) override { get().invalid_face(code, f); }

private:
  template <class V> static V& unwrap(V& v) { return v; }
  template <class V> static V& unwrap(std::reference_wrapper<V>& v) { return v.get(); }
  auto& get() { return unwrap(m_visitor); }
};

template <class Graph, class NamedParameters>
auto make_progress(const NamedParameters& np)
{
  auto visitor = parameter(np, CGAL::internal_np::visitor, Default_visitor());
  return std::make_shared<Visitor_progress<Graph, decltype(visitor)> >(visitor);
}

// A stage for as long as it lives.
class Stage_scope
{
  Progress& m_progress;
  Stage m_stage;

public:
  Stage_scope(Progress& progress, Stage stage) : m_progress(progress), m_stage(stage) { progress.begin(stage); }
  ~Stage_scope() { m_progress.end(m_stage); }
  Stage_scope(const Stage_scope&) = delete;
  Stage_scope& operator=(const Stage_scope&) = delete;
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_VISITOR_H
