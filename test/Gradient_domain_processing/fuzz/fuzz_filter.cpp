// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// From the bytes of a file through the command line's own code to a result. The first line of an input is the command
// line, as in "in.off out.ply --gradient-scale 2"; the mesh file follows. Whatever comes, the program refuses it, or
// the result is finite and can be read again, and unchanged it comes out to the byte; on an error everything is as it
// was.

#include <Failure.h>
#include <Options.h>
#include <Report.h>
#include <Stage_clock.h>
#include <Survey.h>
#include <files/Mesh_file.h>
#include <filter_mesh.h>
#include <normals.h>

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
  options.non_shrinking = (std::min)(options.non_shrinking, int(most_passes));
  options.passes = (std::min)(options.passes.value_or(int(most_passes)), int(most_passes));
  return true;
}

bool is_same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

bool is_same(const Point& a, const Point& b)
{
  return is_same(a.x(), b.x()) && is_same(a.y(), b.y()) && is_same(a.z(), b.z());
}

bool are_same(const std::vector<Point>& a, const std::vector<Point>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Point& p, const Point& q) { return is_same(p, q); });
}

// What faces use is finite, and what was filtered; but outside of a region points stay whatever they are.
bool is_finite(const Mesh_file& file, const Mesh_file& before, bool has_region)
{
  for(int v : file.polygons.corners)
    for(int i = 0; i < 3; ++i)
      if(!std::isfinite(file.points[std::size_t(v)][i])
         && !(has_region && is_same(file.points[std::size_t(v)], before.points[std::size_t(v)])))
        return false;
  for(const Columns* columns : {&file.vertex_columns, &file.face_columns, &file.normal_columns})
    for(const Column& column : *columns)
      for(const double x : column.values)
        if(column.is_changed && !std::isfinite(x) && column.place < 0)
          return false;
  return true;
}

// Columns that were added do not count.
bool is_as_it_was(const Mesh_file& now, const Mesh_file& before)
{
  if(!are_same(now.points, before.points))
    return false;
  for(const auto columns : {&Mesh_file::vertex_columns, &Mesh_file::face_columns, &Mesh_file::normal_columns})
    for(const Column& column : before.*columns)
    {
      const Column* const c = (now.*columns).find(column.name);
      if(!c || !std::equal(column.values.begin(), column.values.end(), c->values.begin(), c->values.end(),
                           [](double x, double y) { return is_same(x, y); }))
        return false;
    }
  return true;
}

// The result can be read again, to the bit where it is not of single precision.
void check_written(Mesh_file& file, const Options& options)
{
  const Output_form form{options.output_format.value_or(file.format), options.encoding, options.precision};
  const bool is_other_format = form.format != file.format;
  std::string text;
  try
  {
    check_output_form(options, form);
    check_form(file, form, options.output_name());
    text = mesh_file_contents(file, form);
  }
  catch(const Usage_error&) { return; }
  catch(const Failure&) { return; } // a form that cannot hold the mesh
  const Mesh_file again = parse_mesh_file(options.output_name(), form.format, text);
  demand(again.polygons.corners.size() == file.polygons.corners.size(), "faces were lost");
  if(is_other_format && form.format != File_format::STL && form.precision != Precision::SINGLE)
    demand(are_same(again.points, file.points), "points were changed");
}

// Without a change every file comes out as it came in.
void check_copy(const Mesh_file& file)
{
  Mesh_file copy = file;
  const std::string before = file.text;
  try
  {
    demand(mesh_file_contents(copy, {file.format, Encoding::DEFAULT, Precision::DEFAULT}) == before,
           "the copy is another");
  }
  catch(const Failure&) {} // numbers beyond their type
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
    std::string text(input.substr((std::min)(end + 1, input.size())));
    const File_format format =
      options.input_format ? *options.input_format : sniffed_format(options.input_name(), text);
    file = parse_mesh_file(options.input_name(), format, std::move(text));
  }
  catch(const Usage_error&) { return; }
  catch(const Failure&) { return; }
  check_copy(file);
  if(file.points.size() > most_vertices || file.polygons.size() > most_faces)
    return;

  const Mesh_file before = file;
  Stage_clock clock(false);
  Report report;
  report.survey = survey(file.points, file.polygons, true);
  try
  {
    const Error_code code = filter_mesh(options, file, clock, report.facts);
    if(code != CGAL::Gradient_domain_processing::ok)
    {
      demand(is_as_it_was(file, before), "an error, but the mesh has changed");
      return;
    }
  }
  catch(const Failure&)
  {
    demand(is_as_it_was(file, before), "a failure, but the mesh has changed");
    return;
  }
  report.updated_normals = update_normals(before.points, file);
  demand(is_finite(file, before, !options.region_property.empty()), "the result is not finite");
  check_written(file, options);
  demand(!report.json(options, clock).empty() && !report.summary(options, clock).empty(), "no report");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  std::cout.setstate(std::ios::failbit); // help and version are of no use here
  run(std::string_view(reinterpret_cast<const char*>(data), size));
  return 0;
}
