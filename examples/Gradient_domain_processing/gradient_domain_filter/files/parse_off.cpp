// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Failure.h"
#include "Mesh_file.h"
#include "Text_scanner.h"

namespace {

// The letters before OFF.
struct Off_variant
{
  bool has_texture = false, has_normals = false;

  static Off_variant parse(const std::string& name, std::string_view keyword)
  {
    const std::string all(keyword);
    Off_variant variant;
    const auto take = [&](std::string_view letters) {
      const bool is_next = keyword.substr(0, letters.size()) == letters;
      if(is_next)
        keyword.remove_prefix(letters.size());
      return is_next;
    };
    variant.has_texture = take("ST");
    take("C"); // the length of the line tells
    variant.has_normals = take("N");
    if(keyword != "OFF")
      throw Failure(name, all.size() < 10 && all.find("OFF") != std::string::npos
                            ? "OFF files of kind " + all + " are not supported"
                            : "not an OFF file");
    return variant;
  }
};

class Off_parser
{
  Mesh_file& m_file;
  Text_scanner m_scanner;
  Off_variant m_variant;
  std::size_t m_count[2] = {0, 0}; // of vertices and faces
  std::vector<double> m_values;    // of a line
  bool m_looks_real = false;       // any number of the line, or of a line before
  std::size_t m_comments = 0;

public:
  explicit Off_parser(Mesh_file& file) : m_file(file), m_scanner(file.text) {}

  void parse()
  {
    read_header();
    read_vertices();
    read_faces();
    for(char c : m_file.text)
      m_comments += c == '#';
    if(m_comments > 0)
      m_file.others.push_back(std::to_string(m_comments) + (m_comments == 1 ? " comment" : " comments"));
  }

private:
  void read_header()
  {
    const std::string_view line = m_scanner.line_without_comment();
    Text_scanner words(line);
    // the keyword may be missing
    if(line.empty() || line.find_first_not_of("0123456789 \t\r") != std::string_view::npos)
    {
      m_variant = Off_variant::parse(m_file.name, words.word());
      if(words.at_end())
        words = Text_scanner(m_scanner.line_without_comment());
      else if(Text_scanner(words).word() == "BINARY")
        throw Failure(m_file.name, "binary OFF files are not supported");
    }
    if(!words.integer(m_count[0]) || !words.integer(m_count[1]))
      throw Failure(m_file.name, "the numbers of vertices and faces are missing");
    for(int i = 0; i < 2; ++i) // a vertex has at least six letters, a face four
      if(m_count[i] > (m_scanner.remaining() + 1) / (i == 0 ? 6 : 4))
        throw Failure(m_file.name, "the header announces " + std::to_string(m_count[i])
                                     + (i == 0 ? " vertices" : " faces") + ", which do not fit into the file");
  }

  Failure failure(const char* what, std::size_t i, const char* is_wrong) const
  {
    const std::string item = std::string(what) + " " + std::to_string(i);
    return Failure(m_file.name, m_scanner.remaining() == 0 ? "the file ends at " + item : item + is_wrong);
  }

  std::string_view next_line(const char* what, std::size_t i)
  {
    const std::string_view line = m_scanner.line_without_comment();
    if(line.empty())
      throw Failure(m_file.name, std::string("the file ends at ") + what + " " + std::to_string(i));
    return line;
  }

  // The numbers that are left of a line; false if one is none.
  bool read_numbers(Text_scanner& words, std::size_t first_color)
  {
    m_values.clear();
    while(!words.at_end())
    {
      const std::string_view word = words.word();
      double x;
      if(!Text_scanner::parse(word, x))
        return false;
      if(m_values.size() >= first_color && word.find_first_of(".eE") != std::string_view::npos)
        m_looks_real = true;
      m_values.push_back(x);
    }
    return true;
  }

  // The coordinates, the normal, the color, the texture coordinates.
  void read_vertices()
  {
    const std::size_t first_color = m_variant.has_normals ? 6 : 3;
    std::size_t number_of_values = 0;
    m_file.points.reserve(m_count[0]);
    m_file.vertex_records.offsets.reserve(m_count[0]);
    for(std::size_t v = 0; v < m_count[0]; ++v)
    {
      Text_scanner words(next_line("vertex", v));
      words.skip_space();
      m_file.vertex_records.offsets.push_back(std::size_t(words.position() - m_file.text.data()));
      if(!read_numbers(words, first_color))
        throw Failure(m_file.name, "vertex " + std::to_string(v) + " holds something that is not a number");
      if(m_values.size() < first_color)
        throw failure("vertex", v, " has too few numbers");
      if(v == 0)
        number_of_values = begin_columns(first_color);
      else if(m_values.size() < number_of_values)
        throw Failure(m_file.name, "vertex " + std::to_string(v) + " has fewer numbers than the first");
      m_file.points.emplace_back(m_values[0], m_values[1], m_values[2]);
      for(Column& column : m_file.vertex_columns)
        column.values.push_back(m_values[std::size_t(column.place)]);
    }
    finish_colors(m_file.vertex_columns);
  }

