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

// Another region in a solver is a new solver of that region, without reading the mesh again.
void check_regions()
{
  Fixture x;
  const std::vector<Face> all(faces(x.tm).begin(), faces(x.tm).end());
  const std::vector<Face> lower(all.begin(), all.begin() + 150), upper(all.begin() + 100, all.end() - 40);
  auto is_constrained = x.tm.add_property_map<Vertex, bool>("v:constrained", false).first;
  for(Vertex v : vertices(x.tm))
    is_constrained[v] = int(v) % 7 == 0;
  const auto constraints = GDP::parameters::vertex_is_constrained_map(is_constrained);
  const auto none = GDP::parameters::default_values();
  const auto weights = GDP::parameters::gradient_weight(1e-2);
  Counting_traits traits;
  auto solver = GDP::make_gradient_domain_solver(x.tm, weights.sparse_linear_solver(traits));
  const auto is_as_new = [&](const std::vector<Face>& region, const auto& np) {
    GDP_CHECK(solver.filter(x.numbers, x.out_numbers) == GDP::ok);
    Fixture y;
    GDP_CHECK(GDP::process_signal(region, y.tm, y.numbers, y.out_numbers, np) == GDP::ok);
    std::vector<char> is_in(num_vertices(x.tm), 0), is_out(num_vertices(x.tm), 1);
    for(Face f : region)
      for(Vertex v : vertices_around_face(halfedge(f, x.tm), x.tm))
        is_in[v] = 1;
    for(Vertex v : vertices(x.tm))
    {
      if(is_in[v])
        GDP_CHECK_NEAR(x.out_numbers[v], y.out_numbers[v], 1e-13);
      else
        GDP_CHECK(x.out_numbers[v] == x.numbers[v]);
    }
  };
  is_as_new(all, weights);
  GDP_CHECK(solver.set_region(lower) == GDP::ok);
  is_as_new(lower, weights);
  const std::size_t dofs = solver.number_of_degrees_of_freedom();
  GDP_CHECK(dofs > 20 && dofs < num_vertices(x.tm) / 2 + 10 && traits.solver().analyses == 2);
  // constraints in a region, which stays as they change
  GDP_CHECK(solver.set_constraints_from_parameters(constraints) == GDP::ok);
  is_as_new(lower, weights.vertex_is_constrained_map(is_constrained));
  GDP_CHECK(solver.set_region(upper, constraints) == GDP::ok);
  is_as_new(upper, weights.vertex_is_constrained_map(is_constrained));
  // one that is refused changes nothing
  std::vector<Face> wrong = lower;
  wrong.push_back(Face(100000));
  GDP_CHECK(solver.set_region(wrong, none) == GDP::error_invalid_region);
  is_as_new(upper, weights.vertex_is_constrained_map(is_constrained));
  GDP_CHECK(solver.set_region(std::vector<Face>()) == GDP::ok);
  is_as_new({}, weights);
  GDP_CHECK(solver.number_of_degrees_of_freedom() == 0);
  GDP_CHECK(solver.set_region(all) == GDP::ok);
  is_as_new(all, weights);

  // within a region that a solver was made for; a soup, with faces in any order
  auto of_region = GDP::make_gradient_domain_solver(upper, x.tm, weights);
  GDP_CHECK(of_region.set_region(lower) == GDP::error_invalid_region);
  const std::vector<Face> common(all.begin() + 100, all.begin() + 150);
  GDP_CHECK(of_region.set_region(common) == GDP::ok);
  Fixture y, z;
  GDP_CHECK(of_region.filter(y.numbers, y.out_numbers) == GDP::ok);
  GDP_CHECK(GDP::process_signal(common, z.tm, z.numbers, z.out_numbers, weights) == GDP::ok);
  for(Face f : common)
    for(Vertex v : vertices_around_face(halfedge(f, x.tm), x.tm))
      GDP_CHECK_NEAR(y.out_numbers[v], z.out_numbers[v], 1e-13);
}

// Likewise of quads, whose virtual vertices go with them.
void check_regions_of_polygons()
{
  std::vector<K::Point_3> points;
  std::vector<std::array<std::size_t, 4> > quads;
  std::vector<double> in, out, expected;
  for(std::size_t i = 0; i < 100; ++i)
  {
    points.emplace_back(double(i / 10), double(i % 10), 0.1 * double(i % 3));
    in.push_back(double(i * 37 % 17));
  }
  for(std::size_t i = 0; i < 9; ++i)
    for(std::size_t j = 0; j < 9; ++j)
      quads.push_back({{10 * i + j, 10 * i + 10 + j, 10 * i + 11 + j, 10 * i + j + 1}});
  out = expected = in;
  const std::vector<std::size_t> region = {40, 41, 49, 50, 51, 31, 32, 33, 42, 22, 23, 24, 30, 39, 48};
  const auto map = [](std::vector<double>& values) { return CGAL::make_property_map(values); };
  auto solver = GDP::make_gradient_domain_solver(points, quads, GDP::parameters::gradient_weight(1e-2));
  GDP_CHECK(solver.set_region(region) == GDP::ok && solver.filter(map(in), map(out)) == GDP::ok);
  GDP_CHECK(GDP::process_signal(region, points, quads, map(in), map(expected), GDP::parameters::gradient_weight(1e-2))
            == GDP::ok);
  int changed = 0;
  for(std::size_t v = 0; v < in.size(); ++v)
  {
    GDP_CHECK_NEAR(out[v], expected[v], 1e-12);
    changed += out[v] != in[v];
  }
  GDP_CHECK(changed > 2 && changed < 16);
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
  check_regions();
  check_regions_of_polygons();
  check_indefinite<GDP::Default_sparse_linear_solver>();
  check_indefinite<CGAL::Eigen_solver_traits<Eigen::SimplicialLLT<Sparse> > >();
  return GDP_TEST_RESULT();
}
