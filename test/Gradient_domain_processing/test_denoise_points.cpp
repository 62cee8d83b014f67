// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Denoising of arrays: pairs of every kind of noise with bounds, equivariance, threads, and knobs that are obeyed.

#include "test_shapes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/internal/denoising/denoise_points.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace GDP = CGAL::Gradient_domain_processing;
using namespace gdp_test;

namespace {

typedef std::vector<Vec> Points;

GDP::internal::Indexed_triangles indexed(const Shape& shape)
{
  GDP::internal::Indexed_triangles mesh;
  mesh.points = shape.points;
  mesh.triangles = shape.triangles;
  mesh.index_corners();
  mesh.is_on_border.assign(shape.points.size(), 0);
  std::map<std::pair<int, int>, int> uses;
  for(const auto& t : shape.triangles)
    for(int i = 0; i < 3; ++i)
      ++uses[std::minmax(t[i], t[(i + 1) % 3])];
  for(const auto& use : uses)
    if(use.second == 1)
      mesh.is_on_border[use.first.first] = mesh.is_on_border[use.first.second] = 1;
  return mesh;
}

struct Result
{
  Points points;
  GDP::Denoising_summary summary;
};

Result denoised(const Shape& shape, const GDP::internal::Denoising_options& options = {}, bool parallel = true,
                std::vector<char> is_constrained = {})
{
  const auto mesh = indexed(shape);
  is_constrained.resize(shape.points.size(), 0);
  GDP::internal::Progress progress;
  Result result;
  result.points = shape.points;
  GDP_CHECK(
    GDP::internal::denoise_points(mesh, is_constrained, options, parallel, progress, result.points, result.summary)
    == GDP::OK);
  return result;
}

Points normals(const Shape& shape, const Points& points)
{
  Points result;
  for(const auto& t : shape.triangles)
    result.push_back((points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).normalized());
  return result;
}

double angle(const Shape& clean, const Points& points) // mean, of face normals, in degrees
{
  const Points a = normals(clean, clean.points), b = normals(clean, points);
  double sum = 0;
  for(std::size_t f = 0; f < a.size(); ++f)
    sum += std::atan2(a[f].cross(b[f]).norm(), a[f].dot(b[f]));
  return sum / double(a.size()) * 180 / pi;
}

double edge_length(const Shape& shape)
{
  double sum = 0;
  for(const auto& t : shape.triangles)
    for(int i = 0; i < 3; ++i)
      sum += (shape.points[t[i]] - shape.points[t[(i + 1) % 3]]).norm();
  return sum / (3. * double(shape.triangles.size()));
}

double largest_shift(const Points& a, const Points& b)
{
  double largest = 0;
  for(std::size_t v = 0; v < a.size(); ++v)
    largest = (std::max)(largest, (a[v] - b[v]).norm());
  return largest;
}

Points vertex_normals(const Shape& shape) { return indexed(shape).vertex_normals(false); }

// Along the normals, of a standard deviation in mean edge lengths, smoothed so many times over the neighbors before.
Shape with_noise(const Shape& clean, double amount, int smoothings = 0)
{
  const auto rings = indexed(clean).one_rings(false);
  Random random(11);
  std::vector<double> heights;
  for(std::size_t v = 0; v < clean.points.size(); ++v)
  {
    double sum = 0;
    for(int i = 0; i < 12; ++i)
      sum += random() / 2;
    heights.push_back(sum);
  }
  for(int k = 0; k < smoothings; ++k)
  {
    std::vector<double> next = heights;
    for(int v = 0; v < rings.size(); ++v)
      for(const int* w = rings.begin(v); w != rings.end(v); ++w)
        next[v] += heights[*w] / rings.size(v);
    for(std::size_t v = 0; v < next.size(); ++v)
      heights[v] = next[v] / 2;
  }
  double squares = 0;
  for(double h : heights)
    squares += h * h / double(heights.size());
  Shape noisy = clean;
  const Points n = vertex_normals(clean);
  for(std::size_t v = 0; v < heights.size(); ++v)
    noisy.points[v] += amount * edge_length(clean) * heights[v] / std::sqrt(squares) * n[v];
  return noisy;
}

Shape box() { return cubes({{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}}, 10); }

// Within so many degrees, by default, and nothing flipped.
Result removes(const char* name, const Shape& clean, const Shape& noisy, double bound)
{
  const Result result = denoised(noisy);
  std::cout << name << ": " << angle(clean, noisy.points) << " degrees, denoised " << angle(clean, result.points)
            << std::endl;
  GDP_CHECK(angle(clean, result.points) < bound);
  const Points a = normals(clean, clean.points), b = normals(clean, result.points), c = normals(clean, noisy.points);
  int flipped = 0;
  for(std::size_t f = 0; f < a.size(); ++f)
    flipped += (a[f].dot(b[f]) < 0) - (a[f].dot(c[f]) < 0);
  GDP_CHECK(flipped <= 0);
  return result;
}

void removes_noise_of_every_kind()
{
  const Shape ball = sphere(40);
  GDP_CHECK(removes("white, creased", box(), with_noise(box(), 0.3), 3.).summary.noise_scale == 0);
  GDP_CHECK(removes("white, smooth", ball, with_noise(ball, 0.2), 2.5).summary.noise_scale == 0);
  GDP_CHECK(removes("white, open", jittered_square(30), with_noise(jittered_square(30), 0.3), 6.).summary.noise_level
            > 0.3);
  GDP_CHECK(removes("correlated, creased", box(), with_noise(box(), 0.25, 3), 3.).summary.noise_scale > 1);
  GDP_CHECK(removes("correlated, smooth", ball, with_noise(ball, 0.25, 3), 3.).summary.noise_scale > 1);
}

// Steps along one axis are told from shape by their scale, which is named.
void removes_stairs()
{
  const Shape clean = sphere(40);
  const double step = 1.7 * edge_length(clean);
  const Shape noisy = clean.mapped([&](const Vec& p) { return Vec(p[0], p[1], step * std::round(p[2] / step)); });
  GDP::internal::Denoising_options options;
  options.noise_scale = 6;
  const Points result = denoised(noisy, options).points;
  std::cout << "stairs: " << angle(clean, noisy.points) << " degrees, denoised " << angle(clean, result) << std::endl;
  GDP_CHECK(angle(clean, result) < 5);
}

void removes_spikes()
{
  const Shape clean = box();
  const double edge = edge_length(clean);
  Shape noisy = with_noise(clean, 0.05);
  const Points n = vertex_normals(clean);
  int spikes = 0;
  for(std::size_t v = 17; v < clean.points.size(); v += 97, ++spikes)
    noisy.points[v] += double(2 + v % 3) * edge * n[v];
  const Result result = denoised(noisy);
  std::cout << "spikes: " << largest_shift(clean.points, noisy.points) / edge << " edges, denoised "
            << largest_shift(clean.points, result.points) / edge << std::endl;
  GDP_CHECK(largest_shift(clean.points, result.points) < edge);
  std::cout << result.summary.number_of_outliers << " outliers of " << spikes << std::endl;
  GDP_CHECK(int(result.summary.number_of_outliers) >= spikes - 1
            && int(result.summary.number_of_outliers) <= 2 * spikes);
}

void keeps_components_apart()
{
  const Shape ball = sphere(24), table = jittered_square(24).scaled(4).moved(Vec(-2, -2, -3));
  const Shape noisy = with_noise(ball, 0.25);
  const Result alone = denoised(noisy), both = denoised(noisy + table);
  for(std::size_t v = 0; v < both.points.size(); ++v)
    GDP_CHECK(both.points[v] == (v < ball.points.size() ? alone.points[v] : table.points[v - ball.points.size()]));
  GDP_CHECK(both.summary.noise_level == alone.summary.noise_level);
  GDP_CHECK(both.summary.number_of_iterations == alone.summary.number_of_iterations);
}

void leaves_clean_meshes()
{
  for(const Shape& clean : {box(), sphere(24), jittered_square(20), ellipsoid(10, Vec(1, 0.5, 0.25))})
  {
    const Result result = denoised(clean);
    GDP_CHECK(result.points == clean.points);
    GDP_CHECK(result.summary.end == GDP::Denoising_end::no_noise && result.summary.number_of_iterations == 0);
    GDP_CHECK(result.summary.number_of_outliers == 0);
  }
}

void is_equivariant(const Shape& noisy, const GDP::internal::Denoising_options& options, bool border_is_fixed)
{
  const auto mesh = indexed(noisy);
  const std::vector<char> is_constrained =
    border_is_fixed ? mesh.is_on_border : std::vector<char>(noisy.points.size(), 0);
  Eigen::Matrix3d turn;
  turn << 2, -1, 2, 2, 2, -1, -1, 2, 2; // three times a rotation
  const auto map = [&](const Vec& p) { return Vec(1.9 * (turn * p) / 3 + Vec(3, -2, 1)); };
  const Points expected = Shape{denoised(noisy, options, true, is_constrained).points, {}}.mapped(map).points;
  const Points result = denoised(noisy.mapped(map), options, true, is_constrained).points;
  const double moved = largest_shift(noisy.mapped(map).points, expected);
  GDP_CHECK(moved > 1e-3);
  GDP_CHECK(largest_shift(expected, result) < 1e-6 * moved);
}

void is_equivariant_with_every_border()
{
  const Shape noisy = with_noise(jittered_square(16), 0.3);
  GDP::internal::Denoising_options options;
  is_equivariant(noisy, options, false);
  is_equivariant(noisy, options, true);
  options.border_is_smoothed_as_curve = true;
  is_equivariant(noisy, options, false);
}

// A border with a zigzag in the plane.
void smooths_borders_as_curves()
{
  Shape shape = square(20);
  for(Vec& p : shape.points)
    if(p[1] == 0)
      p[1] = std::lround(p[0] * 20) % 2 ? 0.015 : -0.015;
  shape = with_noise(shape, 0.2);
  GDP::internal::Denoising_options options;
  options.border_is_smoothed_as_curve = true;
  const Points result = denoised(shape, options).points;
  double before = 0, after = 0;
  for(std::size_t v = 0; v < result.size(); ++v)
    if(std::abs(shape.points[v][1]) < 0.02 && shape.points[v][0] > 0.2 && shape.points[v][0] < 0.8)
    {
      before += std::abs(shape.points[v][1]);
      after += std::abs(result[v][1]);
    }
  std::cout << "zigzag " << before << ", after " << after << std::endl;
  GDP_CHECK(before > 0.1 && after < 0.35 * before);
}

void obeys_knobs()
{
  const Shape clean = sphere(24), noisy = with_noise(clean, 0.2);
  GDP::internal::Denoising_options options;
  for(int passes : {0, 1, 3, 17})
  {
    options.number_of_iterations = passes;
    for(const Shape& shape : {clean, noisy})
    {
      const Result result = denoised(shape, options);
      GDP_CHECK(int(result.summary.number_of_iterations) == passes);
      GDP_CHECK(result.summary.end == GDP::Denoising_end::named_passes);
      GDP_CHECK((result.points == shape.points) == (passes == 0));
    }
  }
  options = {};
  options.noise_level = 0.37;
  GDP_CHECK(denoised(clean, options).summary.noise_level == 0.37);
  GDP_CHECK(denoised(clean, options).points != clean.points);
  options.noise_level = 0;
  GDP_CHECK(denoised(noisy, options).points == noisy.points);
  options = {};
  options.noise_scale = 3;
  GDP_CHECK(denoised(noisy, options).summary.noise_scale == 3);
  options = {};
  options.value_weight = 1;
  const double near = largest_shift(denoised(noisy, options).points, noisy.points);
  options.value_weight = 0.02;
  GDP_CHECK(near < 0.7 * largest_shift(denoised(noisy, options).points, noisy.points));
}

void refuses_invalid_options()
{
  typedef GDP::internal::Denoising_options Options;
  const Shape noisy = with_noise(sphere(12), 0.2);
  const auto mesh = indexed(noisy);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Options> invalid(6);
  invalid[0].number_of_iterations = -1;
  invalid[1].noise_level = -1;
  invalid[2].noise_level = nan;
  invalid[3].noise_scale = -0.5;
  invalid[4].value_weight = 0;
  invalid[5].value_weight = nan;
  for(const Options& options : invalid)
  {
    Points points = noisy.points;
    GDP::Denoising_summary summary;
    GDP::internal::Progress progress;
    const std::vector<char> free(points.size(), 0);
    GDP_CHECK(GDP::internal::denoise_points(mesh, free, options, true, progress, points, summary)
              == GDP::ERROR_INVALID_PARAMETER);
    GDP_CHECK(points == noisy.points);
  }
}

void keeps_constrained_vertices()
{
  const Shape noisy = with_noise(box(), 0.3);
  std::vector<char> is_constrained(noisy.points.size(), 0);
  for(std::size_t v = 0; v < is_constrained.size(); v += 5)
    is_constrained[v] = 1;
  Shape spiky = noisy;
  spiky.points[5 * 40] += Vec(0.4, 0.4, 0.4);
  const Points result = denoised(spiky, {}, true, is_constrained).points;
  int moved = 0;
  for(std::size_t v = 0; v < result.size(); ++v)
  {
    GDP_CHECK(!is_constrained[v] || result[v] == spiky.points[v]);
    moved += result[v] != spiky.points[v];
  }
  GDP_CHECK(moved > int(result.size()) / 2);
}

// Triangles turned over, and three of them at an edge.
void takes_soups()
{
  const Shape clean = jittered_square(24), noisy = with_noise(clean, 0.3);
  Shape turned = noisy;
  for(std::size_t f = 0; f < turned.triangles.size(); f += 3)
    std::swap(turned.triangles[f][0], turned.triangles[f][1]);
  const Points expected = denoised(noisy).points, result = denoised(turned).points;
  GDP_CHECK(largest_shift(expected, noisy.points) > 1e-3);
  GDP_CHECK(largest_shift(expected, result) < 0.05 * largest_shift(expected, noisy.points));

  Shape fins = noisy;
  const int apex = int(fins.points.size());
  fins.points.push_back(Vec(0.5, 0.5, 0.3));
  fins.triangles.push_back({{fins.triangles[500][0], fins.triangles[500][1], apex}});
  GDP::internal::Denoising_options options;
  options.number_of_iterations = 5;
  const Points moved = denoised(fins, options).points;
  for(const Vec& p : moved)
    GDP_CHECK(p.allFinite());
  GDP_CHECK(moved != fins.points);
}

void does_not_depend_on_threads()
{
  const Shape noisy = with_noise(sphere(48), 0.2);
  GDP_CHECK(denoised(noisy, {}, true).points == denoised(noisy, {}, false).points);
}

struct Cancelling : GDP::internal::Progress
{
  int left;
  double last = 0;
  bool is_increasing = true;
  explicit Cancelling(int calls) : left(calls) {}
  bool report(double done) override
  {
    is_increasing = is_increasing && done >= last && done <= 1;
    last = done;
    return --left > 0;
  }
};

// min |x - x_0|^2 + gamma |L x|^2 by a dense solution, taken along the normals.
void fairing_solves_its_system()
{
  const Shape shape = with_noise(sphere(5), 0.2);
  const auto mesh = indexed(shape);
  const GDP::internal::Lists rings = mesh.one_rings(true);
  const int n = int(shape.points.size());
  Eigen::MatrixXd laplacian = Eigen::MatrixXd::Identity(n, n), positions(n, 3);
  for(int v = 0; v < n; ++v)
  {
    positions.row(v) = shape.points[v];
    for(const int* w = rings.begin(v); w != rings.end(v); ++w)
      laplacian(v, *w) -= 1. / rings.size(v);
  }
  const Eigen::MatrixXd bending = GDP::internal::denoising::smooth_fairing * laplacian.transpose() * laplacian;
  const Eigen::MatrixXd change =
    (Eigen::MatrixXd::Identity(n, n) + bending).ldlt().solve(Eigen::MatrixXd(-bending * positions));
  const Points normals = mesh.vertex_normals(true);
  Points points = shape.points;
  const GDP::internal::Dual_graph dual_of_mesh(mesh, true);
  GDP::internal::Surface_fairing fairing(mesh, rings, dual_of_mesh, 1, true);
  fairing.take_all();
  fairing([](int v) { return v != 7; }, normals, points);
  GDP_CHECK(points[7] == shape.points[7]);
  double largest = 0, error = 0;
  for(int v = 0; v < n; ++v)
  {
    if(v == 7 || std::find(rings.begin(7), rings.end(7), v) != rings.end(7))
      continue;
    const Vec expected = normals[v].dot(change.row(v).transpose()) * normals[v];
    largest = (std::max)(largest, expected.norm());
    error = (std::max)(error, (points[v] - shape.points[v] - expected).norm());
  }
  GDP_CHECK(largest > 0.01 && error < 0.1 * largest);

  // creases stay where they are to be kept, and only they
  const Shape cube = box();
  const auto of_cube = indexed(cube);
  const GDP::internal::Lists rings_of_cube = of_cube.one_rings(true);
  const GDP::internal::Dual_graph dual(of_cube, true);
  const GDP::internal::Face_geometry faces(of_cube, dual, cube.points, true);
  GDP::internal::Surface_fairing all(of_cube, rings_of_cube, dual, 1, true), flat = all;
  all.take_all();
  flat.keep_creases(faces.normals);
  Points worn = cube.points, kept = cube.points;
  all([](int) { return true; }, of_cube.vertex_normals(true), worn);
  flat([](int) { return true; }, of_cube.vertex_normals(true), kept);
  GDP_CHECK(largest_shift(cube.points, worn) > 0.05 / 10);
  GDP_CHECK(largest_shift(cube.points, kept) < 0.02 * largest_shift(cube.points, worn));
}

// A wall on a floor: where three sheets meet, nothing is smooth.
void fairing_keeps_lines()
{
  Shape shape = square(6);
  const int n = int(shape.points.size());
  std::vector<int> line, wall;
  for(int v = 0; v < n; ++v)
    if(std::abs(shape.points[v][0] - 0.5) < 1e-9)
      line.push_back(v);
  std::sort(line.begin(), line.end(), [&](int v, int w) { return shape.points[v][1] < shape.points[w][1]; });
  for(int v : line)
  {
    wall.push_back(int(shape.points.size()));
    shape.points.push_back(shape.points[v] + Vec(0, 0, 0.2));
  }
  for(std::size_t k = 0; k + 1 < line.size(); ++k)
  {
    shape.triangles.push_back({{line[k], line[k + 1], wall[k]}});
    shape.triangles.push_back({{line[k + 1], wall[k + 1], wall[k]}});
  }
  const auto mesh = indexed(shape);
  const GDP::internal::Lists rings = mesh.one_rings(true);
  const GDP::internal::Dual_graph dual(mesh, true);
  Points points = shape.points;
  GDP::internal::Surface_fairing fairing(mesh, rings, dual, 1, true);
  fairing.take_all();
  fairing([](int) { return true; }, mesh.vertex_normals(true), points);
  GDP_CHECK(line.size() == 7 && largest_shift(points, shape.points) < 1e-6);
}

// A part that is smaller than single precision can tell beside the whole.
void does_not_depend_on_what_lies_far_away()
{
  const Shape noisy = with_noise(sphere(24), 0.2);
  const Points alone = denoised(noisy).points;
  const double scale = std::ldexp(1., -70);
  Shape small = noisy.mapped([&](const Vec& p) { return Vec(scale * p); });
  const Shape far = with_noise(sphere(24), 0.2).mapped([](const Vec& p) { return Vec(p + Vec(4, 0, 0)); });
  const Points beside = denoised(small + far).points;
  for(std::size_t v = 0; v < alone.size(); ++v)
    GDP_CHECK(beside[v] == scale * alone[v]);
}

// Triangles of a polygon have its area vector, wherever it is not convex.
void cuts_polygons()
{
  const Points points = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 0.2, 0}, {0, 1, 0}};
  std::vector<std::array<int, 3> > triangles;
  GDP::internal::cut_ears({0, 1, 2, 3, 4}, points, triangles);
  GDP_CHECK(triangles.size() == 3);
  double area = 0;
  for(const auto& t : triangles)
  {
    const double z = (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).z();
    GDP_CHECK(z > 0);
    area += z / 2;
  }
  GDP_CHECK_NEAR(area, 1.2, 1e-12);
  triangles.clear();
  const Points rhombus = {{-1, 0, 0}, {0, -2, 0}, {1, 0, 0}, {0, 2, 0}};
  GDP::internal::cut_ears({0, 1, 2, 3}, rhombus, triangles);
  GDP_CHECK(triangles.size() == 2);
  for(const auto& triangle : triangles) // by the shorter diagonal
    GDP_CHECK(std::count(triangle.begin(), triangle.end(), 0) == 1
              && std::count(triangle.begin(), triangle.end(), 2) == 1);
  triangles.clear();
  GDP::internal::cut_ears({0, 1, 1, 4}, points, triangles); // welded corners
  GDP_CHECK(triangles.size() == 1);
}

