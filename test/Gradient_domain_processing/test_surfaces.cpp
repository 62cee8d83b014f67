// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces of all kinds by their properties: random soups give what the mesh gives, random seams too, polygons of any
// size reproduce linear functions, signals on their faces and matrices of soups are those of a dense computation, lines
// of three sheets are curves.

#include "test_shapes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/operators.h>
#include <CGAL/Gradient_domain_processing/process_face_signal.h>
#include <CGAL/Gradient_domain_processing/process_signal.h>
#include <CGAL/Gradient_domain_processing/smooth.h>

#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

using namespace gdp_test;
namespace GDP = CGAL::Gradient_domain_processing;

namespace {

typedef std::vector<Point> Points;
typedef std::vector<std::vector<int> > Polygons;

Points points_of(const Shape& shape)
{
  Points points;
  for(const Vec& p : shape.points)
    points.emplace_back(p.x(), p.y(), p.z());
  return points;
}

// ---- soups and seams

Shape random_shape(Random& random)
{
  switch(random.below(4))
  {
    case 0: return sphere(3 + random.below(3)).noisy(0.03, random.below(1000));
    case 1: return jittered_square(5 + random.below(5)).noisy(0.02, random.below(1000));
    case 2: return disk(6 + random.below(6), 3).noisy(0.03, random.below(1000));
    default: return sphere(3).noisy(0.05) + jittered_square(4).moved(Vec(3, 0, 0)).noisy(0.02, random.below(1000));
  }
}

template <class Items>
std::vector<int> shuffled(const Items& items, Random& random)
{
  std::vector<int> order(items.size());
  std::iota(order.begin(), order.end(), 0);
  for(int i = int(order.size()) - 1; i > 0; --i)
    std::swap(order[std::size_t(i)], order[std::size_t(random.below(i + 1))]);
  return order;
}

// The shape with its triangles in another order, turned and turned over, and some corners with a copy of their vertex.
struct Soup
{
  Points points;
  std::vector<int> original; // of every point
  Polygons triangles;

  Soup(const Shape& shape, double part_of_copies, Random& random)
  {
    std::vector<int> number(shape.points.size());
    for(int v : shuffled(shape.points, random))
    {
      number[std::size_t(v)] = int(points.size());
      add(shape, v);
    }
    for(int f : shuffled(shape.triangles, random))
    {
      std::vector<int> corners;
      for(int v : shape.triangles[std::size_t(f)])
      {
        const bool is_copy = random.in(0, 1) < part_of_copies;
        corners.push_back(is_copy ? int(points.size()) : number[std::size_t(v)]);
        if(is_copy)
          add(shape, v);
      }
      std::rotate(corners.begin(), corners.begin() + random.below(3), corners.end());
      if(random.below(4) == 0)
        std::swap(corners[0], corners[1]);
      triangles.push_back(corners);
    }
  }

