// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What gradient_domain_viewer shows is what its command line makes of the file; what need not be done again is not.

#include "../test_utils.h"

#include "Failure.h"
#include "Filter_model.h"
#include "filter_mesh.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace GDP = CGAL::Gradient_domain_processing;
typedef GDP::Curvature_metric_kind Metric;

namespace {

// A bumpy torus in quads; an OFF file with colors, which have to stay.
void write_torus(const std::string& path, int n, int m, bool has_hole = false)
{
  const double pi = std::acos(-1.);
  std::mt19937 random(1); // whose numbers are the same everywhere
  std::ofstream file(path);
  file.precision(17);
  file << "OFF\n" << n * m << " " << n * m - has_hole << " 0\n";
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < m; ++j)
    {
      const double a = 2 * pi * i / n, b = 2 * pi * j / m;
      const double r = 0.4 + 0.02 * std::sin(11 * a) * std::cos(7 * b) + 0.05 * (double(random()) / 4294967296. - 0.5);
      const double distance = 1 + r * std::cos(b);
      file << distance * std::cos(a) << " " << distance * std::sin(a) << " " << r * std::sin(b) << "\n";
    }
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < m; ++j)
      if(!has_hole || i + j > 0)
        file << "4 " << i * m + j << " " << (i + 1) % n * m + j << " " << (i + 1) % n * m + (j + 1) % m << " "
             << i * m + (j + 1) % m << " " << i % 256 << " 7 9\n";
}

