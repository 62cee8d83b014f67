// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Times the parts of the package inside one process, each against what it is to be compared with, and writes a JSON
// object a line.
//
//   benchmark_parts make-scan INPUT OUTPUT VERTICES      remeshed to about so many vertices, as irregular as a scan's
//   benchmark_parts subdivide INPUT OUTPUT TIMES         by Loop's scheme, for meshes that are too large to remesh
//   benchmark_parts solver|assembly|curvature|reuse|region|threads MESH [REPETITIONS]
//
// Two things that are compared take turns; the numbers are medians.

#include <CGAL/Gradient_domain_processing.h>
#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/subdivision_method_3.h>

#include <Eigen/SparseCholesky>
#ifdef BENCHMARK_WITH_MKL
#include <Eigen/PardisoSupport>
#endif

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace GDP = CGAL::Gradient_domain_processing;
namespace PMP = CGAL::Polygon_mesh_processing;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Eigen_solver_traits<Eigen::SimplicialLLT<Eigen::SparseMatrix<double> > > Eigen_solver;

double seconds(const std::function<void()>& work)
{
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double median(std::vector<double> times)
{
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

void print(const std::string& benchmark, const Mesh& mesh, const std::map<std::string, double>& numbers)
{
  std::cout << "{\"benchmark\": \"" << benchmark << "\", \"vertices\": " << mesh.number_of_vertices();
  for(const auto& number : numbers)
    std::cout << ", \"" << number.first << "\": " << number.second;
  std::cout << "}" << std::endl;
}

// Named pieces of work, in turns.
std::map<std::string, double> in_turns(int repetitions,
                                       const std::vector<std::pair<std::string, std::function<void()> > >& works)
{
  std::map<std::string, std::vector<double> > times;
  for(int i = 0; i < repetitions; ++i)
    for(const auto& work : works)
      times[work.first].push_back(seconds(work.second));
  std::map<std::string, double> medians;
  for(const auto& t : times)
    medians[t.first] = median(t.second);
  return medians;
}

struct Stage_times : GDP::Default_visitor
{
  std::map<std::string, double> sums;
  std::chrono::steady_clock::time_point begin;

  void stage_begins(GDP::Stage) { begin = std::chrono::steady_clock::now(); }
  void stage_ends(GDP::Stage stage)
  {
    sums[GDP::get_stage_name(stage)] += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
};

void require(GDP::Error_code code)
{
  if(code == GDP::OK)
    return;
  std::cerr << GDP::get_error_message(code) << std::endl;
  std::exit(EXIT_FAILURE);
}

// Tables 1 and 2 of the paper: the stages of smoothing, with our default solver, with Eigen's and with MKL's.
void benchmark_solver(const Mesh& mesh, int repetitions)
{
  const auto run = [&](const std::string& name, auto solver) {
    std::map<std::string, std::vector<double> > times;
    for(int i = 0; i < repetitions; ++i)
    {
      Mesh copy = mesh;
      Stage_times stages;
      times["total"].push_back(seconds([&] {
        require(GDP::smooth(copy, GDP::parameters::visitor(std::ref(stages)).sparse_linear_solver(solver())));
      }));
      for(const auto& stage : stages.sums)
        times[stage.first].push_back(stage.second);
    }
    std::map<std::string, double> medians;
    for(const auto& t : times)
      medians[t.first] = median(t.second);
    print(name, mesh, medians);
  };
#ifdef BENCHMARK_WITH_MKL
  run("solver_mkl",
      [] { return CGAL::Eigen_solver_traits<Eigen::PardisoLLT<Eigen::SparseMatrix<double>, Eigen::Lower> >(); });
#else
  run("solver_default", [] { return GDP::Default_sparse_linear_solver(); });
  run("solver_eigen", [] { return Eigen_solver(); });
#endif
}

void benchmark_assembly(const Mesh& mesh, int repetitions)
{
  Eigen::SparseMatrix<double> matrix;
  const auto by_triplets = [&] {
    std::vector<Eigen::Triplet<double> > triplets;
    triplets.reserve(9 * mesh.number_of_faces());
    for(Mesh::Face_index f : mesh.faces())
    {
      const Mesh::Halfedge_index h = mesh.halfedge(f);
      const Mesh::Vertex_index v[3] = {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
      const Kernel::Point_3 p[3] = {mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2])};
      const double area = std::sqrt(CGAL::squared_area(p[0], p[1], p[2]));
      for(int i = 0; i < 3; ++i)
      {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const double half_cotangent = (p[i] - p[k]) * (p[j] - p[k]) / (4 * area);
        triplets.emplace_back(int(v[i]), int(v[j]), area / 12 - 1e-4 * half_cotangent);
        triplets.emplace_back(int(v[j]), int(v[i]), area / 12 - 1e-4 * half_cotangent);
        triplets.emplace_back(int(v[i]), int(v[i]), area / 12 + 1e-4 * half_cotangent);
        triplets.emplace_back(int(v[j]), int(v[j]), area / 12 + 1e-4 * half_cotangent);
      }
    }
    matrix.resize(int(mesh.number_of_vertices()), int(mesh.number_of_vertices()));
    matrix.setFromTriplets(triplets.begin(), triplets.end());
  };
  // a prepared system, as the solver keeps it: what a new metric or weight costs before the factorization
  auto solver = GDP::make_gradient_domain_solver(mesh);
  require(solver.factorize());
  const auto& system = solver.arrays().system;
  GDP::internal::Sparse_matrix filled;
  GDP::internal::set_pattern(
    GDP::internal::sparsity_pattern(system.mesh.one_rings(true), system.degrees_of_freedom(), true, true), true,
    filled);
  const auto refill = [&](bool parallel) {
    GDP::internal::assemble(system.mesh, GDP::internal::Triangle_metrics(), system.weights(),
                            system.degrees_of_freedom(), parallel, filled);
  };
  print("assembly", mesh, in_turns(repetitions, {{"triplets", by_triplets},
                                                 {"sequential", [&] { refill(false); }},
                                                 {"parallel", [&] { refill(true); }}}));
}

void benchmark_curvature(const Mesh& mesh, int repetitions)
{
  typedef GDP::Principal_curvatures_and_directions<Kernel> Curvature;
  Mesh copy = mesh;
  auto curvatures = copy.add_property_map<Mesh::Vertex_index, Curvature>("v:curvature").first;
  const auto ours = [&](auto tag) {
    require(GDP::estimate_curvatures(copy, curvatures, GDP::parameters::concurrency_tag(tag)));
  };
  const auto plain = [&] { // two rings and CGAL's default solver
    CGAL::Monge_via_jet_fitting<Kernel> fit;
    std::vector<Kernel::Point_3> points;
    std::vector<Mesh::Vertex_index> ring, found;
    for(Mesh::Vertex_index v : copy.vertices())
    {
      found.assign(1, v);
      for(int r = 0; r < 2; ++r)
      {
        ring = found;
        for(Mesh::Vertex_index w : ring)
          for(Mesh::Vertex_index u : copy.vertices_around_target(copy.halfedge(w)))
            if(std::find(found.begin(), found.end(), u) == found.end())
              found.push_back(u);
      }
      points.clear();
      for(Mesh::Vertex_index w : found)
        points.push_back(copy.point(w));
      if(points.size() >= 6)
        fit(points.begin(), points.end(), 2, 2);
    }
  };
  auto numbers = in_turns(repetitions, {{"sequential", [&] { ours(CGAL::Sequential_tag()); }},
                                        {"parallel", [&] { ours(CGAL::Parallel_if_available_tag()); }},
                                        {"plain_loop", plain}});
  numbers["sequential_us_per_vertex"] = 1e6 * numbers["sequential"] / double(mesh.number_of_vertices());
  print("curvature", mesh, numbers);
}

void benchmark_reuse(const Mesh& mesh, int repetitions)
{
  Mesh copy = mesh;
  auto result = copy.add_property_map<Mesh::Vertex_index, Kernel::Point_3>("v:result").first;
  std::map<std::string, std::vector<double> > times;
  for(int i = 0; i < repetitions; ++i)
  {
    times["first"].push_back(seconds([&] {
      auto solver = GDP::make_gradient_domain_solver(copy);
      require(solver.filter(copy.points(), result));
      times["new_scale"].push_back(seconds([&] {
        require(solver.set_gradient_scale(2));
        require(solver.filter(copy.points(), result));
      }));
      times["new_weight"].push_back(seconds([&] {
        require(solver.set_gradient_weight(1e-3));
        require(solver.filter(copy.points(), result));
      }));
    }));
    times["first"].back() -= times["new_scale"].back() + times["new_weight"].back();
  }
  std::map<std::string, double> medians;
  for(const auto& t : times)
    medians[t.first] = median(t.second);
  print("reuse", mesh, medians);
}

// One percent of the faces, around the first.
void benchmark_region(const Mesh& mesh, int repetitions)
{
  std::vector<Mesh::Face_index> region(1, *mesh.faces().begin());
  std::vector<char> is_inside(mesh.number_of_faces(), 0);
  is_inside[region[0]] = 1;
  for(std::size_t i = 0; i < region.size() && region.size() < mesh.number_of_faces() / 100; ++i)
    for(Mesh::Face_index f : mesh.faces_around_face(mesh.halfedge(region[i])))
      if(f != Mesh::null_face() && !is_inside[f])
      {
        is_inside[f] = 1;
        region.push_back(f);
      }
  Mesh copy = mesh;
  print("region", mesh, in_turns(repetitions, {{"whole", [&] { require(GDP::smooth(copy)); }},
                                               {"one_percent", [&] { require(GDP::smooth(region, copy)); }}}));
}

// Curvature, metric and assembly with one thread and with all.
void benchmark_threads(const Mesh& mesh, int repetitions)
{
  const auto run = [&](auto tag, const std::string& name) {
    std::map<std::string, std::vector<double> > times;
    for(int i = 0; i < repetitions; ++i)
    {
      Mesh copy = mesh;
      Stage_times stages;
      require(
        GDP::smooth(copy, GDP::parameters::visitor(std::ref(stages)).concurrency_tag(tag).curvature_weight(0.01)));
      for(const auto& stage : stages.sums)
        times[stage.first].push_back(stage.second);
    }
    std::map<std::string, double> medians;
    for(const auto& t : times)
      medians[t.first] = median(t.second);
    print(name, mesh, medians);
  };
  run(CGAL::Sequential_tag(), "threads_sequential");
  run(CGAL::Parallel_if_available_tag(), "threads_parallel");
}

// Remeshing leaves about a sixth more vertices than a tiling by equilateral triangles of the target length has.
void make_scan(Mesh& mesh, double vertices)
{
  const double length = std::sqrt(1.16 * PMP::area(mesh) / vertices * 2 / std::sqrt(3.));
  PMP::isotropic_remeshing(mesh.faces(), length, mesh, CGAL::parameters::number_of_iterations(3));
  mesh.collect_garbage();
}

void subdivide(Mesh& mesh, double times)
{
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(unsigned(times)));
}

// Gaussian noise of 0.2 mean edge lengths along the normals, always the same.
void add_noise(Mesh& mesh)
{
  auto normals = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
  PMP::compute_vertex_normals(mesh, normals);
  double length = 0;
  for(Mesh::Edge_index e : mesh.edges())
    length += PMP::edge_length(e, mesh) / double(mesh.number_of_edges());
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0, 0.2 * length);
  for(Mesh::Vertex_index v : mesh.vertices())
    mesh.point(v) = mesh.point(v) + normal(random) * normals[v];
  mesh.remove_property_map(normals);
}

