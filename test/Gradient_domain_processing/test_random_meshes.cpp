// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A thousand small meshes of random connectivity and random slivers, through the filters with random parameters:
// finite, no more energy than the input has, and the same from another solver.

#include "test_shapes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/operators.h>
#include <CGAL/Gradient_domain_processing/smooth.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <iostream>
#include <vector>

namespace GDP = CGAL::Gradient_domain_processing;
using namespace gdp_test;

typedef GDP::Curvature_metric_kind Kind;
typedef GDP::Curvature_estimator Estimator;

// ---- meshes

bool can_flip(const Mesh& mesh, Mesh::Halfedge_index h)
{
  const auto o = mesh.opposite(h);
  if(mesh.is_border(h) || mesh.is_border(o))
    return false;
  const Vertex a = mesh.target(mesh.next(h)), b = mesh.target(mesh.next(o));
  return a != b && mesh.halfedge(a, b) == Mesh::null_halfedge();
}

Mesh random_mesh(Random& random)
{
  Shape shape;
  switch(random.below(6))
  {
    case 0: shape = sphere(2 + random.below(2)); break;
    case 1: shape = jittered_square(3 + random.below(3)); break;
    case 2: shape = cubes({{{0, 0, 0}}, {{1, 0, 0}}}, 1 + random.below(2)); break;
    case 3: shape = disk(5 + random.below(5), 3); break;
    case 4:
      shape = grid(6, 4, [](double u, double v) {
        const double r = 1 + 0.4 * std::cos(2 * pi * v);
        return Vec(r * std::cos(2 * pi * u), r * std::sin(2 * pi * u), 0.4 * std::sin(2 * pi * v));
      }, true, true);
      break;
    default: shape = sphere(2) + square(3).moved(Vec(2, 0, 0));
  }
  shape = shape.noisy(random.in(0, 0.1), random.below(1000));
  Mesh mesh = mesh_of(shape);

  for(int step = random.below(30); step > 0; --step)
  {
    const auto h = *std::next(mesh.halfedges().begin(), random.below(int(mesh.number_of_halfedges())));
    switch(random.below(3))
    {
      case 0:
        if(can_flip(mesh, h))
          CGAL::Euler::flip_edge(h, mesh);
        break;
      case 1:
        if(mesh.number_of_faces() > 12 && CGAL::Euler::does_satisfy_link_condition(mesh.edge(h), mesh))
          CGAL::Euler::collapse_edge(mesh.edge(h), mesh);
        break;
      default: // a cut into the border, or a hole
        if(mesh.number_of_faces() > 12 && !mesh.is_border(h) && random.below(4) == 0)
          CGAL::Euler::remove_face(h, mesh);
    }
  }
  // slivers: vertices on, or almost on, neighbors and edges
  for(int number = random.below(4); number > 0; --number)
  {
    const auto h = *std::next(mesh.halfedges().begin(), random.below(int(mesh.number_of_halfedges())));
    if(mesh.is_border(h))
      continue;
    const Vec a = vec(mesh.point(mesh.source(h))), b = vec(mesh.point(mesh.target(h)));
    const double along = random.below(2) ? random.in(0, 1) : random.below(2),
                 size = random.below(2) ? 0 : std::pow(10., -random.in(3, 14));
    const double x = random(), y = random(), z = random();
    const Vec p = a + along * (b - a) + size * Vec(x, y, z);
    mesh.point(mesh.target(mesh.next(h))) = Point(p.x(), p.y(), p.z());
  }
  if(random.below(3) == 0)
    mesh.add_vertex(Point(1, 2, 3));
  if(random.below(2))
    mesh.collect_garbage(); // else with the gaps of what was removed
  const double scale = std::pow(10., 4 * random());
  for(Vertex v : mesh.vertices())
    mesh.point(v) = Point(scale * mesh.point(v).x(), scale * mesh.point(v).y(), scale * mesh.point(v).z());
  return mesh;
}

// ---- filters

struct Settings
{
  Kind kind;
  Estimator estimator;
  double alpha, beta, lambda, epsilon, gamma;
  GDP::Border_condition border;
};

Settings random_settings(Random& random)
{
  const Kind kinds[] = {Kind::EMBEDDING, Kind::EDGE_AWARE, Kind::ANISOTROPIC, Kind::PRESERVE_CONVEX,
                        Kind::PRESERVE_CONCAVE};
  const GDP::Border_condition borders[] = {GDP::Border_condition::FREE, GDP::Border_condition::FIXED,
                                           GDP::Border_condition::ALONG_BORDER};
  Settings s;
  s.kind = kinds[random.below(5)];
  s.estimator = random.below(2) ? Estimator::JETS : Estimator::NORMALS;
  s.alpha = std::pow(10., random());
  s.beta = std::pow(10., random.in(-6, 1));
  s.lambda = random.below(3) ? 0 : random.in(-1, 4);
  s.epsilon = std::pow(10., random.in(-4, 1));
  s.gamma = random.below(2) ? 0 : std::pow(10., random.in(-5, -1));
  s.border = borders[random.below(3)];
  return s;
}

