// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// denoise() on synthetic pairs with bounds, what it must not move, and process_face_signal() against a dense solution.

#include "test_shapes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/denoise.h>
#include <CGAL/Gradient_domain_processing/process_face_signal.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <utility>
#include <vector>

namespace GDP = CGAL::Gradient_domain_processing;
using namespace gdp_test;

namespace {

double mean_edge_length(const Mesh& mesh)
{
  double sum = 0;
  for(auto e : mesh.edges())
    sum += (vec(mesh.point(mesh.vertex(e, 0))) - vec(mesh.point(mesh.vertex(e, 1)))).norm();
  return sum / double(mesh.number_of_edges());
}

// Gaussian, along the normals, in mean edge lengths.
void add_noise(Mesh& mesh, double amount)
{
  std::vector<Vec> normals(mesh.number_of_vertices(), Vec(0, 0, 0));
  for(Face f : mesh.faces())
    for(Vertex v : corners(mesh, f))
      normals[v] += area_vector(mesh, f);
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, amount * mean_edge_length(mesh));
  for(Vertex v : mesh.vertices())
  {
    const Vec p = vec(mesh.point(v)) + noise(random) * normals[v].normalized();
    mesh.point(v) = Point(p[0], p[1], p[2]);
  }
}

double mean_normal_angle(const Mesh& a, const Mesh& b) // in degrees
{
  double sum = 0;
  for(Face f : a.faces())
  {
    const Vec m = area_vector(a, f).normalized(), n = area_vector(b, f).normalized();
    sum += std::atan2(m.cross(n).norm(), m.dot(n));
  }
  return sum / double(a.number_of_faces()) * 180 / pi;
}

void removes_noise(const Shape& shape, double noise, double bound)
{
  const Mesh clean = mesh_of(shape);
  Mesh mesh = clean;
  add_noise(mesh, noise);
  const double before = mean_normal_angle(clean, mesh);
  const double edge = mean_edge_length(clean);
  const Mesh noisy = mesh;
  GDP_CHECK(GDP::denoise(mesh) == GDP::OK);
  const double after = mean_normal_angle(clean, mesh);
  std::cout << "noise " << before << " degrees, denoised " << after << std::endl;
  GDP_CHECK(before > 15);
  GDP_CHECK(after < bound);
  double shift = 0;
  for(Vertex v : mesh.vertices())
    shift += (vec(mesh.point(v)) - vec(clean.point(v))).norm() / edge / double(mesh.number_of_vertices());
  GDP_CHECK(shift < 0.25);
}

// Squares of two triangles become one face again.
Mesh with_squares(const Shape& shape)
{
  Mesh mesh = mesh_of(shape);
  std::vector<Mesh::Halfedge_index> diagonals;
  for(auto e : mesh.edges())
  {
    const auto h = mesh.halfedge(e), o = mesh.opposite(h);
    const auto squared_length = [&](Mesh::Halfedge_index g) {
      return (vec(mesh.point(mesh.source(g))) - vec(mesh.point(mesh.target(g)))).squaredNorm();
    };
    if(squared_length(h) > 1.5 * squared_length(mesh.next(h)) && squared_length(o) > 1.5 * squared_length(mesh.next(o)))
      diagonals.push_back(h);
  }
  for(auto h : diagonals)
    CGAL::Euler::join_face(h, mesh);
  mesh.collect_garbage();
  return mesh;
}

void removes_noise_of_squares()
{
  const Mesh clean = with_squares(cubes({{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}}, 10));
  GDP_CHECK(clean.number_of_faces() == 14 * 100);
  Mesh mesh = clean;
  add_noise(mesh, 0.2);
  const auto mean_angle = [&]() {
    double sum = 0;
    for(Face f : mesh.faces())
    {
      std::array<Vec, 2> diagonals[2];
      const auto h = mesh.halfedge(f);
      for(const Mesh* m : {&clean, static_cast<const Mesh*>(&mesh)})
        diagonals[m == &mesh] = {{vec(m->point(m->target(m->next(h)))) - vec(m->point(m->source(h))),
                                  vec(m->point(m->target(m->next(m->next(h))))) - vec(m->point(m->target(h)))}};
      const Vec a = diagonals[0][0].cross(diagonals[0][1]), b = diagonals[1][0].cross(diagonals[1][1]);
      sum += std::atan2(a.cross(b).norm(), a.dot(b));
    }
    return sum / double(mesh.number_of_faces()) * 180 / pi;
  };
  const double before = mean_angle();
  GDP::Denoising_summary summary;
  GDP_CHECK(GDP::denoise(mesh, GDP::parameters::denoising_summary(std::ref(summary))) == GDP::ok);
  std::cout << "squares: noise " << before << " degrees, denoised " << mean_angle() << std::endl;
  GDP_CHECK(before > 10 && mean_angle() < 2);
  GDP_CHECK(summary.noise_scale == 0); // white, though the middles of faces have less of it
}

