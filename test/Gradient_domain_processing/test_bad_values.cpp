// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Values that cannot be used, and cancelling: the right error code, and nothing changed.

#include "test_shapes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/process_face_signal.h>
#include <CGAL/Gradient_domain_processing/process_signal.h>
#include <CGAL/Gradient_domain_processing/smooth.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace GDP = CGAL::Gradient_domain_processing;
using namespace gdp_test;

typedef GDP::Curvature_metric_kind Kind;
typedef GDP::Curvature_estimator Estimator;

const double nan_value = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity(),
             largest = (std::numeric_limits<double>::max)(), smallest = std::numeric_limits<double>::denorm_min();

// ---- weights, signals and tensors

struct Problem
{
  Mesh mesh;
  Mesh::Property_map<Vertex, double> in, out, alpha;
  Mesh::Property_map<Face, double> beta, lambda;
  Mesh::Property_map<Face, GDP::Triangle_metric> metric;

  Problem()
    : mesh(mesh_of(sphere(4).noisy(0.02)))
    , in(mesh.add_property_map<Vertex, double>("v:in", 0.).first)
    , out(mesh.add_property_map<Vertex, double>("v:out", 17.).first)
    , alpha(mesh.add_property_map<Vertex, double>("v:alpha", 1.).first)
    , beta(mesh.add_property_map<Face, double>("f:beta", 0.01).first)
    , lambda(mesh.add_property_map<Face, double>("f:lambda", 0.).first)
    , metric(mesh.add_property_map<Face, GDP::Triangle_metric>("f:g").first)
  {
    Random random;
    for(Vertex v : mesh.vertices())
      in[v] = random();
    for(Face f : mesh.faces())
    {
      const auto c = corners(mesh, f);
      metric[f] = GDP::Triangle_metric::embedding(vec(mesh.point(c[0])), vec(mesh.point(c[1])), vec(mesh.point(c[2])));
    }
  }

  GDP::Error_code run() const
  {
    return GDP::process_signal(mesh, in, out,
                               GDP::parameters::vertex_value_weight_map(alpha)
                                 .face_gradient_weight_map(beta)
                                 .face_gradient_scale_map(lambda)
                                 .face_metric_map(metric));
  }
  GDP::Error_code run(double a, double b, double l) const
  {
    return GDP::process_signal(mesh, in, out, GDP::parameters::value_weight(a).gradient_weight(b).gradient_scale(l));
  }

  void check_untouched() const
  {
    for(Vertex v : mesh.vertices())
      GDP_CHECK(out[v] == 17);
  }
};

