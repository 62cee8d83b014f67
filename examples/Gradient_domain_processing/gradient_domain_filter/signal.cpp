// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "signal.h"
#include "Failure.h"
#include "files/Colors.h"
#include "files/file_blocks.h"
#include "normals.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr std::array<const char*, 3> normal_names = {{"nx", "ny", "nz"}}, color_names = {{"red", "green", "blue"}};

std::string names_of(const Columns& columns)
{
  std::string names;
  for(const Column& column : columns)
    names += (names.empty() ? "" : ", ") + column.name;
  return names.empty() ? "none" : names;
}

std::vector<Three_channels> three_columns(const Columns& columns, const std::array<const char*, 3>& names)
{
  const Column* const c[3] = {columns.find(names[0]), columns.find(names[1]), columns.find(names[2])};
  std::vector<Three_channels> signal(c[0]->values.size());
  for(std::size_t v = 0; v < signal.size(); ++v)
    signal[v] = {{c[0]->values[v], c[1]->values[v], c[2]->values[v]}};
  return signal;
}

void set_three_columns(const std::vector<Three_channels>& signal, const std::array<const char*, 3>& names,
                       Columns& columns)
{
  for(std::size_t i = 0; i < 3; ++i)
  {
    Column& column = columns.find_or_add(names[i], Number_type::DOUBLE, signal.size());
    column.is_changed = true;
    for(std::size_t v = 0; v < signal.size(); ++v)
      column.values[v] = signal[v][i];
  }
}

} // namespace

const std::vector<double>& vertex_property(const Options& options, const Mesh_file& file, const std::string& name)
{
  const Column* const column = file.vertex_columns.find(name);
  if(!column)
    throw Failure(options.input_name(),
                  "no vertex property '" + name + "'; there are: " + names_of(file.vertex_columns));
  for(std::size_t v = 0; v < column->values.size(); ++v)
    if(!std::isfinite(column->values[v]))
      throw Failure(options.input_name(),
                    "the property '" + name + "' of vertex " + std::to_string(v) + " is NaN or infinite");
  return column->values;
}

Property_signal property_signal(const Options& options, Mesh_file& file)
{
  const auto has_all = [&](const Columns& columns) {
    return std::all_of(options.signal_properties.begin(), options.signal_properties.end(),
                       [&](const std::string& name) { return columns.find(name) != nullptr; });
  };
  Property_signal signal;
  signal.is_at_faces = !has_all(file.vertex_columns);
  Columns& columns = signal.is_at_faces ? file.face_columns : file.vertex_columns;
  if(!has_all(columns))
    throw Failure(options.input_name(), "no property '" + options.signal_name
                                          + "'; vertices have: " + names_of(file.vertex_columns)
                                          + "; faces have: " + names_of(file.face_columns));
  for(const std::string& name : options.signal_properties)
  {
    signal.columns.push_back(columns.find(name));
    const std::vector<double>& values = signal.columns.back()->values;
    for(std::size_t i = 0; i < values.size(); ++i)
      if(!std::isfinite(values[i]) && !(options.has_missing_values && std::isnan(values[i])))
        throw Failure(options.input_name(),
                      "the property '" + name + "' of " + (signal.is_at_faces ? "face " : "vertex ") + std::to_string(i)
                        + (std::isnan(values[i]) ? " is NaN (--missing-values fills such in)" : " is infinite"));
  }
  for(const Column* column : signal.columns)
    signal.values.push_back(column->values);
  return signal;
}

void Property_signal::set()
{
  for(std::size_t i = 0; i < columns.size(); ++i)
  {
    columns[i]->values = std::move(values[i]);
    columns[i]->is_changed = true;
  }
}

std::vector<Three_channels> normal_signal(const Options& options, const Mesh_file& file)
{
  std::vector<Vector> normals = vertex_normals_of_file(file);
  if(normals.empty() && file.has_normals())
    throw Failure(options.input_name(), "the corners of a vertex have different normals, which cannot be filtered");
  if(normals.empty())
    normals = vertex_normals(file.points, file.polygons);
  std::vector<Three_channels> signal;
  signal.reserve(normals.size());
  for(const Vector& n : normals)
    signal.push_back({{n.x(), n.y(), n.z()}});
  return signal;
}

void set_normal_signal(const Options& options, const std::vector<Three_channels>& normals, Mesh_file& file)
{
  if(!file.normal_columns.has_normals())
    return set_three_columns(normals, normal_names, file.vertex_columns);
  // one vn may be the normal of several vertices
  std::vector<Three_channels> values = three_columns(file.normal_columns, normal_names);
  std::vector<int> vertex_of(values.size(), -1);
  for(std::size_t c = 0; c < file.corner_normals.size(); ++c)
    if(const int n = file.corner_normals[c]; n >= 0)
    {
      int& vertex = vertex_of[std::size_t(n)];
      const std::size_t v = std::size_t(file.polygons.corners[c]);
      if(vertex >= 0 && normals[v] != normals[std::size_t(vertex)])
        throw Failure(options.input_name(), "vertices " + std::to_string(vertex) + " and " + std::to_string(v)
                                            + " share a normal, which cannot be filtered");
      vertex = int(v);
      values[std::size_t(n)] = normals[v];
    }
  set_three_columns(values, normal_names, file.normal_columns);
}

