// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What is promised of solvers: one owner of a factorization, everything as it was after an error or an exception,
// progress that only grows, elements of the mesh that are checked.

#include "test_shapes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/enhance_details.h>
#include <CGAL/Gradient_domain_processing/estimate_curvatures.h>
#include <CGAL/Gradient_domain_processing/process_signal.h>
#include <CGAL/Gradient_domain_processing/smooth.h>

#include <CGAL/property_map.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

using namespace gdp_test;
namespace GDP = CGAL::Gradient_domain_processing;

namespace {

typedef GDP::Gradient_domain_solver<Mesh> Solver;
static_assert(!std::is_copy_constructible<Solver>::value && !std::is_copy_assignable<Solver>::value,
              "a factorization has one owner");
static_assert(std::is_move_constructible<Solver>::value && std::is_move_assignable<Solver>::value, "which may change");

struct Field
{
  Mesh mesh = mesh_of(sphere(6).noisy(0.02));
  std::vector<double> in;

  Field()
  {
    for(Vertex v : mesh.vertices())
      in.push_back(mesh.point(v).x() * mesh.point(v).y());
  }

  template <class S>
  std::vector<double> filtered(S& solver) const
  {
    std::vector<double> out(in.size(), 17);
    GDP_CHECK(solver.filter(CGAL::make_property_map(in), CGAL::make_property_map(out)) == GDP::ok);
    return out;
  }
  template <class NamedParameters>
  std::vector<double> fresh(const NamedParameters& np) const
  {
    auto solver = GDP::make_gradient_domain_solver(mesh, np);
    return filtered(solver);
  }
};

double largest_difference(const std::vector<double>& a, const std::vector<double>& b)
{
  double most = 0;
  for(std::size_t i = 0; i < a.size(); ++i)
    most = (std::max)(most, std::abs(a[i] - b[i]));
  return most;
}

// Two solvers that were given the same linear solver each answer with their own matrix.
template <class Traits>
void test_shared_linear_solver()
{
  const Field field;
  Traits traits;
  const auto np = GDP::parameters::sparse_linear_solver(traits);
  const auto weak = field.fresh(GDP::parameters::gradient_weight(1e-4)),
             strong = field.fresh(GDP::parameters::gradient_weight(1e-1));
  GDP_CHECK(largest_difference(weak, strong) > 1e-2);
  auto a = GDP::make_gradient_domain_solver(field.mesh, np.gradient_weight(1e-4));
  auto b = GDP::make_gradient_domain_solver(field.mesh, np.gradient_weight(1e-1));
  GDP_CHECK(largest_difference(field.filtered(a), weak) < 1e-9);
  GDP_CHECK(largest_difference(field.filtered(b), strong) < 1e-9);
  GDP_CHECK(largest_difference(field.filtered(a), weak) < 1e-9);
  auto moved = std::move(a);
  GDP_CHECK(b.set_gradient_weight(1e-4) == GDP::ok && moved.set_gradient_weight(1e-1) == GDP::ok);
  GDP_CHECK(largest_difference(field.filtered(b), weak) < 1e-9
            && largest_difference(field.filtered(moved), strong) < 1e-9);
}

struct Throwing_visitor : GDP::Default_visitor
{
  int calls = 0, throws_at = -1;
  bool throws_at_end = false;

