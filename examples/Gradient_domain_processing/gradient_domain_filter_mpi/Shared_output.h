// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_MPI_SHARED_OUTPUT_H
#define GRADIENT_DOMAIN_FILTER_MPI_SHARED_OUTPUT_H

#include "Ply_slices.h"

#include "../gradient_domain_filter/Output_file.h"

#include <memory>
#include <string>
#include <vector>

// New numbers for some properties of vertices of the file.
struct New_values
{
  std::vector<std::string> properties;
  std::vector<Global> file_vertices;
  std::vector<std::vector<double> > columns; // one a property
};

// The bytes of the input with other numbers in them, written by all ranks to a temporary beside the output. It takes
// the output's name when all of them have succeeded, and vanishes otherwise.
class Shared_output
{
  const Ranks& m_ranks;
  std::string m_name;
  std::unique_ptr<Output_file> m_check; // rank 0: whether it can be written
  std::string m_temporary;
  MPI_File m_file = MPI_FILE_NULL;

public:
  // Throws Failure if it surely cannot be written, before any work is done for it; write() too.
  Shared_output(const Ranks& ranks, const std::string& name);
  ~Shared_output() { discard(); }
  Shared_output(const Shared_output&) = delete;
  Shared_output& operator=(const Shared_output&) = delete;

  void write(const Ply_slices& input, const New_values& values);

private:
  void open();
  void write_vertices(const Ply_slices& input, const New_values& values);
  void copy(const Ply_slices& input, MPI_Offset begin, MPI_Offset end);
  void put(MPI_Offset first, const std::vector<char>& bytes);
  void commit();
  void discard();
};

#endif // GRADIENT_DOMAIN_FILTER_MPI_SHARED_OUTPUT_H
