// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// From the bytes of a file through the command line's own code to a result. The first line of an input is the command
// line, as in "in.off out.ply --gradient-scale 2"; the mesh file follows. Whatever comes, the program refuses it, or the
// result is finite and can be read again; on an error everything is as it was.

#include <Failure.h>
#include <Mesh_file.h>
#include <Options.h>
#include <Report.h>
#include <Stage_clock.h>
#include <filter_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

namespace {

using CGAL::Gradient_domain_processing::Error_code;

// Larger meshes and more passes are only slower.
constexpr std::size_t most_vertices = 300, most_faces = 600, most_passes = 3;

// Sanitizers and fuzzers take an abort for what it is.
void demand(bool holds, const char* what)
{
  if(holds)
    return;
  std::fprintf(stderr, "fuzz_filter: %s\n", what);
  std::abort();
}

bool read_options(std::string_view line, Options& options)
{
  std::vector<std::string> words = {"gradient_domain_filter"};
  std::string word;
  for(const char c : std::string(line) + " ")
    if(c != ' ' && c != '\0')
      word += c;
    else if(!word.empty())
    {
      words.push_back(word);
      word.clear();
    }
  std::vector<char*> arguments;
  for(std::string& w : words)
    arguments.push_back(&w[0]);
  if(!parse_command_line(int(arguments.size()), arguments.data(), options))
    return false;
  options.iterations = (std::min)(options.iterations, int(most_passes));
  options.passes = (std::min)(options.passes, int(most_passes));
  return true;
}

bool is_finite(const Mesh_file& file, const Options& options)
{
  for(const Point& p : file.mesh.points())
    if(!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      return false;
  std::vector<const char*> names;
  if(options.signal == Signal_kind::NORMAL)
    names = {"nx", "ny", "nz"};
  else if(options.signal == Signal_kind::COLOR)
    names = {"red", "green", "blue"};
  else if(options.signal == Signal_kind::CURVATURE)
    names = {"curvature", "red", "green", "blue"};
  for(const char* name : names)
  {
    const Column* const column = file.vertex_columns.find(name);
    demand(column != nullptr, "the signal is not there");
    for(const double x : column->values)
      if(!std::isfinite(x))
        return false;
  }
  return true;
}

bool is_same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

// Columns that were added do not count.
bool is_as_it_was(const Mesh_file& file, const std::vector<Point>& points, const Columns& columns)
{
  if(!std::equal(points.begin(), points.end(), file.mesh.points().begin(), file.mesh.points().end()))
    return false;
  for(const Column& column : columns)
  {
    const Column* const now = file.vertex_columns.find(column.name);
    if(!now || !std::equal(column.values.begin(), column.values.end(), now->values.begin(), now->values.end(), is_same))
      return false;
  }
  return true;
}

void check_written(const Mesh_file& file, const Options& options)
{
  const std::string text = mesh_file_contents(file, options.output_format, options.encoding);
  if(options.output_format == File_format::STL) // merges points
  {
    parse_mesh_file(options.output, text);
    return;
  }
  const Polygon_soup soup = parse_mesh_file(options.output, text);
  demand(soup.number_of_polygons() == file.mesh.number_of_faces(), "faces were lost");
  demand(std::equal(soup.points.begin(), soup.points.end(), file.mesh.points().begin(), file.mesh.points().end()), "points were changed");
}

void run(std::string_view input)
{
  const std::size_t end = (std::min)(input.find('\n'), input.size());
  Options options;
  Mesh_file file;
  try
  {
    if(!read_options(input.substr(0, end), options))
      return;
    Polygon_soup soup = parse_mesh_file(options.input, std::string(input.substr((std::min)(end + 1, input.size()))));
    if(soup.points.size() > most_vertices || soup.number_of_polygons() > most_faces)
      return;
    file = connect(options.input, soup, options.read);
  }
  catch(const Usage_error&) { return; }
  catch(const Failure&) { return; }

  const std::vector<Point> points(file.mesh.points().begin(), file.mesh.points().end());
  const Columns columns = file.vertex_columns;
  Stage_clock clock(false);
  Report report;
  report.count(file.mesh);
  try
  {
    const Error_code code = filter_mesh(options, file, clock, report.solver);
    if(code != CGAL::Gradient_domain_processing::OK)
    {
      demand(is_as_it_was(file, points, columns), "an error, but the mesh has changed");
      return;
    }
  }
  catch(const Failure&)
  {
    demand(is_as_it_was(file, points, columns), "a failure, but the mesh has changed");
    return;
  }
  demand(is_finite(file, options), "the result is not finite");
  check_written(file, options);
  demand(!report.json(options, clock).empty() && !report.summary(options, clock, file.notes).empty(), "no report");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  std::cout.setstate(std::ios::failbit); // help and version are of no use here
  run(std::string_view(reinterpret_cast<const char*>(data), size));
  return 0;
}
