// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Ply.h"

namespace {

const char* const type_names[8][2] = {{"char", "int8"},     {"uchar", "uint8"},   {"short", "int16"},
                                      {"ushort", "uint16"}, {"int", "int32"},     {"uint", "uint32"},
                                      {"float", "float32"}, {"double", "float64"}};

class Header_parser
{
  const std::string& m_name;
  Text_scanner m_text;
  const char* m_begin;
  Ply_header m_header;
  bool m_has_format = false;

public:
  Header_parser(const std::string& name, const std::string& text) : m_name(name), m_text(text), m_begin(text.data()) {}

  Ply_header parse()
  {
    if(m_text.line() != "ply")
      throw Failure(m_name, "not a PLY file");
    while(m_text.remaining() > 0)
    {
      const std::string_view line = m_text.line();
      Text_scanner words(line);
      const std::string_view key = words.word();
      if(key == "end_header")
      {
        if(!m_has_format)
          throw Failure(m_name, "bad PLY header: no format");
        m_header.size = std::size_t(m_text.position() - m_begin);
        return std::move(m_header);
      }
      if(key == "format")
        read_format(line, words);
      else if(key == "element")
        read_element(line, words);
      else if(key == "property")
        read_property(line, words);
      else if(key == "comment" || key == "obj_info")
        ++m_header.comments;
      else if(!key.empty())
        bad_line(line);
    }
    throw Failure(m_name, "the file ends in its header");
  }

private:
  [[noreturn]] void bad_line(std::string_view line) const
  {
    std::string shown(line.substr(0, 60));
    for(char& c : shown)
      if(c < ' ' || c > '~')
        c = '?';
    throw Failure(m_name, "bad PLY header: '" + shown + "'");
  }

  static bool number_type(std::string_view name, Number_type& type)
  {
    for(int i = 0; i < 8; ++i)
      if(name == type_names[i][0] || name == type_names[i][1])
      {
        type = Number_type(i);
        return true;
      }
    return false;
  }

  void read_format(std::string_view line, Text_scanner& words)
  {
    const std::string_view name = words.word();
    if(name == "ascii")
      m_header.order = Order::ASCII;
    else if(name == "binary_little_endian" || name == "binary_big_endian")
      m_header.order = (name == "binary_little_endian") == is_little_endian_machine() ? Order::SAME : Order::SWAPPED;
    else
      bad_line(line);
    m_has_format = true;
  }

  void read_element(std::string_view line, Text_scanner& words)
  {
    Ply_element element;
    element.name = std::string(words.word());
    if(element.name.empty() || !words.integer(element.count))
      bad_line(line);
    for(const Ply_element& other : m_header.elements)
      if(other.name == element.name)
        bad_line(line);
    m_header.elements.push_back(element);
  }

  void read_property(std::string_view line, Text_scanner& words)
  {
    if(m_header.elements.empty())
      bad_line(line);
    Property property;
    std::string_view type = words.word();
    if(type == "list")
    {
      property.is_list = true;
      if(!number_type(words.word(), property.size_type) || !is_integer(property.size_type))
        bad_line(line);
      type = words.word();
    }
    property.name = std::string(words.word());
    if(!number_type(type, property.type) || property.name.empty())
      bad_line(line);
    for(const Property& other : m_header.elements.back().properties)
      if(other.name == property.name)
        bad_line(line);
    m_header.elements.back().properties.push_back(property);
  }
};

} // namespace

const char* ply_type_name(Number_type type) { return type_names[int(type)][0]; }

Ply_header parse_ply_header(const std::string& name, const std::string& text)
{
  return Header_parser(name, text).parse();
}
