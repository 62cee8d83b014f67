// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_TEST_SHAPES_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_TEST_SHAPES_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

// Meshes that are made, not read, and what the tests measure on them.
namespace gdp_test {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef CGAL::Surface_mesh<Point> Mesh;
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Face_index Face;
typedef Eigen::Vector3d Vec;

constexpr double pi = 3.14159265358979323846;

// The same numbers with every standard library.
struct Random
{
  std::mt19937 engine;
  explicit Random(unsigned int seed = 1) : engine(seed) {}
  double operator()() { return engine() / 2147483648. - 1.; } // in [-1, 1)
  double in(double low, double high) { return low + (high - low) * (engine() / 4294967296.); }
  int below(int n) { return int(engine() % unsigned(n)); }
};

struct Shape
{
  std::vector<Vec> points;
  std::vector<std::array<int, 3> > triangles;

  template <class Map>
  Shape mapped(const Map& map) const
  {
    Shape result = *this;
    for(Vec& p : result.points)
      p = map(p);
    return result;
  }
  Shape scaled(double s) const { return mapped([&](const Vec& p) { return Vec(s * p); }); }
  Shape moved(const Vec& by) const { return mapped([&](const Vec& p) { return Vec(p + by); }); }
  Shape noisy(double amount, unsigned int seed = 7) const
  {
    Random random(seed);
    return mapped([&](const Vec& p) {
      const double x = random(), y = random(), z = random();
      return Vec(p + amount * Vec(x, y, z));
    });
  }
};

inline Shape operator+(Shape a, const Shape& b)
{
  const int n = int(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for(const auto& t : b.triangles)
    a.triangles.push_back({{t[0] + n, t[1] + n, t[2] + n}});
  return a;
}

// position(u, v) over [0,1] x [0,1], nu by nv squares with alternating diagonals; closed in u, in v, or not.
template <class Position>
Shape grid(int nu, int nv, const Position& position, bool u_is_closed = false, bool v_is_closed = false)
{
  Shape shape;
  const int rows = nu + !u_is_closed, columns = nv + !v_is_closed;
  for(int i = 0; i < rows; ++i)
    for(int j = 0; j < columns; ++j)
      shape.points.push_back(position(double(i) / nu, double(j) / nv));
  const auto at = [&](int i, int j) { return (i % rows) * columns + j % columns; };
  for(int i = 0; i < nu; ++i)
    for(int j = 0; j < nv; ++j)
    {
      const int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if((i + j) % 2)
      {
        shape.triangles.push_back({{a, b, c}});
        shape.triangles.push_back({{a, c, d}});
      }
      else
      {
        shape.triangles.push_back({{a, b, d}});
        shape.triangles.push_back({{b, c, d}});
      }
    }
  return shape;
}

inline Shape square(int n)
{
  return grid(n, n, [](double u, double v) { return Vec(u, v, 0); });
}

// A grid whose inner vertices are shifted within the plane: triangles of all shapes, the border as it was.
inline Shape jittered_square(int n, double amount = 0.3, unsigned int seed = 3)
{
  Shape shape = square(n);
  Random random(seed);
  for(Vec& p : shape.points)
    if(p.x() > 1e-9 && p.x() < 1 - 1e-9 && p.y() > 1e-9 && p.y() < 1 - 1e-9)
    {
      p.x() += amount / n * random();
      p.y() += amount / n * random();
    }
  return shape;
}

// An octahedron whose faces are divided n by n, on the ellipsoid, jittered tangentially.
inline Shape ellipsoid(int n, const Vec& axes, double jitter = 0.3)
{
  Shape shape;
  Random random(5);
  std::map<std::array<int, 3>, int> index;
  const auto vertex = [&](int x, int y, int z) {
    const auto found = index.insert({{{x, y, z}}, int(shape.points.size())});
    if(found.second)
    {
      const auto angle = [&](int i) { return std::sin(i * pi / 2 / n); };
      const double a = random(), b = random(), c = random();
      shape.points.push_back((Vec(angle(x), angle(y), angle(z)).normalized() + jitter / n * Vec(a, b, c)).normalized());
    }
    return found.first->second;
  };
  for(int sx : {-1, 1})
    for(int sy : {-1, 1})
      for(int sz : {-1, 1})
        for(int i = 0; i < n; ++i)
          for(int j = 0; j + i < n; ++j)
          {
            const auto at = [&](int u, int v) { return vertex(sx * u, sy * v, sz * (n - u - v)); };
            const auto add = [&](int a, int b, int c) {
              if(sx * sy * sz < 0)
                std::swap(b, c);
              shape.triangles.push_back({{a, b, c}});
            };
            add(at(i, j), at(i + 1, j), at(i, j + 1));
            if(i + j + 1 < n)
              add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
          }
  return shape.mapped([&](const Vec& p) { return Vec(axes.cwiseProduct(p)); });
}

inline Shape sphere(int n, double jitter = 0.3)
{
  return ellipsoid(n, Vec(1, 1, 1), jitter);
}

// A disk of radius one: rings of n vertices around a center.
inline Shape disk(int n, int rings)
{
  Shape shape;
  shape.points.push_back(Vec(0, 0, 0));
  for(int r = 1; r <= rings; ++r)
    for(int i = 0; i < n; ++i)
      shape.points.push_back(double(r) / rings * Vec(std::cos(2 * pi * i / n), std::sin(2 * pi * i / n), 0));
  const auto at = [&](int r, int i) { return 1 + (r - 1) * n + i % n; };
  for(int i = 0; i < n; ++i)
  {
    shape.triangles.push_back({{0, at(1, i), at(1, i + 1)}});
    for(int r = 1; r < rings; ++r)
    {
      shape.triangles.push_back({{at(r, i), at(r + 1, i), at(r + 1, i + 1)}});
      shape.triangles.push_back({{at(r, i), at(r + 1, i + 1), at(r, i + 1)}});
    }
  }
  return shape;
}

// The surface of a set of unit cubes, every square divided n by n: a part with known creases. Cubes may meet in faces
// only.
inline Shape cubes(const std::set<std::array<int, 3> >& cells, int n)
{
  Shape shape;
  std::map<std::array<int, 3>, int> index;
  const auto vertex = [&](const std::array<int, 3>& p) {
    const auto found = index.insert({p, int(shape.points.size())});
    if(found.second)
      shape.points.push_back(Vec(p[0], p[1], p[2]) / n);
    return found.first->second;
  };
  for(const auto& cell : cells)
    for(int axis = 0; axis < 3; ++axis)
      for(int side : {0, 1})
      {
        std::array<int, 3> neighbor = cell;
        neighbor[axis] += side ? 1 : -1;
        if(cells.count(neighbor))
          continue;
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for(int i = 0; i < n; ++i)
          for(int j = 0; j < n; ++j)
          {
            const auto at = [&](int a, int b) {
              std::array<int, 3> p = {{n * cell[0], n * cell[1], n * cell[2]}};
              p[axis] += side * n;
              p[u] += a;
              p[v] += b;
              return vertex(p);
            };
            std::array<int, 4> q = {{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}};
            if(!side)
              std::swap(q[1], q[3]);
            if((i + j) % 2)
            {
              shape.triangles.push_back({{q[0], q[1], q[2]}});
              shape.triangles.push_back({{q[0], q[2], q[3]}});
            }
            else
            {
              shape.triangles.push_back({{q[0], q[1], q[3]}});
              shape.triangles.push_back({{q[1], q[2], q[3]}});
            }
          }
      }
  return shape;
}

template <class Triangle_mesh>
void build(const Shape& shape, Triangle_mesh& mesh)
{
  typedef typename boost::property_traits<
    typename boost::property_map<Triangle_mesh, CGAL::vertex_point_t>::type>::value_type Mesh_point;
  std::vector<typename boost::graph_traits<Triangle_mesh>::vertex_descriptor> vertices;
  for(const Vec& p : shape.points)
    vertices.push_back(mesh.add_vertex(Mesh_point(p.x(), p.y(), p.z())));
  for(const auto& t : shape.triangles)
    mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
}

inline Mesh mesh_of(const Shape& shape)
{
  Mesh mesh;
  build(shape, mesh);
  return mesh;
}

inline Vec vec(const Point& p) { return Vec(p.x(), p.y(), p.z()); }
inline Vec vec(const Vector& v) { return Vec(v.x(), v.y(), v.z()); }

inline Eigen::MatrixXd positions(const Mesh& mesh)
{
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(mesh.num_vertices(), 3); // removed vertices count
  for(Vertex v : mesh.vertices())
    result.row(v) = vec(mesh.point(v)).transpose();
  return result;
}

inline bool same_bits(const void* a, const void* b, std::size_t size) { return std::memcmp(a, b, size) == 0; }
inline bool same_bits(const Point& a, const Point& b)
{
  for(int i = 0; i < 3; ++i)
  {
    const double x = a[i], y = b[i];
    if(!same_bits(&x, &y, sizeof(double)))
      return false;
  }
  return true;
}
inline bool same_bits(double a, double b) { return same_bits(&a, &b, sizeof(double)); }

// NaN where it was NaN counts as the same.
inline bool same_points(const Mesh& a, const Mesh& b)
{
  for(Vertex v : a.vertices())
    if(!same_bits(a.point(v), b.point(v)))
      return false;
  return true;
}

inline bool is_finite(const Mesh& mesh) { return positions(mesh).allFinite(); }

// The largest distance between vertices of the same number.
inline double distance(const Mesh& a, const Mesh& b)
{
  return (positions(a) - positions(b)).rowwise().norm().maxCoeff();
}

inline std::array<Vertex, 3> corners(const Mesh& mesh, Face f)
{
  const auto h = mesh.halfedge(f);
  return {{mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))}};
}

inline std::array<int, 3> corner_numbers(const Mesh& mesh, Face f)
{
  const auto c = corners(mesh, f);
  return {{int(c[0]), int(c[1]), int(c[2])}};
}

inline Vec area_vector(const Mesh& mesh, Face f)
{
  const auto c = corners(mesh, f);
  const Vec p = vec(mesh.point(c[0]));
  return (vec(mesh.point(c[1])) - p).cross(vec(mesh.point(c[2])) - p) / 2;
}

inline double total_area(const Mesh& mesh)
{
  double sum = 0;
  for(Face f : mesh.faces())
    sum += area_vector(mesh, f).norm();
  return sum;
}

} // namespace gdp_test

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_TEST_SHAPES_H