// A vertex where two borders meet is on no curve, whatever the order of the triangles.
void borders_that_meet_stay()
{
  Shape patch = with_noise(square(8), 0.2);
  const int n = int(patch.points.size());
  int corner = 0;
  for(int v = 0; v < n; ++v)
    if(patch.points[v][0] + patch.points[v][1] > patch.points[corner][0] + patch.points[corner][1])
      corner = v;
  Shape two = patch; // and its mirror image at the corner
  const auto mirrored = [&](int v) { return v == corner ? v : v < corner ? n + v : n + v - 1; };
  for(int v = 0; v < n; ++v)
    if(v != corner)
      two.points.push_back(2 * patch.points[corner] - patch.points[v]);
  for(const auto& t : patch.triangles)
    two.triangles.push_back({{mirrored(t[0]), mirrored(t[2]), mirrored(t[1])}});
  const auto mesh = indexed(two);
  Points points = two.points;
  GDP::internal::smooth_border(mesh, GDP::internal::Dual_graph(mesh, true), std::vector<char>(points.size(), 0), true,
                               points);
  GDP_CHECK(points[corner] == two.points[corner]);
  GDP_CHECK(largest_shift(points, two.points) > 1e-3);
}

void can_be_cancelled()
{
  const Shape noisy = with_noise(sphere(24), 0.2);
  const auto mesh = indexed(noisy);
  for(int calls : {1, 2, 9, 1000})
  {
    Points points = noisy.points;
    GDP::Denoising_summary summary;
    Cancelling progress(calls);
    const std::vector<char> free(points.size(), 0);
    const int code = GDP::internal::denoise_points(mesh, free, {}, true, progress, points, summary);
    GDP_CHECK(code == (calls < 1000 ? GDP::ERROR_CANCELLED : GDP::OK));
    GDP_CHECK(progress.is_increasing);
  }
}

