// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Failure.h"
#include "Mesh_file.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

File_format file_format(const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  for(char& c : extension)
    c = char(std::tolower((unsigned char)c));
  static const struct { const char* extension; File_format format; } formats[] = {
    {".off", File_format::OFF}, {".obj", File_format::OBJ}, {".ply", File_format::PLY}, {".stl", File_format::STL}};
  for(const auto& known : formats)
    if(extension == known.extension)
      return known.format;
  throw Usage_error(path + ": unknown extension; known are .off, .obj, .ply and .stl");
}

void scale_colors_to_bytes(Columns& columns)
{
  static const char* const names[] = {"red", "green", "blue", "alpha"};
  double largest = 0;
  for(const char* name : names)
    if(const Column* column = columns.find(name))
      for(double x : column->values)
        largest = (std::max)(largest, x);
  for(const char* name : names)
    if(Column* column = columns.find(name))
    {
      column->type = Number_type::UINT8;
      if(largest <= 1)
        for(double& x : column->values)
          x *= 255;
    }
}

namespace {

std::string read_all(const std::string& path)
{
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if(!std::filesystem::exists(status))
    throw Failure(path, "no such file");
  if(std::filesystem::is_directory(status))
    throw Failure(path, "is a directory");
  if(!std::filesystem::is_regular_file(status))
    throw Failure(path, "not a regular file");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if(!in)
    throw Failure(path, std::string("cannot be opened: ") + std::strerror(errno));
  std::string text(std::size_t(std::filesystem::file_size(path)), '\0');
  in.read(&text[0], std::streamsize(text.size()));
  if(std::size_t(in.gcount()) != text.size())
    throw Failure(path, "cannot be read");
  if(text.empty())
    throw Failure(path, "the file is empty");
  return text;
}

} // namespace

Polygon_soup parse_mesh_file(const std::string& path, const std::string& text)
{
  switch(file_format(path))
  {
    case File_format::OFF: return parse_off(path, text);
    case File_format::OBJ: return parse_obj(path, text);
    case File_format::PLY: return parse_ply(path, text);
    case File_format::STL: return parse_stl(path, text);
  }
  return Polygon_soup();
}

Mesh_file read_mesh_file(const std::string& path, const Read_options& options)
{
  Polygon_soup soup = parse_mesh_file(path, read_all(path));
  return connect(path, soup, options);
}