std::vector<Three_channels> color_signal(const Options& options, const Mesh_file& file)
{
  if(!file.vertex_columns.has_colors())
    throw Failure(options.input_name(), "no vertex colors, as red, green and blue; there are: "
                                          + names_of(file.vertex_columns));
  return three_columns(file.vertex_columns, color_names);
}

void set_color_signal(const std::vector<Three_channels>& colors, const std::vector<double>& alpha, Mesh_file& file)
{
  Columns& columns = file.vertex_columns;
  const double full = white(columns);
  set_three_columns(colors, color_names, columns);
  if(!alpha.empty())
  {
    columns.find("alpha")->values = alpha;
    columns.find("alpha")->is_changed = true;
  }
  for(const char* name : {"red", "green", "blue", "alpha"})
    if(Column* const column = columns.find(name))
      for(double& x : column->values)
        x = full * unit_color(x, full);
}

void set_curvature(const std::vector<double>& total_curvature, Mesh_file& file)
{
  std::vector<double> sorted = total_curvature;
  std::sort(sorted.begin(), sorted.end());
  const auto percentile = [&](std::size_t percent) { return sorted[(sorted.size() - 1) * percent / 100]; };
  const double most = percentile(95);
  const double least = (std::max)(percentile(5), 1e-6 * most);
  const double decades = most > least ? std::log(most / least) : 1;

  Columns& columns = file.vertex_columns;
  Column& curvature = columns.find_or_add("curvature", Number_type::DOUBLE, total_curvature.size());
  curvature.values = total_curvature;
  curvature.is_changed = true;
  for(std::size_t i = 0; i < 3; ++i)
  {
    Column& color = columns.find_or_add(color_names[i], Number_type::UINT8, total_curvature.size());
    const double full = is_integer(color.type) ? 255 : 1;
    color.is_changed = true;
    for(std::size_t v = 0; v < total_curvature.size(); ++v)
    {
      const double k = total_curvature[v];
      const double t = k <= least || !(most > 0) ? 0 : (std::min)(1., std::log(k / least) / decades);
      const double low = (std::min)(1., 2 * t), high = (std::min)(1., 2 - 2 * t); // of red, of blue
      color.values[v] = full * (i == 0 ? low : i == 1 ? (std::min)(low, high) : high);
    }
  }
}

std::vector<std::vector<double> > signal_values(const Options& options, const Mesh_file& file)
{
  std::vector<std::vector<double> > values;
  if(options.moves_vertices())
  {
    values.assign(3, std::vector<double>(file.points.size()));
    for_each_block_of_records(file.points.size(), [&](std::size_t begin, std::size_t end) {
      for(std::size_t v = begin; v < end; ++v)
        for(int i = 0; i < 3; ++i)
          values[std::size_t(i)][v] = file.points[v][i];
    });
  }
  const Columns& normals = file.normal_columns.has_normals() ? file.normal_columns : file.vertex_columns;
  if(options.signal == Signal_kind::NORMAL && normals.has_normals())
    for(const char* name : normal_names)
      values.push_back(normals.find(name)->values);
  if(options.signal == Signal_kind::COLOR)
    for(const char* name : {"red", "green", "blue", "alpha"})
      if(const Column* const column = file.vertex_columns.find(name))
        values.push_back(column->values);
  for(const std::string& name : options.signal_properties)
    for(const Columns* columns : {&file.vertex_columns, &file.face_columns})
      if(const Column* const column = columns->find(name))
      {
        values.push_back(column->values);
        break;
      }
  return values;
}

std::vector<std::string> rounded_signals(const Options& options, const Mesh_file& file, const Output_form& form)
{
  std::vector<std::string> rounded;
  if(file.format != File_format::PLY || form.format != File_format::PLY)
    return rounded;
  const auto& properties = file.vertex_records.properties;
  if(options.moves_vertices() && form.precision == Precision::DEFAULT
     && std::any_of(file.coordinate_places.begin(), file.coordinate_places.end(),
                    [&](int place) { return is_integer(properties[std::size_t(place)].type); }))
    rounded.push_back("the file has integers for coordinates, and the result is rounded to such: --precision double "
                      "writes reals");
  for(const std::string& name : options.signal_properties)
  {
    const Column* const at_vertices = file.vertex_columns.find(name);
    const Column* const column = at_vertices ? at_vertices : file.face_columns.find(name);
    if(column && is_integer(column->type))
      rounded.push_back("the property " + name + " has integers, and the result is rounded to such");
  }
  return rounded;
}