void test_maps()
{
  {
    const Problem problem;
    GDP_CHECK(problem.run() == GDP::OK);
    for(Vertex v : problem.mesh.vertices())
      GDP_CHECK(std::isfinite(problem.out[v]) && problem.out[v] != 17);
  }
  const auto check = [&](GDP::Error_code code, const std::function<void(Problem&, int)>& spoil) {
    for(int where : {0, 7, 65})
    {
      Problem problem;
      spoil(problem, where);
      GDP_CHECK(problem.run() == code);
      problem.check_untouched();
    }
  };
  for(double bad : {nan_value, inf, -inf})
  {
    check(GDP::ERROR_INVALID_SIGNAL, [&](Problem& p, int i) { p.in[Vertex(i)] = bad; });
    check(GDP::ERROR_INVALID_WEIGHT, [&](Problem& p, int i) { p.alpha[Vertex(i)] = bad; });
    check(GDP::ERROR_INVALID_WEIGHT, [&](Problem& p, int i) { p.beta[Face(i)] = bad; });
    check(GDP::ERROR_INVALID_WEIGHT, [&](Problem& p, int i) { p.lambda[Face(i)] = bad; });
    check(GDP::ERROR_INVALID_POINT, [&](Problem& p, int i) { p.mesh.point(Vertex(i)) = Point(0, 1, bad); });
    check(GDP::ERROR_INVALID_POINT, [&](Problem& p, int i) { p.mesh.point(Vertex(i)) = Point(bad, 1, 0); });
    check(GDP::ERROR_INVALID_METRIC, [&](Problem& p, int i) { p.metric[Face(i)] = GDP::Triangle_metric(bad, 0, 1); });
    check(GDP::ERROR_INVALID_METRIC, [&](Problem& p, int i) { p.metric[Face(i)] = GDP::Triangle_metric(1, bad, 1); });
  }
  for(double bad : {-1., -smallest, -largest})
  {
    check(GDP::ERROR_INVALID_WEIGHT, [&](Problem& p, int i) { p.alpha[Vertex(i)] = bad; });
    check(GDP::ERROR_INVALID_WEIGHT, [&](Problem& p, int i) { p.beta[Face(i)] = bad; });
  }
  // indefinite, negative, singular, zero
  for(const GDP::Triangle_metric& bad :
      {GDP::Triangle_metric(1, 2, 1), GDP::Triangle_metric(-1, 0, -1), GDP::Triangle_metric(-1, 0, 1),
       GDP::Triangle_metric(1, 1, 1), GDP::Triangle_metric(0, 0, 0), GDP::Triangle_metric(0, 0, 1)})
    check(GDP::ERROR_INVALID_METRIC, [&](Problem& p, int i) { p.metric[Face(i)] = bad; });

  // a negative lambda is no error: the gradients are turned round
  Problem problem;
  for(Face f : problem.mesh.faces())
    problem.lambda[f] = -1;
  GDP_CHECK(problem.run() == GDP::OK);

  // weights and tensors at the ends of the range: finite, or an error
  for(double w : {smallest, 1e-300, 1e-30, 1e30, 1e300, largest})
  {
    Problem a, b, c;
    a.alpha[Vertex(5)] = w;
    b.beta[Face(5)] = w;
    c.metric[Face(5)] = GDP::Triangle_metric(w, 0, w);
    for(const Problem* p : {&a, &b, &c})
      if(p->run() == GDP::OK)
      {
        for(Vertex v : p->mesh.vertices())
          GDP_CHECK(std::isfinite(p->out[v]) && std::abs(p->out[v]) < 10);
      }
      else
        p->check_untouched();
  }
}

void test_numbers()
{
  const Problem problem;
  for(double bad : {nan_value, inf, -inf, -1., -smallest})
  {
    GDP_CHECK(problem.run(bad, 1, 0) == GDP::ERROR_INVALID_WEIGHT);
    GDP_CHECK(problem.run(1, bad, 0) == GDP::ERROR_INVALID_WEIGHT);
  }
  for(double bad : {nan_value, inf, -inf})
    GDP_CHECK(problem.run(1, 1, bad) == GDP::ERROR_INVALID_WEIGHT);
  GDP_CHECK(problem.run(0, 1, 0) == GDP::ERROR_UNCONSTRAINED);
  problem.check_untouched();
  for(double a : {smallest, 1e-300, 1., 1e300, largest})
    for(double b : {smallest, 1e-300, 1., 1e300, largest})
      for(double l : {0., -largest, largest, 1e-300})
      {
        const Problem p;
        const GDP::Error_code code = p.run(a, b, l);
        if(code == GDP::OK)
        {
          for(Vertex v : p.mesh.vertices())
            GDP_CHECK(std::isfinite(p.out[v]));
        }
        else
          p.check_untouched();
        // nothing is out of the ordinary about equal weights, whatever their size
        if(a == b && (a == 1 || a == 1e300 || a == 1e-300) && l == 0)
        {
          const Problem one;
          GDP_CHECK(one.run(1, 1, 0) == GDP::OK);
          if(GDP_CHECK(code == GDP::OK))
            for(Vertex v : p.mesh.vertices())
              GDP_CHECK_NEAR(p.out[v], one.out[v], 1e-10);
        }
      }

  // messages for every code, and for none
  std::set<std::string> messages;
  for(int code = GDP::OK; code <= GDP::ERROR_CANCELLED; ++code)
    GDP_CHECK(messages.insert(GDP::get_error_message(code)).second);
  GDP_CHECK(messages.insert(GDP::get_error_message(12345)).second);
}

