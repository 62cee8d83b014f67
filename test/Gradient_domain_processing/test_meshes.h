// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_TEST_MESHES_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_TEST_MESHES_H

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <utility>
#include <vector>

// Meshes to test on, as soups of triangles; build() makes any mesh type of them.
namespace gdp_test {

typedef std::array<double, 3> Coordinates;

struct Soup
{
  std::vector<Coordinates> points;
  std::vector<std::array<int, 3> > triangles;
};

// The same numbers on every platform, which the distributions of the standard library do not promise.
class Random
{
  std::mt19937 m_engine;

public:
  explicit Random(unsigned int seed) : m_engine(seed) {}
  double operator()(double low, double high) { return low + (high - low) * (double(m_engine()) / 4294967296.); }
  std::size_t below(std::size_t n) { return std::size_t(m_engine()) % n; }
};

// Vertex i and face i of the mesh are point i and triangle i of the soup, in the order of vertices(tm) and faces(tm).
template <class Mesh>
void build(const Soup& soup, Mesh& tm)
{
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  const auto vpm = get(CGAL::vertex_point, tm);
  typedef typename boost::property_traits<decltype(vpm)>::value_type Point;
  std::vector<vertex_descriptor> added;
  for(const Coordinates& p : soup.points)
  {
    added.push_back(add_vertex(tm));
    put(vpm, added.back(), Point(p[0], p[1], p[2]));
  }
  for(const auto& t : soup.triangles)
    CGAL::Euler::add_face(std::array<vertex_descriptor, 3>{{added[t[0]], added[t[1]], added[t[2]]}}, tm);
}

template <class Mesh>
Mesh built(const Soup& soup)
{
  Mesh tm;
  build(soup, tm);
  return tm;
}

// An icosahedron, subdivided and projected to the sphere.
inline Soup icosphere(int subdivisions, double radius = 1)
{
  const double g = (1 + std::sqrt(5.)) / 2;
  Soup soup;
  soup.points = {{{-1, g, 0}}, {{1, g, 0}}, {{-1, -g, 0}}, {{1, -g, 0}}, {{0, -1, g}}, {{0, 1, g}},
                 {{0, -1, -g}}, {{0, 1, -g}}, {{g, 0, -1}}, {{g, 0, 1}}, {{-g, 0, -1}}, {{-g, 0, 1}}};
  soup.triangles = {{{0, 11, 5}}, {{0, 5, 1}}, {{0, 1, 7}}, {{0, 7, 10}}, {{0, 10, 11}}, {{1, 5, 9}}, {{5, 11, 4}},
                    {{11, 10, 2}}, {{10, 7, 6}}, {{7, 1, 8}}, {{3, 9, 4}}, {{3, 4, 2}}, {{3, 2, 6}}, {{3, 6, 8}},
                    {{3, 8, 9}}, {{4, 9, 5}}, {{2, 4, 11}}, {{6, 2, 10}}, {{8, 6, 7}}, {{9, 8, 1}}};
  for(int i = 0; i < subdivisions; ++i)
  {
    std::map<std::pair<int, int>, int> midpoints;
    const auto midpoint = [&](int a, int b) {
      const auto found = midpoints.emplace(std::make_pair((std::min)(a, b), (std::max)(a, b)), int(soup.points.size()));
      if(found.second)
      {
        const Coordinates p = soup.points[a], q = soup.points[b];
        soup.points.push_back({{(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2}});
      }
      return found.first->second;
    };
    std::vector<std::array<int, 3> > finer;
    for(const auto& t : soup.triangles)
    {
      const int a = midpoint(t[1], t[2]), b = midpoint(t[2], t[0]), c = midpoint(t[0], t[1]);
      for(const auto& child : {std::array<int, 3>{{t[0], c, b}}, {{c, t[1], a}}, {{b, a, t[2]}}, {{a, b, c}}})
        finer.push_back(child);
    }
    soup.triangles.swap(finer);
    for(Coordinates& p : soup.points)
    {
      const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
      p = {{p[0] / length, p[1] / length, p[2] / length}};
    }
  }
  const double first = std::sqrt(1 + g * g);
  for(Coordinates& p : soup.points)
    for(double& x : p)
      x *= radius / (subdivisions == 0 ? first : 1);
  return soup;
}

// m x n cells, each cut in two, over the unit square.
inline Soup grid(int m, int n)
{
  Soup soup;
  for(int j = 0; j <= n; ++j)
    for(int i = 0; i <= m; ++i)
      soup.points.push_back({{double(i) / m, double(j) / n, 0}});
  const auto at = [&](int i, int j) { return j * (m + 1) + i; };
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < m; ++i)
    {
      soup.triangles.push_back({{at(i, j), at(i + 1, j), at(i + 1, j + 1)}});
      soup.triangles.push_back({{at(i, j), at(i + 1, j + 1), at(i, j + 1)}});
    }
  return soup;
}

// A torus of m x n cells. The point of cell (i, j) tells its place: it is on a torus of revolution, whose metric is not
// flat.
inline Soup torus(int m, int n)
{
  const double two_pi = 8 * std::atan(1.);
  Soup soup;
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < m; ++i)
    {
      const double u = two_pi * i / m, v = two_pi * j / n;
      soup.points.push_back({{(3 + std::cos(v)) * std::cos(u), (3 + std::cos(v)) * std::sin(u), std::sin(v)}});
    }
  const auto at = [&](int i, int j) { return (j % n) * m + i % m; };
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < m; ++i)
    {
      soup.triangles.push_back({{at(i, j), at(i + 1, j), at(i + 1, j + 1)}});
      soup.triangles.push_back({{at(i, j), at(i + 1, j + 1), at(i, j + 1)}});
    }
  return soup;
}