  void add(const Shape& shape, int v)
  {
    const Vec& p = shape.points[std::size_t(v)];
    points.emplace_back(p.x(), p.y(), p.z());
    original.push_back(v);
  }
};

void test_random_soups()
{
  Random random(5);
  double worst = 0, least = 1;
  for(int trial = 0; trial < 60; ++trial)
  {
    const Shape shape = random_shape(random);
    const Soup soup(shape, trial % 3 == 0 ? 0 : random.in(0, 0.5), random);
    const GDP::Border_condition border = GDP::Border_condition(random.below(3));
    const auto np = GDP::parameters::gradient_weight(std::pow(10., random.in(-4, -1)))
                      .gradient_scale(random.in(-0.5, 2))
                      .border_condition(border);
    Points whole = points_of(shape), in_pieces = soup.points;
    GDP_CHECK(GDP::smooth(whole, shape.triangles, np) == GDP::ok);
    GDP_CHECK(GDP::smooth(in_pieces, soup.triangles, np.weld_tolerance(0.)) == GDP::ok);
    double moved = 0;
    for(std::size_t v = 0; v < in_pieces.size(); ++v)
    {
      const Vec expected = vec(whole[std::size_t(soup.original[v])]);
      bool is_used = false; // a vertex of which all corners got copies stays
      for(const auto& t : soup.triangles)
        is_used = is_used || std::find(t.begin(), t.end(), int(v)) != t.end();
      if(is_used)
        worst = (std::max)(worst, (vec(in_pieces[v]) - expected).norm());
      else
        GDP_CHECK(same_bits(in_pieces[v], soup.points[v]));
      moved = (std::max)(moved, (expected - shape.points[std::size_t(soup.original[v])]).norm());
    }
    least = (std::min)(least, moved);
  }
  GDP_CHECK_NEAR(worst, 0, 1e-9);
  GDP_CHECK(least > 1e-6);
}

// ---- polygons

// Neighboring polygons of a plane become one, as often as it goes, where that is convex.
Polygons random_polygons(const Shape& shape, Random& random)
{
  Polygons polygons;
  for(const auto& t : shape.triangles)
    polygons.emplace_back(t.begin(), t.end());
  const auto is_convex = [&](const std::vector<int>& polygon) {
    for(std::size_t i = 0, n = polygon.size(); i < n; ++i)
    {
      const Vec &a = shape.points[std::size_t(polygon[i])], &b = shape.points[std::size_t(polygon[(i + 1) % n])],
                &c = shape.points[std::size_t(polygon[(i + 2) % n])];
      if(!((b - a).cross(c - b).z() > 1e-3 * (b - a).norm() * (c - b).norm()))
        return false;
    }
    return true;
  };
  for(int attempt = 0; attempt < 400; ++attempt)
  {
    const std::size_t f = std::size_t(random.below(int(polygons.size()))),
                      i = std::size_t(random.below(int(polygons[f].size())));
    const std::size_t n = polygons[f].size();
    const int v = polygons[f][i], w = polygons[f][(i + 1) % n];
    for(std::size_t g = 0; g < polygons.size(); ++g)
    {
      const std::size_t m = polygons[g].size();
      const std::size_t j = std::size_t(std::find(polygons[g].begin(), polygons[g].end(), w) - polygons[g].begin());
      if(g == f || j == m || polygons[g][(j + 1) % m] != v)
        continue;
      std::vector<int> joined;
      for(std::size_t k = 1; k <= n; ++k) // from w around to v, then around the other
        joined.push_back(polygons[f][(i + k) % n]);
      for(std::size_t k = 2; k < m; ++k)
        joined.push_back(polygons[g][(j + k) % m]);
      std::vector<int> sorted = joined;
      std::sort(sorted.begin(), sorted.end());
      if(std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end() || !is_convex(joined))
        continue;
      polygons[f] = joined;
      polygons.erase(polygons.begin() + std::ptrdiff_t(g));
      break;
    }
  }
  return polygons;
}

bool is_inside(const Point& p) { return p.x() > 1e-9 && p.y() > 1e-9 && p.x() < 1 - 1e-9 && p.y() < 1 - 1e-9; }

void test_random_polygons()
{
  Random random(8);
  std::size_t most_corners = 0;
  for(int trial = 0; trial < 30; ++trial)
  {
    const Shape shape = jittered_square(3 + random.below(6), 0.3, unsigned(random.below(1000)));
    const Polygons polygons = random_polygons(shape, random);
    const Points points = points_of(shape);
    for(const auto& polygon : polygons)
      most_corners = (std::max)(most_corners, polygon.size());

    // harmonic from wrong values inside, and a stiffness that sees no linear function
    std::vector<double> linear, wrong, out(points.size());
    for(const Point& p : points)
    {
      linear.push_back(3 * p.x() - 2 * p.y() + 1);
      wrong.push_back(linear.back() + (is_inside(p) ? random() : 0));
    }
    GDP_CHECK(GDP::process_signal(points, polygons, CGAL::make_property_map(wrong), CGAL::make_property_map(out),
      GDP::parameters::value_weight(0.).border_condition(GDP::Border_condition::FIXED)) == GDP::ok);
    for(std::size_t v = 0; v < points.size(); ++v)
      GDP_CHECK_NEAR(out[v], linear[v], 1e-10);

    Eigen::SparseMatrix<double> mass, stiffness;
    GDP_CHECK(GDP::mass_matrix(points, polygons, mass) == GDP::ok
              && GDP::stiffness_matrix(points, polygons, stiffness) == GDP::ok);
    const Eigen::Map<const Eigen::VectorXd> f(linear.data(), Eigen::Index(linear.size()));
    const Eigen::VectorXd one = Eigen::VectorXd::Ones(f.size()), flow = stiffness * f;
    for(std::size_t v = 0; v < points.size(); ++v)
      if(is_inside(points[v]))
        GDP_CHECK_NEAR(flow[Eigen::Index(v)], 0, 1e-12);
    GDP_CHECK_NEAR(f.dot(flow), 13, 1e-12); // |grad f|^2 on the unit square
    GDP_CHECK_NEAR((stiffness * one).cwiseAbs().maxCoeff(), 0, 1e-12);
    GDP_CHECK_NEAR(one.dot(mass * one), 1, 1e-13);
    GDP_CHECK_NEAR(f.dot(mass * one), 1.5, 1e-13); // its integral
    const Eigen::MatrixXd dense(stiffness);
    GDP_CHECK_NEAR((dense - dense.transpose()).norm(), 0, 1e-13);
    const Eigen::VectorXd eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense).eigenvalues();
    GDP_CHECK(eigenvalues[0] > -1e-12 && eigenvalues[1] > 1e-3);
  }
  GDP_CHECK(most_corners >= 5);
}

