// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Failure.h"
#include "Mesh_file.h"
#include "Text_scanner.h"
#include "Value_index.h"

#include <algorithm>

namespace {

// STL knows no vertices, only corners; equal ones are one vertex. Their numbers stay where they are.
class Stl_parser
{
  Mesh_file& m_file;
  Value_index<3> m_points;

public:
  explicit Stl_parser(Mesh_file& file) : m_file(file), m_points(file.text.size() / 100)
  {
    m_file.has_corner_records = true;
  }

  void parse()
  {
    const std::string& text = m_file.text;
    const bool looks_ascii = text.compare(0, 5, "solid") == 0;
    std::uint32_t count = 0;
    if(text.size() >= 84)
      for(int i = 3; i >= 0; --i)
        count = 256 * count + (unsigned char)text[80 + std::size_t(i)];
    if(text.size() >= 84 && (!looks_ascii || text.size() == 84 + 50 * std::size_t(count)))
      read_binary(count);
    else if(looks_ascii)
      read_text();
    else
      throw Failure(m_file.name, "not an STL file");
    m_file.points.reserve(m_points.values().size());
    for(const auto& p : m_points.values())
      m_file.points.emplace_back(p[0], p[1], p[2]);
  }

private:
  void add_normal_columns(Number_type type)
  {
    for(const char* name : {"nx", "ny", "nz"})
      m_file.face_columns.push_back({name, type, {}, int(m_file.face_columns.size())});
    m_file.coordinate_type = type;
  }

  void read_binary(std::size_t count)
  {
    const std::string& text = m_file.text;
    if((text.size() - 84) / 50 < count)
      throw Failure(m_file.name, "not an STL file, or cut off: " + std::to_string(count) + " triangles are announced");
    if(text.substr(0, 80).find_first_not_of(std::string(" \0", 2)) != std::string::npos)
      m_file.others.push_back("header");
    add_normal_columns(Number_type::FLOAT);
    Records& faces = m_file.face_records;
    faces.order = m_file.vertex_records.order = little_endian();
    faces.first = 84;
    faces.stride = 50;
    faces.count = count;
    faces.properties = m_file.vertex_records.properties = {
      {"x", Number_type::FLOAT}, {"y", Number_type::FLOAT}, {"z", Number_type::FLOAT}};
    m_file.vertex_records.offsets.reserve(3 * count);
    m_file.polygons.corners.reserve(3 * count);
    m_file.polygons.first_corner.reserve(count + 1);
    for(Column& column : m_file.face_columns)
      column.values.reserve(count);
    bool has_attributes = false;
    for(std::size_t f = 0; f < count; ++f)
    {
      const char* const at = text.data() + faces.offset(f);
      for(std::size_t i = 0; i < 3; ++i)
        m_file.face_columns[i].values.push_back(binary_number(at + 4 * i, Number_type::FLOAT, faces.order));
      for(std::size_t corner = 1; corner < 4; ++corner)
      {
        double x[3];
        for(std::size_t i = 0; i < 3; ++i)
          x[i] = binary_number(at + 12 * corner + 4 * i, Number_type::FLOAT, faces.order);
        m_file.vertex_records.offsets.push_back(faces.offset(f) + 12 * corner);
        m_file.polygons.corners.push_back(m_points.find_or_add({{x[0], x[1], x[2]}}));
      }
      m_file.polygons.close_polygon();
      has_attributes = has_attributes || at[48] != 0 || at[49] != 0;
    }
    if(has_attributes)
      m_file.others.push_back("attribute bytes");
    if(text.size() > 84 + 50 * count)
      m_file.others.push_back("bytes after the last triangle");
  }

  double number(Text_scanner& scanner) const
  {
    double x;
    if(!scanner.number(x))
      throw Failure(m_file.name,
                    "triangle " + std::to_string(m_file.polygons.size()) + " holds something that is not a number");
    return x;
  }

  // The place of the next number.
  std::size_t offset(Text_scanner& scanner) const
  {
    scanner.skip_space();
    return std::size_t(scanner.position() - m_file.text.data());
  }

  void read_text()
  {
    add_normal_columns(Number_type::DOUBLE);
    Text_scanner scanner(m_file.text);
    bool has_ended = false, has_name = false;
    while(!scanner.at_end())
    {
      const std::string_view word = scanner.word();
      if(word == "solid" || word == "endsolid") // a name follows, which may be anything
      {
        has_ended = word == "endsolid";
        has_name = !Text_scanner(scanner.line()).at_end() || has_name;
      }
      else if(word == "facet")
      {
        scanner.word();
        m_file.face_records.offsets.push_back(offset(scanner));
        for(Column& column : m_file.face_columns)
          column.values.push_back(number(scanner));
      }
      else if(word == "vertex")
      {
        m_file.vertex_records.offsets.push_back(offset(scanner));
        const double x = number(scanner), y = number(scanner), z = number(scanner);
        m_file.polygons.corners.push_back(m_points.find_or_add({{x, y, z}}));
      }
      else if(word == "endfacet")
        m_file.polygons.close_polygon();
    }
    if(!has_ended)
      throw Failure(m_file.name, "the file ends before 'endsolid'");
    if(m_file.face_columns[0].values.size() != m_file.polygons.size())
      throw Failure(m_file.name, "a 'facet' without its 'endfacet', or the other way round");
    if(has_name)
      m_file.others.push_back("name of the solid");
  }
};

} // namespace

void parse_stl(Mesh_file& file)
{
  Stl_parser(file).parse();
}
