// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Calls every public function, so that compilers and libraries other than ours see the bodies of all templates. What
// the results are worth is for other tests: here they are finite, and no call fails.

#ifdef PORTABILITY_WINDOWS_H
#include <windows.h>
#endif
#ifdef PORTABILITY_CURSES_H
#include <curses.h>
#endif

#include <CGAL/Gradient_domain_processing.h>
#include <CGAL/Gradient_domain_processing/Conjugate_gradient_solver_traits.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace GDP = CGAL::Gradient_domain_processing;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef CGAL::Surface_mesh<Point> Mesh;
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Face_index Face;

namespace {

struct Curvature
{
  double min_curvature, max_curvature;
  Vector min_direction, max_direction;
};

int number_of_failures = 0;

// No name of an error code here: each may be a macro of the headers above.
void check(const char* what, GDP::Error_code code)
{
  if(static_cast<int>(code) == 0)
    return;
  ++number_of_failures;
  std::cerr << what << ": " << GDP::get_error_message(code) << std::endl;
}

// An octahedron split three times and blown up to a sphere, with a bump, and rough.
Mesh rough_sphere()
{
  Mesh mesh;
  std::vector<Vertex> v;
  for(const Point& p :
      {Point(1, 0, 0), Point(0, 1, 0), Point(-1, 0, 0), Point(0, -1, 0), Point(0, 0, 1), Point(0, 0, -1)})
    v.push_back(mesh.add_vertex(p));
  for(int i = 0; i < 4; ++i)
  {
    mesh.add_face(v[i], v[(i + 1) % 4], v[4]);
    mesh.add_face(v[(i + 1) % 4], v[i], v[5]);
  }
  for(int level = 0; level < 3; ++level)
  {
    Mesh finer;
    std::vector<Vertex> old, middle(mesh.number_of_edges());
    for(Vertex w : mesh.vertices())
      old.push_back(finer.add_vertex(mesh.point(w)));
    for(Mesh::Edge_index e : mesh.edges())
    {
      const Vector m = (mesh.point(mesh.vertex(e, 0)) - CGAL::ORIGIN) + (mesh.point(mesh.vertex(e, 1)) - CGAL::ORIGIN);
      middle[e] = finer.add_vertex(CGAL::ORIGIN + m / std::sqrt(m.squared_length()));
    }
    for(Face f : mesh.faces())
    {
      std::array<Vertex, 3> corner, side;
      Mesh::Halfedge_index h = mesh.halfedge(f);
      for(std::size_t i = 0; i < 3; ++i, h = mesh.next(h))
      {
        corner[i] = old[mesh.source(h)];
        side[i] = middle[mesh.edge(h)];
      }
      for(std::size_t i = 0; i < 3; ++i)
        finer.add_face(corner[i], side[i], side[(i + 2) % 3]);
      finer.add_face(side[0], side[1], side[2]);
    }
    mesh = finer;
  }
  for(Vertex w : mesh.vertices())
    mesh.point(w) = CGAL::ORIGIN + (mesh.point(w) - CGAL::ORIGIN) * (1 + 0.01 * std::sin(37. * w.idx()));
  return mesh;
}

void filter_positions(const Mesh& input, const std::vector<Face>& region)
{
  using namespace GDP::parameters;
  Mesh mesh = input;
  check("smooth", GDP::smooth(mesh));
  check("smooth a region", GDP::smooth(region, mesh, gradient_weight(1e-3)));
  check("sharpen", GDP::sharpen(mesh, curvature_weight(0.01)));
  check("sharpen a region", GDP::sharpen(region, mesh, gradient_scale(1.5)));
  check("smooth with conjugate gradients",
        GDP::smooth(mesh, sparse_linear_solver(GDP::Conjugate_gradient_solver_traits<>())));
  check("enhance_details", GDP::enhance_details(mesh, number_of_iterations(2).concurrency_tag(CGAL::Sequential_tag())));
  check("denoise", GDP::denoise(mesh, number_of_iterations(2)));
  check("denoise a region", GDP::denoise(region, mesh, number_of_iterations(1)));

  auto normal = mesh.add_property_map<Vertex, Vector>("v:normal").first;
  for(Vertex v : mesh.vertices())
    normal[v] = mesh.point(v) - CGAL::ORIGIN;
  check("fit_to_normals", GDP::fit_to_normals(mesh, normal));

  for(Vertex v : mesh.vertices())
    if(!std::isfinite(mesh.point(v).x() + mesh.point(v).y() + mesh.point(v).z()))
      ++number_of_failures;
}

void filter_signals(Mesh mesh, const std::vector<Face>& region)
{
  using namespace GDP::parameters;
  auto height = mesh.add_property_map<Vertex, double>("v:height").first;
  auto color = mesh.add_property_map<Vertex, CGAL::IO::Color>("v:color").first;
  auto patch = mesh.add_property_map<Vertex, int>("v:patch", 0).first;
  for(Vertex v : mesh.vertices())
  {
    height[v] = mesh.point(v).z();
    patch[v] = mesh.point(v).x() > 0;
  }
  check("process_signal", GDP::process_signal(mesh, height, height));
  check("process_signal, colors", GDP::process_signal(mesh, color, color));
  check("process_signal in a region", GDP::process_signal(region, mesh, height, height));
  check("stitch", GDP::stitch(mesh, patch, height, height));
  check("stitch a region", GDP::stitch(region, mesh, patch, height, height));

  auto gradient = mesh.add_property_map<Face, std::array<Vector, 1> >("f:gradient", {Vector(1, 0, 0)}).first;
  auto face_height = mesh.add_property_map<Face, double>("f:height", 1.).first;
  check("fit_to_gradients", GDP::fit_to_gradients(mesh, height, gradient, height));
  check("process_face_signal", GDP::process_face_signal(mesh, face_height, face_height));
}

void write_operators(Mesh mesh)
{
  using namespace GDP::parameters;
  auto curvature = mesh.add_property_map<Vertex, Curvature>("v:curvature").first;
  auto metric = mesh.add_property_map<Face, GDP::Triangle_metric>("f:metric").first;
  check("estimate_curvatures", GDP::estimate_curvatures(mesh, curvature));
  check("embedding_metric", GDP::embedding_metric(mesh, metric));
  check("curvature_metric", GDP::curvature_metric(mesh, metric, vertex_curvature_map(curvature)));
  check("curvature_metric with normals",
        GDP::curvature_metric(mesh, metric, curvature_estimator(GDP::Curvature_estimator::NORMALS)));
  check("smooth with metrics", GDP::smooth(mesh, face_metric_map(metric)));
  Eigen::SparseMatrix<double> matrix;
  check("mass_matrix", GDP::mass_matrix(mesh, matrix));
  check("stiffness_matrix", GDP::stiffness_matrix(mesh, matrix));
  check("gradient_matrix", GDP::gradient_matrix(mesh, matrix));
  check("divergence_matrix", GDP::divergence_matrix(mesh, matrix));
}

} // namespace

int main()
{
  const Mesh mesh = rough_sphere();
  std::vector<Face> region;
  for(Face f : mesh.faces())
    if(f.idx() % 8 < 5)
      region.push_back(f);
  filter_positions(mesh, region);
  filter_signals(mesh, region);
  write_operators(mesh);
  std::cout << number_of_failures << " failures on " << mesh.number_of_faces() << " faces" << std::endl;
  return number_of_failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