std::string contents(const std::string& path)
{
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

Mesh_file read(const std::string& path) { return parse_mesh_file(path, file_format(path), read_bytes(path)); }

double largest_difference(const std::vector<Point>& a, const std::vector<Point>& b)
{
  GDP_CHECK(a.size() == b.size());
  double largest = 0;
  for(std::size_t v = 0; v < a.size(); ++v)
    largest = (std::max)(largest, std::sqrt(CGAL::squared_distance(a[v], b[v])));
  return largest;
}

// What the command line that is shown makes of the file.
std::vector<Point> commanded(const Filter_model& model)
{
  std::vector<std::string> words = model.command_words("commanded.off");
  words.insert(words.begin(), "gradient_domain_filter");
  std::vector<char*> pointers;
  for(std::string& word : words)
    pointers.push_back(word.data());
  Options options;
  GDP_CHECK(parse_command_line(int(pointers.size()), pointers.data(), options));
  Mesh_file file = read(options.input);
  Stage_clock clock(false);
  Filter_facts facts;
  GDP_CHECK(filter_mesh(options, file, clock, facts) == GDP::ok);
  return file.points;
}

Filter_settings with(double weight, double scale, Metric metric = Metric::EMBEDDING)
{
  Filter_settings settings;
  settings.gradient_weight = weight;
  settings.gradient_scale = scale;
  settings.metric = metric;
  return settings;
}

void test_command_line(const std::string& path)
{
  Filter_model model(path);
  for(Metric metric : {Metric::EMBEDDING, Metric::EDGE_AWARE, Metric::ANISOTROPIC, Metric::PRESERVE_CONVEX,
                       Metric::PRESERVE_CONCAVE})
    for(double scale : {0., 0.5, 1., 3.})
    {
      Filter_settings settings = with(2e-4, scale, metric);
      settings.curvature_weight = 0.05;
      settings.presmoothing_weight = 3e-5;
      model.set(settings);
      GDP_CHECK(scale == 1 || largest_difference(model.points(), model.original_points()) > 1e-4);
      GDP_CHECK(largest_difference(model.points(), commanded(model)) < 1e-12);
    }
  GDP_CHECK(model.number_of_solutions() == 5);
  for(Operation operation : {Operation::ENHANCE_DETAILS, Operation::DENOISE})
  {
    Filter_settings settings = with(1e-4, 0);
    settings.operation = operation;
    model.set(settings);
    GDP_CHECK(largest_difference(model.points(), model.original_points()) > 1e-5);
    GDP_CHECK(model.points() == commanded(model));
  }
}

// Solutions are counted; the second visit of an answer costs one again, a new scale never.
void test_what_is_done_again(const std::string& path)
{
  Filter_model model(path);
  int before = 0;
  const auto solutions = [&](const Filter_settings& settings) {
    model.set(settings);
    return model.number_of_solutions() - std::exchange(before, model.number_of_solutions());
  };
  GDP_CHECK(solutions(with(1e-4, 0)) == 1);
  GDP_CHECK(solutions(with(1e-4, 5)) == 0);
  GDP_CHECK(solutions(with(1e-3, 5)) == 1);
  GDP_CHECK(solutions(with(1e-3, 5, Metric::EDGE_AWARE)) == 1);
  GDP_CHECK(solutions(with(1e-3, 2, Metric::EDGE_AWARE)) == 0);
  Filter_settings other = with(1e-3, 2, Metric::EDGE_AWARE);
  other.curvature_weight *= 2;
  GDP_CHECK(solutions(other) == 1);
  other.presmoothing_weight *= 2;
  GDP_CHECK(solutions(other) == 1);
  other.metric = Metric::EMBEDDING; // where neither counts
  GDP_CHECK(solutions(other) == 1);
  other.curvature_weight *= 2;
  other.presmoothing_weight *= 2;
  GDP_CHECK(solutions(other) == 0);
}

void test_brushes(const std::string& path)
{
  Filter_model model(path);
  const Point center = model.original_points()[5];
  GDP_CHECK(!model.paint(Brush::MASK, center, 0.3, false)); // there is no paint to wipe off
  GDP_CHECK(model.paint(Brush::REGION, center, 0.8));
  GDP_CHECK(!model.paint(Brush::REGION, center, 0.8));
  GDP_CHECK(model.paint(Brush::CONSTRAINED, center, 0.25));
  GDP_CHECK(!model.is_painting_saved());
  for(double scale : {0., 2.})
  {
    model.set(with(1e-3, scale));
    model.save_painting();
    GDP_CHECK(model.is_painting_saved());
    GDP_CHECK(largest_difference(model.points(), commanded(model)) < 1e-12);
    std::size_t constrained = 0, moved = 0;
    for(std::size_t v = 0; v < model.points().size(); ++v)
    {
      const bool is_constrained = model.painting().is_painted(Brush::CONSTRAINED, v);
      const bool is_kept = is_constrained || !model.painting().is_painted(Brush::REGION, v);
      constrained += is_constrained;
      moved += model.points()[v] != model.original_points()[v];
      GDP_CHECK(!is_kept || model.points()[v] == model.original_points()[v]);
    }
    GDP_CHECK(constrained > 3 && moved > 20);
  }
  GDP_CHECK(model.paint(Brush::MASK, center, 0.5));
  model.set(with(1e-3, 3));
  std::size_t furthest = 0; // is where the mask is
  for(std::size_t v = 0; v < model.points().size(); ++v)
    if(CGAL::squared_distance(model.points()[v], model.original_points()[v])
       > CGAL::squared_distance(model.points()[furthest], model.original_points()[furthest]))
      furthest = v;
  GDP_CHECK(model.painting().is_painted(Brush::MASK, furthest));
  GDP_CHECK(!model.is_painting_saved());
  model.save_painting();
  GDP_CHECK(largest_difference(model.points(), commanded(model)) < 1e-12);
  model.set(with(1e-3, 2)); // the scale is in the file
  GDP_CHECK(!model.is_painting_saved());
  model.wipe_off();
  model.filter();
  GDP_CHECK(model.is_painting_saved() && model.command_words("x.off").front() == path);
  GDP_CHECK(largest_difference(model.points(), commanded(model)) < 1e-12);
}

// The other side of a thin place is not painted.
void test_connected_dab(const std::string& path)
{
  Filter_model model(path);
  const std::vector<Point>& points = model.original_points();
  const Point center = points[0];
  GDP_CHECK(model.paint(Brush::REGION, center, 0.85));
  std::size_t within = 0, painted = 0;
  for(std::size_t v = 0; v < points.size(); ++v)
  {
    const bool is_within = CGAL::squared_distance(points[v], center) <= 0.85 * 0.85;
    within += is_within;
    painted += model.painting().is_painted(Brush::REGION, v);
    GDP_CHECK(is_within || !model.painting().is_painted(Brush::REGION, v));
  }
  GDP_CHECK(painted > 10 && painted <= within);
  model.wipe_off();
  GDP_CHECK(model.paint(Brush::REGION, center, 1e-9)); // a vertex, and no face
  for(double weight : {1e-3, 1e-4})
  {
    model.set(with(weight, 3));
    GDP_CHECK(!model.why_unchanged().empty() && model.points() == points);
  }
  GDP_CHECK(model.save("region.off").size() == 1);
  model.wipe_off();
  model.filter();
  GDP_CHECK(model.why_unchanged().empty() && model.points() != points);
}

void test_saving(const std::string& path)
{
  Filter_model model(path);
  model.set(with(1e-3, 0));
  model.paint(Brush::CONSTRAINED, model.original_points()[0], 0.2);
  model.filter();
  GDP_CHECK(model.save("saved.off").empty());
  const Mesh_file saved = read("saved.off"), original = read(path);
  GDP_CHECK(largest_difference(saved.points, model.points()) < 1e-12);
  GDP_CHECK(saved.face_columns.size() == original.face_columns.size() && saved.vertex_columns.empty());
  GDP_CHECK(saved.face_columns.find("red")->values == original.face_columns.find("red")->values);
  const std::string before = contents("saved.off");
  bool has_failed = false;
  try { model.save("saved.xyz"); } catch(const Usage_error&) { has_failed = true; }
  GDP_CHECK(has_failed && contents("saved.off") == before);
}

void test_failures(const std::string& path)
{
  Filter_model model(path);
  model.set(with(1e-3, 0));
  const std::vector<Point> points = model.points();
  bool has_failed = false;
  try { model.set(with(-1, 0)); } catch(const std::exception&) { has_failed = true; }
  GDP_CHECK(has_failed && model.points() == points && model.settings().gradient_weight == 1e-3);
  model.set(with(1e-3, 2));
  GDP_CHECK(largest_difference(model.points(), commanded(model)) < 1e-12);
  has_failed = false;
  try { Filter_model("there is no such file.off"); } catch(const Failure&) { has_failed = true; }
  GDP_CHECK(has_failed);
}

void test_lengths_and_colors(const std::string& path)
{
  Filter_model model(path);
  const Wavelengths& lengths = model.wavelengths();
  GDP_CHECK_NEAR(lengths.weight(lengths.wavelength(3e-4)), 3e-4, 1e-15);
  GDP_CHECK_NEAR(lengths.wavelength(1 / lengths.area()), 2 * std::acos(-1.), 1e-12); // beta = 1 in the unit of the file
  GDP_CHECK(lengths.mean_edge() > 0.01 && lengths.mean_edge() < 0.2);
  GDP_CHECK(lengths.diagonal() > 3 && lengths.diagonal() < 5);
  GDP_CHECK(rounded(0.00012345) == 0.000123);
  model.set(with(1e-2, 0));
  const std::vector<double> displacements = model.displacements();
  GDP_CHECK(std::accumulate(displacements.begin(), displacements.end(), 0.) < 0); // it shrinks
  const std::vector<double> curvatures = model.curvatures(model.original_points());
  GDP_CHECK(curvatures.size() == model.points().size());
  GDP_CHECK(std::all_of(curvatures.begin(), curvatures.end(), [](double k) { return k > 0; }));
}

} // namespace

int main()
{
  const std::string path = "viewer torus.off", holed = "viewer_holed.off";
  write_torus(path, 60, 30);
  write_torus(holed, 40, 30, true);
  test_command_line(path);
  test_command_line(holed);
  test_what_is_done_again(path);
  test_brushes(path);
  test_connected_dab(path);
  test_saving(path);
  test_failures(path);
  test_lengths_and_colors(path);
  return GDP_TEST_RESULT();
}
