// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Linear solvers of all kinds give the same answers, and their failures are told.

#include "minimal_solver.h"
#include "test_meshes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/Automatic_sparse_linear_solver.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/time_estimate.h>
#include <CGAL/Gradient_domain_processing/process_face_signal.h>
#include <CGAL/Gradient_domain_processing/process_signal.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

using namespace gdp_test;
namespace GDP = CGAL::Gradient_domain_processing;

typedef CGAL::Simple_cartesian<double> K;
typedef CGAL::Surface_mesh<K::Point_3> Mesh;
typedef Mesh::Vertex_index Vertex;
typedef Eigen::SparseMatrix<double> Sparse;

namespace {

struct Fixture
{
  Mesh tm = built<Mesh>(bumpy_patch(9, 9));
  Mesh::Property_map<Vertex, bool> constrained;
  Mesh::Property_map<Vertex, K::Vector_3> in, out;

  Fixture()
  {
    tm.add_vertex(K::Point_3(3, 3, 3)); // without a face
    constrained = tm.add_property_map<Vertex, bool>("v:constrained", false).first;
    in = tm.add_property_map<Vertex, K::Vector_3>("v:in").first;
    out = tm.add_property_map<Vertex, K::Vector_3>("v:out", K::Vector_3(-7, -7, -7)).first;
    for(Vertex v : vertices(tm))
    {
      constrained[v] = int(v) % 11 == 0;
      in[v] = tm.point(v) - CGAL::ORIGIN;
    }
  }

  template <class NamedParameters>
  GDP::Error_code run(const NamedParameters& np) { return GDP::process_signal(tm, in, out, np); }

  std::vector<Coordinates> result() const
  {
    std::vector<Coordinates> values;
    for(Vertex v : vertices(tm))
      values.push_back({{out[v].x(), out[v].y(), out[v].z()}});
    return values;
  }

  bool is_untouched() const
  {
    for(Vertex v : vertices(tm))
      if(out[v] != K::Vector_3(-7, -7, -7))
        return false;
    return true;
  }
};

std::vector<Coordinates> default_result()
{
  Fixture x;
  GDP_CHECK(x.run(GDP::parameters::gradient_weight(1e-3).vertex_is_constrained_map(x.constrained)) == GDP::OK);
  return x.result();
}

template <class Solver>
void check_agreement(const std::string& name, const Solver& solver, double tolerance)
{
  Fixture x;
  const GDP::Error_code code = x.run(
    GDP::parameters::sparse_linear_solver(solver).gradient_weight(1e-3).vertex_is_constrained_map(x.constrained));
  const double difference = distance(x.result(), default_result());
  if(!GDP_CHECK(code == GDP::OK) || !GDP_CHECK(difference <= tolerance))
    std::cerr << "  " << name << ": " << GDP::get_error_message(code) << ", difference " << difference << std::endl;
}

struct Listener : GDP::Default_visitor
{
  int notices = 0;
  void notice(const std::string&) { ++notices; }
};

// Nothing is written when a solver fails; the code says how.
template <class Solver>
void check_failure(const Solver& solver, GDP::Error_code expected)
{
  Fixture x;
  GDP_CHECK(x.run(GDP::parameters::sparse_linear_solver(solver)) == expected);
  GDP_CHECK(x.is_untouched());
}

// The minimal model again, failing as it is told.
struct Failing_solver : Minimal_solver
{
  enum Failure { FACTOR, SOLUTION, NOT_A_NUMBER } failure = FACTOR;

  Failing_solver() {}
  explicit Failing_solver(Failure failure) : failure(failure) {}

  bool factor(const Matrix& a, double& d) { return failure != FACTOR && Minimal_solver::factor(a, d); }

