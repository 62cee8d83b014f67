// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Failure.h"
#include "Mesh_file.h"
#include "Text_scanner.h"

#include <cstdint>
#include <cstring>
#include <limits>
#include <unordered_map>

namespace {

// An index of OBJ: from 1, or from the end where negative. Returns -1 where it points nowhere.
int obj_index(std::string_view word, std::size_t size)
{
  long long i;
  if(!Text_scanner(word).integer(i))
    return -1;
  if(i < 0)
    i += (long long)size + 1;
  return i >= 1 && i <= (long long)size ? int(i - 1) : -1;
}

// Normals belong to corners in OBJ; those that all corners of a vertex agree upon are the vertex's.
class Obj_normals
{
  std::vector<Vector> m_normals;
  std::vector<int> m_at_vertex;
  bool m_is_unique = true;

public:
  std::size_t size() const { return m_normals.size(); }
  void add(const Vector& n) { m_normals.push_back(n); }

  void use(int vertex, int normal)
  {
    if(std::size_t(vertex) >= m_at_vertex.size())
      m_at_vertex.resize(std::size_t(vertex) + 1, -1);
    int& at = m_at_vertex[vertex];
    m_is_unique = m_is_unique && (at < 0 || at == normal || m_normals[at] == m_normals[normal]);
    at = normal;
  }

  void finish(Polygon_soup& soup)
  {
    if(m_normals.empty())
      return;
    m_at_vertex.resize(soup.points.size(), -1);
    bool is_complete = m_is_unique;
    for(int c : soup.corners)
      is_complete = is_complete && m_at_vertex[c] >= 0;
    if(!is_complete)
    {
      soup.notes.push_back("normals, which are not one for every vertex");
      return;
    }
    static const char* const names[3] = {"nx", "ny", "nz"};
    for(int i = 0; i < 3; ++i)
    {
      soup.vertex_columns.push_back({names[i], Number_type::DOUBLE, {}});
      for(int n : m_at_vertex)
        soup.vertex_columns.back().values.push_back(n < 0 ? 0. : m_normals[n][i]);
    }
  }
};

} // namespace

Polygon_soup parse_obj(const std::string& path, const std::string& text)
{
  Polygon_soup soup;
  Obj_normals normals;
  std::vector<double> colors;
  bool has_texture = false;
  Text_scanner scanner(text);
  for(std::size_t line_number = 1; scanner.remaining() > 0; ++line_number)
  {
    std::string_view line = scanner.line();
    Text_scanner words(line.substr(0, line.find('#')));
    const std::string_view key = words.word();
    const auto fail = [&](const char* what) { return Failure(path, "line " + std::to_string(line_number) + ": " + what); };
    if(key == "v" || key == "vn")
    {
      double x[7];
      int n = 0;
      while(n < 7 && !words.at_end())
        if(!words.number(x[n++]))
          throw fail("not a number");
      if(n < 3)
        throw fail("too few numbers");
      if(key == "vn")
        normals.add(Vector(x[0], x[1], x[2]));
      else
      {
        soup.points.emplace_back(x[0], x[1], x[2]);
        if(n >= 6)
          colors.insert(colors.end(), x + n - 3, x + n);
      }
    }
    else if(key == "f")
    {
      while(!words.at_end())
      {
        const std::string_view word = words.word();
        const std::size_t slash = word.find('/'), last_slash = word.rfind('/');
        const int v = obj_index(word.substr(0, slash), soup.points.size());
        if(v < 0)
          throw fail("a face has a vertex that does not exist");
        soup.corners.push_back(v);
        if(slash != last_slash && last_slash + 1 < word.size())
        {
          const int n = obj_index(word.substr(last_slash + 1), normals.size());
          if(n < 0)
            throw fail("a face has a normal that does not exist");
          normals.use(v, n);
        }
      }
      soup.close_polygon();
    }
    else
      has_texture = has_texture || key == "vt";
  }
  if(soup.points.empty())
    throw Failure(path, "no vertices; not an OBJ file?");
  normals.finish(soup);
  if(colors.size() == 3 * soup.points.size())
  {
    static const char* const names[3] = {"red", "green", "blue"};
    for(int i = 0; i < 3; ++i)
    {
      soup.vertex_columns.push_back({names[i], Number_type::DOUBLE, {}});
      for(std::size_t v = 0; v < soup.points.size(); ++v)
        soup.vertex_columns.back().values.push_back(colors[3 * v + i]);
    }
    scale_colors_to_bytes(soup.vertex_columns);
  }
  if(has_texture)
    soup.notes.push_back("texture coordinates");
  return soup;
}

namespace {

// STL repeats points in every triangle; equal ones are one vertex.
class Point_merger
{
  struct Hash
  {
    std::size_t operator()(const std::array<double, 3>& p) const
    {
      std::uint64_t h = 0;
      for(double x : p)
      {
        std::uint64_t bits;
        std::memcpy(&bits, &x, sizeof bits);
        h = (h ^ bits) * 0x9e3779b97f4a7c15ull;
        h ^= h >> 29;
      }
      return std::size_t(h);
    }
  };
  std::unordered_map<std::array<double, 3>, int, Hash> m_index;
  Polygon_soup& m_soup;

public:
  explicit Point_merger(Polygon_soup& soup) : m_soup(soup) {}

  void add(double x, double y, double z)
  {
    const std::array<double, 3> p = {{x + 0., y + 0., z + 0.}}; // -0 is 0
    const auto found = m_index.emplace(p, int(m_soup.points.size()));
    if(found.second)
      m_soup.points.emplace_back(p[0], p[1], p[2]);
    m_soup.corners.push_back(found.first->second);
  }
};

} // namespace

Polygon_soup parse_stl(const std::string& path, const std::string& text)
{
  Polygon_soup soup;
  Point_merger merger(soup);

  std::uint32_t count = 0;
  if(text.size() >= 84)
    for(int i = 3; i >= 0; --i)
      count = 256 * count + (unsigned char)text[80 + i];
  const bool looks_ascii = text.compare(0, 5, "solid") == 0;
  if(text.size() >= 84 && (!looks_ascii || text.size() == 84 + 50 * std::size_t(count)))
  {
    if((text.size() - 84) / 50 < count)
      throw Failure(path, "not an STL file, or cut off: " + std::to_string(count) + " triangles are announced");
    for(std::size_t f = 0; f < count; ++f)
    {
      for(int corner = 0; corner < 3; ++corner)
      {
        float x[3];
        for(int i = 0; i < 3; ++i)
        {
          const char* const at = text.data() + 84 + 50 * f + 12 * (corner + 1) + 4 * i;
          std::uint32_t bits = 0;
          for(int byte = 3; byte >= 0; --byte)
            bits = 256 * bits + (unsigned char)at[byte];
          std::memcpy(&x[i], &bits, 4);
        }
        merger.add(x[0], x[1], x[2]);
      }
      soup.close_polygon();
    }
    return soup;
  }
  if(!looks_ascii)
    throw Failure(path, "not an STL file");

  Text_scanner scanner(text);
  bool has_ended = false;
  while(!scanner.at_end())
  {
    const std::string_view word = scanner.word();
    has_ended = has_ended || word == "endsolid";
    if(word == "vertex")
    {
      double x[3];
      for(double& coordinate : x)
        if(!scanner.number(coordinate))
          throw Failure(path, "triangle " + std::to_string(soup.number_of_polygons()) + " holds something that is not a number");
      merger.add(x[0], x[1], x[2]);
    }
    else if(word == "endfacet")
      soup.close_polygon();
  }
  if(!has_ended)
    throw Failure(path, "the file ends before 'endsolid'");
  return soup;
}
