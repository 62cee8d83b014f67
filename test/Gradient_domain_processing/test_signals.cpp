// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Signals of all value types are filtered as what they are made of: numbers, channel by channel.

#include "test_meshes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/Gradient_domain_solver.h>
#include <CGAL/Gradient_domain_processing/process_signal.h>
#include <CGAL/Gradient_domain_processing/smooth.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

using namespace gdp_test;
namespace GDP = CGAL::Gradient_domain_processing;

typedef CGAL::Simple_cartesian<double> K;
typedef CGAL::Surface_mesh<K::Point_3> Mesh;
typedef Mesh::Vertex_index Vertex;
typedef GDP::Gradient_domain_solver<Mesh> Solver;

// A value type of the user's.
struct Sample
{
  double height = 0;
  int label = 0; // of no concern
  double width = 0;
};

namespace CGAL {
namespace Gradient_domain_processing {

template <>
struct Signal_traits<Sample>
{
  static constexpr int dimension = 2;
  static double channel(const Sample& s, int i) { return i == 0 ? s.height : s.width; }
  static Sample make(const double* c)
  {
    Sample s;
    s.height = c[0];
    s.label = 42;
    s.width = c[1];
    return s;
  }
};

} // namespace Gradient_domain_processing
} // namespace CGAL

namespace {

// The numbers behind the signals: four channels with jumps, of which sharpening makes values beyond [0, 255].
double number(std::size_t v, int channel)
{
  const int k = int((v * (2 * channel + 7)) % 11);
  return k < 3 ? 0 : k > 7 ? 255 : 25 * k;
}

// One channel at a time, as double: what all other types are compared with.
std::vector<double> filtered(Solver& solver, std::size_t n, int channel, double offset = 0)
{
  std::vector<double> f(n), g(n);
  for(std::size_t v = 0; v < n; ++v)
    f[v] = number(v, channel) + offset;
  GDP_CHECK(solver.filter(CGAL::make_property_map(f), CGAL::make_property_map(g)) == GDP::OK);
  return g;
}

// `make(c)` makes a value of four numbers, of which `channel(value, i)` gives back the first `channels`.
template <class Value, class Make, class Channel>
void check_type(Solver& solver, std::size_t n, int channels, double tolerance, const Make& make, const Channel& channel)
{
  std::vector<Value> in, out(n);
  for(std::size_t v = 0; v < n; ++v)
    in.push_back(make(std::array<double, 4>{{number(v, 0), number(v, 1), number(v, 2), number(v, 3)}}));
  GDP_CHECK(solver.filter(CGAL::make_property_map(in), CGAL::make_property_map(out)) == GDP::OK);
  for(int i = 0; i < channels; ++i)
  {
    const std::vector<double> expected = filtered(solver, n, i);
    double worst = 0;
    for(std::size_t v = 0; v < n; ++v)
      worst = (std::max)(worst, std::abs(channel(out[v], i) - expected[v]));
    GDP_CHECK_NEAR(worst, 0, tolerance);
  }
  // the input is as it was, and may be the output
  for(std::size_t v = 0; v < n; ++v)
    for(int i = 0; i < channels; ++i)
      GDP_CHECK(channel(in[v], i) == number(v, i));
  GDP_CHECK(solver.filter(CGAL::make_property_map(in), CGAL::make_property_map(in)) == GDP::OK);
  for(std::size_t v = 0; v < n; ++v)
    for(int i = 0; i < channels; ++i)
      GDP_CHECK(channel(in[v], i) == channel(out[v], i));
}

// Rounded to the nearest and clamped.
void check_integers(Solver& solver, std::size_t n)
{
  std::vector<CGAL::IO::Color> colors;
  std::vector<int> integers;
  std::vector<std::array<unsigned char, 2> > bytes;
  for(std::size_t v = 0; v < n; ++v)
  {
    colors.emplace_back((unsigned char)number(v, 0), (unsigned char)number(v, 1), (unsigned char)number(v, 2),
                        (unsigned char)number(v, 3));
    integers.push_back(int(number(v, 0)) - 128);
    bytes.push_back({{(unsigned char)number(v, 0), (unsigned char)number(v, 1)}});
  }
  const auto color_map = CGAL::make_property_map(colors);
  const auto integer_map = CGAL::make_property_map(integers);
  const auto byte_map = CGAL::make_property_map(bytes);
  GDP_CHECK(solver.filter(color_map, color_map) == GDP::OK);
  GDP_CHECK(solver.filter(integer_map, integer_map) == GDP::OK);
  GDP_CHECK(solver.filter(byte_map, byte_map) == GDP::OK);

  // none is in doubt about its rounding
  const auto near_to = [](double value, double x) { return std::abs(value - x) <= 0.5 + 1e-9; };
  int above = 0, below = 0;
  for(int i = 0; i < 4; ++i)
  {
    const std::vector<double> expected = filtered(solver, n, i);
    for(std::size_t v = 0; v < n; ++v)
    {
      GDP_CHECK(near_to(colors[v][i], (std::min)(255., (std::max)(0., expected[v]))));
      above += expected[v] > 256;
      below += expected[v] < -1;
    }
  }
  GDP_CHECK(above > 10 && below > 10); // there was something to clamp
  for(std::size_t v = 0; v < n; ++v)
    for(int i = 0; i < 2; ++i)
      GDP_CHECK(bytes[v][i] == colors[v][i]);
  const std::vector<double> expected = filtered(solver, n, 0, -128);
  for(std::size_t v = 0; v < n; ++v)
    GDP_CHECK(near_to(integers[v], expected[v]));

  typedef GDP::Signal_traits<long long> Long;
  for(double x : {1e300, 9.3e18, HUGE_VAL})
  {
    const double minus = -x;
    GDP_CHECK(Long::make(&x) == (std::numeric_limits<long long>::max)());
    GDP_CHECK(Long::make(&minus) == (std::numeric_limits<long long>::min)());
  }
  typedef GDP::Signal_traits<signed char> Byte;
  const double over = 200, under = -200;
  GDP_CHECK(Byte::make(&over) == 127 && Byte::make(&under) == -128 && Byte::channel(-5, 0) == -5);
  const double half = 2.5, minus_half = -2.5, less = 2.4999;
  GDP_CHECK(Long::make(&half) == 3 && Long::make(&minus_half) == -3 && Long::make(&less) == 2);
}

// Values that cannot change stay the same to the bit, be they constants, constrained or without a face.
void check_constants(Mesh tm)
{
  tm.add_vertex(K::Point_3(1, 1, 1));
  const std::size_t n = num_vertices(tm);
  std::vector<double> f(n, 1. / 3), g(n);
  GDP_CHECK(GDP::process_signal(tm, CGAL::make_property_map(f), CGAL::make_property_map(g)) == GDP::OK);
  GDP_CHECK(f == g);
  for(std::size_t v = 0; v < n; ++v)
    f[v] = number(v, 1) / 3;
  auto constrained = tm.add_property_map<Vertex, bool>("v:constrained", false).first;
  for(Vertex v : vertices(tm))
    constrained[v] = int(v) % 3 == 0;
  GDP_CHECK(GDP::process_signal(tm, CGAL::make_property_map(f), CGAL::make_property_map(g),
                                CGAL::parameters::vertex_is_constrained_map(constrained)) == GDP::OK);
  int changed = 0;
  for(Vertex v : vertices(tm))
  {
    if(constrained[v] || tm.is_isolated(v))
      GDP_CHECK(f[v] == g[v]);
    else
      changed += f[v] != g[v];
  }
  GDP_CHECK(changed > int(n) / 2);
}

// n passes are n calls; for positions, the metric is that of the last result each time.
void check_iterations(const Mesh& tm)
{
  const std::size_t n = num_vertices(tm);
  std::vector<double> f(n), once(n), thrice(n);
  for(std::size_t v = 0; v < n; ++v)
    f[v] = once[v] = number(v, 2);
  const auto once_map = CGAL::make_property_map(once);
  for(int i = 0; i < 3; ++i)
    GDP_CHECK(GDP::process_signal(tm, once_map, once_map, GDP::parameters::gradient_weight(1e-3)) == GDP::OK);
  const auto iterated = [&](auto count) {
    GDP_CHECK(GDP::process_signal(tm, CGAL::make_property_map(f), CGAL::make_property_map(thrice),
                                  GDP::parameters::gradient_weight(1e-3).number_of_iterations(count)) == GDP::OK);
  };
  iterated(3u);
  for(std::size_t v = 0; v < n; ++v)
    GDP_CHECK_NEAR(once[v], thrice[v], 1e-12);
  iterated(0u);
  GDP_CHECK(thrice == f);

  Mesh by_calls = tm, by_passes = tm, fixed_metric = tm;
  const auto weights = GDP::parameters::gradient_weight(0.01).area_normalization(false);
  for(int i = 0; i < 3; ++i)
    GDP_CHECK(GDP::smooth(by_calls, weights) == GDP::OK);
  GDP_CHECK(GDP::smooth(by_passes, weights.number_of_iterations(3)) == GDP::OK);
  GDP_CHECK(distance(coordinates(by_calls), coordinates(by_passes)) <= 1e-14);
  GDP_CHECK(GDP::process_signal(tm, tm.points(), fixed_metric.points(), weights.number_of_iterations(3)) == GDP::OK);
  GDP_CHECK(distance(coordinates(by_calls), coordinates(fixed_metric)) > 1e-4);
}

// A result that the output cannot hold, or an input that is no number: the output is as it was.
void check_errors(Solver& solver, std::size_t n)
{
  std::vector<double> in(n);
  std::vector<float> out(n, 5.f);
  for(std::size_t v = 0; v < n; ++v)
    in[v] = 1e38 * number(v, 0);
  GDP_CHECK(solver.filter(CGAL::make_property_map(in), CGAL::make_property_map(out)) == GDP::ERROR_RESULT_OUT_OF_RANGE);
  GDP_CHECK(solver.filter(CGAL::make_property_map(in), CGAL::make_property_map(out), -1)
            == GDP::ERROR_INVALID_PARAMETER);
  for(double bad : {double(NAN), HUGE_VAL, -HUGE_VAL})
  {
    std::fill(in.begin(), in.end(), 0.);
    in[n / 2] = bad;
    GDP_CHECK(solver.filter(CGAL::make_property_map(in), CGAL::make_property_map(out)) == GDP::ERROR_INVALID_SIGNAL);
  }
  GDP_CHECK(out == std::vector<float>(n, 5.f));
}

} // namespace

