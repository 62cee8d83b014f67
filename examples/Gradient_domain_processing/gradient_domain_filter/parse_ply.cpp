// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Failure.h"
#include "Mesh_file.h"
#include "Text_scanner.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace {

struct Property
{
  std::string name;
  Number_type type;
  bool is_list = false;
  Number_type size_type = Number_type::UINT8;
};

struct Element
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
};

enum class Order { ASCII, SAME, SWAPPED };

std::size_t size_of(Number_type type)
{
  static const std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[int(type)];
}

bool is_little_endian_machine()
{
  const std::uint16_t one = 1;
  char first;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

// The numbers after the header, one after the other.
class Numbers
{
  const std::string& m_path;
  Order m_order;
  const char* m_at;
  const char* m_end;
  Text_scanner m_text;

public:
  Numbers(const std::string& path, Order order, const char* begin, const char* end)
    : m_path(path), m_order(order), m_at(begin), m_end(end), m_text(begin, end) {}

  std::size_t remaining() const { return m_order == Order::ASCII ? m_text.remaining() : std::size_t(m_end - m_at); }

  // How many bytes a number takes at least.
  std::size_t least_size(Number_type type) const { return m_order == Order::ASCII ? 2 : size_of(type); }

  double next(Number_type type, const Element& element, std::size_t i)
  {
    if(m_order == Order::ASCII)
    {
      double x;
      if(m_text.at_end())
        ended(element, i);
      if(!m_text.number(x))
        throw Failure(m_path, element.name + " " + std::to_string(i) + " holds something that is not a number");
      return x;
    }
    if(std::size_t(m_end - m_at) < size_of(type))
      ended(element, i);
    switch(type)
    {
      case Number_type::INT8: return get<std::int8_t>();
      case Number_type::UINT8: return get<std::uint8_t>();
      case Number_type::INT16: return get<std::int16_t>();
      case Number_type::UINT16: return get<std::uint16_t>();
      case Number_type::INT32: return get<std::int32_t>();
      case Number_type::UINT32: return get<std::uint32_t>();
      case Number_type::FLOAT: return get<float>();
      case Number_type::DOUBLE: return get<double>();
    }
    return 0;
  }

  // The length of a list, which the rest of the file must be able to hold.
  std::size_t list_size(const Property& list, const Element& element, std::size_t i)
  {
    const double size = next(list.size_type, element, i);
    if(!(size >= 0 && size <= double(remaining() / least_size(list.type) + 1)))
      ended(element, i);
    return std::size_t(size);
  }

private:
  [[noreturn]] void ended(const Element& element, std::size_t i) const
  {
    throw Failure(m_path, "the file ends at " + element.name + " " + std::to_string(i) + " of " + std::to_string(element.count));
  }

  template <class T>
  double get()
  {
    T value;
    if(m_order == Order::SAME)
      std::memcpy(&value, m_at, sizeof(T));
    else
    {
      char bytes[sizeof(T)];
      for(std::size_t i = 0; i < sizeof(T); ++i)
        bytes[i] = m_at[sizeof(T) - 1 - i];
      std::memcpy(&value, bytes, sizeof(T));
    }
    m_at += sizeof(T);
    return double(value);
  }
};

class Ply_parser
{
  const std::string& m_path;
  const std::string& m_text;
  std::vector<Element> m_elements;
  Order m_order = Order::ASCII;
  Polygon_soup m_soup;

public:
  Ply_parser(const std::string& path, const std::string& text) : m_path(path), m_text(text) {}

  Polygon_soup parse()
  {
    const char* const body = read_header();
    Numbers numbers(m_path, m_order, body, m_text.data() + m_text.size());
    for(const Element& element : m_elements)
    {
      check_count(element, numbers);
      if(element.name == "vertex")
        read_vertices(element, numbers);
      else if(element.name == "face")
        read_faces(element, numbers);
      else if(element.name == "tristrips")
        read_strips(element, numbers);
      else
        skip(element, numbers);
    }
    if(!m_soup.face_columns.empty() && m_soup.face_columns[0].values.size() != m_soup.number_of_polygons())
      m_soup.face_columns.clear(); // faces and strips in one file
    return std::move(m_soup);
  }

private:
  [[noreturn]] void bad_header(std::string_view line) const
  {
    std::string shown(line.substr(0, 60));
    for(char& c : shown)
      if(c < ' ' || c > '~')
        c = '?';
    throw Failure(m_path, "bad PLY header: '" + shown + "'");
  }

  static bool number_type(std::string_view name, Number_type& type)
  {
    static const char* const names[8][2] = {{"char", "int8"}, {"uchar", "uint8"}, {"short", "int16"}, {"ushort", "uint16"},
                                            {"int", "int32"}, {"uint", "uint32"}, {"float", "float32"}, {"double", "float64"}};
    for(int i = 0; i < 8; ++i)
      if(name == names[i][0] || name == names[i][1])
      {
        type = Number_type(i);
        return true;
      }
    return false;
  }

  const char* read_header()
  {
    Text_scanner text(m_text);
    if(text.line() != "ply")
      throw Failure(m_path, "not a PLY file");
    bool has_format = false;
    while(text.remaining() > 0)
    {
      const std::string_view line = text.line();
      Text_scanner words(line);
      const std::string_view key = words.word();
      if(key == "end_header")
      {
        if(!has_format)
          throw Failure(m_path, "bad PLY header: no format");
        return text.position();
      }
      if(key == "format")
      {
        const std::string_view name = words.word();
        const bool is_little = name == "binary_little_endian";
        if(name == "ascii")
          m_order = Order::ASCII;
        else if(is_little || name == "binary_big_endian")
          m_order = is_little == is_little_endian_machine() ? Order::SAME : Order::SWAPPED;
        else
          bad_header(line);
        has_format = true;
      }
      else if(key == "element")
      {
        Element element;
        element.name = std::string(words.word());
        if(element.name.empty() || !words.integer(element.count))
          bad_header(line);
        for(const Element& other : m_elements)
          if(other.name == element.name)
            bad_header(line);
        m_elements.push_back(element);
      }
      else if(key == "property")
        read_property(line, words);
      else if(!key.empty() && key != "comment" && key != "obj_info")
        bad_header(line);
    }
    throw Failure(m_path, "the file ends in its header");
  }

  void read_property(std::string_view line, Text_scanner& words)
  {
    if(m_elements.empty())
      bad_header(line);
    Property property;
    std::string_view type = words.word();
    if(type == "list")
    {
      property.is_list = true;
      if(!number_type(words.word(), property.size_type) || !is_integer(property.size_type))
        bad_header(line);
      type = words.word();
    }
    property.name = std::string(words.word());
    if(!number_type(type, property.type) || property.name.empty())
      bad_header(line);
    for(const Property& other : m_elements.back().properties)
      if(other.name == property.name)
        bad_header(line);
    m_elements.back().properties.push_back(property);
  }

  // A count that the file cannot hold must not make us reserve memory for it.
  void check_count(const Element& element, const Numbers& numbers) const
  {
    std::size_t least = 0;
    for(const Property& p : element.properties)
      least += numbers.least_size(p.is_list ? p.size_type : p.type);
    if(least > 0 && element.count > (numbers.remaining() + 1) / least)
      throw Failure(m_path, "the header announces " + std::to_string(element.count) + " times " + element.name
                            + ", which do not fit into the file");
    if(least == 0 && element.count > 0 && (element.name == "vertex" || element.name == "face"))
      throw Failure(m_path, "bad PLY header: " + element.name + " without a property");
  }

  // Lists but one are read over.
  template <class List>
  void read_item(const Element& element, std::size_t i, Numbers& numbers, const std::vector<std::vector<double>*>& target,
                 const Property* wanted, const List& list)
  {
    for(std::size_t p = 0; p < element.properties.size(); ++p)
    {
      const Property& property = element.properties[p];
      if(!property.is_list)
      {
        const double x = numbers.next(property.type, element, i);
        if(target[p])
          target[p]->push_back(x);
        continue;
      }
      const std::size_t size = numbers.list_size(property, element, i);
      for(std::size_t j = 0; j < size; ++j)
      {
        const double x = numbers.next(property.type, element, i);
        if(&property == wanted)
          list(x);
      }
    }
  }

  // A column for every scalar property.
  std::vector<std::vector<double>*> scalar_columns(const Element& element, Columns& columns)
  {
    for(const Property& p : element.properties)
      if(!p.is_list)
      {
        columns.push_back({p.name, p.type, {}});
        columns.back().values.reserve(element.count);
      }
    std::vector<std::vector<double>*> target;
    std::size_t next = 0;
    for(const Property& p : element.properties)
      target.push_back(p.is_list ? nullptr : &columns[next++].values);
    return target;
  }

  void note_lists(const Element& element, const Property* used)
  {
    for(const Property& p : element.properties)
      if(p.is_list && &p != used)
        m_soup.notes.push_back("the list '" + p.name + "' of " + element.name);
  }

  void read_vertices(const Element& element, Numbers& numbers)
  {
    Columns columns;
    const auto target = scalar_columns(element, columns);
    note_lists(element, nullptr);
    const Column *x = columns.find("x"), *y = columns.find("y"), *z = columns.find("z");
    if(!x || !y || !z)
      throw Failure(m_path, "the vertices have no coordinates x, y, z");
    for(std::size_t i = 0; i < element.count; ++i)
      read_item(element, i, numbers, target, nullptr, [](double) {});
    m_soup.points.reserve(element.count);
    for(std::size_t i = 0; i < element.count; ++i)
      m_soup.points.emplace_back(x->values[i], y->values[i], z->values[i]);
    for(Column& column : columns)
      if(column.name != "x" && column.name != "y" && column.name != "z")
        m_soup.vertex_columns.push_back(std::move(column));
  }

  const Property* indices(const Element& element) const
  {
    const Property* list = element.find("vertex_indices", "vertex_index");
    if(!list || !list->is_list || !is_integer(list->type))
      throw Failure(m_path, "no list of integers 'vertex_indices' in " + element.name);
    return list;
  }

  int corner(double index, const Element& element, std::size_t i) const
  {
    if(!(index >= 0 && index < double(m_soup.points.size())) || index != double(int(index)))
      throw Failure(m_path, element.name + " " + std::to_string(i) + " has a vertex that does not exist");
    return int(index);
  }

  void read_faces(const Element& element, Numbers& numbers)
  {
    const Property* const list = indices(element);
    const auto target = scalar_columns(element, m_soup.face_columns);
    note_lists(element, list);
    m_soup.first_corner.reserve(element.count + 1);
    m_soup.corners.reserve((std::min)(3 * element.count, numbers.remaining()));
    for(std::size_t i = 0; i < element.count; ++i)
    {
      read_item(element, i, numbers, target, list, [&](double x) { m_soup.corners.push_back(corner(x, element, i)); });
      m_soup.close_polygon();
    }
  }

  // Every other triangle of a strip is turned over; -1 begins a new one.
  void read_strips(const Element& element, Numbers& numbers)
  {
    const Property* const list = indices(element);
    for(std::size_t i = 0; i < element.count; ++i)
    {
      int last[2] = {-1, -1};
      bool is_turned = false;
      const auto add = [&](double x) {
        if(x == -1)
        {
          last[0] = last[1] = -1;
          is_turned = false;
          return;
        }
        const int v = corner(x, element, i);
        if(last[0] >= 0)
        {
          if(v != last[0] && v != last[1] && last[0] != last[1]) // strips are turned by empty triangles
          {
            m_soup.corners.insert(m_soup.corners.end(), {last[is_turned], last[!is_turned], v});
            m_soup.close_polygon();
          }
          is_turned = !is_turned;
        }
        last[0] = last[1];
        last[1] = v;
      };
      read_item(element, i, numbers, std::vector<std::vector<double>*>(element.properties.size()), list, add);
    }
  }

  void skip(const Element& element, Numbers& numbers)
  {
    if(element.properties.empty())
      return;
    m_soup.notes.push_back("the elements '" + element.name + "'");
    const std::vector<std::vector<double>*> nowhere(element.properties.size());
    for(std::size_t i = 0; i < element.count; ++i)
      read_item(element, i, numbers, nowhere, nullptr, [](double) {});
  }
};

} // namespace

Polygon_soup parse_ply(const std::string& path, const std::string& text)
{
  return Ply_parser(path, text).parse();
}
