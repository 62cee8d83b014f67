// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_MESH_FILE_H
#define GRADIENT_DOMAIN_FILTER_MESH_FILE_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef CGAL::Surface_mesh<Point> Mesh;

enum class Number_type { INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT, DOUBLE };

inline bool is_integer(Number_type type) { return type != Number_type::FLOAT && type != Number_type::DOUBLE; }

// A number at every vertex or face. Every type of PLY fits into double; `type` is what it was in the file. Normals are the
// columns nx, ny, nz, colors red, green, blue and possibly alpha, whatever the format.
struct Column
{
  std::string name;
  Number_type type;
  std::vector<double> values;
};

struct Columns : std::vector<Column>
{
  Column* find(const std::string& name)
  {
    for(Column& column : *this)
      if(column.name == name)
        return &column;
    return nullptr;
  }
  const Column* find(const std::string& name) const { return const_cast<Columns*>(this)->find(name); }

  bool has_normals() const { return find("nx") && find("ny") && find("nz"); }
  bool has_colors() const { return find("red") && find("green") && find("blue"); }

  Column& find_or_add(const std::string& name, Number_type type, std::size_t size)
  {
    if(Column* column = find(name))
      return *column;
    push_back({name, type, std::vector<double>(size, 0.)});
    return back();
  }
};

// What a file says: polygons by the indices of their corners, end to end.
struct Polygon_soup
{
  std::vector<Point> points;
  std::vector<int> corners;
  std::vector<std::size_t> first_corner = {0}; // of every polygon, and the end
  Columns vertex_columns, face_columns;
  std::vector<std::string> notes; // what was in the file and is lost

  std::size_t number_of_polygons() const { return first_corner.size() - 1; }
  void close_polygon() { first_corner.push_back(corners.size()); }
};

struct Mesh_file
{
  Mesh mesh;
  Columns vertex_columns, face_columns;
  std::vector<std::string> notes;
};

enum class File_format { OFF, OBJ, PLY, STL };
enum class Encoding { DEFAULT, ASCII, BINARY };

// By the extension; throws Usage_error.
File_format file_format(const std::string& path);

struct Read_options
{
  bool triangulate = false, repair = false;
};

// Both throw Failure.
Mesh_file read_mesh_file(const std::string& path, const Read_options& options);
std::string mesh_file_contents(const Mesh_file& file, File_format format, Encoding encoding);

// `text` is all of the file; one function for each format, and one that chooses by the extension of `path`. They throw
// Failure with `path`.
Polygon_soup parse_mesh_file(const std::string& path, const std::string& text);
Polygon_soup parse_off(const std::string& path, const std::string& text);
Polygon_soup parse_obj(const std::string& path, const std::string& text);
Polygon_soup parse_ply(const std::string& path, const std::string& text);
Polygon_soup parse_stl(const std::string& path, const std::string& text);

// Colors from 0 to 1, as text formats have them, become those from 0 to 255 that all others expect; not rounded yet.
void scale_colors_to_bytes(Columns& columns);

// Makes triangles of all polygons, which have three corners at least. Throws Failure.
void split_polygons(const std::string& path, Polygon_soup& soup);

// Checks the soup and connects it; consumes it. Throws Failure.
Mesh_file connect(const std::string& path, Polygon_soup& soup, const Read_options& options);

#endif // GRADIENT_DOMAIN_FILTER_MESH_FILE_H