// What was measured and done when this was written, within what compilers differ by, and how good it was then: whoever
// changes it shall mean to.
struct Known
{
  const char* name;
  Shape clean, noisy;
  double level, share, roughness, border_variance, border_level; // of the noise
  int passes, outliers;
  double degrees;

  void check() const
  {
    const auto mesh = indexed(noisy);
    const GDP::internal::Dual_graph dual(mesh, false);
    const GDP::internal::Face_geometry faces(mesh, dual, noisy.points, false);
    const auto noise = GDP::internal::estimate_noise(mesh, faces, dual, mesh.one_rings(false), false);
    const Result result = denoised(noisy);
    const double after = angle(clean, result.points);
    std::cout.precision(8);
    std::cout << name << ": " << result.summary.noise_level << ", " << result.summary.noise_share << ", "
              << noise.roughness_level << ", " << noise.border_variance << ", " << noise.border_level << ", "
              << result.summary.number_of_iterations << ", " << result.summary.number_of_outliers << ", " << after
              << std::endl;
    GDP_CHECK_NEAR(result.summary.noise_level, level, 1e-4 * level);
    GDP_CHECK_NEAR(result.summary.noise_share, share, 1e-4 * share);
    GDP_CHECK_NEAR(noise.roughness_level, roughness, 1e-4 * roughness);
    GDP_CHECK_NEAR(noise.border_variance, border_variance, 1e-4 * border_variance);
    GDP_CHECK_NEAR(noise.border_level, border_level, 1e-4 * border_level);
    GDP_CHECK(int(result.summary.number_of_iterations) == passes);
    GDP_CHECK(int(result.summary.number_of_outliers) == outliers);
    GDP_CHECK(after <= 1.03 * degrees);
  }
};