  bool go_on(double)
  {
    if(++calls == throws_at)
      throw std::runtime_error("go_on");
    return true;
  }
  void stage_ends(GDP::Stage)
  {
    if(throws_at_end && calls >= throws_at)
      throw std::runtime_error("stage_ends");
  }
};

// After an error or an exception metric and weights are those of before.
void test_failed_metrics()
{
  const Field field;
  const auto np = GDP::parameters::gradient_weight(1e-2).curvature_weight(0.05);
  const auto expected = field.fresh(np);
  GDP_CHECK(largest_difference(expected, field.fresh(GDP::parameters::gradient_weight(1e-2))) > 1e-3);
  for(GDP::Curvature_estimator estimator : {GDP::Curvature_estimator::JETS, GDP::Curvature_estimator::NORMALS})
  {
    Throwing_visitor visitor;
    auto solver = GDP::make_gradient_domain_solver(field.mesh, np.visitor(std::ref(visitor)));
    const auto bad = [](double, double) { return std::make_pair(-1., 1.); };
    const auto angry = [](double, double) -> std::pair<double, double> { throw std::runtime_error("functor"); };
    const auto with = GDP::parameters::curvature_estimator(estimator).presmoothing_weight(1e-3);
    GDP_CHECK(solver.set_metric_from_parameters(with.curvature_metric_kind(bad)) == GDP::error_invalid_metric);
    GDP_CHECK(largest_difference(field.filtered(solver), expected) < 1e-12);
    bool has_thrown = false;
    try { (void)solver.set_metric_from_parameters(with.curvature_metric_kind(angry)); }
    catch(const std::runtime_error&) { has_thrown = true; }
    GDP_CHECK(has_thrown);
    GDP_CHECK(largest_difference(field.filtered(solver), expected) < 1e-12);
    for(int at = 1; at < 12; ++at)
    {
      visitor.throws_at = visitor.calls + at;
      visitor.throws_at_end = at % 2;
      try { (void)solver.set_metric_from_parameters(with.curvature_weight(0.5)); }
      catch(const std::runtime_error&)
      {
        visitor.throws_at = -1;
        visitor.throws_at_end = false;
        GDP_CHECK(largest_difference(field.filtered(solver), expected) < 1e-12);
      }
      visitor.throws_at = -1;
      visitor.throws_at_end = false;
      GDP_CHECK(solver.set_metric_from_parameters(np) == GDP::ok);
    }
  }
}

// Nor does an exception while missing values are filled in, or after, leave anything of what that needs.
void test_failed_filling()
{
  const Field field;
  const auto np = GDP::parameters::gradient_weight(1e-2).gradient_scale(2.).missing_values(true);
  const auto expected = field.fresh(np);
  std::vector<double> with_hole = field.in, out(field.in.size());
  with_hole[20] = std::numeric_limits<double>::quiet_NaN();
  int exceptions = 0;
  for(int at = 1; at < 30; ++at)
  {
    Throwing_visitor visitor;
    auto solver = GDP::make_gradient_domain_solver(field.mesh, np.visitor(std::ref(visitor)));
    visitor.throws_at = visitor.calls + at;
    try { GDP_CHECK(solver.filter(CGAL::make_property_map(with_hole), CGAL::make_property_map(out)) == GDP::ok); }
    catch(const std::runtime_error&) { ++exceptions; }
    visitor.throws_at = -1;
    GDP_CHECK(largest_difference(field.filtered(solver), expected) < 1e-12);
  }
  GDP_CHECK(exceptions > 5);
}

// Constraints and weights set anew are those of a new solver.
void test_new_constraints()
{
  const Field field;
  std::vector<char> first(field.in.size(), 0), second(field.in.size(), 0);
  for(std::size_t v = 0; v < first.size(); ++v)
  {
    first[v] = v % 5 == 0;
    second[v] = v % 7 == 1;
  }
  std::vector<double> alpha(field.in.size());
  for(std::size_t v = 0; v < alpha.size(); ++v)
    alpha[v] = 1 + double(v % 3);
  const auto np = GDP::parameters::gradient_weight(1e-2);
  const auto with_second = np.vertex_is_constrained_map(CGAL::make_property_map(second))
                             .vertex_value_weight_map(CGAL::make_property_map(alpha));
  auto solver =
    GDP::make_gradient_domain_solver(field.mesh, np.vertex_is_constrained_map(CGAL::make_property_map(first)));
  const auto before = field.filtered(solver);
  GDP_CHECK(solver.set_constraints_from_parameters(with_second) == GDP::ok
            && solver.set_weights_from_parameters(with_second) == GDP::ok);
  GDP_CHECK(largest_difference(field.filtered(solver), field.fresh(with_second)) < 1e-12);
  GDP_CHECK(largest_difference(field.filtered(solver), before) > 1e-3);
  alpha[9] = -1;
  GDP_CHECK(solver.set_weights_from_parameters(with_second) == GDP::error_invalid_weight);
  alpha[9] = 1;
  GDP_CHECK(largest_difference(field.filtered(solver), field.fresh(with_second)) < 1e-12);
}

struct Recording_visitor : GDP::Default_visitor
{
  std::vector<double> parts;
  std::vector<std::string> notices;
  std::vector<Vertex> invalid;
  bool go_on(double part)
  {
    parts.push_back(part);
    return true;
  }
  void notice(const std::string& sentence) { notices.push_back(sentence); }
  void invalid_vertex(GDP::Error_code, Vertex v) { invalid.push_back(v); }
};

void test_progress()
{
  for(int iterations : {1, 3})
    for(double epsilon : {0., 0.05})
    {
      Mesh mesh = mesh_of(sphere(30));
      Recording_visitor visitor;
      GDP_CHECK(
        GDP::smooth(
          mesh, GDP::parameters::number_of_iterations(iterations).curvature_weight(epsilon).visitor(std::ref(visitor)))
        == GDP::ok);
      GDP_CHECK(std::is_sorted(visitor.parts.begin(), visitor.parts.end()));
      GDP_CHECK(visitor.parts.front() == 0 && visitor.parts.back() <= 1);
      GDP_CHECK(visitor.parts.back() > 0.4 && visitor.parts.size() > 8);
      GDP_CHECK(visitor.notices.empty());
      GDP_CHECK(GDP::smooth(mesh, GDP::parameters::gradient_scale(1.).visitor(std::ref(visitor))) == GDP::ok);
      GDP_CHECK(visitor.notices.size() == 1); // nothing moved
    }
}

// Faces that are none of the mesh, and an index map that nobody filled.
void test_elements()
{
  Mesh mesh = mesh_of(square(4));
  const Face removed = *mesh.faces().begin();
  CGAL::Euler::remove_face(mesh.halfedge(removed), mesh);
  const Mesh before = mesh;
  for(Face bad : {removed, Mesh::null_face(), Face(12345)})
  {
    GDP_CHECK(GDP::smooth(std::vector<Face>{Face(3), bad}, mesh) == GDP::error_invalid_region);
    GDP_CHECK(same_points(mesh, before));
  }
  const auto empty_map = mesh.add_property_map<Vertex, std::size_t>("v:nothing", std::size_t(-1)).first;
  const auto constant_map = mesh.add_property_map<Vertex, std::size_t>("v:constant", std::size_t(3)).first;
  const auto large_map = mesh.add_property_map<Vertex, std::size_t>("v:large", std::size_t(1) << 33).first;
  for(const auto& map : {empty_map, constant_map, large_map}) // nothing of that size is allocated
    GDP_CHECK(GDP::smooth(mesh, GDP::parameters::vertex_index_map(map)) == GDP::error_invalid_index);
  GDP_CHECK(same_points(mesh, before));
}

// The whole mesh's area counts for a region, all of every polygon outside of it too.
void test_area_of_polygons()
{
  Mesh triangles = mesh_of(square(6)), quads;
  for(Vertex v : triangles.vertices())
    quads.add_vertex(triangles.point(v));
  std::vector<Face> region;
  for(Face f : triangles.faces())
  {
    const auto c = corners(triangles, f);
    double most = 0;
    for(Vertex v : c)
      most = (std::max)(most, triangles.point(v).x());
    if(most < 0.6)
    {
      region.push_back(f);
      quads.add_face(c[0], c[1], c[2]);
    }
  }
  std::vector<Face> same(quads.faces().begin(), quads.faces().end());
  for(int i = 0; i < 6; ++i)
    for(int j = 0; j < 6; ++j)
      if((i + 1) / 6. > 0.6)
      {
        const auto at = [&](int a, int b) { return Vertex(a * 7 + b); };
        GDP_CHECK(quads.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)) != Mesh::null_face());
      }
  for(Mesh* mesh : {&triangles, &quads})
    for(Vertex v : mesh->vertices())
      if(mesh->point(v).x() < 0.6)
        mesh->point(v) = mesh->point(v) + Vector(0, 0, 0.01 * std::sin(40. * int(v)));
  GDP_CHECK(GDP::smooth(region, triangles, GDP::parameters::gradient_weight(1e-3)) == GDP::ok);
  GDP_CHECK(GDP::smooth(same, quads, GDP::parameters::gradient_weight(1e-3)) == GDP::ok);
  GDP_CHECK(distance(triangles, quads) < 1e-4); // with half of the quads missing it is 1e-3
}

