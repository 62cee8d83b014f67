// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Weights that vary over the mesh: smooth here, sharpen there, nothing beyond, in one solve.

#include "test_energy.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/process_face_signal.h>
#include <CGAL/Gradient_domain_processing/process_signal.h>

#include <iostream>

namespace GDP = CGAL::Gradient_domain_processing;
using namespace gdp_test;

struct Masks
{
  Mesh mesh;
  Mesh::Property_map<Vertex, double> alpha;
  Mesh::Property_map<Face, double> beta, lambda;
  Mesh::Property_map<Vertex, Point> in, out;

  explicit Masks(const Shape& shape)
    : mesh(mesh_of(shape)),
      alpha(mesh.add_property_map<Vertex, double>("v:alpha", 1.).first),
      beta(mesh.add_property_map<Face, double>("f:beta", 0.).first),
      lambda(mesh.add_property_map<Face, double>("f:lambda", 0.).first),
      in(mesh.add_property_map<Vertex, Point>("v:in").first),
      out(mesh.add_property_map<Vertex, Point>("v:out").first)
  {
    for(Vertex v : mesh.vertices())
      in[v] = mesh.point(v);
  }

  GDP::Error_code run(bool area_normalization)
  {
    return GDP::process_signal(mesh, in, out,
                               GDP::parameters::vertex_value_weight_map(alpha)
                                 .face_gradient_weight_map(beta)
                                 .face_gradient_scale_map(lambda)
                                 .area_normalization(area_normalization));
  }

  Eigen::MatrixXd result() const
  {
    Eigen::MatrixXd g(mesh.number_of_vertices(), 3);
    for(Vertex v : mesh.vertices())
      g.row(v) = vec(out[v]).transpose();
    return g;
  }

  Eigen::MatrixXd expected(bool area_normalization) const
  {
    Dense_energy energy(mesh);
    for(Vertex v : mesh.vertices())
      energy.alpha[v] = alpha[v];
    for(Face f : mesh.faces())
    {
      energy.beta[f] = beta[f] * (area_normalization ? total_area(mesh) : 1);
      energy.lambda[f] = lambda[f];
    }
    return energy.minimum(positions(mesh));
  }

  double x_of(Face f) const
  {
    double sum = 0;
    for(Vertex v : corners(mesh, f))
      sum += mesh.point(v).x() / 3;
    return sum;
  }
};

Shape test_shape()
{
  return sphere(5).noisy(0.04) + jittered_square(7).noisy(0.02).moved(Vec(3, 0, 0));
}

// Masks that are constant are the scalar parameter.
void test_constant_masks()
{
  for(bool area_normalization : {true, false})
    for(double alpha : {0.5, 3.})
      for(double beta : {1e-3, 0.2})
        for(double lambda : {0., 0.7, 4.})
        {
          Masks masks(test_shape());
          for(Vertex v : masks.mesh.vertices())
            masks.alpha[v] = alpha;
          for(Face f : masks.mesh.faces())
          {
            masks.beta[f] = beta;
            masks.lambda[f] = lambda;
          }
          GDP_CHECK(masks.run(area_normalization) == GDP::OK);
          const Eigen::MatrixXd by_masks = masks.result();
          GDP_CHECK(
            GDP::process_signal(
              masks.mesh, masks.in, masks.out,
              GDP::parameters::value_weight(alpha).gradient_weight(beta).gradient_scale(lambda).area_normalization(
                area_normalization))
            == GDP::OK);
          GDP_CHECK_NEAR((by_masks - masks.result()).cwiseAbs().maxCoeff(), 0, 1e-13);
          GDP_CHECK((by_masks - positions(masks.mesh)).cwiseAbs().maxCoeff() > 1e-4);
        }
}

// Masks of two values, and of any values, against the dense energy.
void test_varying_masks()
{
  for(bool area_normalization : {true, false})
    for(int varies = 1; varies < 8; ++varies) // which of the three
      for(bool is_random : {false, true})
      {
        Masks masks(test_shape());
        Random random(varies);
        for(Vertex v : masks.mesh.vertices())
          masks.alpha[v] = !(varies & 1) ? 1 : is_random ? random.in(0, 5) : masks.mesh.point(v).y() > 0 ? 4 : 0.1;
        for(Face f : masks.mesh.faces())
        {
          masks.beta[f] = !(varies & 2) ? 0.02 : is_random ? random.in(0, 0.1) : masks.x_of(f) > 0 ? 0.1 : 0.001;
          masks.lambda[f] = !(varies & 4) ? 0.5 : is_random ? random.in(-1, 3) : masks.x_of(f) > 0.2 ? 2 : 0;
        }
        GDP_CHECK(masks.run(area_normalization) == GDP::OK);
        GDP_CHECK_NEAR((masks.result() - masks.expected(area_normalization)).cwiseAbs().maxCoeff(), 0, 1e-12);
      }
}

