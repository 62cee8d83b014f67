// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_FILES_PLY_H
#define GRADIENT_DOMAIN_FILTER_FILES_PLY_H

#include "../Failure.h"
#include "Records.h"
#include "Text_scanner.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// The header of a PLY file, line by line, so that it can be written again.
struct Ply_element
{
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;

  const Property* find(const char* a, const char* b) const
  {
    for(const Property& p : properties)
      if(p.name == a || p.name == b)
        return &p;
    return nullptr;
  }
  bool has_lists() const
  {
    for(const Property& p : properties)
      if(p.is_list)
        return true;
    return false;
  }
};

struct Ply_header
{
  Order order = Order::ASCII;
  std::vector<Ply_element> elements;
  std::size_t size = 0; // of the header in bytes
  std::size_t comments = 0;
};

// Throws Failure.
Ply_header parse_ply_header(const std::string& name, const std::string& text);
const char* ply_type_name(Number_type type);

// The numbers after the header, one after the other.
class Ply_numbers
{
  const std::string& m_name;
  Order m_order;
  const char* m_at;
  const char* m_end;
  Text_scanner m_text;
  std::string_view m_word;

public:
  Ply_numbers(const std::string& name, const std::string& text, const Ply_header& header)
    : m_name(name)
    , m_order(header.order)
    , m_at(text.data() + header.size)
    , m_end(text.data() + text.size())
    , m_text(m_at, m_end)
  {
  }

  std::size_t remaining() const { return m_order == Order::ASCII ? m_text.remaining() : std::size_t(m_end - m_at); }
  const char* position()
  {
    if(m_order != Order::ASCII)
      return m_at;
    m_text.skip_space();
    return m_text.position();
  }
  void advance(std::size_t bytes) { m_at += bytes; } // not in text

  // How many bytes a number takes at least.
  std::size_t least_size(Number_type type) const { return m_order == Order::ASCII ? 2 : size_of(type); }

  // As it was spelled, for text.
  std::string_view last_word() const { return m_word; }

  double next(Number_type type, const Ply_element& element, std::size_t i)
  {
    if(m_order == Order::ASCII)
    {
      double x;
      m_word = m_text.word();
      if(m_word.empty())
        ended(element, i);
      if(!Text_scanner::parse(m_word, x))
        throw Failure(m_name, element.name + " " + std::to_string(i) + " holds something that is not a number");
      return x;
    }
    if(std::size_t(m_end - m_at) < size_of(type))
      ended(element, i);
    const double x = binary_number(m_at, type, m_order);
    m_at += size_of(type);
    return x;
  }

  // The length of a list, which the rest of the file must be able to hold.
  std::size_t list_size(const Property& list, const Ply_element& element, std::size_t i)
  {
    const double size = next(list.size_type, element, i);
    if(!(size >= 0 && size <= double(remaining() / least_size(list.type) + 1)))
      ended(element, i);
    return std::size_t(size);
  }

  [[noreturn]] void ended(const Ply_element& element, std::size_t i) const
  {
    throw Failure(m_name, "the file ends at " + element.name + " " + std::to_string(i) + " of "
                            + std::to_string(element.count));
  }
};

#endif // GRADIENT_DOMAIN_FILTER_FILES_PLY_H