void keeps_what_it_must()
{
  // a clean mesh is returned to the bit
  const Mesh box = mesh_of(cubes({{{0, 0, 0}}, {{1, 0, 0}}}, 8));
  for(const Mesh& clean : {box, mesh_of(sphere(24))})
  {
    Mesh mesh = clean;
    GDP_CHECK(GDP::denoise(mesh) == GDP::OK);
    GDP_CHECK(same_points(mesh, clean));
  }

  Mesh mesh, noisy = box;
  add_noise(noisy, 0.3);
  mesh = noisy;
  auto is_fixed = mesh.add_property_map<Vertex, bool>("v:fixed", false).first;
  for(Vertex v : mesh.vertices())
    is_fixed[v] = int(v) % 5 == 0;
  GDP_CHECK(GDP::denoise(mesh, GDP::parameters::vertex_is_constrained_map(is_fixed)) == GDP::OK);
  int moved = 0;
  for(Vertex v : mesh.vertices())
  {
    GDP_CHECK(!is_fixed[v] || same_bits(mesh.point(v), noisy.point(v)));
    moved += !same_bits(mesh.point(v), noisy.point(v));
  }
  GDP_CHECK(moved > 0);

  mesh = noisy;
  std::vector<Face> region;
  for(Face f : mesh.faces())
    if(int(f) < int(mesh.number_of_faces()) / 3)
      region.push_back(f);
  GDP_CHECK(GDP::denoise(region, mesh) == GDP::OK);
  std::vector<char> may_move(mesh.number_of_vertices(), 0);
  for(Face f : region)
    for(Vertex v : corners(mesh, f))
      may_move[v] = 1;
  for(Face f : mesh.faces())
    if(std::find(region.begin(), region.end(), f) == region.end())
      for(Vertex v : corners(mesh, f))
        may_move[v] = 0;
  moved = 0;
  for(Vertex v : mesh.vertices())
  {
    GDP_CHECK(may_move[v] || same_bits(mesh.point(v), noisy.point(v)));
    moved += !same_bits(mesh.point(v), noisy.point(v));
  }
  GDP_CHECK(moved > 0);

  // nothing moves where a parameter is out of its range
  mesh = noisy;
  GDP_CHECK(GDP::denoise(mesh, GDP::parameters::noise_level(-1.)) == GDP::ERROR_INVALID_PARAMETER);
  GDP_CHECK(same_points(mesh, noisy));
}

// A bumpy sphere: rough, but all of it is the surface.
Mesh bumpy_sphere(int n, int bumps, double height)
{
  Mesh mesh = mesh_of(sphere(n));
  for(Vertex v : mesh.vertices())
  {
    const Vec p = vec(mesh.point(v));
    const Vec q = p * (1 + height * std::sin(bumps * p[0]) * std::sin(bumps * p[1]) * std::sin(bumps * p[2]));
    mesh.point(v) = Point(q[0], q[1], q[2]);
  }
  return mesh;
}

// Every face in four, in its plane.
Mesh refined(const Mesh& mesh)
{
  Mesh result;
  for(Vertex v : mesh.vertices())
    result.add_vertex(mesh.point(v));
  std::vector<Vertex> middle;
  for(auto e : mesh.edges())
    middle.push_back(result.add_vertex(CGAL::midpoint(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)))));
  for(Face f : mesh.faces())
  {
    std::array<Vertex, 3> corner, side; // a side ends in its corner
    int i = 0;
    for(auto h : mesh.halfedges_around_face(mesh.halfedge(f)))
    {
      corner[i] = mesh.target(h);
      side[i++] = middle[mesh.edge(h)];
    }
    for(i = 0; i < 3; ++i)
      result.add_face(corner[i], side[(i + 1) % 3], side[i]);
    result.add_face(side[0], side[1], side[2]);
  }
  return result;
}

