// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_FILES_MESH_FILE_H
#define GRADIENT_DOMAIN_FILTER_FILES_MESH_FILE_H

#include "Records.h"

#include <CGAL/Simple_cartesian.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <boost/range/iterator_range.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;

// A number at every vertex or face. Every type of PLY fits into double; `type` is what it was in the file. Normals are
// the columns nx, ny, nz, colors red, green, blue and possibly alpha, whatever the format, with the range they have in
// the file.
struct Column
{
  std::string name;
  Number_type type;
  std::vector<double> values;
  int place = -1;               // in its record; negative if the file has no such number
  bool is_changed = false;
  bool is_spelled_real = false; // with a point always, as 1 and 1.0 are not the same
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

// Faces by the indices of their corners, end to end; a random access range of ranges of indices.
class Polygons
{
  typedef boost::iterator_range<const int*> Polygon;
  struct Get
  {
    const Polygons* polygons;
    Polygon operator()(std::size_t i) const { return (*polygons)[i]; }
  };

public:
  typedef boost::transform_iterator<Get, boost::counting_iterator<std::size_t>, Polygon, Polygon> const_iterator;
  typedef const_iterator iterator;
  typedef Polygon value_type;
  typedef Polygon const_reference;
  typedef Polygon reference;
  typedef std::size_t size_type;
  typedef std::ptrdiff_t difference_type;

  std::vector<int> corners;
  std::vector<std::size_t> first_corner = {0}; // of every polygon, and the end

  void close_polygon() { first_corner.push_back(corners.size()); }

  std::size_t size() const { return first_corner.size() - 1; }
  bool empty() const { return size() == 0; }
  Polygon operator[](std::size_t i) const
  {
    return Polygon(corners.data() + first_corner[i], corners.data() + first_corner[i + 1]);
  }
  const_iterator begin() const { return const_iterator(boost::counting_iterator<std::size_t>(0), Get{this}); }
  const_iterator end() const { return const_iterator(boost::counting_iterator<std::size_t>(size()), Get{this}); }
};

enum class File_format { OFF, OBJ, PLY, STL };
enum class Encoding { DEFAULT, ASCII, BINARY };
enum class Precision { DEFAULT, SINGLE, DOUBLE };

// A file in memory: its bytes, what the filter works on, and where that stands in the bytes. The readers are ours
// because those of CGAL and of other libraries give a mesh and drop the rest: order, comments, materials, texture
// seams, types, elements of one's own.
struct Mesh_file
{
  std::string name;
  File_format format = File_format::PLY;
  std::string text;
  bool has_mark = false; // of UTF-8, before the text

  std::vector<Point> points;
  Polygons polygons;
  Columns vertex_columns, face_columns;

  // Normals that are neither those of vertices nor of faces, as the vn of OBJ, and which one every corner has; -1:
  // none.
  Columns normal_columns;
  std::vector<int> corner_normals;

  Records vertex_records, face_records, normal_records;
  bool has_corner_records = false;                  // vertex records are those of corners, as in STL
  std::array<int, 3> coordinate_places = {{0, 1, 2}};
  Number_type coordinate_type = Number_type::DOUBLE;

  std::vector<std::string> others; // what no other format can hold

  bool has_normals() const { return vertex_columns.has_normals() || normal_columns.has_normals(); }
};

constexpr const char* utf8_mark = "\xEF\xBB\xBF";

// What is written, and how.
struct Output_form
{
  File_format format = File_format::PLY;
  // that of the file where it is of the same format; else PLY in binary and STL as text
  Encoding encoding = Encoding::DEFAULT;
  Precision precision = Precision::DEFAULT; // likewise; else double
};

// By the extension, before a .gz; throws Usage_error.
File_format file_format(const std::string& path);
bool is_compressed_name(const std::string& path);

// The bytes of a file or, for "-", of the standard input; unpacked if they are packed. Throws Failure.
std::string read_bytes(const std::string& path);
std::string packed(const std::string& bytes);

// By what is in it; throws Failure.
File_format sniffed_format(const std::string& name, const std::string& text);

// `name` is for messages. They throw Failure.
Mesh_file parse_mesh_file(const std::string& name, File_format format, std::string text);
void parse_off(Mesh_file& file);
void parse_obj(Mesh_file& file);
void parse_ply(Mesh_file& file);
void parse_stl(Mesh_file& file);

// The normals that all corners of a vertex agree upon, by vertex; empty if the file has none or there is no such
// agreement.
std::vector<Vector> vertex_normals_of_file(const Mesh_file& file);

// What would be lost.
std::vector<std::string> not_kept(const Mesh_file& file, const Output_form& form);

// The bytes to write; consumes those of the file. Throws Failure if the form cannot hold the mesh.
std::string mesh_file_contents(Mesh_file& file, const Output_form& form);
std::string changed_ply(const Mesh_file& file, const Output_form& form);
std::string new_ply(const Mesh_file& file, const Output_form& form);
std::string new_off(const Mesh_file& file, const Output_form& form);
std::string new_obj(const Mesh_file& file, const Output_form& form);
std::string new_stl(const Mesh_file& file, const Output_form& form);

// Early: whether the form can hold the faces at all. Throws Failure.
void check_form(const Mesh_file& file, const Output_form& form, const std::string& output);

#endif // GRADIENT_DOMAIN_FILTER_FILES_MESH_FILE_H