  // By the first vertex. Returns how many numbers are used.
  std::size_t begin_columns(std::size_t first_color)
  {
    static const char* const names[] = {"nx", "ny", "nz", "red", "green", "blue", "alpha", "s", "t"};
    const auto add = [&](int name, std::size_t place) {
      m_file.vertex_columns.push_back({names[name], Number_type::DOUBLE, {}, int(place)});
      m_file.vertex_columns.back().values.reserve(m_count[0]);
    };
    for(std::size_t i = 3; i < first_color; ++i)
      add(int(i) - 3, i);
    const bool has_texture = m_variant.has_texture && m_values.size() >= first_color + 2;
    const std::size_t after_color = m_values.size() - (has_texture ? 2 : 0);
    if(after_color >= first_color + 3)
      for(std::size_t i = first_color; i < (std::min)(after_color, first_color + 4); ++i)
        add(int(i - first_color) + 3, i);
    if(has_texture)
      for(std::size_t i = 0; i < 2; ++i)
        add(int(i) + 7, after_color + i);
    return m_file.vertex_columns.empty() ? first_color : std::size_t(m_file.vertex_columns.back().place) + 1;
  }

  // Integers are from 0 to 255, reals from 0 to 1.
  void finish_colors(Columns& columns)
  {
    for(const char* name : {"red", "green", "blue", "alpha"})
      if(Column* const column = columns.find(name))
      {
        column->type = m_looks_real ? Number_type::DOUBLE : Number_type::UINT8;
        column->is_spelled_real = m_looks_real;
      }
  }

  void read_faces()
  {
    m_file.polygons.first_corner.reserve(m_count[1] + 1);
    m_looks_real = false;
    std::size_t with_color = 0, numbers = 0;
    for(std::size_t f = 0; f < m_count[1]; ++f)
    {
      Text_scanner face(next_line("face", f));
      face.skip_space();
      const std::size_t offset = std::size_t(face.position() - m_file.text.data());
      std::size_t size;
      if(!face.integer(size))
        throw Failure(m_file.name, "face " + std::to_string(f) + " has no number of vertices");
      for(std::size_t i = 0; i < size; ++i)
      {
        int v;
        if(face.at_end())
          throw failure("face", f, " has too few vertices");
        if(!face.integer(v) || v < 0 || std::size_t(v) >= m_count[0])
          throw Failure(m_file.name, "face " + std::to_string(f) + " has a vertex that does not exist");
        m_file.polygons.corners.push_back(v);
      }
      m_file.polygons.close_polygon();
      if(face.at_end())
        continue;
      const bool are_numbers = read_numbers(face, 0);
      numbers += m_values.size();
      const bool is_color = are_numbers && (m_values.size() == 3 || m_values.size() == 4);
      if(is_color && with_color == f && (f == 0 || m_values.size() == m_file.face_columns.size()))
        add_face_color(offset, with_color);
    }
    finish_face_colors(with_color, numbers);
  }

  void add_face_color(std::size_t offset, std::size_t& with_color)
  {
    static const char* const names[] = {"red", "green", "blue", "alpha"};
    if(with_color++ == 0)
    {
      m_file.face_records.properties = {{"corners", Number_type::INT32, true, Number_type::INT32}};
      for(std::size_t i = 0; i < m_values.size(); ++i)
        m_file.face_columns.push_back({names[i], Number_type::DOUBLE, {}, int(i) + 1});
    }
    m_file.face_records.offsets.push_back(offset);
    for(std::size_t i = 0; i < m_values.size(); ++i)
      m_file.face_columns[i].values.push_back(m_values[i]);
  }

  void finish_face_colors(std::size_t with_color, std::size_t numbers)
  {
    if(with_color == m_count[1])
    {
      finish_colors(m_file.face_columns);
      return;
    }
    m_file.face_columns.clear();
    m_file.face_records = Records();
    if(numbers > 0)
      m_file.others.push_back("face colors, which not all faces have");
  }
};

} // namespace

void parse_off(Mesh_file& file)
{
  Off_parser(file).parse();
}