void keeps_detail()
{
  for(const Mesh& clean :
      {bumpy_sphere(40, 12, 0.1), refined(bumpy_sphere(14, 6, 0.2)), mesh_of(ellipsoid(10, Vec(1, 0.5, 0.25)))})
  {
    Mesh mesh = clean;
    GDP_CHECK(GDP::denoise(mesh) == GDP::OK);
    const double moved = mean_normal_angle(clean, mesh);
    add_noise(mesh, 0.2);
    const Mesh noisy = mesh;
    GDP_CHECK(GDP::denoise(mesh) == GDP::OK);
    std::cout << "clean " << moved << " degrees, noisy " << mean_normal_angle(clean, noisy) << ", denoised "
              << mean_normal_angle(clean, mesh) << std::endl;
    GDP_CHECK(moved < 0.5);
    GDP_CHECK(mean_normal_angle(clean, mesh) < 0.55 * mean_normal_angle(clean, noisy));
  }
}

// Facets as rough as can be are no noise where they are refined.
void keeps_facets()
{
  Mesh facets = mesh_of(sphere(14));
  add_noise(facets, 0.15);
  const Mesh clean = refined(facets);
  Mesh mesh = clean;
  GDP_CHECK(GDP::denoise(mesh) == GDP::OK);
  GDP_CHECK(mean_normal_angle(clean, mesh) < 0.5);
}

int passes_by_default(Mesh mesh)
{
  GDP::Denoising_summary summary;
  GDP_CHECK(GDP::denoise(mesh, GDP::parameters::denoising_summary(std::ref(summary))) == GDP::OK);
  return int(summary.number_of_iterations);
}

void chooses_passes()
{
  Mesh creased = mesh_of(cubes({{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}}, 12));
  add_noise(creased, 0.3);
  Mesh smooth = bumpy_sphere(40, 6, 0.2);
  add_noise(smooth, 0.2);
  const int of_creased = passes_by_default(creased), of_smooth = passes_by_default(smooth);
  std::cout << "passes: creased " << of_creased << ", smooth " << of_smooth << std::endl;
  GDP_CHECK(of_creased >= 15);
  GDP_CHECK(of_smooth >= 4 && of_smooth <= 9);
}

bool touches_border(const Mesh& mesh, Face f)
{
  const auto t = corners(mesh, f);
  return mesh.is_border(t[0]) || mesh.is_border(t[1]) || mesh.is_border(t[2]);
}

double mean_border_angle(const Mesh& a, const Mesh& b) // in degrees
{
  double sum = 0;
  int count = 0;
  for(Face f : a.faces())
    if(touches_border(a, f))
    {
      const Vec m = area_vector(a, f).normalized(), n = area_vector(b, f).normalized();
      sum += std::atan2(m.cross(n).norm(), m.dot(n));
      ++count;
    }
  return sum / count * 180 / pi;
}

// After five passes faces at the border stay to the bit, while the inside goes on.
void keeps_borders(const Mesh& clean, double noise, double bound)
{
  Mesh noisy = clean;
  add_noise(noisy, noise);
  Mesh few = noisy, many = noisy;
  GDP_CHECK(GDP::denoise(few, GDP::parameters::number_of_iterations(5)) == GDP::OK);
  GDP_CHECK(GDP::denoise(many, GDP::parameters::number_of_iterations(20)) == GDP::OK);
  const double after_few = mean_border_angle(clean, few), after_many = mean_border_angle(clean, many);
  std::cout << "border " << mean_border_angle(clean, noisy) << " degrees, after 5 passes " << after_few << ", after 20 "
            << after_many << std::endl;
  GDP_CHECK(after_few < bound);
  GDP_CHECK(after_many <= after_few);
  int moved = 0;
  for(Face f : clean.faces())
    if(touches_border(clean, f))
      for(Vertex v : corners(clean, f))
        moved += !same_bits(few.point(v), many.point(v));
  GDP_CHECK(moved == 0);
  GDP_CHECK(!same_points(few, many));
}