Shape with_spikes(Shape shape)
{
  const Points n = vertex_normals(shape);
  const double edge = edge_length(shape);
  for(std::size_t v = 17; v < shape.points.size(); v += 97)
    shape.points[v] += double(1 + v % 3) * edge * n[v];
  return shape;
}

void does_what_it_did()
{
  // no choice of a diagonal hangs on rounding
  const Shape table = jittered_square(24), ring = grid(64, 32, [](double u, double v) {
    const double radius = 2 + std::cos(2 * pi * v);
    return Vec(radius * std::cos(2 * pi * u), radius * std::sin(2 * pi * u), std::sin(2 * pi * v));
  }, true, true);
  const Shape waves = ring.mapped([](const Vec& p) { return Vec(p * (1 + 0.02 * std::sin(8 * p[0]))); });
  const Shape noisy_inside = with_noise(table, 0.25).mapped([](const Vec& p) {
    const bool is_on_border = (std::min)({p[0], p[1], 1 - p[0], 1 - p[1]}) < 1e-9;
    return Vec(p[0], p[1], is_on_border ? 0.2 * p[2] : p[2]);
  });
  for(const Known& known : {
        Known{"box", box(), with_noise(box(), 0.2), 0.46137492, 0.97467943, 0.47877785, 1, 0, 20, 0, 1.069},
        Known{"ring", ring, with_noise(ring, 0.15), 0.31515291, 0.9, 0.35870369, 1, 0, 9, 0, 1.783},
        Known{"heavy noise", ring, with_noise(ring, 0.6), 0.88236935, 0.98994949, 0.89645723, 1, 0, 14, 4, 3.16},
        Known{"table", table, with_noise(table, 0.25), 0.56731228, 1, 0.57161457, 1.308991, 1, 10, 0, 1.806},
        Known{"still border", table, noisy_inside,
              0.53412083, 1, 0.53868827, 0.051968391, 0.80893672, 10, 0, 1.653},
        Known{"waves", waves, with_noise(waves, 0.1), 0.22626328, 0.84852814, 0.27912331, 1, 0, 8, 0, 5.446},
        Known{"clean waves", waves, waves, 0, 0.37416574, 0.11415834, 1, 0, 0, 0, 0},
        Known{"correlated", box(), with_noise(box(), 0.25, 3), 0.15, 0, 0.21858712, 1, 0, 20, 0, 0.865},
        Known{"spikes", box(), with_spikes(with_noise(box(), 0.1)),
              0.24674784, 0.9591663, 0.2732798, 1, 0, 20, 10, 0.98},
      })
    known.check();
}

