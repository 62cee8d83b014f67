// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Failure.h"
#include "Mesh_file.h"
#include "Text_scanner.h"
#include "file_blocks.h"

#include <algorithm>
#include <set>

namespace {

// Indices of vertices or normals. In a block it is not known how many there are before it.
struct Obj_indices
{
  std::vector<std::size_t> relative; // which of the corners count from the first of the block
  long long most_missing = 0;        // that must stand before the block
  std::size_t number_before = 0;

  // An index of OBJ: from 1, or from the end where negative. False where it points nowhere, as far as that is known.
  bool read(std::string_view word, std::size_t size, std::size_t corner, bool is_all, int& index)
  {
    constexpr long long most = (1ll << 31) - 2;
    long long i;
    if(!Text_scanner(word).integer(i) || i == 0 || i < -most || i > most)
      return false;
    const long long missing = i > 0 ? i - (long long)size : -i - (long long)size;
    if(is_all && missing > 0)
      return false;
    most_missing = (std::max)(most_missing, missing);
    if(i < 0)
      relative.push_back(corner);
    index = i > 0 ? int(i - 1) : int((long long)size + i);
    return true;
  }

  bool are_there() const { return most_missing <= (long long)number_before; }
};

// What is read of a block of lines.
struct Obj_part
{
  std::vector<Point> points;
  std::vector<std::size_t> vertex_offsets, normal_offsets;
  std::vector<double> normals, colors; // three each
  std::vector<int> corners, corner_normals;
  std::vector<std::size_t> polygon_ends;
  Obj_indices vertex_indices, normal_indices;
  std::size_t with_colors = 0, first_color_place = 0, color_place = 0, with_weights = 0, texture = 0, groups = 0,
              objects = 0, curves = 0;
  std::size_t comments = 0, smoothing_groups = 0, libraries = 0;
  std::set<std::string> materials;
};

// Reads the lines that say something about the mesh; all others stay in the bytes of the file and come out again.
class Obj_block_parser
{
  const Mesh_file& m_file;
  const bool m_is_all; // of the file
  Obj_part& m_part;
  std::size_t m_line = 1;

public:
  Obj_block_parser(const Mesh_file& file, bool is_all, Obj_part& part) : m_file(file), m_is_all(is_all), m_part(part) {}

  void parse(const char* begin, const char* end)
  {
    Text_scanner scanner(begin, end, true);
    while(scanner.remaining() > 0)
    {
      const std::string_view line = scanner.line();
      const std::size_t comment = line.find('#');
      m_part.comments += comment != std::string_view::npos;
      const std::string_view said = line.substr(0, comment);
      read_line(Text_scanner(said.data(), said.data() + said.size(), true));
      if(m_is_all)
        m_line += std::size_t(std::count(line.begin(), line.end(), '\n')) + 1;
    }
  }

private:
  Failure failure(const char* what) const
  {
    return Failure(m_file.name, "line " + std::to_string(m_line) + ": " + what);
  }

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
      m_part.materials.insert(std::string(words.word()));
    else
    {
      m_part.texture += key == "vt";
      m_part.libraries += key == "mtllib";
      m_part.groups += key == "g";
      m_part.objects += key == "o";
      m_part.smoothing_groups += key == "s";
      m_part.curves += key == "l" || key == "p" || key == "curv" || key == "surf";
    }
  }

  std::size_t read_numbers(Text_scanner& words, double (&x)[8], std::vector<std::size_t>& offsets)
  {
    words.skip_space();
    offsets.push_back(std::size_t(words.position() - m_file.text.data()));
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
    const std::size_t n = read_numbers(words, x, m_part.vertex_offsets);
    m_part.points.emplace_back(x[0], x[1], x[2]);
    m_part.with_weights += n == 4 || n >= 7;
    if(n < 6)
      return;
    const std::size_t place = n == 6 ? 3 : 4;
    if(m_part.with_colors == 0)
      m_part.first_color_place = place;
    m_part.with_colors += m_part.with_colors == 0 || place == m_part.color_place;
    m_part.color_place = place;
    m_part.colors.insert(m_part.colors.end(), x + place, x + place + 3);
  }

