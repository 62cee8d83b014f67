// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Gradient_domain_solver computes once what can be kept: the analysis for a mesh, the factorization for a metric and
// weights.

#include "test_meshes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/Gradient_domain_solver.h>
#include <CGAL/Gradient_domain_processing/process_signal.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/SparseCholesky>

#include <array>
#include <vector>

using namespace gdp_test;
namespace GDP = CGAL::Gradient_domain_processing;

typedef CGAL::Simple_cartesian<double> K;
typedef CGAL::Surface_mesh<K::Point_3> Mesh;
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Face_index Face;
typedef Eigen::SparseMatrix<double> Sparse;

namespace {

// A solver in the manner of Eigen's that counts what it is asked to do, and reads the matrix again as it solves, as
// UMFPACK does.
class Counting_solver
{
  Eigen::SimplicialLLT<Sparse> m_solver;
  const Sparse* m_matrix = nullptr;

public:
  typedef Sparse MatrixType;
  typedef double Scalar;
  int analyses = 0, factorizations = 0, solutions = 0, right_hand_sides = 0;

  void analyzePattern(const Sparse& matrix)
  {
    ++analyses;
    m_solver.analyzePattern(matrix);
  }
  void factorize(const Sparse& matrix)
  {
    ++factorizations;
    m_matrix = &matrix;
    m_solver.factorize(matrix);
  }
  void compute(const Sparse& matrix)
  {
    analyzePattern(matrix);
    factorize(matrix);
  }
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right)
  {
    ++solutions;
    right_hand_sides += int(right.cols());
    const Eigen::MatrixXd solution = m_solver.solve(right);
    GDP_CHECK((*m_matrix * solution - right).norm() <= 1e-9 * right.norm());
    return solution;
  }
  Eigen::ComputationInfo info() const { return m_solver.info(); }
};

typedef CGAL::Eigen_solver_traits<Counting_solver> Counting_traits;

struct Fixture
{
  Mesh tm = built<Mesh>(bumpy_sphere(2));
  Mesh::Property_map<Vertex, K::Vector_3> vectors, out_vectors;
  Mesh::Property_map<Vertex, double> numbers, out_numbers;

  Fixture()
  {
    vectors = tm.add_property_map<Vertex, K::Vector_3>("v:vector").first;
    out_vectors = tm.add_property_map<Vertex, K::Vector_3>("v:out_vector").first;
    numbers = tm.add_property_map<Vertex, double>("v:number").first;
    out_numbers = tm.add_property_map<Vertex, double>("v:out_number").first;
    for(Vertex v : vertices(tm))
    {
      vectors[v] = tm.point(v) - CGAL::ORIGIN;
      numbers[v] = tm.point(v).x() * tm.point(v).y();
    }
  }

  std::vector<std::array<double, 1> > result() const
  {
    std::vector<std::array<double, 1> > values;
    for(Vertex v : vertices(tm))
      values.push_back({{out_numbers[v]}});
    return values;
  }
};

void check_reuse()
{
  Fixture x;
  Counting_traits traits;
  const Counting_solver& counts = traits.solver();
  auto solver =
    GDP::make_gradient_domain_solver(x.tm, GDP::parameters::sparse_linear_solver(traits).gradient_weight(1e-3));
  const auto are = [&](int analyses, int factorizations, int solutions, int right_hand_sides) {
    const bool hold = counts.analyses == analyses && counts.factorizations == factorizations
                      && counts.solutions == solutions && counts.right_hand_sides == right_hand_sides;
    if(!hold)
      std::cerr << "  counted: " << counts.analyses << " " << counts.factorizations << " " << counts.solutions << " "
                << counts.right_hand_sides << std::endl;
    return hold;
  };
  // what the solver answers after all this is what a new one answers
  const auto fresh = [&](const auto& np) {
    Fixture y;
    GDP_CHECK(GDP::process_signal(y.tm, y.numbers, y.out_numbers, np) == GDP::OK);
    GDP_CHECK(distance(x.result(), y.result()) <= 1e-13);
  };

  GDP_CHECK(are(0, 0, 0, 0));
  GDP_CHECK(solver.error() == GDP::OK);
  GDP_CHECK(solver.factorize() == GDP::OK);
  GDP_CHECK(are(1, 1, 0, 0));
  GDP_CHECK(solver.number_of_degrees_of_freedom() == num_vertices(x.tm));

  // all channels in one
  GDP_CHECK(solver.filter(x.vectors, x.out_vectors) == GDP::OK);
  GDP_CHECK(are(1, 1, 1, 3));
  // another signal
  GDP_CHECK(solver.filter(x.numbers, x.out_numbers) == GDP::OK);
  GDP_CHECK(are(1, 1, 2, 4));
  fresh(GDP::parameters::gradient_weight(1e-3));
  // another lambda
  GDP_CHECK(solver.set_gradient_scale(2) == GDP::OK);
  GDP_CHECK(solver.filter(x.numbers, x.out_numbers) == GDP::OK);
  GDP_CHECK(are(1, 1, 3, 5));
  fresh(GDP::parameters::gradient_weight(1e-3).gradient_scale(2.));
  // a target field
  auto targets = x.tm.add_property_map<Face, std::array<K::Vector_3, 3> >("f:target").first;
  GDP_CHECK(solver.fit_to_gradients(x.vectors, targets, x.out_vectors) == GDP::OK);
  GDP_CHECK(are(1, 1, 4, 8));
  // several passes
  GDP_CHECK(solver.filter(x.numbers, x.out_numbers, 3) == GDP::OK);
  GDP_CHECK(are(1, 1, 7, 11));
  // factorizing again is not needed
  GDP_CHECK(solver.factorize() == GDP::OK);
  GDP_CHECK(are(1, 1, 7, 11));

  // another alpha, beta or metric: one factorization each, and when it is needed
  GDP_CHECK(solver.set_gradient_weight(1e-2) == GDP::OK);
  GDP_CHECK(are(1, 1, 7, 11));
  GDP_CHECK(solver.filter(x.numbers, x.out_numbers) == GDP::OK);
  GDP_CHECK(are(1, 2, 8, 12));
  fresh(GDP::parameters::gradient_weight(1e-2).gradient_scale(2.));
  GDP_CHECK(solver.set_value_weight(5) == GDP::OK);
  GDP_CHECK(solver.filter(x.numbers, x.out_numbers) == GDP::OK);
  GDP_CHECK(are(1, 3, 9, 13));
  fresh(GDP::parameters::gradient_weight(1e-2).gradient_scale(2.).value_weight(5.));
  auto metrics =
    x.tm.add_property_map<Face, GDP::Triangle_metric>("f:metric", GDP::Triangle_metric::equilateral(0.2)).first;
  GDP_CHECK(solver.set_metric(metrics) == GDP::OK);
  GDP_CHECK(solver.filter(x.numbers, x.out_numbers) == GDP::OK);
  GDP_CHECK(are(1, 4, 10, 14));
  fresh(GDP::parameters::gradient_weight(1e-2).gradient_scale(2.).value_weight(5.).face_metric_map(metrics));
  GDP_CHECK(solver.set_embedding_metric() == GDP::OK);
  GDP_CHECK(solver.filter(x.numbers, x.out_numbers) == GDP::OK);
  GDP_CHECK(are(1, 5, 11, 15));
  fresh(GDP::parameters::gradient_weight(1e-2).gradient_scale(2.).value_weight(5.));

  // a setting that is refused costs nothing and changes nothing
  metrics[Face(5)] = GDP::Triangle_metric(1, 1, 1);
  GDP_CHECK(solver.set_metric(metrics) == GDP::ERROR_INVALID_METRIC);
  GDP_CHECK(solver.set_gradient_weight(-1) == GDP::ERROR_INVALID_WEIGHT);
  GDP_CHECK(solver.set_value_weight(NAN) == GDP::ERROR_INVALID_WEIGHT);
  GDP_CHECK(solver.set_gradient_scale(HUGE_VAL) == GDP::ERROR_INVALID_WEIGHT);
  GDP_CHECK(solver.filter(x.numbers, x.out_numbers) == GDP::OK);
  GDP_CHECK(are(1, 5, 12, 16));
  fresh(GDP::parameters::gradient_weight(1e-2).gradient_scale(2.).value_weight(5.));
}

