// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Colors.h"
#include "Mesh_file.h"
#include "Ply.h"

#include <algorithm>

namespace {

Order order_of(Encoding encoding, Order otherwise)
{
  return encoding == Encoding::DEFAULT ? otherwise : encoding == Encoding::ASCII ? Order::ASCII
         : otherwise == Order::ASCII ? Order::SAME : otherwise;
}

const char* format_name(Order order)
{
  return order == Order::ASCII                                  ? "ascii"
         : (order == Order::SAME) == is_little_endian_machine() ? "binary_little_endian"
                                                                : "binary_big_endian";
}

// The numbers of records, one after the other.
class Ply_body
{
  std::string& m_text;
  Order m_order;
  bool m_is_first = true; // of a line

public:
  Ply_body(std::string& text, Order order) : m_text(text), m_order(order) {}

  void add(double x, Number_type type)
  {
    if(m_order != Order::ASCII)
      return append_binary_number(m_text, x, type, m_order);
    separate();
    append_number(m_text, x, type);
  }
  void add_word(std::string_view word)
  {
    separate();
    m_text += word;
  }
  void end_record()
  {
    if(m_order == Order::ASCII)
      m_text += '\n';
    m_is_first = true;
  }

private:
  void separate()
  {
    if(!m_is_first)
      m_text += ' ';
    m_is_first = false;
  }
};

// A PLY file in another form or with more properties; all that is in it stays.
class Ply_changer
{
  const Mesh_file& m_file;
  const Output_form& m_form;
  const Ply_header m_header;
  const Order m_order;
  std::string m_text;

  // What becomes of a property, by its place.
  struct Change
  {
    Number_type type;
    const Column* column = nullptr; // its new values
    int coordinate = -1;            // or which one it is
  };

public:
  Ply_changer(const Mesh_file& file, const Output_form& form)
    : m_file(file)
    , m_form(form)
    , m_header(parse_ply_header(file.name, file.text))
    , m_order(order_of(form.encoding, m_header.order))
  {
  }

  std::string changed()
  {
    write_header();
    Ply_numbers numbers(m_file.name, m_file.text, m_header);
    Ply_body body(m_text, m_order);
    for(const Ply_element& element : m_header.elements)
      write_element(element, numbers, body);
    return std::move(m_text);
  }

private:
  const Columns& columns(const Ply_element& element) const
  {
    static const Columns none;
    return element.name == "vertex" ? m_file.vertex_columns : element.name == "face" ? m_file.face_columns : none;
  }

  Number_type wanted_real(Number_type type) const
  {
    return m_form.precision == Precision::DEFAULT  ? type
           : m_form.precision == Precision::SINGLE ? Number_type::FLOAT : Number_type::DOUBLE;
  }
  Number_type wanted(Number_type type) const { return is_integer(type) ? type : wanted_real(type); }

  std::vector<Change> changes(const Ply_element& element) const
  {
    std::vector<Change> changes;
    for(const Property& p : element.properties)
      changes.push_back({p.type});
    for(const Column& column : columns(element))
      if(column.is_changed && column.place >= 0)
        changes[std::size_t(column.place)] = {wanted(column.type), &column};
    if(element.name == "vertex")
      for(int i = 0; i < 3; ++i)
      {
        Change& change = changes[std::size_t(m_file.coordinate_places[std::size_t(i)])];
        change.type = wanted_real(change.type);
        change.coordinate = i;
      }
    return changes;
  }

  void write_new_properties(const Ply_element& element)
  {
    for(const Column& column : columns(element))
      if(column.place < 0 && element.find(column.name.c_str(), column.name.c_str()))
        throw Failure(m_file.name,
                      "the list '" + column.name + "' of " + element.name + " has the name of what is to be added");
      else if(column.place < 0)
        m_text += std::string("property ") + ply_type_name(wanted(column.type)) + " " + column.name + "\n";
  }

  // Line by line; comments stay where they are.
  void write_header()
  {
    Text_scanner lines(std::string_view(m_file.text).substr(0, m_header.size));
    std::size_t element = 0, property = 0;
    std::vector<Change> changed;
    while(lines.remaining() > 0)
    {
      const std::string_view line = lines.line();
      Text_scanner words(line);
      const std::string_view key = words.word();
      if((key == "element" && element > 0) || (key == "end_header" && element > 0))
        write_new_properties(m_header.elements[element - 1]);
      if(key == "element")
      {
        changed = changes(m_header.elements[element++]);
        property = 0;
      }
      if(key == "format")
        m_text += std::string("format ") + format_name(m_order) + " 1.0";
      else if(key == "property" && m_header.elements[element - 1].properties[property].type != changed[property].type)
        m_text += std::string("property ") + ply_type_name(changed[property].type) + " "
                  + m_header.elements[element - 1].properties[property].name;
      else
        m_text += line;
      property += key == "property";
      m_text += '\n';
    }
  }

