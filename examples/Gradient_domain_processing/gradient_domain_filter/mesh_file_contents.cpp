// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Mesh_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>

namespace {

class Text_writer
{
  std::string m_text;

public:
  Text_writer& operator<<(const char* text) { m_text += text; return *this; }
  Text_writer& operator<<(const std::string& text) { m_text += text; return *this; }
  Text_writer& operator<<(std::size_t i) { m_text += std::to_string(i); return *this; }

  // So many digits that reading gives the same number again.
  Text_writer& operator<<(double x)
  {
    char buffer[40];
#ifdef __cpp_lib_to_chars
    m_text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, x).ptr);
#else
    m_text.append(buffer, std::size_t(std::snprintf(buffer, sizeof buffer, "%.17g", x)));
#endif
    return *this;
  }

  template <class T>
  void bytes(T x)
  {
    char buffer[sizeof(T)];
    std::memcpy(buffer, &x, sizeof(T));
    m_text.append(buffer, sizeof(T));
  }

  void reserve(std::size_t size) { m_text.reserve(size); }
  std::string take() { return std::move(m_text); }
};

// Integers are rounded and clamped, never wrapped.
double in_range(double x, Number_type type)
{
  static const double range[][2] = {{-128., 127.}, {0., 255.}, {-32768., 32767.}, {0., 65535.}, {-2147483648., 2147483647.}, {0., 4294967295.}};
  if(!is_integer(type))
    return x;
  if(!(x >= range[int(type)][0])) // and NaN
    return range[int(type)][0];
  return (std::min)(std::round(x), range[int(type)][1]);
}

void write_number(Text_writer& out, double x, Number_type type, bool is_binary)
{
  x = in_range(x, type);
  if(!is_binary)
  {
    out << x;
    return;
  }
  switch(type)
  {
    case Number_type::INT8: out.bytes(std::int8_t(x)); break;
    case Number_type::UINT8: out.bytes(std::uint8_t(x)); break;
    case Number_type::INT16: out.bytes(std::int16_t(x)); break;
    case Number_type::UINT16: out.bytes(std::uint16_t(x)); break;
    case Number_type::INT32: out.bytes(std::int32_t(x)); break;
    case Number_type::UINT32: out.bytes(std::uint32_t(x)); break;
    case Number_type::FLOAT: out.bytes(float(x)); break;
    case Number_type::DOUBLE: out.bytes(x); break;
  }
}

bool is_little_endian_machine()
{
  const std::uint16_t one = 1;
  char first;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

std::array<std::size_t, 3> corners(const Mesh& mesh, Mesh::Face_index f)
{
  const auto last = mesh.halfedge(f), first = mesh.next(last);
  return {{std::size_t(mesh.source(first)), std::size_t(mesh.target(first)), std::size_t(mesh.source(last))}};
}

void write_columns(Text_writer& out, const Columns& columns, std::size_t i, bool is_binary)
{
  for(const Column& column : columns)
  {
    if(!is_binary)
      out << " ";
    write_number(out, column.values[i], column.type, is_binary);
  }
}

std::string ply(const Mesh_file& file, bool is_binary)
{
  static const char* const type_names[] = {"char", "uchar", "short", "ushort", "int", "uint", "float", "double"};
  const Mesh& mesh = file.mesh;
  Text_writer out;
  out.reserve((is_binary ? 1 : 2) * (mesh.number_of_vertices() * 8 * (3 + file.vertex_columns.size())
                                     + mesh.number_of_faces() * (13 + 8 * file.face_columns.size())) + 1024);
  out << "ply\nformat " << (!is_binary ? "ascii" : is_little_endian_machine() ? "binary_little_endian" : "binary_big_endian") << " 1.0\n";
  out << "element vertex " << std::size_t(mesh.number_of_vertices()) << "\nproperty double x\nproperty double y\nproperty double z\n";
  for(const Column& column : file.vertex_columns)
    out << "property " << type_names[int(column.type)] << " " << column.name << "\n";
  out << "element face " << std::size_t(mesh.number_of_faces()) << "\nproperty list uchar int vertex_indices\n";
  for(const Column& column : file.face_columns)
    out << "property " << type_names[int(column.type)] << " " << column.name << "\n";
  out << "end_header\n";

  for(Mesh::Vertex_index v : mesh.vertices())
  {
    const Point& p = mesh.point(v);
    if(is_binary)
      for(int i = 0; i < 3; ++i)
        out.bytes(double(p[i]));
    else
      out << p[0] << " " << p[1] << " " << p[2];
    write_columns(out, file.vertex_columns, std::size_t(v), is_binary);
    if(!is_binary)
      out << "\n";
  }
  for(Mesh::Face_index f : mesh.faces())
  {
    const auto t = corners(mesh, f);
    if(is_binary)
    {
      out.bytes(std::uint8_t(3));
      for(std::size_t v : t)
        out.bytes(std::int32_t(v));
    }
    else
      out << "3 " << t[0] << " " << t[1] << " " << t[2];
    write_columns(out, file.face_columns, std::size_t(f), is_binary);
    if(!is_binary)
      out << "\n";
  }
  return out.take();
}

// The columns of a group, of those there are.
Columns group(const Columns& columns, std::initializer_list<const char*> names)
{
  Columns found;
  for(const char* name : names)
    if(const Column* column = columns.find(name))
      found.push_back(*column);
  return found;
}

std::string off(const Mesh_file& file)
{
  const Mesh& mesh = file.mesh;
  const Columns& columns = file.vertex_columns;
  const Columns normals = columns.has_normals() ? group(columns, {"nx", "ny", "nz"}) : Columns();
  const Columns colors = columns.has_colors() ? group(columns, {"red", "green", "blue", "alpha"}) : Columns();
  Text_writer out;
  out << (colors.empty() ? "" : "C") << (normals.empty() ? "" : "N") << "OFF\n"
      << std::size_t(mesh.number_of_vertices()) << " " << std::size_t(mesh.number_of_faces()) << " 0\n";
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    const Point& p = mesh.point(v);
    out << p[0] << " " << p[1] << " " << p[2];
    write_columns(out, normals, std::size_t(v), false);
    for(const Column& column : colors)
    {
      out << " ";
      const double x = in_range(column.values[std::size_t(v)], column.type);
      out << x;
      if(!is_integer(column.type) && x == std::floor(x))
        out << ".0"; // lest it be taken for one of 0..255
    }
    out << "\n";
  }
  for(Mesh::Face_index f : mesh.faces())
  {
    const auto t = corners(mesh, f);
    out << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
  }
  return out.take();
}

