// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the curvature metrics are for (paper, Figures 1, 3 and 4), in numbers.

#include "test_creases.h"

#include <CGAL/Gradient_domain_processing/deformation_matrices.h>
#include <CGAL/Gradient_domain_processing/enhance_details.h>
#include <CGAL/Gradient_domain_processing/mass_matrix.h>

#include <Eigen/SparseCholesky>

#include <iostream>
#include <limits>
#include <vector>

using namespace gdp_test;

typedef Eigen::SparseMatrix<double> Sparse;

double dihedral_angle(const Mesh& mesh, Mesh::Edge_index e)
{
  const auto h = mesh.halfedge(e);
  return angle(area_vector(mesh, mesh.face(h)), area_vector(mesh, mesh.face(mesh.opposite(h))));
}

// ---- Figure 1: a noisy shape whose creases are known

struct Noisy_part
{
  Mesh clean, noisy;
  std::vector<Mesh::Edge_index> creases;
  std::vector<Face> smooth_faces; // far from every crease

  Noisy_part(const Shape& shape, double noise) : clean(mesh_of(shape))
  {
    double edge = 0;
    for(auto e : clean.edges())
      edge +=
        (vec(clean.point(clean.vertex(e, 0))) - vec(clean.point(clean.vertex(e, 1)))).norm() / clean.number_of_edges();
    noisy = mesh_of(shape.noisy(noise * edge));

    for(auto e : clean.edges())
      if(dihedral_angle(clean, e) > 45)
        creases.push_back(e);
    for(Face f : clean.faces())
    {
      Vec center(0, 0, 0);
      for(Vertex v : corners(clean, f))
        center += vec(clean.point(v)) / 3;
      double distance = std::numeric_limits<double>::infinity();
      for(auto e : creases)
        distance = (std::min)(distance, (vec(clean.point(clean.vertex(e, 0))) - center).norm());
      if(distance > 4 * edge)
        smooth_faces.push_back(f);
    }
    GDP_CHECK(creases.size() > 40 && smooth_faces.size() > 100);
  }

  // root mean square of the angle between the normals and those without noise
  double residual_noise(const Mesh& mesh) const
  {
    double sum = 0;
    for(Face f : smooth_faces)
      sum += std::pow(angle(area_vector(mesh, f), area_vector(clean, f)), 2);
    return std::sqrt(sum / smooth_faces.size());
  }

  // mean absolute error of the dihedral angles
  double crease_error(const Mesh& mesh) const
  {
    double sum = 0;
    for(auto e : creases)
      sum += std::abs(dihedral_angle(mesh, e) - dihedral_angle(clean, e));
    return sum / creases.size();
  }
};

// Two spherical caps that meet at an edge.
Shape lens(int n)
{
  const double radius = 1.2;
  return sphere(n, 0).mapped([&](const Vec& p) {
    const double polar = std::acos((std::min)(1., std::abs(p.z()))) / (pi / 2), r = p.z() == 0 ? 1 : polar;
    const double height = std::sqrt(radius * radius - r * r) - std::sqrt(radius * radius - 1);
    const double length = p.head<2>().norm();
    const Vec flat = length > 0 ? Vec(r / length * p.x(), r / length * p.y(), 0) : Vec(0, 0, 0);
    return Vec(flat.x(), flat.y(), p.z() == 0 ? 0 : p.z() > 0 ? height : -height);
  });
}

// The energies of deformations in place of S: of what is left between a smoothed shape, at rest, and the noisy one, as
// much comes back as leaves the same noise. Along normals, or, of a shell, in all directions.
struct Deformation
{
  const Noisy_part& part;
  Mesh rest;
  Sparse mass, energy;
  bool is_of_shell;
  Eigen::MatrixXd offsets, normals; // by vertex

  Deformation(const Noisy_part& p, double weight, bool shell) : part(p), is_of_shell(shell)
  {
    rest = smoothed(part.noisy, weight, Filter());
    GDP_CHECK(GDP::mass_matrix(rest, mass) == GDP::ok);
    GDP_CHECK((shell ? GDP::shell_hessian_matrix(rest, 1, 1, 1, energy)
                     : GDP::modified_dirichlet_matrix(rest, energy)) == GDP::ok);
    offsets.resize(mass.rows(), 3);
    normals.setZero(mass.rows(), 3);
    for(Vertex v : rest.vertices())
      offsets.row(int(v)) = (vec(part.noisy.point(v)) - vec(rest.point(v))).transpose();
    for(Face f : rest.faces())
      for(Vertex v : corners(rest, f))
        normals.row(int(v)) += area_vector(rest, f).transpose();
    normals.rowwise().normalize();
    if(!shell)
      return;
    std::vector<Eigen::Triplet<double> > entries;
    for(int j = 0; j < int(mass.cols()); ++j)
      for(Sparse::InnerIterator it(mass, j); it; ++it)
        for(int k = 0; k < 3; ++k)
          entries.emplace_back(3 * int(it.row()) + k, 3 * j + k, it.value());
    mass = Sparse(3 * mass.rows(), 3 * mass.rows());
    mass.setFromTriplets(entries.begin(), entries.end());
  }

