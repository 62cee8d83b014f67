// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Everything that runs in parallel, on meshes large enough for it: results are the same to the bit with one thread and
// with several, and a visitor is called by one thread at a time. ThreadSanitizer watches it, see the preset tsan.

#include "test_meshes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/Conjugate_gradient_solver_traits.h>
#include <CGAL/Gradient_domain_processing/denoise.h>
#include <CGAL/Gradient_domain_processing/smooth.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <vector>

using namespace gdp_test;
namespace GDP = CGAL::Gradient_domain_processing;

typedef CGAL::Simple_cartesian<double> K;
typedef CGAL::Surface_mesh<K::Point_3> Mesh;

namespace {

// Without locks: it relies on being called by one thread at a time.
struct Counting_visitor : GDP::Default_visitor
{
  std::size_t calls = 0, cancel_at;

  explicit Counting_visitor(std::size_t cancel_at = std::size_t(-1)) : cancel_at(cancel_at) {}
  bool go_on(double) { return ++calls < cancel_at; }
};

template <class Operation>
std::vector<Coordinates> result(const Soup& soup, std::size_t threads, const Operation& operation)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
#else
  (void)threads;
#endif
  Mesh mesh = built<Mesh>(soup);
  Counting_visitor visitor;
  GDP_CHECK(operation(mesh, visitor) == GDP::OK);
  GDP_CHECK(visitor.calls > 0);
  return coordinates(mesh);
}

template <class Operation>
void check(const Soup& soup, const Operation& operation)
{
  const std::vector<Coordinates> expected = result(soup, 1, operation);
  GDP_CHECK(distance(expected, soup.points) > 1e-5);
  GDP_CHECK(result(soup, 4, operation) == expected);
}

} // namespace

int main()
{
  const Soup soup = bumpy_patch(110, 95); // enough vertices for the order of elimination to be found by two threads

  for(const GDP::Curvature_estimator estimator : {GDP::Curvature_estimator::JETS, GDP::Curvature_estimator::NORMALS})
    check(soup, [&](Mesh& mesh, Counting_visitor& visitor) {
      return GDP::smooth(mesh, GDP::parameters::gradient_weight(1e-3)
                                 .curvature_metric_kind(GDP::Curvature_metric_kind::EDGE_AWARE)
                                 .curvature_estimator(estimator)
                                 .curvature_weight(0.01)
                                 .visitor(std::ref(visitor)));
    });
  check(soup, [&](Mesh& mesh, Counting_visitor& visitor) {
    GDP::Conjugate_gradient_solver_traits<> solver;
    return GDP::smooth(mesh,
                       GDP::parameters::gradient_weight(1e-3).sparse_linear_solver(solver).visitor(std::ref(visitor)));
  });
  check(soup, [&](Mesh& mesh, Counting_visitor& visitor) {
    return GDP::denoise(mesh, GDP::parameters::number_of_iterations(1).visitor(std::ref(visitor)));
  });

  // in the middle of the loop over the curvatures: there are calls at the beginnings of stages, then one for every part
  for(const std::size_t cancel_at : {8u, 10u, 12u})
  {
    Mesh mesh = built<Mesh>(soup);
    Counting_visitor visitor(cancel_at);
    GDP_CHECK(GDP::smooth(mesh, GDP::parameters::gradient_weight(1e-3)
                                  .curvature_metric_kind(GDP::Curvature_metric_kind::EDGE_AWARE)
                                  .curvature_estimator(GDP::Curvature_estimator::JETS)
                                  .curvature_weight(0.01)
                                  .visitor(std::ref(visitor)))
              == GDP::ERROR_CANCELLED);
    GDP_CHECK(visitor.calls == cancel_at); // and is not asked again
    GDP_CHECK(coordinates(mesh) == soup.points);
  }
  return GDP_TEST_RESULT();
}