// The formulas, by hand.
void tells_noise_from_detail()
{
  using GDP::internal::noise_share;
  GDP_CHECK_NEAR(noise_share(-0.17, 0.08), 1, 0.011);
  GDP_CHECK(noise_share(0.5, std::pow(0.5, 1.4)) == 0 && noise_share(0.9, 0.9) == 0);
  GDP_CHECK_NEAR(noise_share(0.5 * 0.5 - 0.17 * 0.5, 0.5 * std::pow(0.5, 1.4) + 0.08 * 0.5), 0.5, 0.011);
  GDP_CHECK_NEAR(noise_share(0.8 * 0.6 - 0.17 * 0.2, 0.8 * std::pow(0.6, 1.4) + 0.08 * 0.2), 0.2, 0.011);
  GDP_CHECK(noise_share(-0.9, 0.5) == GDP::internal::neither_noise_nor_detail);

  GDP::internal::Pair_correlation pairs;
  pairs.insert(3, 1);
  GDP_CHECK_NEAR(pairs.of_means(), 0.6, 1e-12);
  GDP_CHECK_NEAR(pairs.of_medians(), 0.6, 1e-12);
  pairs.insert(1, -1);
  pairs.insert(-2, -2); // differences 2, 2, 0, sums 4, 0, 4
  GDP_CHECK_NEAR(pairs.of_means(), 0.6, 1e-12);
  GDP_CHECK_NEAR(pairs.of_medians(), 0.6, 1e-12);
  pairs.insert(5, -5);
  GDP_CHECK_NEAR(pairs.of_means(), (64. - 196) / (64 + 196), 1e-12);

  using GDP::internal::correlated_excess;
  GDP_CHECK_NEAR(correlated_excess({{1, 0.7, 0.4, 0.2, 0.1}}), 0.7 - 0.8, 1e-12);
  GDP_CHECK_NEAR(correlated_excess({{1, 0.7, 0.4, 0.2, 0.04}}), 0.7 - 1, 1e-12);
  GDP_CHECK_NEAR(correlated_excess({{1, 0.7, 0.4, 0.2, -0.1}}), 0.7 - 0.4, 1e-12);
  GDP_CHECK_NEAR(correlated_excess({{1, 0.7, -0.4, 0.2, 0.1}}), 0.7, 1e-12);
}

