// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Identities of the operators: S = D G, S 1 = 0, sum(M) = area, exact integrals of linear functions, definiteness,
// scaling of the metric; on embeddings and under any metric; with gaps in the indices and with isolated vertices.

#include "test_meshes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/operators.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

using namespace gdp_test;
namespace GDP = CGAL::Gradient_domain_processing;

typedef CGAL::Simple_cartesian<double> K;
typedef CGAL::Surface_mesh<K::Point_3> Mesh;
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Face_index Face;
typedef Mesh::Property_map<Face, GDP::Triangle_metric> Metrics;
typedef Eigen::SparseMatrix<double> Sparse;

namespace {

struct Operators
{
  Sparse mass, stiffness, gradient, divergence;
};

template <class NamedParameters>
Operators operators(const Mesh& tm, const NamedParameters& np)
{
  Operators result;
  GDP_CHECK(GDP::mass_matrix(tm, result.mass, np) == GDP::OK);
  GDP_CHECK(GDP::stiffness_matrix(tm, result.stiffness, np) == GDP::OK);
  GDP_CHECK(GDP::gradient_matrix(tm, result.gradient, np) == GDP::OK);
  GDP_CHECK(GDP::divergence_matrix(tm, result.divergence, np) == GDP::OK);
  return result;
}

Eigen::Vector3d eigen(const K::Point_3& p) { return Eigen::Vector3d(p.x(), p.y(), p.z()); }

std::array<Eigen::Vector3d, 3> corners(const Mesh& tm, Face f)
{
  const auto h = tm.halfedge(f);
  return {{eigen(tm.point(tm.source(h))), eigen(tm.point(tm.target(h))), eigen(tm.point(tm.target(tm.next(h))))}};
}

double area(const Mesh& tm, Face f)
{
  const auto p = corners(tm, f);
  return (p[1] - p[0]).cross(p[2] - p[0]).norm() / 2;
}

double norm(const Eigen::MatrixXd& m) { return m.size() == 0 ? 0 : m.cwiseAbs().maxCoeff(); }

// `areas` of the faces under the metric, `components` that have faces.
void check_identities(const Mesh& tm, const Operators& op, const std::vector<double>& areas, int components)
{
  const double sum = std::accumulate(areas.begin(), areas.end(), 0.);
  const Eigen::VectorXd ones_v = Eigen::VectorXd::Ones(op.mass.rows()),
                        ones_f = Eigen::VectorXd::Ones(op.gradient.rows());
  const Eigen::MatrixXd mass(op.mass), stiffness(op.stiffness);
  const double eps = 1e-13;

  GDP_CHECK(op.stiffness.rows() == op.mass.rows() && op.gradient.cols() == op.mass.rows());
  GDP_CHECK(op.divergence.rows() == op.mass.rows() && op.divergence.cols() == op.gradient.rows());
  GDP_CHECK_NEAR(op.mass.sum(), sum, eps * sum);
  GDP_CHECK(norm(mass - mass.transpose()) <= eps * norm(mass));
  GDP_CHECK(norm(stiffness - stiffness.transpose()) <= eps * norm(stiffness));
  GDP_CHECK(norm(stiffness - Eigen::MatrixXd(op.divergence * op.gradient)) <= eps * norm(stiffness));
  GDP_CHECK(norm(stiffness * ones_v) <= eps * norm(stiffness));
  GDP_CHECK(norm(op.gradient * ones_v) == 0);
  GDP_CHECK(norm(op.divergence.transpose() * ones_v) <= eps * norm(Eigen::MatrixXd(op.divergence)));

  // a row of M sums up to a third of the area around its vertex
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(op.mass.rows());
  std::size_t i = 0;
  for(Face f : faces(tm))
  {
    for(Vertex v : vertices_around_face(tm.halfedge(f), tm))
      expected[int(v)] += areas[i] / 3;
    ++i;
  }
  GDP_CHECK(norm(mass * ones_v - expected) <= eps * sum);

  // definiteness, on the vertices that have a face
  std::vector<int> used;
  for(Vertex v : vertices(tm))
    if(!tm.is_isolated(v))
      used.push_back(int(v));
  const int n = int(used.size());
  Eigen::MatrixXd m(n, n), s(n, n);
  for(int a = 0; a < n; ++a)
    for(int b = 0; b < n; ++b)
    {
      m(a, b) = mass(used[a], used[b]);
      s(a, b) = stiffness(used[a], used[b]);
    }
  const Eigen::VectorXd of_mass =
                          Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(m, Eigen::EigenvaluesOnly).eigenvalues(),
                        of_stiffness =
                          Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(s, Eigen::EigenvaluesOnly).eigenvalues();
  GDP_CHECK(of_mass[0] > 0);
  for(int k = 0; k < components; ++k)
    GDP_CHECK(std::abs(of_stiffness[k]) <= 1e-12 * of_stiffness[n - 1]);
  GDP_CHECK(of_stiffness[components] > 1e-6 * of_stiffness[n - 1]);

  // what is not used is zero
  GDP_CHECK_NEAR(m.sum(), mass.sum(), eps * sum);
  GDP_CHECK_NEAR(s.cwiseAbs().sum(), stiffness.cwiseAbs().sum(), eps * s.cwiseAbs().sum());
}

void check_mesh(Mesh tm, int components)
{
  std::vector<double> areas;
  for(Face f : faces(tm))
    areas.push_back(area(tm, f));
  const Operators embedding = operators(tm, GDP::parameters::default_values());
  check_identities(tm, embedding, areas, components);

  // any symmetric positive definite tensors, from one far from round to the next
  Metrics metrics = tm.add_property_map<Face, GDP::Triangle_metric>("f:metric").first;
  Metrics multiples = tm.add_property_map<Face, GDP::Triangle_metric>("f:multiple").first;
  Random random(5);
  std::vector<double> areas_of_metrics, areas_of_multiples;
  const double c = 7.25;
  for(Face f : faces(tm))
  {
    const double l11 = random(0.5, 2), l21 = random(-2, 2), l22 = random(0.2, 2);
    const double g11 = l11 * l11, g12 = l11 * l21, g22 = l21 * l21 + l22 * l22;
    metrics[f] = GDP::Triangle_metric(g11, g12, g22);
    multiples[f] = GDP::Triangle_metric(c * g11, c * g12, c * g22);
    areas_of_metrics.push_back(l11 * l22 / 2);
  }
  const Operators any = operators(tm, GDP::parameters::face_metric_map(metrics));
  check_identities(tm, any, areas_of_metrics, components);

  // c g leaves S and D as they are and scales M by c; so does scaled()
  const Operators multiple = operators(tm, GDP::parameters::face_metric_map(multiples));
  const auto near_to = [](const Sparse& a, const Sparse& b) {
    return norm(Eigen::MatrixXd(a) - Eigen::MatrixXd(b)) <= 1e-12 * norm(Eigen::MatrixXd(b)); };
  GDP_CHECK(near_to(multiple.stiffness, any.stiffness));
  GDP_CHECK(near_to(multiple.divergence, any.divergence));
  GDP_CHECK(near_to(multiple.mass, c * any.mass));
  for(Face f : faces(tm))
    multiples[f] = metrics[f].scaled(c);
  const Operators scaled = operators(tm, GDP::parameters::face_metric_map(multiples));
  GDP_CHECK(near_to(scaled.stiffness, any.stiffness));
  GDP_CHECK(near_to(scaled.mass, c * any.mass));

  // the metric of the embedding handed over is the default
  for(Face f : faces(tm))
  {
    const auto p = corners(tm, f);
    const Eigen::Vector3d t1 = p[1] - p[0], t2 = p[2] - p[0];
    metrics[f] = GDP::Triangle_metric(t1.dot(t1), t1.dot(t2), t2.dot(t2));
  }
  const Operators given = operators(tm, GDP::parameters::face_metric_map(metrics));
  GDP_CHECK(near_to(given.stiffness, embedding.stiffness));
  GDP_CHECK(near_to(given.mass, embedding.mass));
  GDP_CHECK(near_to(given.divergence, embedding.divergence));
}

// One right triangle with legs 2 and 1, and one equilateral: numbers one knows.
void check_single_triangles()
{
  Mesh tm = built<Mesh>(Soup{{{{5, 5, 5}}, {{7, 5, 5}}, {{5, 5, 6}}}, {{{0, 1, 2}}}});
  const Operators op = operators(tm, GDP::parameters::default_values());
  Eigen::Matrix3d mass, stiffness;
  mass << 2, 1, 1, 1, 2, 1, 1, 1, 2;
  stiffness << 2.5, -0.5, -2, -0.5, 0.5, 0, -2, 0, 2;
  GDP_CHECK(norm(Eigen::MatrixXd(op.mass) - mass / 12) <= 1e-15);
  GDP_CHECK(norm(Eigen::MatrixXd(op.stiffness) - stiffness / 2) <= 1e-15);

  Metrics metrics = tm.add_property_map<Face, GDP::Triangle_metric>("f:metric").first;
  metrics[*faces(tm).begin()] = GDP::Triangle_metric::equilateral(3);
  const Operators equilateral = operators(tm, GDP::parameters::face_metric_map(metrics));
  stiffness << 2, -1, -1, -1, 2, -1, -1, -1, 2;
  GDP_CHECK(norm(Eigen::MatrixXd(equilateral.stiffness) - stiffness / (2 * std::sqrt(3.))) <= 1e-15);
  GDP_CHECK_NEAR(equilateral.mass.sum(), 9 * std::sqrt(3.) / 4, 1e-14);
}

// A flat mesh with a constant metric T on its plane: integrals of linear functions are exact.
void check_linear_precision(bool with_metric)
{
  Random random(3);
  const int n = 9;
  Soup soup = grid(n, n);
  for(Coordinates& p : soup.points)
    if(p[0] > 0 && p[0] < 1 && p[1] > 0 && p[1] < 1)
    {
      p[0] += random(-0.3, 0.3) / n;
      p[1] += random(-0.3, 0.3) / n;
    }
  const Soup flat = soup;
  Mesh tm = built<Mesh>(translated(rotated(soup), {{4, -2, 1}}));
  Eigen::Matrix2d t = Eigen::Matrix2d::Identity();
  if(with_metric)
    t << 3, 1.2, 1.2, 0.9;
  const double stretch = std::sqrt(t.determinant());

  Metrics metrics = tm.add_property_map<Face, GDP::Triangle_metric>("f:metric").first;
  const auto plane = [&](Vertex v) { return Eigen::Vector2d(flat.points[v][0], flat.points[v][1]); };
  for(Face f : faces(tm))
  {
    const auto h = tm.halfedge(f);
    const Eigen::Vector2d o = plane(tm.source(h)), t1 = plane(tm.target(h)) - o, t2 = plane(tm.target(tm.next(h))) - o;
    metrics[f] = GDP::Triangle_metric(t1.dot(t * t1), t1.dot(t * t2), t2.dot(t * t2));
  }
  const Operators op = with_metric ? operators(tm, GDP::parameters::face_metric_map(metrics))
                                   : operators(tm, GDP::parameters::default_values());
  Eigen::VectorXd x(num_vertices(tm)), y(num_vertices(tm));
  for(Vertex v : vertices(tm))
  {
    x[int(v)] = flat.points[v][0];
    y[int(v)] = flat.points[v][1];
  }

  // products of linear functions over the unit square, and their Dirichlet energies
  GDP_CHECK_NEAR(x.dot(op.mass * x), stretch / 3, 1e-14);
  GDP_CHECK_NEAR(x.dot(op.mass * y), stretch / 4, 1e-14);
  GDP_CHECK_NEAR(op.mass.sum(), stretch, 1e-13);
  const Eigen::Matrix2d inverse = t.inverse();
  GDP_CHECK_NEAR(x.dot(op.stiffness * x), stretch * inverse(0, 0), 1e-12);
  GDP_CHECK_NEAR(x.dot(op.stiffness * y), stretch * inverse(0, 1), 1e-12);
  GDP_CHECK_NEAR(y.dot(op.stiffness * y), stretch * inverse(1, 1), 1e-12);

  // linear functions are harmonic inside
  const Eigen::VectorXd sx = op.stiffness * x, sy = op.stiffness * y;
  for(Vertex v : vertices(tm))
    if(!tm.is_border(v))
    {
      GDP_CHECK_NEAR(sx[int(v)], 0, 1e-13);
      GDP_CHECK_NEAR(sy[int(v)], 0, 1e-13);
    }

  // the gradient of a linear function is its differences along the sides
  const Eigen::VectorXd g = op.gradient * (2 * x - 3 * y);
  for(Face f : faces(tm))
  {
    const auto h = tm.halfedge(f);
    const Eigen::Vector2d o = plane(tm.source(h)), a(2, -3);
    GDP_CHECK_NEAR(g[2 * int(f)], a.dot(plane(tm.target(h)) - o), 1e-14);
    GDP_CHECK_NEAR(g[2 * int(f) + 1], a.dot(plane(tm.target(tm.next(h))) - o), 1e-14);
  }
}

// Faces and vertices were removed, in the middle and at the end; there are isolated vertices.
Mesh with_gaps()
{
  Mesh tm = built<Mesh>(bumpy_patch(6, 5));
  tm.add_vertex(K::Point_3(9, 9, 9));
  const Vertex last = tm.add_vertex(K::Point_3(1, 2, 3));
  for(int f : {0, 1, 20, 21, 22, int(num_faces(tm)) - 1})
    CGAL::Euler::remove_face(tm.halfedge(Face(Mesh::size_type(f))), tm);
  for(int v = 0; v < int(tm.number_of_vertices() + tm.number_of_removed_vertices()); ++v)
  {
    const Vertex vertex{Mesh::size_type(v)};
    if(v % 5 == 0 && !tm.is_removed(vertex) && tm.is_isolated(vertex))
      tm.remove_vertex(vertex);
  }
  GDP_CHECK(tm.has_garbage() && !tm.is_removed(last));
  return tm;
}

// An index map of the user's numbers the rows and columns; with it, there are no gaps.
void check_index_maps(Mesh tm)
{
  const Operators usual = operators(tm, GDP::parameters::default_values());
  auto vertex_indices = tm.add_property_map<Vertex, std::size_t>("v:number").first;
  auto face_indices = tm.add_property_map<Face, std::size_t>("f:number").first;
  const std::size_t n = num_vertices(tm), m = num_faces(tm);
  std::size_t i = 0;
  for(Vertex v : vertices(tm))
    vertex_indices[v] = n - ++i;
  for(Face f : faces(tm))
    face_indices[f] = (7 * i++) % m;
  GDP_CHECK(m % 7 != 0);
  const Operators other = operators(tm, GDP::parameters::vertex_index_map(vertex_indices).face_index_map(face_indices));
  GDP_CHECK(other.mass.rows() == int(n) && other.gradient.rows() == int(2 * m));

  Eigen::MatrixXd to_vertices = Eigen::MatrixXd::Zero(n, usual.mass.rows()),
                  to_faces = Eigen::MatrixXd::Zero(2 * m, usual.gradient.rows());
  for(Vertex v : vertices(tm))
    to_vertices(vertex_indices[v], int(v)) = 1;
  for(Face f : faces(tm))
    for(int side = 0; side < 2; ++side)
      to_faces(2 * face_indices[f] + side, 2 * int(f) + side) = 1;
  const auto same = [](const Sparse& a, const Eigen::MatrixXd& b) {
    return norm(Eigen::MatrixXd(a) - b) <= 1e-14 * norm(b);
  };
  GDP_CHECK(same(other.mass, to_vertices * usual.mass * to_vertices.transpose()));
  GDP_CHECK(same(other.stiffness, to_vertices * usual.stiffness * to_vertices.transpose()));
  GDP_CHECK(same(other.gradient, to_faces * usual.gradient * to_vertices.transpose()));
  GDP_CHECK(same(other.divergence, to_vertices * usual.divergence * to_faces.transpose()));
}

// The unit of length is a factor of M alone; far from the origin and at any scale.
void check_scales()
{
  const Soup soup = bumpy_patch(5, 5);
  const Operators unit = operators(built<Mesh>(soup), GDP::parameters::default_values());
  for(double s : {1e-100, 1e-6, 1e6, 1e100})
  {
    const Operators op = operators(built<Mesh>(scaled(soup, s)), GDP::parameters::default_values());
    GDP_CHECK(norm(Eigen::MatrixXd(op.stiffness - unit.stiffness)) <= 1e-12 * norm(Eigen::MatrixXd(unit.stiffness)));
    GDP_CHECK(norm(Eigen::MatrixXd(op.mass / (s * s) - unit.mass)) <= 1e-12 * norm(Eigen::MatrixXd(unit.mass)));
  }
}

// Whatever is wrong, the matrix stays as it was.
void check_errors()
{
  const auto refused = [](const Mesh& tm, GDP::Error_code expected, const auto& np, int first = 0) {
    for(int i = first; i < 4; ++i)
    {
      Sparse matrix(2, 3);
      matrix.insert(1, 2) = 5;
      const GDP::Error_code code = i == 0   ? GDP::mass_matrix(tm, matrix, np)
                                   : i == 1 ? GDP::stiffness_matrix(tm, matrix, np)
                                   : i == 2 ? GDP::gradient_matrix(tm, matrix, np)
                                            : GDP::divergence_matrix(tm, matrix, np);
      GDP_CHECK(code == expected);
      GDP_CHECK(matrix.rows() == 2 && matrix.cols() == 3 && matrix.coeff(1, 2) == 5);
    }
  };
  Mesh tm;
  refused(tm, GDP::ERROR_EMPTY_MESH, GDP::parameters::default_values());
  tm = built<Mesh>(grid(2, 2));
  Metrics metrics = tm.add_property_map<Face, GDP::Triangle_metric>("f:metric").first;
  metrics[Face(3)] = GDP::Triangle_metric(1, 2, 1);
  refused(tm, GDP::ERROR_INVALID_METRIC, GDP::parameters::face_metric_map(metrics));
  tm.point(Vertex(4)) = K::Point_3(0, NAN, 0);
  refused(tm, GDP::ERROR_INVALID_POINT, GDP::parameters::default_values());
  Mesh quad;
  std::vector<Vertex> around;
  for(const Coordinates& p : grid(1, 1).points)
    around.push_back(quad.add_vertex(K::Point_3(p[0], p[1], p[2])));
  quad.add_face(around[0], around[1], around[3], around[2]);
  // gradients are those of triangles
  refused(quad, GDP::ERROR_NON_TRIANGULAR_MESH, GDP::parameters::default_values(), 2);
}

} // namespace

int main()
{
  check_single_triangles();
  check_mesh(built<Mesh>(bumpy_sphere(2)), 1);
  check_mesh(built<Mesh>(bumpy_patch(8, 6)), 1);
  check_mesh(built<Mesh>(box(3)), 1);
  Mesh two = built<Mesh>(icosphere(1));
  build(translated(bumpy_patch(4, 4), {{5, 0, 0}}), two);
  two.add_vertex(K::Point_3(1, 1, 1));
  check_mesh(two, 2);
  check_mesh(with_gaps(), 1);
  check_linear_precision(false);
  check_linear_precision(true);
  check_index_maps(built<Mesh>(bumpy_sphere(1)));
  check_index_maps(with_gaps());
  check_scales();
  check_errors();
  return GDP_TEST_RESULT();
}