std::string obj(const Mesh_file& file)
{
  const Mesh& mesh = file.mesh;
  const Columns& columns = file.vertex_columns;
  const Columns normals = columns.has_normals() ? group(columns, {"nx", "ny", "nz"}) : Columns();
  const Columns colors = columns.has_colors() ? group(columns, {"red", "green", "blue"}) : Columns();
  Text_writer out;
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    const Point& p = mesh.point(v);
    out << "v " << p[0] << " " << p[1] << " " << p[2];
    for(const Column& column : colors) // from 0 to 1 in OBJ, where they need not be rounded
    {
      const double x = column.values[std::size_t(v)];
      const double largest = column.type == Number_type::UINT8 ? 255. : column.type == Number_type::UINT16 ? 65535. : 1.;
      out << " " << (is_integer(column.type) ? (std::min)((std::max)(x, 0.), largest) / largest : x);
    }
    out << "\n";
  }
  if(!normals.empty())
    for(Mesh::Vertex_index v : mesh.vertices())
    {
      out << "vn";
      write_columns(out, normals, std::size_t(v), false);
      out << "\n";
    }
  for(Mesh::Face_index f : mesh.faces())
  {
    out << "f";
    for(std::size_t v : corners(mesh, f))
    {
      out << " " << v + 1;
      if(!normals.empty())
        out << "//" << v + 1;
    }
    out << "\n";
  }
  return out.take();
}

Vector unit_normal(const Point& a, const Point& b, const Point& c)
{
  const Vector n = CGAL::cross_product(b - a, c - a);
  const double length = std::sqrt(n.squared_length());
  return length > 0 && std::isfinite(length) ? n / length : Vector(0, 0, 0);
}

// The binary form knows no double precision.
std::string stl(const Mesh_file& file, bool is_binary)
{
  const Mesh& mesh = file.mesh;
  Text_writer out;
  const auto number = [&](double x) {
    float single = float(x);
    std::uint32_t bits;
    std::memcpy(&bits, &single, 4);
    for(int i = 0; i < 4; ++i)
      out.bytes(std::uint8_t(bits >> 8 * i));
  };
  if(is_binary)
  {
    out << std::string(80, ' ');
    for(int i = 0; i < 4; ++i)
      out.bytes(std::uint8_t(std::uint32_t(mesh.number_of_faces()) >> 8 * i));
  }
  else
    out << "solid\n";
  for(Mesh::Face_index f : mesh.faces())
  {
    Point p[3];
    int corner = 0;
    for(std::size_t v : corners(mesh, f))
      p[corner++] = mesh.point(Mesh::Vertex_index(Mesh::size_type(v)));
    const Vector n = unit_normal(p[0], p[1], p[2]);
    if(is_binary)
    {
      for(int i = 0; i < 3; ++i)
        number(n[i]);
      for(const Point& q : p)
        for(int i = 0; i < 3; ++i)
          number(q[i]);
      out.bytes(std::uint8_t(0));
      out.bytes(std::uint8_t(0));
      continue;
    }
    out << "facet normal " << n[0] << " " << n[1] << " " << n[2] << "\nouter loop\n";
    for(const Point& q : p)
      out << "vertex " << q[0] << " " << q[1] << " " << q[2] << "\n";
    out << "endloop\nendfacet\n";
  }
  if(!is_binary)
    out << "endsolid\n";
  return out.take();
}

} // namespace

std::string mesh_file_contents(const Mesh_file& file, File_format format, Encoding encoding)
{
  switch(format)
  {
    case File_format::OFF: return off(file);
    case File_format::OBJ: return obj(file);
    case File_format::PLY: return ply(file, encoding != Encoding::ASCII);
    case File_format::STL: return stl(file, encoding == Encoding::BINARY);
  }
  return std::string();
}