// ---- the mesh

struct Settings
{
  Kind kind = Kind::EDGE_AWARE;
  Estimator estimator = Estimator::JETS;
  int iterations = 1, jet_degree = 2;
  double curvature_weight = 0.02, presmoothing_weight = 1e-4;
};

template <class Visitor>
GDP::Error_code run(Mesh& mesh, const Settings& s, Visitor& visitor)
{
  return GDP::smooth(mesh, GDP::parameters::curvature_metric_kind(s.kind)
                             .curvature_estimator(s.estimator)
                             .number_of_iterations(s.iterations)
                             .jet_degree(s.jet_degree)
                             .curvature_weight(s.curvature_weight)
                             .presmoothing_weight(s.presmoothing_weight)
                             .visitor(std::ref(visitor)));
}

// Counts, and cancels at the call of this number.
struct Visitor : GDP::Default_visitor
{
  int calls = 0, cancel_at = -1, open = 0;
  std::vector<GDP::Stage> begun;
  std::vector<GDP::Stage> at_call;
  GDP::Stage stage = GDP::Stage::READ;
  double part = 0;

  void stage_begins(GDP::Stage s)
  {
    begun.push_back(s);
    stage = s;
    part = 0;
    ++open;
  }
  void stage_ends(GDP::Stage) { --open; }
  bool go_on(double done)
  {
    GDP_CHECK(done >= 0 && done <= 1);
    at_call.push_back(stage);
    return calls++ != cancel_at;
  }
};

void test_meshes_and_options()
{
  const Mesh before = mesh_of(sphere(4).noisy(0.02));
  const auto check = [&](const Settings& s, GDP::Error_code code) {
    Mesh mesh = before;
    Visitor visitor;
    GDP_CHECK(run(mesh, s, visitor) == code);
    GDP_CHECK(same_points(mesh, before) == (code != GDP::OK));
    GDP_CHECK(visitor.open == 0);
  };
  for(int degree : {-3, 0, 1, 5, 1000})
    check({Kind::EDGE_AWARE, Estimator::JETS, 1, degree}, GDP::ERROR_INVALID_PARAMETER);
  for(int degree : {2, 3, 4})
    check({Kind::EDGE_AWARE, Estimator::JETS, 1, degree}, GDP::OK);
  for(Estimator estimator : {Estimator::JETS, Estimator::NORMALS})
    for(double bad : {nan_value, inf, -1.})
    {
      check({Kind::EDGE_AWARE, estimator, 1, 2, bad}, GDP::ERROR_INVALID_WEIGHT);
      check({Kind::EDGE_AWARE, estimator, 1, 2, 0.02, bad}, GDP::ERROR_INVALID_WEIGHT);
    }
  check({Kind::EDGE_AWARE, Estimator::JETS, -1}, GDP::ERROR_INVALID_PARAMETER);
  check({Kind::EDGE_AWARE, Estimator::JETS, 3}, GDP::OK);
  {
    Mesh mesh = before;
    Visitor visitor;
    GDP_CHECK(run(mesh, {Kind::EDGE_AWARE, Estimator::JETS, 0}, visitor) == GDP::OK); // no pass
    GDP_CHECK(same_points(mesh, before));
  }

  // no faces; a face that is not a triangle
  Visitor visitor;
  Mesh empty;
  GDP_CHECK(run(empty, Settings(), visitor) == GDP::ERROR_EMPTY_MESH);
  empty.add_vertex(Point(nan_value, 0, 0));
  GDP_CHECK(run(empty, Settings(), visitor) == GDP::ERROR_EMPTY_MESH);
  Mesh quad = before;
  const auto a = quad.add_vertex(Point(5, 0, 0)), b = quad.add_vertex(Point(6, 0, 0)),
             c = quad.add_vertex(Point(6, 1, 0)), d = quad.add_vertex(Point(5, 1, 0));
  quad.add_face(a, b, c, d);
  Mesh copy = quad;
  GDP_CHECK(run(copy, Settings(), visitor) == GDP::OK); // polygons take part
  GDP_CHECK(!same_points(copy, quad));
  const auto metric = quad.add_property_map<Face, GDP::Triangle_metric>("f:metric").first;
  copy = quad;
  GDP_CHECK(GDP::smooth(copy, GDP::parameters::face_metric_map(metric)) == GDP::ERROR_NON_TRIANGULAR_MESH);
  GDP_CHECK(same_points(copy, quad));

  // a vertex without a face is left alone, whatever its point is
  Mesh lonely = before;
  const Vertex alone = lonely.add_vertex(Point(0, nan_value, 0));
  copy = lonely;
  Mesh without = before;
  GDP_CHECK(run(copy, Settings(), visitor) == GDP::OK && run(without, Settings(), visitor) == GDP::OK);
  GDP_CHECK(std::isnan(copy.point(alone).y()) && copy.point(alone).x() == 0);
  for(Vertex v : without.vertices())
    GDP_CHECK((copy.point(v) - without.point(v)).squared_length() < 1e-24);
}

