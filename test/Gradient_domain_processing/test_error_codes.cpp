// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Whatever goes wrong has its code, and leaves mesh and maps as they were.

#include "test_meshes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/smooth.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <vector>

using namespace gdp_test;
namespace GDP = CGAL::Gradient_domain_processing;

typedef CGAL::Simple_cartesian<double> K;
typedef CGAL::Surface_mesh<K::Point_3> Mesh;
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Face_index Face;

namespace {

// Weights that apply to all, in one pack; those of the energy and those of the metric.
struct Weights
{
  double alpha = 1, beta = 1e-3, lambda = 0, eps = 0, gamma = 1e-4;
  int iterations = 1, degree = 2;
  bool restores_volume = false;
};

GDP::Error_code smooth(Mesh& tm, const Weights& w)
{
  return GDP::smooth(tm, GDP::parameters::value_weight(w.alpha).gradient_weight(w.beta).gradient_scale(w.lambda)
    .curvature_weight(w.eps).presmoothing_weight(w.gamma).jet_degree(w.degree).number_of_iterations(w.iterations)
    .restore_volume(w.restores_volume));
}

bool same_bits(const std::vector<Coordinates>& a, const std::vector<Coordinates>& b)
{
  bool same = a.size() == b.size();
  for(std::size_t i = 0; i < a.size() && same; ++i)
    for(int j = 0; j < 3; ++j)
      same = same && (a[i][j] == b[i][j] || (std::isnan(a[i][j]) && std::isnan(b[i][j])));
  return same;
}

void refused(Mesh tm, const Weights& w, GDP::Error_code expected)
{
  const std::vector<Coordinates> before = coordinates(tm);
  const GDP::Error_code code = smooth(tm, w);
  if(!GDP_CHECK(code == expected))
    std::cerr << "  " << GDP::get_error_message(code) << " against " << GDP::get_error_message(expected) << std::endl;
  GDP_CHECK(same_bits(before, coordinates(tm)));
}

void check_meshes()
{
  refused(Mesh(), Weights(), GDP::ERROR_EMPTY_MESH);
  Mesh points;
  points.add_vertex(K::Point_3(0, 0, 0));
  refused(points, Weights(), GDP::ERROR_EMPTY_MESH);

  Mesh quad = built<Mesh>(bumpy_patch(3, 3));
  CGAL::Euler::join_face(quad.halfedge(Vertex(0), Vertex(5)), quad);
  GDP_CHECK(num_faces(quad) == 17);
  refused(quad, Weights(), GDP::ERROR_NON_TRIANGULAR_MESH);

  for(double bad : {double(NAN), HUGE_VAL, -HUGE_VAL, 1e160})
  {
    Mesh tm = built<Mesh>(bumpy_patch(3, 3));
    tm.point(Vertex(5)) = K::Point_3(0, bad, 0);
    refused(tm, Weights(), GDP::ERROR_INVALID_POINT);
  }
}

void check_weights()
{
  const Mesh tm = built<Mesh>(bumpy_patch(3, 3));
  const auto with = [](const std::function<void(Weights&)>& change) { Weights w; change(w); return w; };
  for(double bad : {-1e-9, -1., double(NAN), HUGE_VAL})
  {
    refused(tm, with([&](Weights& w) { w.alpha = bad; }), GDP::ERROR_INVALID_WEIGHT);
    refused(tm, with([&](Weights& w) { w.beta = bad; }), GDP::ERROR_INVALID_WEIGHT);
    refused(tm, with([&](Weights& w) { w.eps = bad; }), GDP::ERROR_INVALID_WEIGHT);
    refused(tm, with([&](Weights& w) { w.eps = 0.1; w.gamma = bad; }), GDP::ERROR_INVALID_WEIGHT);
  }
  refused(tm, with([&](Weights& w) { w.lambda = NAN; }), GDP::ERROR_INVALID_WEIGHT);
  refused(tm, with([&](Weights& w) { w.lambda = HUGE_VAL; }), GDP::ERROR_INVALID_WEIGHT);
  refused(tm, with([&](Weights& w) { w.eps = 0.1; w.degree = 1; }), GDP::ERROR_INVALID_PARAMETER);
  refused(tm, with([&](Weights& w) { w.eps = 0.1; w.degree = 5; }), GDP::ERROR_INVALID_PARAMETER);
  refused(tm, with([&](Weights& w) { w.iterations = -1; }), GDP::ERROR_INVALID_PARAMETER);
  refused(tm, with([&](Weights& w) { w.alpha = 0; }), GDP::ERROR_UNCONSTRAINED);
  refused(tm, with([&](Weights& w) { w.restores_volume = true; }), GDP::ERROR_NO_VOLUME);

  // a negative lambda is no error, nor are weights of zero that hold or move nothing
  Mesh fine = tm;
  GDP_CHECK(smooth(fine, with([&](Weights& w) { w.lambda = -1; })) == GDP::OK);
  fine = tm;
  GDP_CHECK(smooth(fine, with([&](Weights& w) { w.beta = 0; })) == GDP::OK);
  GDP_CHECK(same_bits(coordinates(tm), coordinates(fine)));
  GDP_CHECK(smooth(fine, with([&](Weights& w) { w.beta = 0; w.alpha = 0; })) == GDP::OK);
  GDP_CHECK(same_bits(coordinates(tm), coordinates(fine)));
}

void check_maps()
{
  Mesh tm = built<Mesh>(bumpy_patch(3, 3));
  build(translated(bumpy_patch(3, 3), {{2, 0, 0}}), tm); // a second component
  auto alphas = tm.add_property_map<Vertex, double>("v:alpha", 1.).first;
  auto betas = tm.add_property_map<Face, double>("f:beta", 1e-3).first;
  auto lambdas = tm.add_property_map<Face, double>("f:lambda", 0.).first;
  auto metrics = tm.add_property_map<Face, GDP::Triangle_metric>("f:metric", GDP::Triangle_metric::equilateral(0.3)).first;
  const auto run = [&] {
    Mesh copy = tm;
    const GDP::Error_code code = GDP::smooth(copy, GDP::parameters::vertex_value_weight_map(alphas).face_gradient_weight_map(betas)
      .face_gradient_scale_map(lambdas).face_metric_map(metrics));
    GDP_CHECK((code == GDP::OK) != same_bits(coordinates(tm), coordinates(copy)));
    return code;
  };
  GDP_CHECK(run() == GDP::OK);
  for(double bad : {-1., double(NAN), HUGE_VAL})
  {
    alphas[Vertex(7)] = bad;
    GDP_CHECK(run() == GDP::ERROR_INVALID_WEIGHT);
    alphas[Vertex(7)] = 1;
    betas[Face(7)] = bad;
    GDP_CHECK(run() == GDP::ERROR_INVALID_WEIGHT);
    betas[Face(7)] = 1e-3;
  }
  lambdas[Face(0)] = NAN;
  GDP_CHECK(run() == GDP::ERROR_INVALID_WEIGHT);
  lambdas[Face(0)] = -3;
  GDP_CHECK(run() == GDP::OK);
  for(const GDP::Triangle_metric& bad : {GDP::Triangle_metric(1, 1, 1), GDP::Triangle_metric(-1, 0, -1), GDP::Triangle_metric(1, 2, 1),
                                         GDP::Triangle_metric(1, NAN, 1), GDP::Triangle_metric(HUGE_VAL, 0, 1), GDP::Triangle_metric(0, 0, 0)})
  {
    metrics[Face(5)] = bad;
    GDP_CHECK(run() == GDP::ERROR_INVALID_METRIC);
  }
  metrics[Face(5)] = GDP::Triangle_metric(1, 0.5, 1);
  GDP_CHECK(run() == GDP::OK);

  // one component without a value weight floats; one vertex that is held holds it
  for(Vertex v : vertices(tm))
    if(int(v) >= 16)
      alphas[v] = 0;
  GDP_CHECK(run() == GDP::ERROR_UNCONSTRAINED);
  alphas[Vertex(20)] = 1e-3;
  GDP_CHECK(run() == GDP::OK);
}

struct Cancelling_visitor : GDP::Default_visitor
{
  int calls_left = -1, calls = 0, open = 0;
  std::multiset<std::string> stages;