  void write_element(const Ply_element& element, Ply_numbers& numbers, Ply_body& body)
  {
    const std::vector<Change> changed = changes(element);
    for(std::size_t i = 0; i < element.count; ++i)
    {
      for(std::size_t p = 0; p < element.properties.size(); ++p)
      {
        const Property& property = element.properties[p];
        if(property.is_list)
          copy_list(property, element, i, numbers, body);
        else
          write_number(changed[p], numbers.next(property.type, element, i), i, numbers, body);
      }
      for(const Column& column : columns(element))
        if(column.place < 0)
          body.add(column.values[i], wanted(column.type));
      if(!element.properties.empty())
        body.end_record();
    }
  }

  void copy_list(const Property& list, const Ply_element& element, std::size_t i, Ply_numbers& numbers, Ply_body& body)
  {
    const std::size_t size = numbers.list_size(list, element, i);
    write_number({list.size_type}, double(size), i, numbers, body);
    for(std::size_t j = 0; j < size; ++j)
      write_number({list.type}, numbers.next(list.type, element, i), i, numbers, body);
  }

  // From text to text a number that is as it was is spelled as it was.
  void write_number(const Change& change, double before, std::size_t i, const Ply_numbers& numbers, Ply_body& body)
  {
    const double x = change.column            ? change.column->values[i]
                     : change.coordinate >= 0 ? m_file.points[i][change.coordinate]
                                              : before;
    if(x == before && m_order == Order::ASCII && m_header.order == Order::ASCII)
      body.add_word(numbers.last_word());
    else if(x == before && m_header.order == Order::ASCII && !(fits(x, change.type) && in_range(x, change.type) == x))
      throw Failure(m_file.name, "holds a number that does not fit into its type: " + std::string(numbers.last_word()));
    else
      body.add(x, change.type);
  }
};

// The columns as PLY has them: colors are bytes there.
Columns ply_columns(const Columns& columns)
{
  Columns result = columns;
  const double full = white(columns);
  if(columns.has_colors())
    for(const char* name : {"red", "green", "blue", "alpha"})
      if(Column* const column = result.find(name); column && !is_integer(column->type))
      {
        column->type = Number_type::UINT8;
        for(double& x : column->values)
          x = 255 * unit_color(x, full);
      }
  return result;
}

void add_properties(std::string& text, const Columns& columns)
{
  for(const Column& column : columns)
    text += std::string("property ") + ply_type_name(column.type) + " " + column.name + "\n";
}

} // namespace

std::string changed_ply(const Mesh_file& file, const Output_form& form)
{
  return Ply_changer(file, form).changed();
}

std::string new_ply(const Mesh_file& file, const Output_form& form)
{
  const Number_type type = form.precision == Precision::SINGLE ? Number_type::FLOAT : Number_type::DOUBLE;
  const Order order = order_of(form.encoding, Order::SAME);
  Columns vertex_columns = ply_columns(file.vertex_columns);
  const Columns face_columns = file.format == File_format::STL ? Columns() : ply_columns(file.face_columns);
  if(const std::vector<Vector> normals = vertex_normals_of_file(file);
     !normals.empty() && !vertex_columns.has_normals())
    for(int i = 0; i < 3; ++i)
    {
      vertex_columns.push_back({std::string("n") + "xyz"[i], type, {}});
      for(const Vector& n : normals)
        vertex_columns.back().values.push_back(n[i]);
    }
  std::size_t most_corners = 0;
  for(std::size_t f = 0; f < file.polygons.size(); ++f)
    most_corners = (std::max)(most_corners, std::size_t(file.polygons[f].size()));
  const Number_type size_type = most_corners < 256 ? Number_type::UINT8 : Number_type::UINT32;

  std::string text = std::string("ply\nformat ") + format_name(order) + " 1.0\nelement vertex "
                     + std::to_string(file.points.size()) + "\n";
  for(const char* name : {"x", "y", "z"})
    text += std::string("property ") + ply_type_name(type) + " " + name + "\n";
  add_properties(text, vertex_columns);
  text += "element face " + std::to_string(file.polygons.size()) + "\nproperty list " + ply_type_name(size_type)
          + " int vertex_indices\n";
  add_properties(text, face_columns);
  text += "end_header\n";
  text.reserve(text.size() + (order == Order::ASCII ? 2 : 1) * (file.points.size() * 8 * (3 + vertex_columns.size())
               + file.polygons.size() * (4 + 8 * face_columns.size()) + 4 * file.polygons.corners.size()));

  Ply_body body(text, order);
  for(std::size_t v = 0; v < file.points.size(); ++v)
  {
    for(int i = 0; i < 3; ++i)
      body.add(file.points[v][i], type);
    for(const Column& column : vertex_columns)
      body.add(column.values[v], column.type);
    body.end_record();
  }
  for(std::size_t f = 0; f < file.polygons.size(); ++f)
  {
    body.add(double(file.polygons[f].size()), size_type);
    for(int v : file.polygons[f])
      body.add(v, Number_type::INT32);
    for(const Column& column : face_columns)
      body.add(column.values[f], column.type);
    body.end_record();
  }
  return text;
}