// ---- whom an error is about

struct Blaming_visitor : GDP::Default_visitor
{
  std::vector<std::pair<GDP::Error_code, std::size_t> > vertices, faces;

  void invalid_vertex(GDP::Error_code code, Vertex v) { vertices.emplace_back(code, v); }
  void invalid_face(GDP::Error_code code, Face f) { faces.emplace_back(code, f); }

  // One element was blamed, and it is among these.
  bool takes(GDP::Error_code code, const char* kind, const std::vector<std::size_t>& guilty)
  {
    const auto& blamed = *kind == 'v' ? vertices : faces;
    const bool holds = vertices.size() + faces.size() == 1 && blamed.size() == 1 && blamed[0].first == code
                    && std::find(guilty.begin(), guilty.end(), blamed[0].second) != guilty.end();
    vertices.clear();
    faces.clear();
    return holds;
  }
};

void test_blame()
{
  Problem p;
  Blaming_visitor visitor;
  const auto solver = [&] {
    return GDP::make_gradient_domain_solver(p.mesh, GDP::parameters::vertex_value_weight_map(p.alpha)
                                                      .face_gradient_weight_map(p.beta)
                                                      .face_gradient_scale_map(p.lambda)
                                                      .visitor(std::ref(visitor)));
  };
  const Vertex v(7), later(20);
  const Face f(5);
  std::vector<std::size_t> all(p.mesh.number_of_faces());
  std::iota(all.begin(), all.end(), std::size_t(0));

  p.alpha[v] = p.alpha[later] = -1;
  GDP_CHECK(solver().error() == GDP::ERROR_INVALID_WEIGHT
            && visitor.takes(GDP::ERROR_INVALID_WEIGHT, "vertex", {v, later}));
  p.alpha[v] = p.alpha[later] = 1;
  p.beta[f] = nan_value;
  GDP_CHECK(solver().error() == GDP::ERROR_INVALID_WEIGHT && visitor.takes(GDP::ERROR_INVALID_WEIGHT, "face", {f}));
  p.beta[f] = 1;
  p.lambda[f] = inf;
  GDP_CHECK(solver().error() == GDP::ERROR_INVALID_WEIGHT && visitor.takes(GDP::ERROR_INVALID_WEIGHT, "face", {f}));
  p.lambda[f] = 0;

  auto good = solver();
  GDP_CHECK(good.error() == GDP::OK);
  p.in[v] = p.in[later] = nan_value;
  GDP_CHECK(good.filter(p.in, p.out) == GDP::ERROR_INVALID_SIGNAL
            && visitor.takes(GDP::ERROR_INVALID_SIGNAL, "vertex", {v, later}));
  const auto flat = [](double, double) { return std::make_pair(1., 0.); };
  GDP_CHECK(good.set_metric_from_parameters(GDP::parameters::curvature_metric_kind(flat)) == GDP::ERROR_INVALID_METRIC);
  GDP_CHECK(visitor.takes(GDP::ERROR_INVALID_METRIC, "face", all));
  p.metric[f] = GDP::Triangle_metric(1, 2, 1);
  GDP_CHECK(good.set_metric(p.metric) == GDP::ERROR_INVALID_METRIC
            && visitor.takes(GDP::ERROR_INVALID_METRIC, "face", {f}));

  const std::vector<double> large(p.mesh.number_of_faces(), 1e39);
  std::vector<float> narrow(large.size());
  GDP_CHECK(GDP::process_face_signal(p.mesh, CGAL::make_property_map(large), CGAL::make_property_map(narrow),
                                     GDP::parameters::visitor(std::ref(visitor))) == GDP::ERROR_RESULT_OUT_OF_RANGE);
  GDP_CHECK(visitor.takes(GDP::ERROR_RESULT_OUT_OF_RANGE, "face", all));

  const Point point = p.mesh.point(v);
  p.mesh.point(v) = p.mesh.point(later) = Point(0, 1e151, 0);
  GDP_CHECK(solver().error() == GDP::ERROR_INVALID_POINT
            && visitor.takes(GDP::ERROR_INVALID_POINT, "vertex", {v, later}));
  p.mesh.point(v) = point;
  GDP_CHECK(solver().error() == GDP::ERROR_INVALID_POINT
            && visitor.takes(GDP::ERROR_INVALID_POINT, "vertex", {later}));
  p.mesh.point(later) = point;
  const auto a = p.mesh.add_vertex(point), b = p.mesh.add_vertex(point), c = p.mesh.add_vertex(point),
             d = p.mesh.add_vertex(point);
  p.mesh.add_face(a, b, c, d); // a polygon shrunk to a point
  GDP_CHECK(solver().error() == GDP::OK);
  p.mesh.point(d) = Point(0, nan_value, 0);
  GDP_CHECK(solver().error() == GDP::ERROR_INVALID_POINT && visitor.takes(GDP::ERROR_INVALID_POINT, "vertex", {d}));
  p.mesh.point(d) = point;
  p.check_untouched();
}

