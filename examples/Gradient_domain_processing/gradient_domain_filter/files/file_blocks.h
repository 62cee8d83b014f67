// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_FILES_FILE_BLOCKS_H
#define GRADIENT_DOMAIN_FILTER_FILES_FILE_BLOCKS_H

#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_blocks.h>

#include <cstddef>
#include <string>
#include <vector>

// Files are read and written in blocks, which depend on the file only: what comes of it is the same on any number of
// threads.
constexpr std::size_t bytes_of_block = std::size_t(1) << 20;
constexpr std::size_t records_of_block = std::size_t(1) << 14;

// Calls body(k) for each.
template <class Body>
void for_each_part(std::size_t count, const Body& body)
{
  CGAL::Gradient_domain_processing::internal::for_each_block(true, count, 1,
                                                             [&](std::size_t k, std::size_t) { body(k); });
}

// Calls body(begin, end) for blocks of records.
template <class Body>
void for_each_block_of_records(std::size_t count, const Body& body)
{
  CGAL::Gradient_domain_processing::internal::for_each_block(true, count, records_of_block, body);
}

// Where blocks of a text begin, and its end: at lines that no backslash joins to the one before.
inline std::vector<std::size_t> line_blocks(const std::string& text, std::size_t size = bytes_of_block)
{
  std::vector<std::size_t> begins(1, 0);
  while(text.size() - begins.back() > size)
  {
    std::size_t end = text.find('\n', begins.back() + size);
    while(end != std::string::npos && (text[end - 1] == '\\' || (text[end - 1] == '\r' && text[end - 2] == '\\')))
      end = text.find('\n', end + 1);
    if(end == std::string::npos || end + 1 == text.size())
      break;
    begins.push_back(end + 1);
  }
  begins.push_back(text.size());
  return begins;
}

#endif // GRADIENT_DOMAIN_FILTER_FILES_FILE_BLOCKS_H