// An open surface with waves that end at its border.
Mesh waves(int n, double height)
{
  Mesh mesh = mesh_of(jittered_square(n));
  for(Vertex v : mesh.vertices())
  {
    const Vec p = vec(mesh.point(v));
    mesh.point(v) = Point(p[0], p[1], height * std::sin(9 * p[0]) * std::cos(9 * p[1]));
  }
  return mesh;
}

// Two planes that meet.
Mesh wedge(int n)
{
  Mesh mesh = mesh_of(square(n));
  for(Vertex v : mesh.vertices())
  {
    const Vec p = vec(mesh.point(v));
    mesh.point(v) = Point(p[0], p[1], std::abs(p[0] - 0.5));
  }
  return mesh;
}

void stays_finite()
{
  Mesh mesh = mesh_of(jittered_square(14));
  add_noise(mesh, 0.3);
  // a face of zero area, and a vertex without a face
  const Face f = *mesh.faces().begin();
  const auto t = corners(mesh, f);
  mesh.point(t[0]) = mesh.point(t[1]);
  mesh.add_vertex(Point(3, 3, 3));
  GDP_CHECK(GDP::denoise(mesh, GDP::parameters::number_of_iterations(50)) == GDP::OK);
  GDP_CHECK(is_finite(mesh));
}

// Between the face of h and its neighbor come two triangles that share two edges: their ends are joined by a second
// edge.
void insert_lens(Mesh& mesh, Mesh::Halfedge_index h, const Point& point)
{
  const Vertex opposite = mesh.target(mesh.next(h));
  const Vertex m = mesh.target(CGAL::Euler::add_center_vertex(h, mesh));
  mesh.point(m) = point;
  CGAL::Euler::join_face(mesh.halfedge(opposite, m), mesh);
  const auto to_target = mesh.opposite(mesh.next(h)), to_source = mesh.prev(mesh.opposite(mesh.prev(h)));
  CGAL::Euler::split_face(to_source, to_target, mesh);
}

// At a double edge four triangles meet, and nothing flows across it. What flows elsewhere is conserved.
void conserves_flow_at_double_edges()
{
  Mesh mesh;
  const Vertex a = mesh.add_vertex(Point(0, 0, 0)), b = mesh.add_vertex(Point(1, 0, 0)),
               c = mesh.add_vertex(Point(0, 1, 0));
  mesh.add_face(a, b, c);
  mesh.add_face(a, c, b);
  const std::pair<Vertex, Vertex> edges[] = {{a, b}, {b, c}, {c, a}};
  for(const auto& e : edges)
  {
    const Vec middle = (vec(mesh.point(e.first)) + vec(mesh.point(e.second))) / 2;
    insert_lens(mesh, mesh.halfedge(e.first, e.second), Point(middle[0] - 0.1, middle[1] - 0.1, 0.3));
  }
  GDP_CHECK(CGAL::is_valid_polygon_mesh(mesh) && CGAL::is_triangle_mesh(mesh) && mesh.number_of_faces() == 8);

  auto signal = mesh.add_property_map<Face, double>("f:signal").first;
  double before = 0, after = 0;
  int changed = 0;
  for(Face f : mesh.faces())
  {
    signal[f] = 1. + int(f);
    before += area_vector(mesh, f).norm() * signal[f];
  }
  GDP_CHECK(GDP::process_face_signal(mesh, signal, signal, GDP::parameters::gradient_weight(1)) == GDP::OK);
  for(Face f : mesh.faces())
  {
    after += area_vector(mesh, f).norm() * signal[f];
    changed += signal[f] != 1. + int(f);
  }
  GDP_CHECK_NEAR(before, after, 1e-12);
  GDP_CHECK(changed > 0 && changed < 8);
  GDP_CHECK(GDP::denoise(mesh, GDP::parameters::number_of_iterations(2).noise_level(0.3)) == GDP::OK);
  GDP_CHECK(is_finite(mesh));
}