// ---- cancelling

void test_cancelling()
{
  // enough vertices for progress within the curvature
  const Mesh before = mesh_of(ellipsoid(30, Vec(1, 0.8, 0.6)).noisy(0.005));
  for(Estimator estimator : {Estimator::JETS, Estimator::NORMALS})
  {
    const Settings settings = {Kind::ANISOTROPIC, estimator, 2};
    Mesh expected = before;
    Visitor counter;
    GDP_CHECK(run(expected, settings, counter) == GDP::OK);
    GDP_CHECK(counter.open == 0);
    std::set<GDP::Stage> stages(counter.begun.begin(), counter.begun.end());
    GDP_CHECK(stages.size() == 8); // each of them occurs
    int in_curvature = 0;
    for(GDP::Stage s : counter.at_call)
      in_curvature += s == GDP::Stage::CURVATURE;
    GDP_CHECK(estimator == Estimator::NORMALS || in_curvature >= 4);
    std::cout << counter.begun.size() << " stages, may be cancelled at " << counter.calls << " places, " << in_curvature
              << " of them in the curvature loop" << std::endl;

    for(int at = 0; at < counter.calls; ++at)
    {
      Mesh mesh = before;
      Visitor visitor;
      visitor.cancel_at = at;
      GDP_CHECK(run(mesh, settings, visitor) == GDP::ERROR_CANCELLED);
      GDP_CHECK(same_points(mesh, before));
      GDP_CHECK(visitor.calls == at + 1); // it is not asked again
      GDP_CHECK(visitor.open == 0);
    }
    Mesh mesh = before;
    Visitor visitor;
    GDP_CHECK(run(mesh, settings, visitor) == GDP::OK);
    GDP_CHECK(same_points(mesh, expected));
  }
}

int main()
{
  test_maps();
  test_numbers();
  test_meshes_and_options();
  test_blame();
  test_cancelling();
  return GDP_TEST_RESULT();
}