int main()
{
  const Mesh tm = built<Mesh>(bumpy_sphere(2));
  const std::size_t n = num_vertices(tm);
  Solver solver(tm, GDP::parameters::gradient_weight(1e-3).gradient_scale(2.5)); // sharpens
  typedef std::array<double, 4> Four;
  const double exact = 1e-12, single = 1e-4;

  check_type<double>(solver, n, 1, exact, [](const Four& c) { return c[0]; }, [](double x, int) { return x; });
  check_type<float>(
    solver, n, 1, single, [](const Four& c) { return float(c[0]); }, [](float x, int) { return double(x); });
  check_type<K::Point_3>(solver, n, 3, exact, [](const Four& c) { return K::Point_3(c[0], c[1], c[2]); },
                         [](const K::Point_3& p, int i) { return p[i]; });
  check_type<K::Vector_3>(solver, n, 3, exact, [](const Four& c) { return K::Vector_3(c[0], c[1], c[2]); },
                          [](const K::Vector_3& p, int i) { return p[i]; });
  check_type<K::Vector_2>(solver, n, 2, exact, [](const Four& c) { return K::Vector_2(c[0], c[1]); },
                          [](const K::Vector_2& p, int i) { return p[i]; });
  check_type<std::array<double, 4> >(
    solver, n, 4, exact, [](const Four& c) { return c; }, [](const Four& p, int i) { return p[i]; });
  check_type<std::array<std::array<float, 2>, 2> >(
    solver, n, 4, single,
    [](const Four& c) {
      return std::array<std::array<float, 2>, 2>{{{{float(c[0]), float(c[1])}}, {{float(c[2]), float(c[3])}}}};
    },
    [](const std::array<std::array<float, 2>, 2>& p, int i) { return double(p[i / 2][i % 2]); });
  check_type<Eigen::Vector3d>(solver, n, 3, exact, [](const Four& c) { return Eigen::Vector3d(c[0], c[1], c[2]); },
                              [](const Eigen::Vector3d& p, int i) { return p[i]; });
  check_type<Eigen::Matrix<float, 1, 2> >(
    solver, n, 2, single, [](const Four& c) { return Eigen::Matrix<float, 1, 2>(float(c[0]), float(c[1])); },
    [](const Eigen::Matrix<float, 1, 2>& p, int i) { return double(p[i]); });
  check_type<Sample>(solver, n, 2, exact, [](const Four& c) { Sample s; s.height = c[0]; s.width = c[1]; return s; },
                     [](const Sample& s, int i) { return i == 0 ? s.height : s.width; });
  check_integers(solver, n);
  check_errors(solver, n);
  check_constants(tm);
  check_iterations(tm);
  return GDP_TEST_RESULT();
}