// (alpha A + beta L) g = (alpha A + lambda beta L) f with dense matrices.
void solves_face_signals()
{
  Mesh mesh = mesh_of(jittered_square(5));
  const int n = int(mesh.number_of_faces());
  auto signal = mesh.add_property_map<Face, double>("f:signal").first;
  auto result = mesh.add_property_map<Face, double>("f:result").first;
  auto weight = mesh.add_property_map<Mesh::Edge_index, double>("e:weight").first;
  for(Face f : mesh.faces())
    signal[f] = std::sin(3. * int(f));
  for(auto e : mesh.edges())
    weight[e] = 0.5 + int(e) % 3;

  const double alpha = 2, beta = 0.01, lambda = 1.5;
  Eigen::MatrixXd masses = Eigen::MatrixXd::Zero(n, n), laplacian = masses;
  for(Face f : mesh.faces())
    masses(int(f), int(f)) = area_vector(mesh, f).norm();
  const double scale = masses(0, 0) / (std::sqrt(CGAL::squared_area(mesh.point(corners(mesh, Face(0))[0]),
                                                                   mesh.point(corners(mesh, Face(0))[1]),
                                                                   mesh.point(corners(mesh, Face(0))[2]))));
  masses /= scale; // area_vector() may be of twice the area
  for(auto e : mesh.edges())
    if(!mesh.is_border(e))
    {
      const int a = int(mesh.face(mesh.halfedge(e))), b = int(mesh.face(mesh.opposite(mesh.halfedge(e))));
      laplacian(a, a) += weight[e];
      laplacian(b, b) += weight[e];
      laplacian(a, b) -= weight[e];
      laplacian(b, a) -= weight[e];
    }
  Eigen::VectorXd f(n);
  for(Face face : mesh.faces())
    f[int(face)] = signal[face];
  const Eigen::VectorXd expected
    = (alpha * masses + beta * laplacian).ldlt().solve((alpha * masses + lambda * beta * laplacian) * f);

  GDP_CHECK(GDP::process_face_signal(mesh, signal, result,
    GDP::parameters::value_weight(alpha).gradient_weight(beta).gradient_scale(lambda)
      .interior_edge_weight_map(weight).area_normalization(false)) == GDP::OK);
  double before = 0, after = 0;
  for(Face face : mesh.faces())
  {
    GDP_CHECK_NEAR(result[face], expected[int(face)], 1e-12);
    before += masses(int(face), int(face)) * signal[face];
    after += masses(int(face), int(face)) * result[face];
  }
  GDP_CHECK_NEAR(before, after, 1e-12);

  // in and out may be the same; lambda = 1 changes nothing
  auto copy = mesh.add_property_map<Face, double>("f:copy").first;
  for(Face face : mesh.faces())
    copy[face] = signal[face];
  GDP_CHECK(GDP::process_face_signal(mesh, copy, copy, GDP::parameters::gradient_scale(1)) == GDP::OK);
  for(Face face : mesh.faces())
    GDP_CHECK(same_bits(copy[face], signal[face]));

  for(auto e : mesh.edges())
    weight[e] = -1;
  GDP_CHECK(GDP::process_face_signal(mesh, copy, copy, GDP::parameters::interior_edge_weight_map(weight))
            == GDP::ERROR_INVALID_WEIGHT);
  signal[Face(0)] = std::numeric_limits<double>::quiet_NaN();
  GDP_CHECK(GDP::process_face_signal(mesh, signal, copy) == GDP::ERROR_INVALID_SIGNAL);
}

} // namespace

int main()
{
  removes_noise(cubes({{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}}, 10), 0.3, 3.5); // creases, convex and concave
  removes_noise(sphere(24), 0.2, 6.);
  removes_noise(jittered_square(24), 0.3, 6.); // open and flat
  removes_noise_of_squares();
  keeps_what_it_must();
  keeps_detail();
  keeps_facets();
  chooses_passes();
  keeps_borders(wedge(20), 0.2, 5.7);
  keeps_borders(waves(40, 0.1), 0.2, 6.1);
  keeps_borders(waves(40, 0.1), 0.4, 9.5);
  stays_finite();
  conserves_flow_at_double_edges();
  solves_face_signals();
  return GDP_TEST_RESULT();
}