template <class Function>
Soup transformed(Soup soup, const Function& function)
{
  for(Coordinates& p : soup.points)
    p = function(p);
  return soup;
}

inline Soup scaled(const Soup& soup, double factor)
{
  return transformed(soup, [&](const Coordinates& p) {
    return Coordinates{{factor * p[0], factor * p[1], factor * p[2]}};
  });
}

inline Soup translated(const Soup& soup, const Coordinates& by)
{
  return transformed(soup, [&](const Coordinates& p) {
    return Coordinates{{p[0] + by[0], p[1] + by[1], p[2] + by[2]}};
  });
}

// A rotation about no axis in particular.
inline Coordinates rotated(const Coordinates& p)
{
  const double a = 0.7, b = -1.9;
  const Coordinates q = {{std::cos(a) * p[0] - std::sin(a) * p[1], std::sin(a) * p[0] + std::cos(a) * p[1], p[2]}};
  return {{q[0], std::cos(b) * q[1] - std::sin(b) * q[2], std::sin(b) * q[1] + std::cos(b) * q[2]}};
}

inline Soup rotated(const Soup& soup)
{
  return transformed(soup, [](const Coordinates& p) { return rotated(p); });
}

inline Soup jittered(const Soup& soup, double amount, unsigned int seed)
{
  Random random(seed);
  return transformed(soup, [&](const Coordinates& p) {
    const double x = random(-amount, amount), y = random(-amount, amount), z = random(-amount, amount);
    return Coordinates{{p[0] + x, p[1] + y, p[2] + z}};
  });
}

// A closed, bumpy surface without symmetries.
inline Soup bumpy_sphere(int subdivisions)
{
  return jittered(transformed(icosphere(subdivisions), [](const Coordinates& p) {
    const double r = 1 + 0.2 * std::sin(3 * p[0] + p[1]) + 0.1 * std::cos(5 * p[2]);
    return Coordinates{{1.3 * r * p[0], r * p[1], 0.8 * r * p[2]}};
  }), 0.02, 7);
}

// An open, bumpy surface without symmetries.
inline Soup bumpy_patch(int m, int n)
{
  return jittered(transformed(grid(m, n), [](const Coordinates& p) {
    return Coordinates{{p[0], p[1], 0.2 * std::sin(5 * p[0]) * std::cos(4 * p[1])}};
  }), 0.1 / (std::max)(m, n), 11);
}

// The surface of the unit cube, every side a grid of n x n cells: flat sides and sharp edges.
inline Soup box(int n)
{
  Soup soup;
  std::map<std::array<int, 3>, int> found;
  const auto at = [&](const std::array<int, 3>& p) {
    const auto entry = found.emplace(p, int(soup.points.size()));
    if(entry.second)
      soup.points.push_back({{double(p[0]) / n, double(p[1]) / n, double(p[2]) / n}});
    return entry.first->second;
  };
  for(int axis = 0; axis < 3; ++axis)
    for(int side = 0; side < 2; ++side)
      for(int i = 0; i < n; ++i)
        for(int j = 0; j < n; ++j)
        {
          const auto corner = [&](int di, int dj) {
            std::array<int, 3> p;
            p[axis] = side * n;
            p[(axis + 1) % 3] = i + di;
            p[(axis + 2) % 3] = j + dj;
            return at(p);
          };
          const int a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
          if(side == 1)
          {
            soup.triangles.push_back({{a, b, c}});
            soup.triangles.push_back({{a, c, d}});
          }
          else
          {
            soup.triangles.push_back({{a, c, b}});
            soup.triangles.push_back({{a, d, c}});
          }
        }
  return soup;
}

// Vertices, faces, and where faces start, in another order. Vertex i becomes vertex place[i].
inline Soup permuted(const Soup& soup, unsigned int seed, std::vector<int>& place)
{
  Random random(seed);
  const auto shuffle = [&](auto& items) {
    for(std::size_t i = items.size(); i > 1; --i)
      std::swap(items[i - 1], items[random.below(i)]);
  };
  place.resize(soup.points.size());
  for(std::size_t i = 0; i < place.size(); ++i)
    place[i] = int(i);
  shuffle(place);

  Soup result;
  result.points.resize(soup.points.size());
  for(std::size_t i = 0; i < place.size(); ++i)
    result.points[place[i]] = soup.points[i];
  for(const auto& t : soup.triangles)
  {
    const std::size_t start = random.below(3);
    result.triangles.push_back({{place[t[start]], place[t[(start + 1) % 3]], place[t[(start + 2) % 3]]}});
  }
  shuffle(result.triangles);
  return result;
}

// The points of a mesh in the order of its vertices.
template <class Mesh>
std::vector<Coordinates> coordinates(const Mesh& tm)
{
  std::vector<Coordinates> result;
  const auto vpm = get(CGAL::vertex_point, tm);
  for(auto v : vertices(tm))
  {
    const auto& p = get(vpm, v);
    result.push_back({{CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])}});
  }
  return result;
}

// The largest difference of two signals; NaN counts as infinite.
template <class Values>
double distance(const Values& a, const Values& b)
{
  double largest = a.size() == b.size() ? 0 : HUGE_VAL;
  for(std::size_t i = 0; i < a.size() && i < b.size(); ++i)
    for(std::size_t j = 0; j < a[i].size(); ++j)
    {
      const double difference = std::abs(a[i][j] - b[i][j]);
      largest = difference <= largest ? largest : std::isnan(difference) ? HUGE_VAL : difference;
    }
  return largest;
}

} // namespace gdp_test

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_TEST_MESHES_H
