// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Ply_slices.h"

#include <algorithm>
#include <limits>

int Ply_slices::Element::rank_of(Global i, int size) const
{
  const Global each = count / size, longer = count % size; // the first ones have one more
  return int(i < longer * (each + 1) ? i / (each + 1) : longer + (i - longer * (each + 1)) / each);
}

Ply_slices::Ply_slices(const Ranks& ranks, const std::string& name) : m_ranks(ranks), m_name(name)
{
  open();
  try
  {
    read_header();
    find_records();
  }
  catch(...)
  {
    MPI_File_close(&m_file);
    throw;
  }
}

Ply_slices::~Ply_slices()
{
  MPI_File_close(&m_file);
}

void Ply_slices::open()
{
  const int code = MPI_File_open(m_ranks.comm(), m_name.c_str(), MPI_MODE_RDONLY, MPI_INFO_NULL, &m_file);
  m_ranks.agree(code == MPI_SUCCESS ? "" : m_name + ": cannot be read");
  MPI_File_get_size(m_file, &m_size);
}

std::vector<char> Ply_slices::read(MPI_Offset first, Global bytes) const
{
  constexpr Global most = 1 << 28; // at once
  std::vector<char> data;
  m_ranks.together([&] { data.resize(std::size_t(bytes)); });
  const Global rounds = m_ranks.largest((bytes + most - 1) / most);
  bool is_read = true;
  for(Global round = 0; round < rounds; ++round)
  {
    const Global begin = (std::min)(bytes, round * most), end = (std::min)(bytes, begin + most);
    MPI_Status status;
    int got = 0;
    const int code = MPI_File_read_at_all(m_file, first + begin, data.data() + begin, int(end - begin), MPI_BYTE,
                                          &status);
    if(code == MPI_SUCCESS && end > begin)
      MPI_Get_count(&status, MPI_BYTE, &got);
    is_read = is_read && code == MPI_SUCCESS && got == int(end - begin);
  }
  m_ranks.agree(is_read ? "" : m_name + ": cannot be read to its end");
  return data;
}

// Rank 0 reads pieces of growing size until the header is in it.
void Ply_slices::read_header()
{
  std::string text;
  m_ranks.together([&] {
    const std::string mark = "end_header";
    for(MPI_Offset length = 1 << 12; m_ranks.is_first() && text.find(mark) == std::string::npos; length *= 4)
    {
      length = (std::min)(length, m_size);
      text.resize(std::size_t(length));
      if(MPI_File_read_at(m_file, 0, &text[0], int(length), MPI_BYTE, MPI_STATUS_IGNORE) != MPI_SUCCESS)
        throw Failure(m_name, "cannot be read");
      if(text.compare(0, 3, "ply") != 0)
        throw Failure(m_name, "not a PLY file");
      if(length == m_size || length > (1 << 24))
        break;
    }
    if(m_ranks.is_first())
      text.resize(parse_ply_header(m_name, text).size);
  });
  m_ranks.broadcast(text);
  m_header = parse_ply_header(m_name, text);
}

void Ply_slices::find_records()
{
  if(m_header.order == Order::ASCII)
    throw Failure(m_name, "PLY as text: parts of it cannot be found; gradient_domain_filter --binary makes it binary");
  MPI_Offset at = MPI_Offset(m_header.size);
  bool has_vertices = false, has_faces = false;
  for(const Ply_element& element : m_header.elements)
  {
    if(has_vertices && has_faces)
      break; // what follows is copied, whatever it is
    const bool is_faces = element.name == "face";
    Element found{Global(element.count), at, 0};
    for(const Property& p : element.properties)
    {
      const bool is_corners = is_faces && p.is_list && (p.name == "vertex_indices" || p.name == "vertex_index");
      if(p.is_list && !is_corners)
        throw Failure(m_name, "the list '" + p.name + "' of " + element.name
                                + ": records of different sizes cannot be shared among processes");
      if(is_corners)
      {
        m_corners_at = std::size_t(found.stride);
        m_count_type = p.size_type;
        m_index_type = p.type;
        found.stride += Global(size_of(p.size_type) + 3 * size_of(p.type));
        has_faces = true;
      }
      else
        found.stride += Global(size_of(p.type));
    }
    if(element.count > std::size_t((std::numeric_limits<Global>::max)() / (std::max)(found.stride, Global(1)) / 2))
      throw Failure(m_name, "the file ends at " + element.name + " 0 of " + std::to_string(element.count));
    at += found.count * found.stride;
    has_vertices = has_vertices || element.name == "vertex";
    if(element.name == "vertex")
      m_vertices = found;
    else if(is_faces)
      m_faces = found;
    if(at > m_size)
      throw Failure(m_name, "the file ends within " + element.name + ", of which it should have "
                              + std::to_string(element.count));
  }
  if(!has_vertices || !has_faces || m_faces.count == 0 || m_vertices.count == 0)
    throw Failure(m_name, "no vertices or no faces");
  if(!is_integer(m_index_type) || !is_integer(m_count_type))
    throw Failure(m_name, "indices of vertices that are not integers");
  for(const char* coordinate : {"x", "y", "z"})
    place(coordinate);
}

bool Ply_slices::has_property(const std::string& property) const
{
  for(const Ply_element& element : m_header.elements)
    if(element.name == "vertex" && element.find(property.c_str(), property.c_str()))
      return true;
  return false;
}

Ply_slices::Place Ply_slices::place(const std::string& property) const
{
  std::string others;
  for(const Ply_element& element : m_header.elements)
  {
    if(element.name != "vertex")
      continue;
    std::size_t offset = 0;
    for(const Property& p : element.properties)
    {
      if(p.name == property)
        return {offset, p.type};
      offset += size_of(p.type);
      others += (others.empty() ? "" : ", ") + p.name;
    }
  }
  throw Failure(m_name, "no vertex property '" + property + "'; there are: " + others);
}

std::vector<std::array<Global, 3> > Ply_slices::read_faces(Global begin, Global end) const
{
  const std::vector<char> bytes = read(m_faces.first + begin * m_faces.stride, (end - begin) * m_faces.stride);
  std::vector<std::array<Global, 3> > corners;
  m_ranks.together([&] {
    corners.resize(std::size_t(end - begin));
    for(std::size_t f = 0; f < corners.size(); ++f)
    {
      const char* at = bytes.data() + Global(f) * m_faces.stride + m_corners_at;
      if(binary_number(at, m_count_type, order()) != 3)
        throw Failure(m_name, "face " + std::to_string(begin + Global(f))
                                + " is not a triangle, as all must be whose parts are read at the same time");
      at += size_of(m_count_type);
      for(Global& v : corners[f])
      {
        v = Global(binary_number(at, m_index_type, order()));
        at += size_of(m_index_type);
        if(v < 0 || v >= m_vertices.count)
          throw Failure(m_name, "face " + std::to_string(begin + Global(f)) + " has a corner that is no vertex");
      }
    }
  });
  return corners;
}