// process_signal() with several passes factorizes once.
void check_iterations()
{
  Fixture x;
  Counting_traits traits;
  GDP_CHECK(GDP::process_signal(x.tm, x.numbers, x.out_numbers,
    GDP::parameters::sparse_linear_solver(traits).number_of_iterations(4)) == GDP::OK);
  GDP_CHECK(traits.solver().analyses == 1 && traits.solver().factorizations == 1 && traits.solver().solutions == 4);
}

// A mesh that changes later is not seen; a solver that failed says so whatever one asks.
void check_state()
{
  Fixture x, y;
  auto solver = GDP::make_gradient_domain_solver(x.tm);
  for(Vertex v : vertices(x.tm))
    x.tm.point(v) = K::Point_3(0, 0, 0);
  GDP_CHECK(solver.filter(x.numbers, x.out_numbers) == GDP::OK);
  GDP_CHECK(GDP::process_signal(y.tm, y.numbers, y.out_numbers) == GDP::OK);
  GDP_CHECK(distance(x.result(), y.result()) <= 1e-15);

  y.tm.point(Vertex(3)) = K::Point_3(0, NAN, 0);
  auto failed = GDP::make_gradient_domain_solver(y.tm);
  const auto before = y.result();
  GDP_CHECK(failed.error() == GDP::ERROR_INVALID_POINT);
  GDP_CHECK(failed.factorize() == GDP::ERROR_INVALID_POINT);
  GDP_CHECK(failed.filter(y.numbers, y.out_numbers) == GDP::ERROR_INVALID_POINT);
  GDP_CHECK(distance(y.result(), before) == 0);
}

// The default solver, and LL^T in general, notices a matrix that is not positive definite.
template <class Traits>
void check_indefinite()
{
  Sparse matrix(3, 3);
  for(int i = 0; i < 3; ++i)
    matrix.insert(i, i) = i == 1 ? -1 : 2;
  matrix.makeCompressed();
  GDP::internal::Linear_solver<Traits> solver((Traits()));
  GDP_CHECK(solver.analyze(matrix) == GDP::OK);
  GDP_CHECK(solver.factorize(matrix) == GDP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM);

  // and is of use afterwards
  matrix.coeffRef(1, 1) = 4;
  GDP_CHECK(solver.factorize(matrix) == GDP::OK);
  Eigen::MatrixXd solution;
  GDP_CHECK(solver.solve(Eigen::MatrixXd::Ones(3, 2), solution) == GDP::OK);
  GDP_CHECK_NEAR(solution(1, 1), 0.25, 1e-15);
  GDP_CHECK_NEAR(solution(0, 0), 0.5, 1e-15);
}

} // namespace

int main()
{
  check_reuse();
  check_iterations();
  check_state();
  check_indefinite<GDP::Default_sparse_linear_solver>();
  check_indefinite<CGAL::Eigen_solver_traits<Eigen::SimplicialLLT<Sparse> > >();
  return GDP_TEST_RESULT();
}