// Three zones of a strip: smoothed, sharpened, left alone. Each is, away from the others, as if it were all of the
// mesh.
void test_brushes()
{
  const int n = 120;
  const Shape strip = grid(n, 6, [](double u, double v) {
    return Vec(20 * u, v, 0.05 * std::sin(2 * pi * 20 * u) * std::cos(pi * v));
  });
  Masks masks(strip);
  const auto zone = [&](double x) { return x < 20. / 3 ? 0 : x < 40. / 3 ? 1 : 2; };
  const double beta[3] = {0.02, 0.02, 0}, lambda[3] = {0, 2, 1};
  for(Face f : masks.mesh.faces())
  {
    masks.beta[f] = beta[zone(masks.x_of(f))];
    masks.lambda[f] = lambda[zone(masks.x_of(f))];
  }
  GDP_CHECK(masks.run(false) == GDP::OK);
  const Eigen::MatrixXd together = masks.result(), before = positions(masks.mesh);

  for(int z = 0; z < 3; ++z)
  {
    for(Face f : masks.mesh.faces())
    {
      masks.beta[f] = beta[z];
      masks.lambda[f] = lambda[z];
    }
    GDP_CHECK(masks.run(false) == GDP::OK);
    const Eigen::MatrixXd alone = masks.result();
    double error = 0, change = 0, roughness[2] = {0, 0};
    for(Vertex v : masks.mesh.vertices())
    {
      const double x = before(int(v), 0);
      if(zone(x - 2) != z || zone(x + 2) != z)
        continue;
      error = (std::max)(error, (together.row(v) - alone.row(v)).norm());
      change = (std::max)(change, (together.row(v) - before.row(v)).norm());
      roughness[0] += before(int(v), 2) * before(int(v), 2);
      roughness[1] += together(int(v), 2) * together(int(v), 2);
    }
    const double factor = std::sqrt(roughness[1] / roughness[0]);
    std::cout << "zone " << z << ": amplitude times " << factor << ", changed by " << change << ", against alone "
              << error << std::endl;
    GDP_CHECK(error < 1e-4);
    if(z == 0)
      GDP_CHECK(factor < 0.7);
    if(z == 1)
      GDP_CHECK(factor > 1.3);
    if(z == 2)
      GDP_CHECK(change < 1e-4);
  }
}

// A mask in which the weights are such that nothing is asked for: lambda is 1 everywhere, or beta is 0 everywhere.
void test_masks_of_nothing()
{
  Masks masks(test_shape());
  const Eigen::MatrixXd before = positions(masks.mesh);
  Random random;
  for(Vertex v : masks.mesh.vertices())
    masks.alpha[v] = random.in(0.1, 2);
  for(Face f : masks.mesh.faces())
  {
    masks.beta[f] = random.in(0, 1);
    masks.lambda[f] = 1;
  }
  GDP_CHECK(masks.run(true) == GDP::OK);
  for(Vertex v : masks.mesh.vertices())
    GDP_CHECK(same_bits(masks.out[v], masks.in[v]));
  for(Face f : masks.mesh.faces())
  {
    masks.lambda[f] = random.in(0, 3);
    masks.beta[f] = 0;
  }
  GDP_CHECK(masks.run(true) == GDP::OK);
  for(Vertex v : masks.mesh.vertices())
    GDP_CHECK(same_bits(masks.out[v], masks.in[v]));
}