// A weight by vertex holds inside of polygons too: one that is constant but for a trifle is as good as the constant.
void test_weights_of_polygons()
{
  Random random(9);
  const Shape shape = jittered_square(8);
  const Polygons polygons = random_polygons(shape, random);
  const Points points = points_of(shape);
  std::vector<double> in, alpha(points.size(), 3.), by_map(points.size()), by_constant(points.size());
  for(std::size_t v = 0; v < points.size(); ++v)
    in.push_back(random());
  alpha[5] += 1e-9;
  const auto signal = CGAL::make_property_map(in);
  GDP_CHECK(GDP::process_signal(points, polygons, signal, CGAL::make_property_map(by_map),
    GDP::parameters::vertex_value_weight_map(CGAL::make_property_map(alpha)).gradient_weight(0.1)) == GDP::ok);
  GDP_CHECK(GDP::process_signal(points, polygons, signal, CGAL::make_property_map(by_constant),
    GDP::parameters::value_weight(3.).gradient_weight(0.1)) == GDP::ok);
  for(std::size_t v = 0; v < points.size(); ++v)
  {
    GDP_CHECK_NEAR(by_map[v], by_constant[v], 1e-8);
    GDP_CHECK(std::abs(by_map[v] - in[v]) > 1e-6);
  }
}

// ---- matrices

// Three sheets of triangles that meet in a line, here straight; or in a circle, of n points.
Shape three_sheets(int n, bool is_closed)
{
  Shape all;
  for(int sheet = 0; sheet < 3; ++sheet)
  {
    const double angle = 2 * pi * sheet / 3 + 0.2;
    all = all + grid(n, 4, [&](double u, double v) {
      const Vec out = is_closed ? Vec(std::cos(2 * pi * u), std::sin(2 * pi * u), 0) : Vec(1, 0, 0);
      const Vec up = is_closed ? Vec(0, 0, 1) : Vec(0, 1, 0);
      const Vec along = is_closed ? out : Vec(0, 0, u * u);
      return Vec(along + 0.5 * v * (std::cos(angle) * out + std::sin(angle) * up));
    }, is_closed);
  }
  std::map<std::array<long, 3>, int> at;
  std::vector<int> number;
  Shape joined;
  for(const Vec& p : all.points)
  {
    const std::array<long, 3> place{{std::lround(1e6 * p.x()), std::lround(1e6 * p.y()), std::lround(1e6 * p.z())}};
    const auto found = at.emplace(place, int(joined.points.size()));
    if(found.second)
      joined.points.push_back(p);
    number.push_back(found.first->second);
  }
  for(const auto& t : all.triangles)
    joined.triangles.push_back({{number[std::size_t(t[0])], number[std::size_t(t[1])], number[std::size_t(t[2])]}});
  return joined;
}

