// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Failure.h"
#include "Mesh_file.h"
#include "Text_scanner.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <utility>

#ifdef GRADIENT_DOMAIN_FILTER_HAS_ZLIB
#include <boost/iostreams/copy.hpp>
#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#endif

namespace {

std::string lower_extension(const std::filesystem::path& path)
{
  std::string extension = path.extension().string();
  for(char& c : extension)
    c = char(std::tolower((unsigned char)c));
  return extension;
}

std::string read_file(const std::string& path)
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
  return text;
}

std::string read_standard_input()
{
  std::string text;
  std::size_t size = 0;
  do
  {
    text.resize((std::max)(2 * size, std::size_t(1) << 16));
    const std::size_t n = std::fread(&text[size], 1, text.size() - size, stdin);
    size += n;
  } while(size == text.size());
  text.resize(size);
  if(std::ferror(stdin))
    throw Failure("standard input", "cannot be read");
  return text;
}

bool is_packed(const std::string& text) { return text.size() > 2 && text[0] == '\x1f' && text[1] == '\x8b'; }

std::string unpacked(const std::string& name, const std::string& text)
{
#ifdef GRADIENT_DOMAIN_FILTER_HAS_ZLIB
  namespace io = boost::iostreams;
  std::string result;
  try
  {
    io::filtering_istream in;
    in.push(io::gzip_decompressor(15, 1 << 18));
    in.push(io::array_source(text.data(), text.size()));
    in.set_auto_close(false);
    in.exceptions(std::ios::badbit);
    io::copy(in, io::back_inserter(result), 1 << 18);
  }
  catch(const std::ios::failure& error)
  {
    throw Failure(name, std::string("cannot be unpacked: ") + error.what());
  }
  return result;
#else
  (void)text;
  throw Failure(name, "is compressed; this program was built without Boost.Iostreams");
#endif
}

} // namespace

bool is_compressed_name(const std::string& path) { return lower_extension(path) == ".gz"; }

File_format file_format(const std::string& path)
{
  std::filesystem::path name(path);
  if(lower_extension(name) == ".gz")
    name = name.stem();
  const std::string extension = lower_extension(name);
  static const struct { const char* extension; File_format format; } formats[] = {
    {".off", File_format::OFF}, {".obj", File_format::OBJ}, {".ply", File_format::PLY}, {".stl", File_format::STL}};
  for(const auto& known : formats)
    if(extension == known.extension)
      return known.format;
  for(const auto& other : {std::pair<const char*, const char*>{".gltf", "glTF"}, {".glb", "glTF"}, {".3mf", "3MF"},
                           {".vtp", "VTP"}, {".vtk", "VTK"}, {".vtu", "VTU"}, {".dae", "Collada"}, {".fbx", "FBX"},
                           {".usd", "USD"}, {".usdz", "USD"}, {".x3d", "X3D"}, {".3ds", "3DS"}, {".amf", "AMF"}})
    if(extension == other.first)
      throw Usage_error(path + ": " + other.second
                        + " is not read or written here; convert it to PLY or OBJ, as assimp, Blender or ParaView do");
  throw Usage_error(path + ": unknown extension; known are .off, .obj, .ply and .stl, also before .gz");
}

std::string packed(const std::string& bytes)
{
#ifdef GRADIENT_DOMAIN_FILTER_HAS_ZLIB
  namespace io = boost::iostreams;
  std::string result;
  io::filtering_ostream out;
  out.push(io::gzip_compressor(io::gzip_params(io::gzip::default_compression), 1 << 18));
  out.push(io::back_inserter(result));
  out.write(bytes.data(), std::streamsize(bytes.size()));
  out.reset();
  return result;
#else
  return bytes;
#endif
}

std::string read_bytes(const std::string& path)
{
  const std::string name = path == "-" ? "standard input" : path;
  std::string text = path == "-" ? read_standard_input() : read_file(path);
  if(is_packed(text))
    text = unpacked(name, text);
  if(text.empty())
    throw Failure(name, "the file is empty");
  return text;
}

File_format sniffed_format(const std::string& name, const std::string& text)
{
  Text_scanner scanner(text);
  const std::string_view first = scanner.line();
  if(first == "ply")
    return File_format::PLY;
  if(first.substr(0, 5) == "solid")
    return File_format::STL;
  std::uint32_t count = 0;
  if(text.size() >= 84)
    for(std::size_t i = 4; i > 0; --i)
      count = 256 * count + (unsigned char)text[79 + i];
  if(text.size() >= 84 && text.size() == 84 + 50 * std::size_t(count))
    return File_format::STL;
  const std::string_view said = Text_scanner(text).line_without_comment();
  const std::string_view word = Text_scanner(said).word();
  if((word.size() >= 3 && word.size() < 10 && word.substr(word.size() - 3) == "OFF")
     || (!said.empty() && said.find_first_not_of("0123456789 \t\r") == std::string_view::npos))
    return File_format::OFF;
  for(Text_scanner lines(text); lines.remaining() > 0;)
    if(Text_scanner(lines.line()).word() == "v")
      return File_format::OBJ;
  throw Failure(name, "neither OFF nor OBJ, PLY or STL");
}

namespace {

void parse(Mesh_file& file)
{
  switch(file.format)
  {
    case File_format::OFF: return parse_off(file);
    case File_format::OBJ: return parse_obj(file);
    case File_format::PLY: return parse_ply(file);
    case File_format::STL: return parse_stl(file);
  }
}

// What a file that cannot be read as what it is called seems to be.
std::string other_format(const Mesh_file& file)
{
  File_format format = file.format;
  try { format = sniffed_format(file.name, file.text); }
  catch(const Failure&) {}
  static const char* const names[] = {"off", "obj", "ply", "stl"};
  static const File_format formats[] = {File_format::OFF, File_format::OBJ, File_format::PLY, File_format::STL};
  for(std::size_t i = 0; i < 4; ++i)
    if(formats[i] == format && format != file.format)
      return std::string("; it looks like --input-format ") + names[i];
  return std::string();
}

} // namespace

Mesh_file parse_mesh_file(const std::string& name, File_format format, std::string text)
{
  Mesh_file file;
  file.name = name;
  file.format = format;
  file.text = std::move(text);
  const bool begins_with_mark = file.text.compare(0, 3, utf8_mark) == 0;
  file.has_mark = begins_with_mark && (format != File_format::STL || file.text.compare(3, 5, "solid") == 0);
  if(file.has_mark)
    file.text.erase(0, 3);
  try
  {
    parse(file);
  }
  catch(const Failure& failure)
  {
    throw Failure(failure.what() + other_format(file));
  }
  if(file.points.size() > std::size_t((std::numeric_limits<int>::max)()) / 8)
    throw Failure(name, "too many vertices");
  if(file.polygons.empty())
    throw Failure(name, "no faces");
  for(std::size_t f = 0; f < file.polygons.size(); ++f)
    if(const auto corners = file.polygons[f].size(); corners < 3)
      throw Failure(name, "face " + std::to_string(f) + " has " + std::to_string(corners)
                            + (corners == 1 ? " corner" : " corners"));
  return file;
}