// Where the value weight varies, a border that is filtered as a curve minimizes the energy of the curve: with dense
// matrices, and Simpson's rule, which is exact for alpha times two hat functions.
void test_varying_masks_along_border()
{
  Mesh mesh = mesh_of(jittered_square(7));
  const int n = int(mesh.number_of_vertices());
  auto alpha = mesh.add_property_map<Vertex, double>("v:alpha").first;
  auto in = mesh.add_property_map<Vertex, double>("v:in").first,
       out = mesh.add_property_map<Vertex, double>("v:out").first;
  for(Vertex v : mesh.vertices())
  {
    alpha[v] = 0.3 + int(v) % 4;
    in[v] = std::sin(3. * int(v));
  }
  const double beta = 0.02;
  Eigen::MatrixXd masses = Eigen::MatrixXd::Zero(n, n), stiffness = masses;
  for(auto h : mesh.halfedges())
  {
    if(!mesh.is_border(h))
      continue;
    const Vertex ends[2] = {mesh.source(h), mesh.target(h)};
    const double length = (vec(mesh.point(ends[1])) - vec(mesh.point(ends[0]))).norm(),
                 middle = (alpha[ends[0]] + alpha[ends[1]]) / 2;
    for(int i : {0, 1})
      for(int j : {0, 1})
      {
        masses(int(ends[i]), int(ends[j])) += length / 6 * ((i == j ? alpha[ends[i]] : 0.) + middle);
        stiffness(int(ends[i]), int(ends[j])) += (i == j ? 1 : -1) * beta / length;
      }
  }
  Eigen::VectorXd f(n);
  for(Vertex v : mesh.vertices())
  {
    f[int(v)] = in[v];
    if(!mesh.is_border(v))
      masses(int(v), int(v)) = 1;
  }
  const Eigen::VectorXd expected = (masses + stiffness).ldlt().solve(masses * f);
  GDP_CHECK(
    GDP::process_signal(
      mesh, in, out,
      GDP::parameters::vertex_value_weight_map(alpha).gradient_weight(beta).area_normalization(false).border_condition(
        GDP::Border_condition::ALONG_BORDER))
    == GDP::OK);
  for(Vertex v : mesh.vertices())
    if(mesh.is_border(v))
      GDP_CHECK_NEAR(out[v], expected[int(v)], 1e-12);
}

// What has neither values nor gradients to keep stays to the bit, also where the mean of the rest is set right after
// the solution.
void test_rest_of_component()
{
  Mesh mesh = mesh_of(jittered_square(10));
  auto alpha = mesh.add_property_map<Vertex, double>("v:alpha", 0.).first;
  auto beta = mesh.add_property_map<Face, double>("f:beta", 0.).first;
  auto in = mesh.add_property_map<Vertex, double>("v:in").first;
  auto out = mesh.add_property_map<Vertex, double>("v:out").first;
  for(Vertex v : mesh.vertices())
  {
    in[v] = 1 + std::sin(3. * int(v)) / 3;
    alpha[v] = mesh.point(v).x() < 0.45 ? 1e-9 : 0;
  }
  for(Face f : mesh.faces())
    for(Vertex v : corners(mesh, f))
      if(alpha[v] != 0)
        beta[f] = 1;
  GDP_CHECK(
    GDP::process_signal(mesh, in, out, GDP::parameters::vertex_value_weight_map(alpha).face_gradient_weight_map(beta))
    == GDP::OK);
  int at_rest = 0;
  for(Vertex v : mesh.vertices())
    if(mesh.point(v).x() > 0.7)
    {
      GDP_CHECK(same_bits(out[v], in[v]));
      ++at_rest;
    }
    else if(mesh.point(v).x() < 0.4)
      GDP_CHECK(out[v] != in[v]);
  GDP_CHECK(at_rest > 10);
}

// Two faces of area a under the weight w of their edge: their difference is divided by 1 + 2 beta w / a. By default w =
// 3 in a square, and beta is relative to the area.
void test_two_faces()
{
  for(double size : {1., 7.})
  {
    Mesh mesh = mesh_of(square(1).scaled(size));
    auto signal = mesh.add_property_map<Face, double>("f:signal", 0.).first;
    signal[Face(0)] = 2;
    GDP_CHECK(GDP::process_face_signal(mesh, signal, signal, GDP::parameters::gradient_weight(0.1)) == GDP::OK);
    GDP_CHECK_NEAR(signal[Face(0)] + signal[Face(1)], 2, 1e-14);
    GDP_CHECK_NEAR(signal[Face(0)] - signal[Face(1)], 2 / (1 + 2 * 0.1 * 3 / 0.5), 1e-14);
  }
}

int main()
{
  test_constant_masks();
  test_varying_masks();
  test_brushes();
  test_varying_masks_along_border();
  test_rest_of_component();
  test_two_faces();
  test_masks_of_nothing();
  return GDP_TEST_RESULT();
}