void test_matrices()
{
  // a mesh and its arrays
  const Shape ball = sphere(4).noisy(0.05);
  const Mesh mesh = mesh_of(ball);
  const Points points = points_of(ball);
  const auto difference = [](const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& b) {
    return a.rows() == b.rows() && a.cols() == b.cols() ? Eigen::MatrixXd(a - b).cwiseAbs().maxCoeff() : 1.;
  };
  Eigen::SparseMatrix<double> a, b, mass, stiffness, gradient, divergence;
  GDP_CHECK(GDP::mass_matrix(mesh, a) == GDP::ok && GDP::mass_matrix(points, ball.triangles, b) == GDP::ok);
  GDP_CHECK_NEAR(difference(a, b), 0, 1e-15);
  GDP_CHECK(GDP::stiffness_matrix(mesh, a) == GDP::ok && GDP::stiffness_matrix(points, ball.triangles, b) == GDP::ok);
  GDP_CHECK_NEAR(difference(a, b), 0, 1e-13);

  // any soup, with a triangle that has a corner twice and a point of no triangle
  Shape sheets = three_sheets(5, false).noisy(0.02);
  sheets.triangles.push_back({{0, 0, 1}});
  sheets.points.push_back(Vec(7, 8, 9));
  const Points of_sheets = points_of(sheets);
  GDP_CHECK(GDP::mass_matrix(of_sheets, sheets.triangles, mass) == GDP::ok);
  GDP_CHECK(GDP::stiffness_matrix(of_sheets, sheets.triangles, stiffness) == GDP::ok);
  GDP_CHECK(GDP::gradient_matrix(of_sheets, sheets.triangles, gradient) == GDP::ok);
  GDP_CHECK(GDP::divergence_matrix(of_sheets, sheets.triangles, divergence) == GDP::ok);
  double area = 0;
  for(const auto& t : sheets.triangles)
    area += (sheets.points[std::size_t(t[1])] - sheets.points[std::size_t(t[0])])
              .cross(sheets.points[std::size_t(t[2])] - sheets.points[std::size_t(t[0])]).norm() / 2;
  GDP_CHECK_NEAR(mass.sum(), area, 1e-8); // a degenerate triangle has a little
  const Eigen::Index n = Eigen::Index(sheets.points.size());
  GDP_CHECK(mass.rows() == n && gradient.rows() == 2 * Eigen::Index(sheets.triangles.size()) && gradient.cols() == n);
  GDP_CHECK_NEAR(difference(divergence * gradient, stiffness), 0,
                 1e-9 * Eigen::MatrixXd(stiffness).cwiseAbs().maxCoeff());
  GDP_CHECK_NEAR((gradient * Eigen::VectorXd::Ones(n)).cwiseAbs().maxCoeff(), 0, 0);

  const Polygons quad = {{0, 1, 2, 3}};
  const Points corners = {Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)};
  GDP_CHECK(GDP::gradient_matrix(corners, quad, gradient) == GDP::error_non_triangular_mesh);
  GDP_CHECK(GDP::divergence_matrix(corners, quad, divergence) == GDP::error_non_triangular_mesh);
  GDP_CHECK(gradient.cols() == n); // as it was
  Mesh of_quad;
  for(const Point& p : corners)
    of_quad.add_vertex(p);
  of_quad.add_face(Vertex(0), Vertex(1), Vertex(2), Vertex(3));
  GDP_CHECK(GDP::mass_matrix(of_quad, a) == GDP::ok && GDP::mass_matrix(corners, quad, b) == GDP::ok);
  GDP_CHECK_NEAR(difference(a, b), 0, 1e-15);
  GDP_CHECK_NEAR(a.sum(), 1, 1e-15);
}

// ---- signals on faces

struct Dual
{
  Eigen::MatrixXd areas, laplacian;

  Dual(const Points& points, const Polygons& polygons)
  {
    const Eigen::Index n = Eigen::Index(polygons.size());
    areas = laplacian = Eigen::MatrixXd::Zero(n, n);
    std::vector<Vec> centers;
    std::map<std::pair<int, int>, std::vector<Eigen::Index> > faces_at;
    for(Eigen::Index f = 0; f < n; ++f)
    {
      const auto& polygon = polygons[std::size_t(f)];
      Vec center(0, 0, 0);
      for(std::size_t i = 0; i < polygon.size(); ++i)
      {
        const int v = polygon[i], w = polygon[(i + 1) % polygon.size()];
        faces_at[std::minmax(v, w)].push_back(f);
        if(i == 0 || i + 1 == polygon.size())
          continue;
        const Vec a = vec(points[std::size_t(polygon[0])]), b = vec(points[std::size_t(v)]),
                  c = vec(points[std::size_t(w)]);
        const double area = (b - a).cross(c - a).norm() / 2;
        areas(f, f) += area;
        center += area * (a + b + c) / 3;
      }
      centers.push_back(center / areas(f, f));
    }
    for(const auto& edge : faces_at)
    {
      if(edge.second.size() != 2)
        continue;
      const Eigen::Index f = edge.second[0], g = edge.second[1];
      const double weight =
        (vec(points[std::size_t(edge.first.first)]) - vec(points[std::size_t(edge.first.second)])).norm()
        / (centers[std::size_t(f)] - centers[std::size_t(g)]).norm();
      laplacian(f, f) += weight;
      laplacian(g, g) += weight;
      laplacian(f, g) -= weight;
      laplacian(g, f) -= weight;
    }
  }