int make_mesh(void (*refine)(Mesh&, double), const char* input, const char* output, double amount)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(input, mesh))
    return EXIT_FAILURE;
  refine(mesh, amount);
  add_noise(mesh);
  return CGAL::IO::write_polygon_mesh(output, mesh, CGAL::parameters::use_binary_mode(true)) ? EXIT_SUCCESS
                                                                                             : EXIT_FAILURE;
}

int main(int argc, char* argv[])
{
  const std::string benchmark = argc > 1 ? argv[1] : "";
  if(argc == 5 && (benchmark == "make-scan" || benchmark == "subdivide"))
    return make_mesh(benchmark == "subdivide" ? subdivide : make_scan, argv[2], argv[3], std::atof(argv[4]));
  const std::map<std::string, void (*)(const Mesh&, int)> benchmarks = {
    {"solver", benchmark_solver}, {"assembly", benchmark_assembly}, {"curvature", benchmark_curvature},
    {"reuse", benchmark_reuse}, {"region", benchmark_region}, {"threads", benchmark_threads}};
  Mesh mesh;
  const auto found = benchmarks.find(benchmark);
  if(found == benchmarks.end() || argc < 3 || !CGAL::IO::read_polygon_mesh(argv[2], mesh))
  {
    std::cerr << "usage: " << argv[0] << " make-scan INPUT OUTPUT VERTICES\n"
              << "       " << argv[0] << " subdivide INPUT OUTPUT TIMES\n"
              << "       " << argv[0] << " solver|assembly|curvature|reuse|region|threads MESH [REPETITIONS]"
              << std::endl;
    return 2;
  }
  found->second(mesh, argc > 3 ? std::atoi(argv[3]) : 3);
  return EXIT_SUCCESS;
}