  void stage_begins(GDP::Stage stage)
  {
    ++open;
    stages.insert(GDP::get_stage_name(stage));
  }
  void stage_ends(GDP::Stage) { --open; }
  bool go_on(double done)
  {
    GDP_CHECK(done >= 0 && done <= 1);
    ++calls;
    return calls_left < 0 || calls_left-- > 0;
  }
};

// Cancelled wherever it may be; every stage that began ends.
void check_cancelling()
{
  const Mesh tm = built<Mesh>(bumpy_sphere(2));
  const auto run = [&](Cancelling_visitor& visitor) {
    Mesh copy = tm;
    const GDP::Error_code code = GDP::smooth(copy, GDP::parameters::visitor(std::ref(visitor)).curvature_weight(0.02).number_of_iterations(2));
    GDP_CHECK((code == GDP::OK) != same_bits(coordinates(tm), coordinates(copy)));
    GDP_CHECK(visitor.open == 0);
    return code;
  };
  Cancelling_visitor patient;
  GDP_CHECK(run(patient) == GDP::OK);
  GDP_CHECK(patient.stages.count("analyze") == 1);
  GDP_CHECK(patient.stages.count("factor") == 4); // presmoothing and filter, twice
  GDP_CHECK(patient.stages.count("curvature") == 2);
  GDP_CHECK(patient.stages.count("write") == 1);
  GDP_CHECK(patient.calls >= 10);
  for(int i = 0; i < patient.calls; ++i)
  {
    Cancelling_visitor visitor;
    visitor.calls_left = i;
    GDP_CHECK(run(visitor) == GDP::ERROR_CANCELLED);
  }
}

// Every code has words of its own.
void check_messages()
{
  std::set<std::string> messages;
  for(int code = GDP::OK; code <= GDP::ERROR_CANCELLED; ++code)
    messages.insert(GDP::get_error_message(code));
  GDP_CHECK(messages.size() == std::size_t(GDP::ERROR_CANCELLED) + 1);
  GDP_CHECK(messages.count(GDP::get_error_message(-1)) == 0);
}

} // namespace

int main()
{
  check_meshes();
  check_weights();
  check_maps();
  check_cancelling();
  check_messages();
  return GDP_TEST_RESULT();
}
