// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Failure.h"
#include "Mesh_file.h"

#include <algorithm>
#include <initializer_list>

namespace {

bool has_new_columns(const Columns& columns)
{
  return std::any_of(columns.begin(), columns.end(), [](const Column& column) { return column.place < 0; });
}

// Whether all numbers that may have changed have the precision that is asked for.
bool has_precision(const Mesh_file& file, Precision precision)
{
  if(precision == Precision::DEFAULT)
    return true;
  const Number_type type = precision == Precision::SINGLE ? Number_type::FLOAT : Number_type::DOUBLE;
  for(int place : file.coordinate_places)
    if(file.vertex_records.properties[std::size_t(place)].type != type)
      return false;
  for(const Columns* columns : {&file.vertex_columns, &file.face_columns})
    for(const Column& column : *columns)
      if(column.is_changed && !is_integer(column.type) && column.type != type)
        return false;
  return true;
}

bool is_text(const Mesh_file& file) { return file.vertex_records.order == Order::ASCII; }

// Whether it is enough to exchange numbers in the bytes of the file.
bool can_replace(const Mesh_file& file, const Output_form& form)
{
  if(form.format != file.format || has_new_columns(file.vertex_columns) || has_new_columns(file.face_columns))
    return false;
  if(form.encoding != Encoding::DEFAULT && (form.encoding == Encoding::ASCII) != is_text(file))
    return false;
  return file.format != File_format::PLY || has_precision(file, form.precision);
}

void add_changed(const Columns& columns, Number_type real, std::vector<Replacement>& numbers)
{
  for(const Column& column : columns)
    if(column.is_changed)
      numbers.push_back({column.place,
                         is_integer(column.type)             ? column.type
                         : column.type == Number_type::FLOAT ? column.type
                                                             : real,
                         [&column](std::size_t i) { return column.values[i]; }, column.is_spelled_real});
}

void replace_changed(Mesh_file& file, Precision precision)
{
  const Number_type real = precision == Precision::SINGLE ? Number_type::FLOAT : Number_type::DOUBLE;
  std::vector<Replaced_records> replaced;
  Replaced_records vertices{&file.vertex_records, {}};
  for(int i = 0; i < 3; ++i)
  {
    const std::size_t place = std::size_t(file.coordinate_places[std::size_t(i)]);
    const auto& properties = file.vertex_records.properties;
    const Number_type type = place < properties.size() ? properties[place].type : real;
    if(file.has_corner_records)
      vertices.numbers.push_back({int(place), type, [&file, i](std::size_t c) {
        return file.points[std::size_t(file.polygons.corners[c])][i];
      }});
    else
      vertices.numbers.push_back({int(place), type, [&file, i](std::size_t v) { return file.points[v][i]; }});
  }
  add_changed(file.vertex_columns, real, vertices.numbers);
  replaced.push_back(vertices);
  Replaced_records faces{&file.face_records, {}}, normals{&file.normal_records, {}};
  add_changed(file.face_columns, real, faces.numbers);
  add_changed(file.normal_columns, real, normals.numbers);
  if(!faces.numbers.empty())
    replaced.push_back(faces);
  if(!normals.numbers.empty())
    replaced.push_back(normals);
  replace_numbers(file.text, std::move(replaced));
}

bool is_one_of(const std::string& name, std::initializer_list<const char*> names)
{
  return std::any_of(names.begin(), names.end(), [&](const char* n) { return name == n; });
}

// Those of the columns that the format cannot hold, normals and colors by these words.
void note_columns(const Columns& columns, const char* where, bool holds_normals, bool holds_colors, bool holds_alpha,
                  std::vector<std::string>& lost)
{
  std::string names;
  std::size_t count = 0;
  for(const Column& column : columns)
  {
    if(columns.has_normals() && is_one_of(column.name, {"nx", "ny", "nz"}))
    {
      if(!holds_normals && column.name == "nx")
        lost.push_back(std::string("normals of ") + where);
    }
    else if(columns.has_colors() && is_one_of(column.name, {"red", "green", "blue", "alpha"}))
    {
      if(!holds_colors && column.name == "red")
        lost.push_back(std::string("colors of ") + where);
      else if(holds_colors && !holds_alpha && column.name == "alpha")
        lost.push_back(std::string("alpha of ") + where);
    }
    else if(++count <= 6)
      names += (names.empty() ? "" : ", ") + column.name;
  }
  if(count > 0)
    lost.push_back((count == 1 ? "the property " : "the properties ") + names + (count > 6 ? ", ..." : "") + " of "
                   + where);
}

bool is_binary_stl(const Mesh_file& file, const Output_form& form)
{
  return form.format == File_format::STL
         && (form.encoding == Encoding::BINARY
             || (form.encoding == Encoding::DEFAULT && file.format == File_format::STL && !is_text(file)));
}

// Numbers that would become infinite where single precision is written.
void check_range(const Mesh_file& file, const Output_form& form)
{
  const bool is_single =
    form.precision == Precision::SINGLE || is_binary_stl(file, form)
    || (form.precision == Precision::DEFAULT && form.format == File_format::PLY && file.format == File_format::PLY
        && file.coordinate_type == Number_type::FLOAT && !(is_text(file) && can_replace(file, form)));
  if(!is_single)
    return;
  for(std::size_t v = 0; v < file.points.size(); ++v)
    for(int i = 0; i < 3; ++i)
      if(!fits(file.points[v][i], Number_type::FLOAT))
        throw Failure(file.name, "vertex " + std::to_string(v) + " does not fit into single precision");
}

} // namespace