  void read_normal(Text_scanner& words)
  {
    double x[8];
    read_numbers(words, x, m_part.normal_offsets);
    m_part.normals.insert(m_part.normals.end(), x, x + 3);
  }

  void read_face(Text_scanner& words)
  {
    Obj_part& part = m_part;
    while(!words.at_end())
    {
      const std::string_view word = words.word();
      const std::size_t slash = word.find('/'), last_slash = word.rfind('/');
      int v = -1, n = -1;
      if(!part.vertex_indices.read(word.substr(0, slash), part.points.size(), part.corners.size(), m_is_all, v))
        throw failure("a face has a vertex that does not exist");
      const bool has_normal = slash != last_slash && last_slash + 1 < word.size();
      if(has_normal)
      {
        if(!part.normal_indices.read(word.substr(last_slash + 1), part.normal_offsets.size(), part.corners.size(),
                                     m_is_all, n))
          throw failure("a face has a normal that does not exist");
        part.corner_normals.resize(part.corners.size(), -1);
      }
      part.corners.push_back(v);
      if(has_normal || !part.corner_normals.empty())
        part.corner_normals.push_back(n);
    }
    part.polygon_ends.push_back(part.corners.size());
  }
};

// Blocks are read side by side and put together. Where one of them fails, or asks for what it cannot know of, all is
// read as one block, which knows the line.
class Obj_parser
{
  Mesh_file& m_file;
  std::vector<Obj_part> m_parts;
  Obj_part m_sum; // its numbers

public:
  explicit Obj_parser(Mesh_file& file) : m_file(file) {}

  void parse()
  {
    m_file.vertex_records.lines_continue = m_file.normal_records.lines_continue = true;
    if(!parse_blocks())
    {
      m_parts.assign(1, Obj_part());
      Obj_block_parser(m_file, true, m_parts[0]).parse(m_file.text.data(), m_file.text.data() + m_file.text.size());
    }
    if(!std::any_of(m_parts.begin(), m_parts.end(), [](const Obj_part& part) { return !part.points.empty(); }))
      throw Failure(m_file.name, "no vertices; not an OBJ file?");
    add_up();
    put_together();
    finish();
  }

private:
  bool parse_blocks()
  {
    const std::vector<std::size_t> begins = line_blocks(m_file.text);
    const std::size_t count = begins.size() - 1;
    if(count < 2)
      return false;
    m_parts.resize(count);
    std::vector<char> is_read(count, 0);
    for_each_part(count, [&](std::size_t k) {
      try
      {
        Obj_block_parser(m_file, false, m_parts[k])
          .parse(m_file.text.data() + begins[k], m_file.text.data() + begins[k + 1]);
        is_read[k] = 1;
      }
      catch(const Failure&) {}
    });
    std::size_t vertices = 0, normals = 0;
    for(Obj_part& part : m_parts)
    {
      part.vertex_indices.number_before = vertices;
      part.normal_indices.number_before = normals;
      vertices += part.points.size();
      normals += part.normal_offsets.size();
    }
    return std::find(is_read.begin(), is_read.end(), 0) == is_read.end()
           && std::all_of(m_parts.begin(), m_parts.end(), [](const Obj_part& part) {
                return part.vertex_indices.are_there() && part.normal_indices.are_there();
              });
  }

  void add_up()
  {
    for(Obj_part& part : m_parts)
    {
      if(part.with_colors > 0)
      {
        m_sum.with_colors += part.with_colors - (m_sum.with_colors > 0 && part.first_color_place != m_sum.color_place);
        m_sum.color_place = part.color_place;
      }
      m_sum.with_weights += part.with_weights;
      m_sum.texture += part.texture;
      m_sum.groups += part.groups;
      m_sum.objects += part.objects;
      m_sum.curves += part.curves;
      m_sum.comments += part.comments;
      m_sum.smoothing_groups += part.smoothing_groups;
      m_sum.libraries += part.libraries;
      m_sum.materials.merge(part.materials);
    }
  }