  // min |d - offset|^2 + beta E(d)
  Mesh combined(double beta) const
  {
    const Eigen::SimplicialLLT<Sparse> solver(Sparse(mass + beta * energy));
    Eigen::MatrixXd moved = offsets;
    if(is_of_shell)
    {
      const Eigen::MatrixXd by_axis = offsets.transpose();
      const Eigen::VectorXd all = Eigen::Map<const Eigen::VectorXd>(by_axis.data(), by_axis.size());
      const Eigen::VectorXd solved = solver.solve(Eigen::VectorXd(mass * all));
      moved = Eigen::Map<const Eigen::MatrixXd>(solved.data(), 3, offsets.rows()).transpose();
    }
    else
    {
      const Eigen::VectorXd heights = offsets.cwiseProduct(normals).rowwise().sum();
      const Eigen::VectorXd solved = solver.solve(Eigen::VectorXd(mass * heights));
      moved = solved.asDiagonal() * normals;
    }
    Mesh result = rest;
    for(Vertex v : result.vertices())
    {
      const Vec p = vec(rest.point(v)) + moved.row(int(v)).transpose();
      result.point(v) = Point(p.x(), p.y(), p.z());
    }
    return result;
  }

  double crease_error_at(double noise) const
  {
    double low = -20, high = 6; // of the logarithm of beta
    for(int step = 0; step < 12; ++step)
      (part.residual_noise(combined(std::exp((low + high) / 2))) > noise ? low : high) = (low + high) / 2;
    const Mesh result = combined(std::exp(high));
    GDP_CHECK_NEAR(part.residual_noise(result) / noise, 1, 0.02);
    return part.crease_error(result);
  }
};

// They keep creases no better than plain smoothing does, or a little: the shape at rest has lost them.
void test_deformation_energies(const char* name, const Noisy_part& part, double remaining, double weight,
                               double of_edge_aware)
{
  const double noise = remaining * part.residual_noise(part.noisy);
  const double modified = Deformation(part, weight, false).crease_error_at(noise);
  const double shell = Deformation(part, weight, true).crease_error_at(noise);
  std::cout << name << ": dihedral angles off by " << modified << " degrees (modified Dirichlet energy), " << shell
            << " (shell)" << std::endl;
  GDP_CHECK(shell < modified);
  GDP_CHECK(shell > 1.8 * of_edge_aware);
}

// ---- Figure 3: convex and concave creases of the same radius

struct Stairs
{
  static constexpr double radius = 0.1, turn = pi / 3, straight = 0.4;
  struct Sample
  {
    Vec point;
    int sign; // 1 in the middle of a convex crease, -1 of a concave one
  };

  // the profile at a length along it: straight, up, straight, down, straight, up, ...
  static Sample at(double s)
  {
    Vec p(0, 0, 0);
    double heading = 0;
    for(int piece = 0;; ++piece)
    {
      if(s <= straight)
        return {p + s * Vec(std::cos(heading), 0, std::sin(heading)), 0};
      p += straight * Vec(std::cos(heading), 0, std::sin(heading));
      s -= straight;
      const int direction = piece % 2 ? -1 : 1; // upwards is concave, seen from above
      const double along = (std::min)(s, radius * turn) / radius, end = heading + direction * along;
      p += radius * direction * Vec(std::sin(end) - std::sin(heading), 0, std::cos(heading) - std::cos(end));
      if(s <= radius * turn)
        return {p, std::abs(along / turn - 0.5) < 0.3 ? -direction : 0};
      s -= radius * turn;
      heading = end;
    }
  }
  static double length() { return 5 * straight + 4 * radius * turn; }
};