void knows_smooth_surfaces()
{
  const auto variation = [](double median, double root_mean_square) {
    GDP::internal::Normal_variation result;
    result.median = median;
    result.root_mean_square = root_mean_square;
    return result;
  };
  GDP_CHECK(variation(0.1, 0.71).is_of_folded_surface() && !variation(0.1, 0.69).is_of_folded_surface());
  GDP_CHECK(variation(0.1, 0.3).is_settled(variation(0.11, 0.3)));
  GDP_CHECK(!variation(0.1, 0.3).is_settled(variation(0.12, 0.3)));
  GDP_CHECK(!variation(0.1, 0.3).is_settled(variation(0, 0.3)));
  GDP_CHECK(variation(0.17, 0.3).is_of_smooth_surface(variation(0.17, 0.31)));  // less detail
  GDP_CHECK(!variation(0.19, 0.3).is_of_smooth_surface(variation(0.19, 0.31))); // as much
  GDP_CHECK(variation(0.19, 0.3).is_of_smooth_surface(variation(0.19, 0.29)));  // and facets
  GDP_CHECK(!variation(0.17, 0.3).is_of_smooth_surface(variation(0.19, 0.31)) // goes on
            && !variation(0.17, 0.3).is_of_smooth_surface(variation(0.17, 0.34)));
  GDP_CHECK(!variation(0.065, 0.3).is_of_smooth_surface(variation(0.07, 0.31))); // flat pieces, flatter than before
  GDP_CHECK(variation(0.065, 0.3).is_of_smooth_surface(variation(0.065, 0.3)));  // folds that stay
  GDP_CHECK(!variation(0.065, 0.3).is_of_smooth_surface(variation(0.065, 0.29)));
  GDP_CHECK(!variation(0.065, 0.61).is_of_smooth_surface(variation(0.065, 0.61)));
  GDP_CHECK(variation(0.067, 0.3).is_of_smooth_surface(variation(0.067, 0.31)));
}

} // namespace

int main()
{
  tells_noise_from_detail();
  knows_smooth_surfaces();
  does_what_it_did();
  removes_noise_of_every_kind();
  removes_stairs();
  removes_spikes();
  keeps_components_apart();
  leaves_clean_meshes();
  is_equivariant_with_every_border();
  smooths_borders_as_curves();
  obeys_knobs();
  refuses_invalid_options();
  keeps_constrained_vertices();
  takes_soups();
  does_not_depend_on_threads();
  can_be_cancelled();
  fairing_solves_its_system();
  fairing_keeps_lines();
  does_not_depend_on_what_lies_far_away();
  cuts_polygons();
  borders_that_meet_stay();
  return GDP_TEST_RESULT();
}