// The second pass has a metric of its own, whatever was named for the first.
void test_metric_of_second_pass()
{
  const Shape shape = sphere(10).noisy(0.02);
  const auto run = [&](const auto& np) {
    Mesh mesh = mesh_of(shape);
    GDP_CHECK(GDP::enhance_details(mesh, np) == GDP::ok);
    return mesh;
  };
  Mesh mesh = mesh_of(shape);
  const auto metric =
    mesh.add_property_map<Face, GDP::Triangle_metric>("f:metric", GDP::Triangle_metric::equilateral(0.2)).first;
  const auto np = GDP::parameters::face_metric_map(metric).sharpening_weight(1e-3);
  const Mesh plain = run(np), anisotropic = run(np.sharpening_metric_kind(GDP::Curvature_metric_kind::ANISOTROPIC));
  GDP_CHECK(distance(plain, anisotropic) > 1e-3);
}

void test_overflow()
{
  typedef CGAL::Simple_cartesian<float> Narrow;
  typedef GDP::Principal_curvatures_and_directions<Narrow> Curvature;
  const Mesh mesh = mesh_of(sphere(5).scaled(1e-60));
  const Curvature untouched = {17, 17, Narrow::Vector_3(1, 0, 0), Narrow::Vector_3(0, 1, 0)};
  std::vector<Curvature> curvatures(mesh.number_of_vertices(), untouched);
  GDP_CHECK(GDP::estimate_curvatures(mesh, CGAL::make_property_map(curvatures)) == GDP::error_result_out_of_range);
  for(const Curvature& k : curvatures)
    GDP_CHECK(k.min_curvature == 17 && k.max_curvature == 17);

  // a value that does not fit is blamed on its vertex
  Recording_visitor visitor;
  std::vector<double> in(mesh.number_of_vertices(), 1.);
  std::vector<float> out(mesh.number_of_vertices(), 17.f);
  in[7] = 1e300;
  GDP_CHECK(GDP::process_signal(mesh, CGAL::make_property_map(in), CGAL::make_property_map(out),
                                GDP::parameters::gradient_weight(0).visitor(std::ref(visitor)))
            == GDP::error_result_out_of_range);
  GDP_CHECK(visitor.invalid == std::vector<Vertex>{Vertex(7)});
  GDP_CHECK(out == std::vector<float>(mesh.number_of_vertices(), 17.f));
}

} // namespace

int main()
{
  test_shared_linear_solver<GDP::Default_sparse_linear_solver>();
  test_shared_linear_solver<CGAL::Eigen_solver_traits<Eigen::SimplicialLLT<Eigen::SparseMatrix<double> > > >();
  test_failed_metrics();
  test_failed_filling();
  test_new_constraints();
  test_progress();
  test_elements();
  test_area_of_polygons();
  test_metric_of_second_pass();
  test_overflow();
  return GDP_TEST_RESULT();
}