std::vector<Vector> vertex_normals_of_file(const Mesh_file& file)
{
  std::vector<Vector> normals;
  const Columns& columns = file.vertex_columns.has_normals() ? file.vertex_columns : file.normal_columns;
  if(!columns.has_normals())
    return normals;
  const auto &x = columns.find("nx")->values, &y = columns.find("ny")->values, &z = columns.find("nz")->values;
  normals.assign(file.points.size(), Vector(0, 0, 0));
  if(&columns == &file.vertex_columns)
  {
    for(std::size_t v = 0; v < normals.size(); ++v)
      normals[v] = Vector(x[v], y[v], z[v]);
    return normals;
  }
  std::vector<int> normal_at(file.points.size(), -1);
  for(std::size_t c = 0; c < file.polygons.corners.size(); ++c)
  {
    const int n = c < file.corner_normals.size() ? file.corner_normals[c] : -1;
    int& at = normal_at[std::size_t(file.polygons.corners[c])];
    if(n < 0)
      return std::vector<Vector>();
    const std::size_t i = std::size_t(n), j = std::size_t(at < 0 ? n : at);
    if(x[i] != x[j] || y[i] != y[j] || z[i] != z[j])
      return std::vector<Vector>();
    at = n;
  }
  for(std::size_t v = 0; v < normals.size(); ++v)
    if(normal_at[v] >= 0)
      normals[v] = Vector(x[std::size_t(normal_at[v])], y[std::size_t(normal_at[v])], z[std::size_t(normal_at[v])]);
  return normals;
}

std::vector<std::string> not_kept(const Mesh_file& file, const Output_form& form)
{
  std::vector<std::string> lost;
  if(can_replace(file, form) || (file.format == File_format::PLY && form.format == File_format::PLY))
    return lost;
  lost = file.others;
  if(file.has_mark)
    lost.push_back("the mark of UTF-8");
  const bool is_ply = form.format == File_format::PLY, is_stl = form.format == File_format::STL;
  if(!is_ply)
  {
    note_columns(file.vertex_columns, "vertices", !is_stl, !is_stl, form.format == File_format::OFF, lost);
    if(file.format != File_format::STL) // its normals follow from the corners
      note_columns(file.face_columns, "faces", is_stl, form.format == File_format::OFF, true, lost);
  }
  if(file.normal_columns.has_normals() && (is_stl || vertex_normals_of_file(file).empty()))
    lost.push_back(is_stl ? "normals of vertices" : "normals, which are not one for every vertex");
  if(is_stl && file.format != File_format::STL)
  {
    std::vector<char> is_used(file.points.size(), 0);
    for(int v : file.polygons.corners)
      is_used[std::size_t(v)] = 1;
    if(const auto unused = std::count(is_used.begin(), is_used.end(), 0))
      lost.push_back(std::to_string(unused) + (unused == 1 ? " vertex" : " vertices") + " without a face");
  }
  return lost;
}

void check_form(const Mesh_file& file, const Output_form& form, const std::string& output)
{
  if(form.format == File_format::STL && form.precision == Precision::DOUBLE && is_binary_stl(file, form))
    throw Failure(output, "binary STL is single precision");
  if(form.format != File_format::STL || can_replace(file, form))
    return;
  for(std::size_t f = 0; f < file.polygons.size(); ++f)
    if(file.polygons[f].size() != 3)
      throw Failure(output, "STL holds triangles only, and face " + std::to_string(f) + " has "
                              + std::to_string(file.polygons[f].size()) + " corners");
}

std::string mesh_file_contents(Mesh_file& file, const Output_form& form)
{
  check_range(file, form);
  if(can_replace(file, form))
  {
    replace_changed(file, form.precision);
    if(file.has_mark)
      file.text.insert(0, utf8_mark);
    return std::move(file.text);
  }
  switch(form.format)
  {
    case File_format::OFF: return new_off(file, form);
    case File_format::OBJ: return new_obj(file, form);
    case File_format::PLY: return file.format == File_format::PLY ? changed_ply(file, form) : new_ply(file, form);
    case File_format::STL: return new_stl(file, form);
  }
  return std::string();
}