template <class Solver>
GDP::Error_code run(Mesh& mesh, const Settings& s, const Solver& solver)
{
  return GDP::smooth(mesh, GDP::parameters::value_weight(s.alpha).gradient_weight(s.beta).gradient_scale(s.lambda)
                             .curvature_metric_kind(s.kind).curvature_estimator(s.estimator).curvature_weight(s.epsilon)
                             .presmoothing_weight(s.gamma).border_condition(s.border).sparse_linear_solver(solver));
}

typedef CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> > Other_solver;

// By number of the vertex, the removed ones too.
Eigen::MatrixXd all_positions(const Mesh& mesh, std::size_t rows)
{
  Eigen::MatrixXd p = Eigen::MatrixXd::Zero(rows, 3);
  for(Vertex v : mesh.vertices())
    p.row(v) = vec(mesh.point(v)).transpose();
  return p;
}

int main()
{
  const int number = 1000;
  int slivers = 0, compared = 0, with_gaps = 0, open = 0;
  double worst = 0, worst_energy = 0;
  Random random(2026);
  for(int trial = 0; trial < number; ++trial)
  {
    const int failures = number_of_failures();
    const Mesh before = random_mesh(random);
    const Settings s = random_settings(random);
    Mesh mesh = before;
    GDP_CHECK(run(mesh, s, GDP::Default_sparse_linear_solver()) == GDP::OK);
    GDP_CHECK(is_finite(mesh));
    for(Vertex v : mesh.vertices())
      if(before.is_isolated(v) || (s.border == GDP::Border_condition::FIXED && before.is_border(v)))
        GDP_CHECK(same_bits(mesh.point(v), before.point(v)));
    with_gaps += before.has_garbage();
    for(Vertex v : before.vertices())
      if(!before.is_isolated(v) && before.is_border(v))
      {
        ++open;
        break;
      }

    // how good the triangles are: the condition of the system grows with one over it
    double quality = 1;
    for(Face f : before.faces())
    {
      double longest = 0;
      for(auto h : before.halfedges_around_face(before.halfedge(f)))
        longest = (std::max)(longest,
                             (vec(before.point(before.source(h))) - vec(before.point(before.target(h)))).squaredNorm());
      quality = (std::min)(quality, longest > 0 ? area_vector(before, f).norm() / longest : 0);
    }
    slivers += quality < 1e-3;

    // the energy of the embedding, in the package's own matrices
    Eigen::SparseMatrix<double> mass, stiffness;
    GDP_CHECK(GDP::mass_matrix(before, mass) == GDP::OK);
    GDP_CHECK(GDP::stiffness_matrix(before, stiffness) == GDP::OK);
    const Eigen::Index rows = mass.rows();
    const Eigen::MatrixXd f = all_positions(before, rows), g = all_positions(mesh, rows),
                          one = Eigen::MatrixXd::Ones(rows, 1);
    const double beta = s.beta * mass.sum(), size = f.cwiseAbs().maxCoeff();
    GDP_CHECK_NEAR((stiffness * one).cwiseAbs().maxCoeff(), 0, 1e-9 * stiffness.coeffs().cwiseAbs().maxCoeff());
    GDP_CHECK_NEAR((Eigen::MatrixXd(mass) - Eigen::MatrixXd(mass).transpose()).norm(), 0, 0);
    if(s.kind == Kind::EMBEDDING && s.border != GDP::Border_condition::ALONG_BORDER)
    {
      const auto energy = [&](const Eigen::MatrixXd& x) {
        const Eigen::MatrixXd d = x - f, e = x - s.lambda * f;
        return s.alpha * (d.transpose() * (mass * d)).trace() + beta * (e.transpose() * (stiffness * e)).trace();
      };
      const double at_input = energy(f), at_result = energy(g);
      worst_energy = (std::max)(worst_energy, at_result / at_input);
      GDP_CHECK(at_result <= at_input * (1 + 1e-9) + 1e-14 * (s.alpha * mass.sum() + beta) * size * size);
    }

    // another solver, with another order of the unknowns
    if(quality > 1e-3)
    {
      Mesh other = before;
      GDP_CHECK(run(other, s, Other_solver()) == GDP::OK);
      const double difference = (all_positions(other, rows) - g).cwiseAbs().maxCoeff() / size;
      worst = (std::max)(worst, difference);
      GDP_CHECK_NEAR(difference, 0, 1e-8);
      ++compared;
    }
    if(number_of_failures() > failures)
      std::cerr << "  mesh " << trial << ": " << before.number_of_vertices() << " vertices, quality " << quality
                << ", kind " << int(s.kind) << ", estimator " << int(s.estimator) << ", border " << int(s.border)
                << ", alpha " << s.alpha << ", beta " << s.beta << ", lambda " << s.lambda << ", epsilon " << s.epsilon
                << ", gamma " << s.gamma << std::endl;
  }
  std::cout << number << " meshes, " << open << " open, " << slivers << " with slivers, " << with_gaps << " with gaps; "
            << compared << " compared with another solver, largest difference " << worst
            << " of the size; largest part of the energy left " << worst_energy << std::endl;
  GDP_CHECK(slivers > 200 && compared > 200 && with_gaps > 100 && open > 300);
  return GDP_TEST_RESULT();
}
