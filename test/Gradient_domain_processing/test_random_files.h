// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Mesh files with whatever their formats allow, at random: spellings of numbers, spaces, comments, properties, lists,
// elements. They hold the same kind of surface, a piece of a grid with random heights.

#ifndef GRADIENT_DOMAIN_PROCESSING_TEST_RANDOM_FILES_H
#define GRADIENT_DOMAIN_PROCESSING_TEST_RANDOM_FILES_H

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace gdp_test {

class Random_file
{
  std::mt19937 m_random;
  std::string m_end_of_line;
  std::vector<std::array<double, 3> > m_points;
  std::vector<std::vector<int> > m_faces;

public:
  explicit Random_file(unsigned int seed) : m_random(seed), m_end_of_line(below(3) == 0 ? "\r\n" : "\n")
  {
    const int n = 3 + below(4);
    for(int i = 0; i < n; ++i)
      for(int j = 0; j < n; ++j)
        m_points.push_back({{double(i), double(j), below(1000) / 1000.}});
    for(int i = 0; i + 1 < n; ++i)
      for(int j = 0; j + 1 < n; ++j)
      {
        const int v = n * i + j;
        if(below(3) == 0)
          m_faces.push_back({v, v + n, v + n + 1, v + 1});
        else
        {
          m_faces.push_back({v, v + n, v + n + 1});
          m_faces.push_back({v, v + n + 1, v + 1});
        }
      }
    std::shuffle(m_faces.begin(), m_faces.end(), m_random);
  }

  std::string obj()
  {
    std::string text = "# made at random" + m_end_of_line + "mtllib a b.mtl" + m_end_of_line;
    for(std::size_t v = 0; v < m_points.size(); ++v)
    {
      text += maybe("# between" + m_end_of_line) + maybe(m_end_of_line) + "v" + point(m_points[v]) + m_end_of_line;
      text += maybe("vt" + space() + number(0.25) + space() + number(0.5) + m_end_of_line);
    }
    text += "vt 0 0" + m_end_of_line + "vn 0 0 1" + m_end_of_line;
    for(const auto& face : m_faces)
    {
      static const char* const lines[] = {"o thing", "g a b", "s 1", "s off", "usemtl red", "l 1 2", "p 3", "vp 1 2"};
      text += maybe(lines[below(8)] + m_end_of_line) + "f";
      const int form = below(4);
      for(int v : face)
      {
        text += maybe(" \\" + m_end_of_line) + space()
                + (below(2) ? std::to_string(v + 1) : std::to_string(v - int(m_points.size())));
        text += form == 1 ? "/1" : form == 2 ? "//1" : form == 3 ? "/-1/-1" : "";
      }
      text += maybe(" # the end") + m_end_of_line;
    }
    return text;
  }

  std::string off()
  {
    const bool has_normals = below(2), has_colors = below(2);
    std::string text = std::string(has_colors ? "C" : "") + (has_normals ? "N" : "") + "OFF" + m_end_of_line
                       + maybe("# comment" + m_end_of_line) + std::to_string(m_points.size()) + space()
                       + std::to_string(m_faces.size()) + " 0" + m_end_of_line;
    for(const auto& p : m_points)
      text += maybe(m_end_of_line) + point(p) + (has_normals ? " 0 0 1.0" : "") + (has_colors ? " 0.5 1.0 0.25 1" : "")
              + maybe(" # here") + m_end_of_line;
    for(const auto& face : m_faces)
    {
      text += std::to_string(face.size());
      for(int v : face)
        text += space() + std::to_string(v);
      text += maybe("  255 0 17") + m_end_of_line;
    }
    return text;
  }

  std::string text_stl()
  {
    std::string text = "solid any name 7" + m_end_of_line;
    for(const auto& face : m_faces)
    {
      text += space() + "facet normal" + point({{0, 0, 1}}) + m_end_of_line + "outer loop" + m_end_of_line;
      for(int i = 0; i < 3; ++i)
        text += space() + "vertex" + point(m_points[std::size_t(face[std::size_t(i)])]) + m_end_of_line;
      text += "endloop" + m_end_of_line + space() + "endfacet" + m_end_of_line;
    }
    return text + "endsolid any name 7" + m_end_of_line;
  }

  std::string binary_stl()
  {
    std::string text;
    while(text.size() < 80)
      text += char('a' + below(26));
    append<std::uint32_t>(text, std::uint32_t(m_faces.size()), true);
    for(const auto& face : m_faces)
    {
      for(float x : {0.f, 0.f, 1.f})
        append(text, x, true);
      for(int i = 0; i < 3; ++i)
        for(double x : m_points[std::size_t(face[std::size_t(i)])])
          append(text, float(x), true);
      append(text, std::uint16_t(below(65536)), true);
    }
    return text;
  }

  // 0: text, 1: little endian, 2: big endian.
  std::string ply(int order)
  {
    const std::vector<Property> of_vertices = properties(true), of_faces = properties(false);
    std::string text = std::string("ply\nformat ")
                       + (order == 0 ? "ascii" : order == 1 ? "binary_little_endian" : "binary_big_endian")
                       + " 1.0\ncomment at  random\n" + maybe("obj_info 1 2\n");
    const std::vector<Property> of_camera = {{"float", "", "f"}, {"double", "uchar", "view"}};
    const bool has_camera = below(2), has_edge = below(2);
    text += has_camera ? header("camera", 1, of_camera) : "";
    text += header("vertex", m_points.size(), of_vertices) + header("face", m_faces.size(), of_faces);
    text += (has_edge ? header("edge", 1, {{"int", "", "vertex1"}, {"int", "", "vertex2"}}) : "") + "end_header\n";
    if(has_camera)
      add_record(of_camera, nullptr, nullptr, order, text);
    for(const auto& p : m_points)
      add_record(of_vertices, &p, nullptr, order, text);
    for(const auto& face : m_faces)
      add_record(of_faces, nullptr, &face, order, text);
    if(has_edge)
      add_record({{"int", "", "vertex1"}, {"int", "", "vertex2"}}, nullptr, nullptr, order, text);
    return text;
  }

private:
  struct Property { std::string type, count_type, name; }; // a list with a type of its count

  int below(int n) { return int(m_random() % unsigned(n)); }
  std::string maybe(const std::string& text) { return below(5) == 0 ? text : std::string(); }
  std::string space() { return below(4) ? " " : below(2) ? "\t" : "   "; }

  std::string number(double x)
  {
    static const char* const formats[] = {"%g", "%.3f", "%.6e", "%.17g", "%+g", "%.1E"};
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, formats[below(6)], x);
    return buffer;
  }

  std::string point(const std::array<double, 3>& p)
  {
    return space() + number(p[0]) + space() + number(p[1]) + space() + number(p[2]);
  }

  std::vector<Property> properties(bool of_vertices)
  {
    static const char* const types[] = {"char", "uchar", "short", "ushort", "int", "uint", "float", "double"};
    std::vector<Property> result;
    if(of_vertices)
      for(const char* name : {"x", "y", "z"})
        result.push_back({below(2) ? "float" : "double", "", name});
    else
      result.push_back({below(2) ? "int" : "uint", below(2) ? "uchar" : "int", "vertex_indices"});
    for(int i = 0, n = below(4); i < n; ++i)
      result.insert(result.begin() + below(int(result.size()) + 1),
                    {types[below(8)], below(3) ? "" : types[below(2) + 1], "extra" + std::to_string(i)});
    return result;
  }

  static std::string header(const std::string& name, std::size_t count, const std::vector<Property>& properties)
  {
    std::string text = "element " + name + " " + std::to_string(count) + "\n";
    for(const Property& p : properties)
      text += "property " + (p.count_type.empty() ? "" : "list " + p.count_type + " ") + p.type + " " + p.name + "\n";
    return text;
  }

  void add_record(const std::vector<Property>& properties, const std::array<double, 3>* p,
                  const std::vector<int>* face, int order, std::string& text)
  {
    bool is_first = true;
    const auto add = [&](double x, const std::string& type) {
      if(order == 0)
      {
        text += (is_first ? "" : space()) + (type == "float" || type == "double" ? number(x) : std::to_string(long(x)));
        is_first = false;
      }
      else
        add_number(x, type, order == 1, text);
    };
    for(const Property& property : properties)
    {
      const bool is_face = face && property.name == "vertex_indices", is_list = !property.count_type.empty();
      const int size = is_face ? int(face->size()) : is_list ? below(4) : 1;
      if(is_list)
        add(size, property.count_type);
      for(int i = 0; i < size; ++i)
        add(is_face                                ? (*face)[std::size_t(i)]
            : p && property.name.size() == 1       ? (*p)[std::size_t(property.name[0] - 'x')]
                                                   : below(100),
            property.type);
    }
    text += order == 0 ? "\n" : "";
  }

  template <class T>
  static void append(std::string& bytes, T x, bool is_little)
  {
    char buffer[sizeof(T)];
    std::memcpy(buffer, &x, sizeof(T));
    const std::uint16_t one = 1;
    char first;
    std::memcpy(&first, &one, 1);
    if((first == 1) != is_little)
      std::reverse(buffer, buffer + sizeof(T));
    bytes.append(buffer, sizeof(T));
  }

  static void add_number(double x, const std::string& type, bool is_little, std::string& text)
  {
    if(type == "char" || type == "uchar")
      append(text, std::uint8_t(x), is_little);
    else if(type == "short" || type == "ushort")
      append(text, std::uint16_t(x), is_little);
    else if(type == "int" || type == "uint")
      append(text, std::uint32_t(x), is_little);
    else if(type == "float")
      append(text, float(x), is_little);
    else
      append(text, x, is_little);
  }
};

} // namespace gdp_test

#endif // GRADIENT_DOMAIN_PROCESSING_TEST_RANDOM_FILES_H
