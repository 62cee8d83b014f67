// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Failure.h"
#include "Colors.h"
#include "Mesh_file.h"

// Files of another format than the input, which hold what both know.
namespace {

constexpr std::array<const char*, 4> color_names = {{"red", "green", "blue", "alpha"}};

Number_type real_type(const Output_form& form)
{
  return form.precision == Precision::SINGLE ? Number_type::FLOAT : Number_type::DOUBLE;
}

void append_vector(std::string& text, double x, double y, double z, Number_type type)
{
  append_number(text, x, type);
  text += ' ';
  append_number(text, y, type);
  text += ' ';
  append_number(text, z, type);
}

void append_point(std::string& text, const Point& p, Number_type type)
{
  append_vector(text, p.x(), p.y(), p.z(), type);
}

// In OFF bytes are integers and all others reals with a point.
class Off_colors
{
  std::vector<const Column*> m_columns;
  double m_white;

public:
  explicit Off_colors(const Columns& columns) : m_white(white(columns))
  {
    if(columns.has_colors())
      for(const char* name : color_names)
        if(const Column* const column = columns.find(name))
          m_columns.push_back(column);
  }

  bool empty() const { return m_columns.empty(); }

  void append(std::string& text, std::size_t i, Number_type type) const
  {
    for(const Column* column : m_columns)
    {
      text += ' ';
      if(is_integer(column->type) && m_white == 255)
      {
        append_number(text, column->values[i], Number_type::UINT8);
        continue;
      }
      const double x = unit_color(column->values[i], m_white);
      append_number(text, x, type);
      if(x == std::floor(x))
        text += ".0";
    }
  }
};

} // namespace

std::string new_off(const Mesh_file& file, const Output_form& form)
{
  const Number_type type = real_type(form);
  const std::vector<Vector> normals = vertex_normals_of_file(file);
  const Off_colors colors(file.vertex_columns), face_colors(file.face_columns);
  std::string text = std::string(colors.empty() ? "" : "C") + (normals.empty() ? "" : "N") + "OFF\n";
  text += std::to_string(file.points.size()) + " " + std::to_string(file.polygons.size()) + " 0\n";
  for(std::size_t v = 0; v < file.points.size(); ++v)
  {
    append_point(text, file.points[v], type);
    if(!normals.empty())
    {
      text += ' ';
      append_vector(text, normals[v].x(), normals[v].y(), normals[v].z(), type);
    }
    colors.append(text, v, type);
    text += '\n';
  }
  for(std::size_t f = 0; f < file.polygons.size(); ++f)
  {
    append_integer(text, file.polygons[f].size());
    for(int v : file.polygons[f])
    {
      text += ' ';
      append_integer(text, std::size_t(v));
    }
    face_colors.append(text, f, type);
    text += '\n';
  }
  return text;
}

std::string new_obj(const Mesh_file& file, const Output_form& form)
{
  const Number_type type = real_type(form);
  const std::vector<Vector> normals = vertex_normals_of_file(file);
  const bool has_colors = file.vertex_columns.has_colors();
  const double full = white(file.vertex_columns);
  std::string text;
  for(std::size_t v = 0; v < file.points.size(); ++v)
  {
    text += "v ";
    append_point(text, file.points[v], type);
    for(std::size_t i = 0; has_colors && i < 3; ++i)
    {
      text += ' ';
      append_number(text, unit_color(file.vertex_columns.find(color_names[i])->values[v], full), type);
    }
    text += '\n';
  }
  for(const Vector& n : normals)
  {
    text += "vn ";
    append_vector(text, n.x(), n.y(), n.z(), type);
    text += '\n';
  }
  for(std::size_t f = 0; f < file.polygons.size(); ++f)
  {
    text += 'f';
    for(int v : file.polygons[f])
    {
      text += ' ';
      append_integer(text, std::size_t(v) + 1);
      if(normals.empty())
        continue;
      text += "//";
      append_integer(text, std::size_t(v) + 1);
    }
    text += '\n';
  }
  return text;
}

namespace {

Vector unit_normal(const Point& a, const Point& b, const Point& c)
{
  const Vector n = CGAL::cross_product(b - a, c - a);
  const double length = std::sqrt(n.squared_length());
  return length > 0 && std::isfinite(length) ? n / length : Vector(0, 0, 0);
}

void append_text_facet(std::string& text, const Vector& n, const std::array<Point, 3>& corners, Number_type type)
{
  text += "facet normal ";
  append_vector(text, n.x(), n.y(), n.z(), type);
  text += "\nouter loop\n";
  for(const Point& p : corners)
  {
    text += "vertex ";
    append_point(text, p, type);
    text += '\n';
  }
  text += "endloop\nendfacet\n";
}

void append_binary_facet(std::string& text, const Vector& n, const std::array<Point, 3>& corners)
{
  for(int i = 0; i < 3; ++i)
    append_binary_number(text, n[i], Number_type::FLOAT, little_endian());
  for(const Point& p : corners)
    for(int i = 0; i < 3; ++i)
      append_binary_number(text, p[i], Number_type::FLOAT, little_endian());
  text.append(2, '\0');
}

} // namespace

// The binary form knows no double precision.
std::string new_stl(const Mesh_file& file, const Output_form& form)
{
  const bool is_binary = form.encoding == Encoding::BINARY;
  std::string text = is_binary ? std::string(80, ' ') : "solid\n";
  if(is_binary)
    append_binary_number(text, double(file.polygons.size()), Number_type::UINT32, little_endian());
  for(std::size_t f = 0; f < file.polygons.size(); ++f)
  {
    std::array<Point, 3> corners;
    for(std::size_t i = 0; i < 3; ++i)
      corners[i] = file.points[std::size_t(file.polygons[f][std::ptrdiff_t(i)])];
    const Vector n = unit_normal(corners[0], corners[1], corners[2]);
    if(is_binary)
      append_binary_facet(text, n, corners);
    else
      append_text_facet(text, n, corners, real_type(form));
  }
  if(!is_binary)
    text += "endsolid\n";
  return text;
}
