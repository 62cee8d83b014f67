// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Failure.h"
#include "Mesh_file.h"
#include "Text_scanner.h"

#include <algorithm>

namespace {

// Numbers of one line.
struct Line_of_numbers
{
  std::vector<double> values;
  std::vector<char> looks_real; // by value

  bool read(std::string_view line)
  {
    values.clear();
    looks_real.clear();
    Text_scanner words(line);
    while(!words.at_end())
    {
      const std::string_view word = words.word();
      double x;
      if(!Text_scanner(word).number(x))
        return false;
      values.push_back(x);
      looks_real.push_back(word.find_first_of(".eE") != std::string_view::npos);
    }
    return true;
  }
};

// The letters before OFF.
struct Off_variant
{
  bool has_texture = false, has_normals = false;

  static Off_variant parse(const std::string& path, std::string_view keyword)
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
      throw Failure(path, all.size() < 10 && all.find("OFF") != std::string::npos ? "OFF files of kind " + all + " are not supported"
                                                                                 : "not an OFF file");
    return variant;
  }
};

} // namespace

Polygon_soup parse_off(const std::string& path, const std::string& text)
{
  Polygon_soup soup;
  Text_scanner scanner(text);
  std::string_view line = scanner.line_without_comment();
  Text_scanner words(line);
  Off_variant variant;
  std::size_t counts[2];
  if(line.empty() || line.find_first_not_of("0123456789 \t\r") != std::string_view::npos) // the keyword may be missing
  {
    variant = Off_variant::parse(path, words.word());
    if(words.at_end())
      words = Text_scanner(scanner.line_without_comment());
    else if(Text_scanner(words).word() == "BINARY")
      throw Failure(path, "binary OFF files are not supported");
  }
  if(!words.integer(counts[0]) || !words.integer(counts[1]))
    throw Failure(path, "the numbers of vertices and faces are missing");
  for(int i = 0; i < 2; ++i) // a vertex has at least six letters, a face four
    if(counts[i] > (scanner.remaining() + 1) / (i == 0 ? 6 : 4))
      throw Failure(path, "the header announces " + std::to_string(counts[i]) + (i == 0 ? " vertices" : " faces")
                          + ", which do not fit into the file");

  const auto ended = [&](const char* what, std::size_t i) {
    return Failure(path, std::string("the file ends at ") + what + " " + std::to_string(i));
  };
  soup.points.reserve(counts[0]);
  const std::size_t first_color = variant.has_normals ? 6 : 3;
  static const char* const names[] = {"nx", "ny", "nz", "red", "green", "blue", "alpha"};
  Line_of_numbers numbers;
  std::size_t number_of_values = 0;
  bool has_real_colors = false;
  for(std::size_t v = 0; v < counts[0]; ++v)
  {
    line = scanner.line_without_comment();
    if(line.empty())
      throw ended("vertex", v);
    if(!numbers.read(line))
      throw Failure(path, "vertex " + std::to_string(v) + " holds something that is not a number");
    const std::size_t n = numbers.values.size() - (variant.has_texture && numbers.values.size() >= first_color + 2 ? 2 : 0);
    if(n < first_color)
      throw scanner.remaining() == 0 ? ended("vertex", v) : Failure(path, "vertex " + std::to_string(v) + " has too few numbers");
    if(v == 0)
    {
      number_of_values = n >= first_color + 3 ? (std::min)(n, first_color + 4) : first_color;
      for(std::size_t i = 3; i < number_of_values; ++i)
        soup.vertex_columns.push_back({names[i < first_color ? i - 3 : i - first_color + 3], Number_type::DOUBLE, {}});
    }
    else if(n < number_of_values)
      throw Failure(path, "vertex " + std::to_string(v) + " has fewer numbers than the first");
    soup.points.emplace_back(numbers.values[0], numbers.values[1], numbers.values[2]);
    for(std::size_t i = 3; i < number_of_values; ++i)
    {
      soup.vertex_columns[i - 3].values.push_back(numbers.values[i]);
      has_real_colors = has_real_colors || (i >= first_color && numbers.looks_real[i]);
    }
  }
  if(has_real_colors)
    scale_colors_to_bytes(soup.vertex_columns);
  else
    for(std::size_t i = first_color; i < number_of_values; ++i)
      soup.vertex_columns[i - 3].type = Number_type::UINT8;
  if(variant.has_texture)
    soup.notes.push_back("texture coordinates");

  soup.first_corner.reserve(counts[1] + 1);
  bool has_face_colors = false;
  for(std::size_t f = 0; f < counts[1]; ++f)
  {
    line = scanner.line_without_comment();
    if(line.empty())
      throw ended("face", f);
    Text_scanner face(line);
    std::size_t size;
    if(!face.integer(size))
      throw Failure(path, "face " + std::to_string(f) + " has no number of vertices");
    for(std::size_t i = 0; i < size; ++i)
    {
      int v;
      if(face.at_end())
        throw scanner.remaining() == 0 ? ended("face", f) : Failure(path, "face " + std::to_string(f) + " has too few vertices");
      if(!face.integer(v) || v < 0 || std::size_t(v) >= counts[0])
        throw Failure(path, "face " + std::to_string(f) + " has a vertex that does not exist");
      soup.corners.push_back(v);
    }
    has_face_colors = has_face_colors || !face.at_end();
    soup.close_polygon();
  }
  if(has_face_colors)
    soup.notes.push_back("face colors");
  return soup;
}
