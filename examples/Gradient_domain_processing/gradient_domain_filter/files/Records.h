// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_FILES_RECORDS_H
#define GRADIENT_DOMAIN_FILTER_FILES_RECORDS_H

#include "Numbers.h"

#include <functional>
#include <string>
#include <vector>

// A number of a record, or a list of numbers that begins with its length, as in PLY.
struct Property
{
  std::string name;
  Number_type type;
  bool is_list = false;
  Number_type size_type = Number_type::UINT8;
};

// Where the numbers of the vertices, faces or normals stand in the bytes of a file. What comes out is what came in,
// with single numbers exchanged: so everything is kept of which we know nothing.
struct Records
{
  Order order = Order::ASCII;
  std::vector<std::size_t> offsets;              // of every record in its order; if empty, records have the same size
  std::size_t first = 0, stride = 0, count = 0;
  std::vector<Property> properties;              // if empty, only scalars
  bool lines_continue = false;                   // after a backslash

  std::size_t size() const { return offsets.empty() ? count : offsets.size(); }
  std::size_t offset(std::size_t i) const { return offsets.empty() ? first + i * stride : offsets[i]; }
};

// The number at a place of every record, and what it shall be.
struct Replacement
{
  int place;
  Number_type type;
  std::function<double(std::size_t)> value; // of a record
  bool is_spelled_real = false;             // with a point, though it is an integer
};

struct Replaced_records
{
  const Records* records;
  std::vector<Replacement> numbers;
};

// All records are of the same order. A number that is as it was stays as it was spelled.
void replace_numbers(std::string& text, std::vector<Replaced_records> replaced);

#endif // GRADIENT_DOMAIN_FILTER_FILES_RECORDS_H
