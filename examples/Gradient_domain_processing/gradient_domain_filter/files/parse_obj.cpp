// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Failure.h"
#include "Mesh_file.h"
#include "Text_scanner.h"

#include <set>

namespace {

// Reads the lines that say something about the mesh; all others stay in the bytes of the file and come out again.
class Obj_parser
{
  Mesh_file& m_file;
  std::size_t m_line = 1;
  std::vector<double> m_colors;
  std::size_t m_with_colors = 0, m_with_weights = 0, m_texture = 0, m_groups = 0, m_objects = 0, m_curves = 0, m_comments = 0;
  std::size_t m_smoothing_groups = 0, m_libraries = 0, m_color_place = 0;
  std::set<std::string> m_materials;

public:
  explicit Obj_parser(Mesh_file& file) : m_file(file) {}

  void parse()
  {
    m_file.vertex_records.lines_continue = m_file.normal_records.lines_continue = true;
    for(const char* name : {"nx", "ny", "nz"})
      m_file.normal_columns.push_back({name, Number_type::DOUBLE, {}, int(m_file.normal_columns.size())});
    const char* const end = m_file.text.data() + m_file.text.size();
    Text_scanner scanner(m_file.text.data(), end, true);
    while(scanner.remaining() > 0)
    {
      const std::string_view line = scanner.line();
      const std::size_t comment = line.find('#');
      m_comments += comment != std::string_view::npos;
      const std::string_view said = line.substr(0, comment);
      read_line(Text_scanner(said.data(), said.data() + said.size(), true));
      for(const char c : line)
        m_line += c == '\n';
      ++m_line;
    }
    if(m_file.points.empty())
      throw Failure(m_file.name, "no vertices; not an OBJ file?");
    finish();
  }

private:
  Failure failure(const char* what) const { return Failure(m_file.name, "line " + std::to_string(m_line) + ": " + what); }

  void read_line(Text_scanner words)
  {
    const std::string_view key = words.word();
    if(key == "v")
      read_vertex(words);
    else if(key == "vn")
      read_normal(words);
    else if(key == "f")
      read_face(words);
    else if(key == "usemtl")
      m_materials.insert(std::string(words.word()));
    else
    {
      m_texture += key == "vt";
      m_libraries += key == "mtllib";
      m_groups += key == "g";
      m_objects += key == "o";
      m_smoothing_groups += key == "s";
      m_curves += key == "l" || key == "p" || key == "curv" || key == "surf";
    }
  }

  std::size_t read_numbers(Text_scanner& words, double (&x)[8], Records& records)
  {
    words.skip_space();
    records.offsets.push_back(std::size_t(words.position() - m_file.text.data()));
    std::size_t n = 0;
    while(n < 8 && !words.at_end())
      if(!words.number(x[n++]))
        throw failure("not a number");
    if(n < 3)
      throw failure("too few numbers");
    return n;
  }

  void read_vertex(Text_scanner& words)
  {
    double x[8];
    const std::size_t n = read_numbers(words, x, m_file.vertex_records);
    m_file.points.emplace_back(x[0], x[1], x[2]);
    m_with_weights += n == 4 || n >= 7;
    if(n >= 6)
    {
      const std::size_t place = n == 6 ? 3 : 4;
      m_with_colors += m_with_colors == 0 || place == m_color_place;
      m_color_place = place;
      m_colors.insert(m_colors.end(), x + place, x + place + 3);
    }
  }

  void read_normal(Text_scanner& words)
  {
    double x[8];
    read_numbers(words, x, m_file.normal_records);
    for(std::size_t i = 0; i < 3; ++i)
      m_file.normal_columns[i].values.push_back(x[i]);
  }

  // An index of OBJ: from 1, or from the end where negative. Returns -1 where it points nowhere.
  static int index(std::string_view word, std::size_t size)
  {
    long long i;
    if(!Text_scanner(word).integer(i))
      return -1;
    if(i < 0)
      i += (long long)size + 1;
    return i >= 1 && i <= (long long)size ? int(i - 1) : -1;
  }

  void read_face(Text_scanner& words)
  {
    while(!words.at_end())
    {
      const std::string_view word = words.word();
      const std::size_t slash = word.find('/'), last_slash = word.rfind('/');
      const int v = index(word.substr(0, slash), m_file.points.size());
      if(v < 0)
        throw failure("a face has a vertex that does not exist");
      int n = -1;
      if(slash != last_slash && last_slash + 1 < word.size())
      {
        n = index(word.substr(last_slash + 1), m_file.normal_columns[0].values.size());
        if(n < 0)
          throw failure("a face has a normal that does not exist");
        m_file.corner_normals.resize(m_file.polygons.corners.size(), -1);
      }
      m_file.polygons.corners.push_back(v);
      if(n >= 0 || !m_file.corner_normals.empty())
        m_file.corner_normals.push_back(n);
    }
    m_file.polygons.close_polygon();
  }

  void finish()
  {
    if(m_file.corner_normals.empty())
      m_file.normal_columns.clear();
    const std::size_t n = m_file.points.size();
    if(m_with_colors == n)
    {
      static const char* const names[3] = {"red", "green", "blue"};
      for(std::size_t i = 0; i < 3; ++i)
      {
        m_file.vertex_columns.push_back({names[i], Number_type::DOUBLE, {}, int(m_color_place + i)});
        m_file.vertex_columns.back().values.reserve(n);
        for(std::size_t v = 0; v < n; ++v)
          m_file.vertex_columns.back().values.push_back(m_colors[3 * v + i]);
      }
    }
    else if(!m_colors.empty())
      m_file.others.push_back("vertex colors, which not all vertices have");
    note(m_texture > 0, "texture coordinates");
    note_number(m_materials.size(), "material");
    if(m_materials.empty())
      note_number(m_libraries, "material library");
    note_number(m_objects, "object");
    note_number(m_groups, "group");
    note(m_smoothing_groups > 0, "smoothing groups");
    note(m_curves > 0, "points, lines and curves");
    note(m_with_weights > 0, "weights of vertices");
    note_number(m_comments, "comment");
  }

  void note(bool there_are, const char* what)
  {
    if(there_are)
      m_file.others.push_back(what);
  }
  void note_number(std::size_t n, const std::string& one)
  {
    if(n > 0)
      m_file.others.push_back(std::to_string(n) + " " + one + (n == 1 ? "" : "s"));
  }
};

} // namespace

void parse_obj(Mesh_file& file)
{
  Obj_parser(file).parse();
}
