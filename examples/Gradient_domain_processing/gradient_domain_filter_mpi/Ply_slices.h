// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_MPI_PLY_SLICES_H
#define GRADIENT_DOMAIN_FILTER_MPI_PLY_SLICES_H

#include "Ranks.h"

#include "../gradient_domain_filter/files/Ply.h"

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

// A binary PLY file of triangles of which every rank reads and writes a part. Records of vertices and faces have the
// same size each, so that everybody knows where they stand.
class Ply_slices
{
public:
  struct Element
  {
    Global count = 0;
    MPI_Offset first = 0; // byte of the file
    Global stride = 0;

    // Of `size` ranks.
    Global slice_begin(int rank, int size) const
    {
      return count / size * rank + (std::min)(count % size, Global(rank));
    }
    int rank_of(Global i, int size) const;
  };

private:
  const Ranks& m_ranks;
  std::string m_name;
  MPI_File m_file = MPI_FILE_NULL;
  Ply_header m_header;
  MPI_Offset m_size = 0; // of the file
  Element m_vertices, m_faces;
  std::size_t m_corners_at = 0; // in the record of a face
  Number_type m_index_type = Number_type::INT32, m_count_type = Number_type::UINT8;

public:
  // Throws Failure, as all members do.
  Ply_slices(const Ranks& ranks, const std::string& name);
  ~Ply_slices();
  Ply_slices(const Ply_slices&) = delete;
  Ply_slices& operator=(const Ply_slices&) = delete;

  const Element& vertices() const { return m_vertices; }
  const Element& faces() const { return m_faces; }
  MPI_Offset size() const { return m_size; }
  Order order() const { return m_header.order; }

  struct Place
  {
    std::size_t offset; // in the record
    Number_type type;
  };
  // Of a property of vertices; throws Failure if there is none.
  Place place(const std::string& property) const;
  bool has_property(const std::string& property) const;

  // The bytes from `first` on; all ranks call it, some perhaps with none.
  std::vector<char> read(MPI_Offset first, Global bytes) const;

  // The corners of faces begin to end.
  std::vector<std::array<Global, 3> > read_faces(Global begin, Global end) const;

private:
  void open();
  void read_header();
  void find_records();
};

#endif // GRADIENT_DOMAIN_FILTER_MPI_PLY_SLICES_H
