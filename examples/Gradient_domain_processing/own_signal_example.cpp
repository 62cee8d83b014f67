// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Gradient_domain_processing/process_signal.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace GDP = CGAL::Gradient_domain_processing;

typedef CGAL::Simple_cartesian<double>      Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Vertex_index                  vertex_descriptor;
typedef Mesh::Edge_index                    edge_descriptor;

// What is measured at a vertex: two numbers of different kinds
struct Weather
{
  float temperature;
  int humidity; // in percent
};

// says how it is made of numbers.
template <>
struct CGAL::Gradient_domain_processing::Signal_traits<Weather>
{
  static constexpr int dimension = 2;
  static double channel(const Weather& weather, int i) { return i == 0 ? weather.temperature : weather.humidity; }
  static Weather make(const double* c)
  {
    return { float(c[0]), std::clamp(int(c[1] + 0.5), 0, 100) };
  }
};

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/pebble.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto weather = mesh.add_property_map<vertex_descriptor, Weather>("v:weather").first;
  CGAL::Random random(0);
  for(vertex_descriptor v : vertices(mesh))
    weather[v] = { float(20 + random.get_double(-10, 10)), random.get_int(30, 91) };

  const auto difference = [&] {
    double sum = 0;
    for(edge_descriptor e : edges(mesh))
      sum += std::abs(weather[source(e, mesh)].temperature - weather[target(e, mesh)].temperature);
    return sum / num_edges(mesh);
  };
  const double before = difference();

  const GDP::Error_code code = GDP::process_signal(mesh, weather, weather, GDP::parameters::gradient_weight(1e-2));
  if(code != GDP::OK)
  {
    std::cerr << GDP::get_error_message(code) << std::endl;
    return EXIT_FAILURE;
  }

  std::cout << "Smoothed the weather: neighbors differ by " << before << " degrees before and by " << difference()
            << " after" << std::endl;
  return EXIT_SUCCESS;
}