void test_preserved_signs()
{
  const int n = 150, width = 12;
  const double length = Stairs::length();
  const Mesh before = mesh_of(grid(n, width, [&](double u, double v) {
    return Vec(Stairs::at(u * length).point + Vec(0, v * width * length / n, 0));
  }));
  const auto sign_of = [&](Vertex v) {
    const int i = int(v) / (width + 1), j = int(v) % (width + 1);
    return j > 3 && j < width - 3 ? Stairs::at(double(i) / n * length).sign : 0;
  };
  const auto changes = [&](Kind kind, double& convex, double& concave) {
    Filter filter;
    filter.kind = kind;
    filter.curvature_weight = 1;
    filter.presmoothing_weight = 0;
    filter.border_condition = GDP::Border_condition::FIXED;
    const Mesh after = smoothed(before, 1e-4, filter);
    double sum[2] = {0, 0};
    int number[2] = {0, 0};
    for(Vertex v : before.vertices())
      if(const int sign = sign_of(v))
      {
        sum[sign > 0] += (vec(after.point(v)) - vec(before.point(v))).squaredNorm();
        ++number[sign > 0];
      }
    GDP_CHECK(number[0] > 20 && number[1] > 20);
    concave = std::sqrt(sum[0] / number[0]);
    convex = std::sqrt(sum[1] / number[1]);
  };
  double convex, concave;
  changes(Kind::EMBEDDING, convex, concave);
  std::cout << "isotropic: convex creases change by " << convex << ", concave ones by " << concave << std::endl;
  GDP_CHECK(convex > 1e-4 && concave > 1e-4 && convex < 1.2 * concave && concave < 1.2 * convex);
  changes(Kind::PRESERVE_CONVEX, convex, concave);
  std::cout << "convex preserved: convex creases change " << concave / convex << " times less" << std::endl;
  GDP_CHECK(concave > 5 * convex);
  changes(Kind::PRESERVE_CONCAVE, convex, concave);
  std::cout << "concave preserved: concave creases change " << convex / concave << " times less" << std::endl;
  GDP_CHECK(convex > 5 * concave);
}

// ---- Figure 4: details enhanced, noise not

void test_enhancement()
{
  const Shape shape = cubes({{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}}, 8); // its creases are the details
  const Mesh clean = mesh_of(shape), noisy = mesh_of(shape.noisy(0.012));
  const double sharpening_weight = 2e-4, sharpening_scale = 3;
  const Mesh ideal = smoothed(clean, sharpening_weight, Filter(), sharpening_scale);

  // in decibels: the normals of the sharpened details are the signal, noise is what differs from them
  const auto ratio = [&](const Mesh& mesh) {
    double noise = 0, area = 0;
    for(Face f : mesh.faces())
    {
      const double a = area_vector(clean, f).norm();
      noise += a * (area_vector(mesh, f).normalized() - area_vector(ideal, f).normalized()).squaredNorm();
      area += a;
    }
    return 10 * std::log10(area / noise);
  };
  const auto enhanced = [&](Kind kind, double weight) {
    Mesh mesh = noisy;
    GDP_CHECK(GDP::enhance_details(mesh, GDP::parameters::gradient_weight(weight)
                                           .curvature_metric_kind(kind)
                                           .curvature_weight(0.1)
                                           .presmoothing_weight(3e-5)
                                           .sharpening_weight(sharpening_weight)
                                           .sharpening_scale(sharpening_scale))
              == GDP::OK);
    return ratio(mesh);
  };
  // each with the smoothing that suits it best
  const double naive = ratio(smoothed(noisy, sharpening_weight, Filter(), sharpening_scale));
  double isotropic = -1000, edge_aware = -1000;
  for(double weight = 1e-6; weight < 3e-3; weight *= 1.6)
  {
    isotropic = (std::max)(isotropic, enhanced(Kind::EMBEDDING, weight));
    edge_aware = (std::max)(edge_aware, enhanced(Kind::EDGE_AWARE, weight));
  }
  std::cout << "signal to noise: sharpened " << naive << " dB, smoothed isotropically first " << isotropic
            << " dB, edge-aware first " << edge_aware << " dB" << std::endl;
  GDP_CHECK(isotropic > naive + 3);
  GDP_CHECK(edge_aware > isotropic + 2);
}

int main()
{
  Filter filter;
  filter.curvature_weight = 0.2;
  const Noisy_part part(cubes({{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}}, 10), 0.2), curved(lens(12), 0.12);
  const Smoothed_part smooth_part = test_creases("part", part, 0.35, filter);
  const Smoothed_part smooth_lens = test_creases("lens", curved, 0.35, filter);
  test_deformation_energies("part", part, 0.35, 2e-4, part.crease_error(smooth_part.edge_aware));
  test_deformation_energies("lens", curved, 0.35, 5e-4, curved.crease_error(smooth_lens.edge_aware));
  test_preserved_signs();
  test_enhancement();
  return GDP_TEST_RESULT();
}