  Eigen::VectorXd filtered(const std::vector<double>& signal, double alpha, double beta, double lambda) const
  {
    const Eigen::Map<const Eigen::VectorXd> f(signal.data(), Eigen::Index(signal.size()));
    return (alpha * areas + beta * laplacian).lu().solve(alpha * (areas * f) + beta * lambda * (laplacian * f));
  }
};

void test_face_signals()
{
  Random random(4);
  for(int trial = 0; trial < 10; ++trial)
  {
    const Shape shape = jittered_square(4 + random.below(4), 0.3, unsigned(random.below(1000)));
    const Points points = points_of(shape);
    const Polygons polygons = random_polygons(shape, random);
    std::vector<double> signal;
    for(std::size_t f = 0; f < polygons.size(); ++f)
      signal.push_back(random());
    const double alpha = random.in(0.5, 2), beta = std::pow(10., random.in(-3, 0)), lambda = random.in(-1, 2);
    const auto np =
      GDP::parameters::value_weight(alpha).gradient_weight(beta).gradient_scale(lambda).area_normalization(false);
    std::vector<double> out(signal.size());
    GDP_CHECK(
      GDP::process_face_signal(points, polygons, CGAL::make_property_map(signal), CGAL::make_property_map(out), np)
      == GDP::ok);
    const Eigen::VectorXd expected = Dual(points, polygons).filtered(signal, alpha, beta, lambda);
    for(std::size_t f = 0; f < out.size(); ++f)
      GDP_CHECK_NEAR(out[f], expected[Eigen::Index(f)], 1e-10);

    // a region is a soup of its own; the others stay
    std::vector<std::size_t> region;
    Polygons inside;
    std::vector<double> inside_signal;
    for(std::size_t f = 0; f < polygons.size(); ++f)
      if(random.below(2))
      {
        region.push_back(f);
        inside.push_back(polygons[f]);
        inside_signal.push_back(signal[f]);
      }
    std::vector<double> in_region = signal;
    GDP_CHECK(GDP::process_face_signal(region, points, polygons, CGAL::make_property_map(in_region),
                                       CGAL::make_property_map(in_region), np)
              == GDP::ok);
    const Eigen::VectorXd expected_inside = Dual(points, inside).filtered(inside_signal, alpha, beta, lambda);
    for(std::size_t i = 0; i < region.size(); ++i)
    {
      GDP_CHECK_NEAR(in_region[region[i]], expected_inside[Eigen::Index(i)], 1e-10);
      in_region[region[i]] = signal[region[i]];
    }
    GDP_CHECK(in_region == signal);
  }

  // at a line of three sheets there are no neighbors
  const Points points = {Point(0, 0, 0), Point(0, 0, 1), Point(1, 0, 0), Point(-1, 1, 0), Point(-1, -1, 0)};
  const Polygons fan = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  std::vector<double> signal = {1, 5, 9};
  const std::vector<double> before = signal;
  GDP_CHECK(GDP::process_face_signal(points, fan, CGAL::make_property_map(signal), CGAL::make_property_map(signal))
            == GDP::ok);
  GDP_CHECK(signal == before);
}

// ---- lines of three sheets