  template <class T, class Get>
  void join(const Get& get, std::vector<T>& all) const
  {
    std::vector<std::size_t> begin(1, 0);
    for(const Obj_part& part : m_parts)
      begin.push_back(begin.back() + get(part).size());
    all.resize(begin.back());
    for_each_part(m_parts.size(), [&](std::size_t k) {
      std::copy(get(m_parts[k]).begin(), get(m_parts[k]).end(), all.begin() + std::ptrdiff_t(begin[k]));
    });
  }

  void put_together()
  {
    const bool has_normals =
      std::any_of(m_parts.begin(), m_parts.end(), [](const Obj_part& part) { return !part.corner_normals.empty(); });
    std::vector<std::size_t> corners_before(1, 0);
    for(const Obj_part& part : m_parts)
      corners_before.push_back(corners_before.back() + part.corners.size());
    for_each_part(m_parts.size(), [&](std::size_t k) {
      Obj_part& part = m_parts[k];
      for(std::size_t c : part.vertex_indices.relative)
        part.corners[c] += int(part.vertex_indices.number_before);
      for(std::size_t c : part.normal_indices.relative)
        part.corner_normals[c] += int(part.normal_indices.number_before);
      if(has_normals)
        part.corner_normals.resize(part.corners.size(), -1);
      for(std::size_t& end : part.polygon_ends)
        end += corners_before[k];
    });
    join([](const Obj_part& part) -> const std::vector<Point>& { return part.points; }, m_file.points);
    join([](const Obj_part& part) -> const std::vector<std::size_t>& { return part.vertex_offsets; },
         m_file.vertex_records.offsets);
    join([](const Obj_part& part) -> const std::vector<std::size_t>& { return part.normal_offsets; },
         m_file.normal_records.offsets);
    join([](const Obj_part& part) -> const std::vector<int>& { return part.corners; }, m_file.polygons.corners);
    join([](const Obj_part& part) -> const std::vector<int>& { return part.corner_normals; }, m_file.corner_normals);
    join([](const Obj_part& part) -> const std::vector<std::size_t>& { return part.polygon_ends; },
         m_file.polygons.first_corner);
    m_file.polygons.first_corner.insert(m_file.polygons.first_corner.begin(), 0);
    join([](const Obj_part& part) -> const std::vector<double>& { return part.normals; }, m_sum.normals);
    join([](const Obj_part& part) -> const std::vector<double>& { return part.colors; }, m_sum.colors);
    m_parts.clear();
  }

  static void add_columns(const std::array<const char*, 3>& names, std::size_t first_place,
                          const std::vector<double>& values, Columns& columns)
  {
    for(std::size_t i = 0; i < 3; ++i)
    {
      columns.push_back({names[i], Number_type::DOUBLE, {}, int(first_place + i)});
      columns.back().values.reserve(values.size() / 3);
      for(std::size_t j = i; j < values.size(); j += 3)
        columns.back().values.push_back(values[j]);
    }
  }

  void finish()
  {
    if(!m_file.corner_normals.empty())
      add_columns({{"nx", "ny", "nz"}}, 0, m_sum.normals, m_file.normal_columns);
    if(m_sum.with_colors == m_file.points.size())
      add_columns({{"red", "green", "blue"}}, m_sum.color_place, m_sum.colors, m_file.vertex_columns);
    else if(!m_sum.colors.empty())
      m_file.others.push_back("vertex colors, which not all vertices have");
    note(m_sum.texture > 0, "texture coordinates");
    note_number(m_sum.materials.size(), "material");
    if(m_sum.materials.empty())
      note_number(m_sum.libraries, "material library");
    note_number(m_sum.objects, "object");
    note_number(m_sum.groups, "group");
    note(m_sum.smoothing_groups > 0, "smoothing groups");
    note(m_sum.curves > 0, "points, lines and curves");
    note(m_sum.with_weights > 0, "weights of vertices");
    note_number(m_sum.comments, "comment");
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