  bool linear_solver(const Vector& b, Vector& x)
  {
    for(int i = 0; i < b.dimension(); ++i)
      x[i] = NAN;
    return failure != SOLUTION;
  }
};

// Small meshes are factorized, to the bit as by default; where no factor may take any memory, it iterates.
void check_automatic_solver()
{
  const double no_memory = 1;
  const GDP::Automatic_sparse_linear_solver free, bound(1e-10, 1, no_memory);
  check_agreement("automatic", free, 0);
  GDP_CHECK(!free.has_iterated());
  check_agreement("automatic, without memory", bound, 1e-8);
  GDP_CHECK(bound.has_iterated());

  // as a solver of its own
  const int n = 50;
  GDP::Automatic_sparse_linear_solver::Matrix matrix(n);
  GDP::Automatic_sparse_linear_solver::Vector b(n), x(n);
  for(int i = 0; i < n; ++i)
  {
    matrix.set_coef(i, i, 3, true);
    if(i > 0) // a ring, and all with the first
      for(int j : {i - 1, 0})
      {
        matrix.set_coef(i, j, -0.03, true);
        matrix.set_coef(j, i, -0.03, true);
      }
  }
  const Eigen::VectorXd wanted = Eigen::VectorXd::LinSpaced(n, 0, n - 1);
  b.eigen_object() = matrix.eigen_object() * wanted;
  for(GDP::Automatic_sparse_linear_solver solver : {free, bound})
  {
    double denominator = 0;
    GDP_CHECK(!solver.linear_solver(b, x)); // nothing is factorized
    GDP_CHECK(solver.linear_solver(matrix, b, x, denominator) && denominator == 1);
    for(int i = 0; i < n; ++i)
      GDP_CHECK_NEAR(x[i], i, 1e-9);
  }
  GDP::internal::Solver_task task;
  task.unknowns = 1000000;
  task.cores = 16;
  GDP_CHECK(GDP::internal::multigrid_pays(task, 1e12));
  task.solutions_of_each = 100;
  task.cores = 2;
  GDP_CHECK(!GDP::internal::multigrid_pays(task, 1e12));
  task.solutions_of_each = 1;
  task.is_of_second_order = true;
  GDP_CHECK(!GDP::internal::multigrid_pays(task, 1e12) && GDP::internal::multigrid_pays(task, no_memory));
}

#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD
// CHOLMOD's settings are afterwards what the caller made them, or the defaults.
void check_settings()
{
  typedef CGAL::Eigen_solver_traits<Eigen::CholmodSupernodalLLT<Sparse> > Solver;
  Fixture fixture;
  const auto signal = fixture.tm.add_property_map<Mesh::Face_index, double>("f:signal", 1).first;
  for(int ordering : {-1, CHOLMOD_AMD})
  {
    Solver vertices, faces, untouched; // copies share them
    for(Solver* solver : {&vertices, &faces, &untouched})
      if(ordering >= 0)
      {
        solver->solver().cholmod().nmethods = 1;
        solver->solver().cholmod().method[0].ordering = ordering;
      }
    GDP_CHECK(fixture.run(GDP::parameters::sparse_linear_solver(vertices)) == GDP::OK);
    GDP_CHECK(GDP::process_face_signal(fixture.tm, signal, signal, GDP::parameters::sparse_linear_solver(faces))
              == GDP::OK);
    const cholmod_common& before = untouched.solver().cholmod();
    for(Solver* solver : {&vertices, &faces})
    {
      const cholmod_common& after = solver->solver().cholmod();
      GDP_CHECK(after.nmethods == before.nmethods && after.method[0].ordering == before.method[0].ordering);
      GDP_CHECK(after.postorder == before.postorder && after.print == before.print
                && after.nrelax[0] == before.nrelax[0]);
    }
  }
}
#endif

} // namespace

// A choice of a solver that is fast: small systems, and those in the metric of the embedding.
void check_choice()
{
  using namespace GDP::internal;
  Solver_task task;
  task.unknowns = 999;
  task.gradient_weight = 1;
  GDP_CHECK_NEAR(multigrid_iterations(task), 28, 1e-9);
  task.has_metric = true;
  GDP_CHECK_NEAR(multigrid_iterations(task), 42, 1e-9);
  GDP_CHECK(!multigrid_pays(task, 1e12));
  task.unknowns = 2000000;
  task.cores = 16;
  GDP_CHECK(multigrid_pays(task, 1e12));
  task.matrices = 0; // it is factorized already, if at all
  GDP_CHECK(cholesky_time(task) > 0 && multigrid_time(task) == 0);
  task.unknowns = 10000;
  GDP_CHECK(multigrid_pays(task, 1)); // where nothing else fits
}

int main()
{
  check_choice();
#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD
  check_settings();
#endif
  check_automatic_solver();
  // the direct solvers differ by rounding, the iterative one by its tolerance
  check_agreement("SimplicialLLT", CGAL::Eigen_solver_traits<Eigen::SimplicialLLT<Sparse> >(), 1e-13);
  check_agreement("SimplicialLDLT", CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<Sparse> >(), 1e-13);
  check_agreement("SimplicialLLT, upper", CGAL::Eigen_solver_traits<Eigen::SimplicialLLT<Sparse, Eigen::Upper> >(),
                  1e-13);
#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD
  check_agreement("CholmodSupernodalLLT", CGAL::Eigen_solver_traits<Eigen::CholmodSupernodalLLT<Sparse> >(), 1e-13);
#endif
  check_agreement("ConjugateGradient", CGAL::Eigen_solver_traits<Eigen::ConjugateGradient<Sparse> >(), 1e-12);
  check_agreement("minimal model", Minimal_solver(), 1e-13);

  CGAL::Eigen_solver_traits<Eigen::ConjugateGradient<Sparse> > hurried;
  hurried.solver().setMaxIterations(2);
  check_agreement("ConjugateGradient of two iterations, then Cholesky", hurried, 1e-13);
  Listener listener;
  Fixture fixture;
  GDP_CHECK(fixture.run(GDP::parameters::sparse_linear_solver(hurried).visitor(std::ref(listener))) == GDP::OK);
  GDP_CHECK(listener.notices == 1);
  for(auto failure : {Failing_solver::FACTOR, Failing_solver::SOLUTION, Failing_solver::NOT_A_NUMBER})
    check_failure(Failing_solver(failure), GDP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM);
  return GDP_TEST_RESULT();
}