void test_lines()
{
  typedef GDP::Border_condition Condition;
  const auto run = [](Points& points, const Shape& shape, Condition condition, double beta) {
    return GDP::smooth(
      points, shape.triangles,
      GDP::parameters::gradient_weight(beta).area_normalization(false).non_manifold_condition(condition));
  };
  const auto is_on_line = [](const Vec& p, bool is_closed) {
    return is_closed ? std::abs(p.head<2>().norm() - 1) < 1e-9 && std::abs(p.z()) < 1e-9 : p.head<2>().norm() < 1e-9;
  };

  // a circle is a curve of its own: it shrinks by the factor of the one-dimensional energy
  const int n = 24;
  const double t = 0.05, h = 2 * std::sin(pi / n), c = std::cos(2 * pi / n),
               factor = 1 / (1 + t * 6 * (1 - c) / (h * h * (2 + c)));
  const Shape ring = three_sheets(n, true);
  Points free = points_of(ring), fixed = free, along = free;
  GDP_CHECK(run(free, ring, Condition::FREE, t) == GDP::ok && run(fixed, ring, Condition::FIXED, t) == GDP::ok);
  GDP_CHECK(run(along, ring, Condition::ALONG_BORDER, t) == GDP::ok);
  int on_line = 0;
  for(std::size_t v = 0; v < along.size(); ++v)
  {
    const Vec& p = ring.points[v];
    const Point before(p.x(), p.y(), p.z());
    if(is_on_line(p, true))
    {
      ++on_line;
      GDP_CHECK(same_bits(fixed[v], before));
      GDP_CHECK_NEAR((vec(along[v]) - factor * p).norm(), 0, 1e-12);
      GDP_CHECK((vec(free[v]) - vec(along[v])).norm() > 1e-4);
    }
    else
      GDP_CHECK(!same_bits(fixed[v], before) && !same_bits(along[v], before));
  }
  GDP_CHECK(on_line == n);

  // what the sheets do is nothing to it
  Points other = points_of(
    ring.mapped([&](const Vec& p) { return is_on_line(p, true) ? p : Vec(p + Vec(0, 0, 0.1 * std::sin(9 * p.x()))); }));
  GDP_CHECK(run(other, ring, Condition::ALONG_BORDER, t) == GDP::ok);
  for(std::size_t v = 0; v < other.size(); ++v)
    if(is_on_line(ring.points[v], true))
      GDP_CHECK_NEAR((vec(other[v]) - vec(along[v])).norm(), 0, 1e-14);

  // where it is straight it stays so, however its points are spaced; lines and borders both, and ends that are held by
  // the border
  const Shape book = three_sheets(6, false);
  Points points = points_of(book);
  GDP_CHECK(GDP::smooth(points, book.triangles, GDP::parameters::gradient_weight(t).border_condition(Condition::FIXED)
                                                  .non_manifold_condition(Condition::ALONG_BORDER)) == GDP::ok);
  for(std::size_t v = 0; v < points.size(); ++v)
    if(is_on_line(book.points[v], false))
      GDP_CHECK_NEAR((vec(points[v]) - book.points[v]).norm(), 0, 1e-14);
  // where values do not count, a free line needs something to hold it
  GDP_CHECK(GDP::smooth(points, book.triangles,
                        GDP::parameters::value_weight(0.).non_manifold_condition(Condition::ALONG_BORDER))
            == GDP::error_unconstrained);
  GDP_CHECK(
    GDP::smooth(points, book.triangles, GDP::parameters::value_weight(0.).non_manifold_condition(Condition::FIXED))
    == GDP::ok);
}

// Where one side of a seam has no value, it takes that of the other; where none has, that of its surroundings. The
// middle of a polygon is no reason for another value.
void test_missing_values()
{
  const Points points = {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0),
                         Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)};
  const std::vector<std::array<std::size_t, 3> > triangles = {{{0, 1, 2}}, {{3, 4, 5}}};
  std::vector<double> values = {7, 5, 3, std::nan(""), 2, 3};
  const auto map = CGAL::make_property_map(values);
  const auto np = GDP::parameters::weld_tolerance(0.).missing_values(true).number_of_iterations(0);
  GDP_CHECK(GDP::process_signal(points, triangles, map, map, np) == GDP::ok);
  GDP_CHECK_NEAR(values[3], 5, 1e-12);
  GDP_CHECK(values[0] == 7 && values[1] == 5 && values[4] == 2);

  const Points corners = {Point(0, 0, 0), Point(3, 0, 0), Point(2, 2, 0),
                          Point(0, 1, 0), Point(5, 1, 0), Point(4, 3, 0)};
  const std::vector<std::array<std::size_t, 4> > quads = {{{0, 1, 2, 3}}, {{1, 4, 5, 2}}};
  std::vector<double> constant = {4, 4, std::nan(""), 4, 4, 4};
  const auto of_constant = CGAL::make_property_map(constant);
  GDP_CHECK(GDP::process_signal(corners, quads, of_constant, of_constant, np) == GDP::ok);
  for(double x : constant)
    GDP_CHECK_NEAR(x, 4, 1e-12);
}

} // namespace

int main()
{
  test_missing_values();
  test_random_soups();
  test_random_polygons();
  test_weights_of_polygons();
  test_matrices();
  test_face_signals();
  test_lines();
  return GDP_TEST_RESULT();
}
