// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Mesh_file.h"
#include "Ply.h"
#include "file_blocks.h"

#include <algorithm>

namespace {

std::string counted(std::size_t n, const std::string& one)
{
  return std::to_string(n) + " " + one + (n == 1 ? "" : "s");
}

class Ply_parser
{
  Mesh_file& m_file;
  const Ply_header m_header;
  Ply_numbers m_numbers;

public:
  explicit Ply_parser(Mesh_file& file)
    : m_file(file), m_header(parse_ply_header(file.name, file.text)), m_numbers(file.name, file.text, m_header) {}

  void parse()
  {
    if(m_header.comments > 0)
      m_file.others.push_back(counted(m_header.comments, "comment"));
    for(const Ply_element& element : m_header.elements)
    {
      check_count(element);
      if(element.name == "vertex")
        read_vertices(element);
      else if(element.name == "face")
        read_faces(element);
      else if(element.name == "tristrips")
        read_strips(element);
      else
        skip(element);
    }
    if(!m_file.face_columns.empty() && m_file.face_columns[0].values.size() != m_file.polygons.size())
      m_file.face_columns.clear(); // faces and strips in one file
  }

private:
  // A count that the file cannot hold must not make us reserve memory for it.
  void check_count(const Ply_element& element) const
  {
    std::size_t least = 0;
    for(const Property& p : element.properties)
      least += m_numbers.least_size(p.is_list ? p.size_type : p.type);
    if(least > 0 && element.count > (m_numbers.remaining() + 1) / least)
      throw Failure(m_file.name, "the header announces " + std::to_string(element.count) + " times " + element.name
                                 + ", which do not fit into the file");
    if(least == 0 && element.count > 0 && (element.name == "vertex" || element.name == "face"))
      throw Failure(m_file.name, "bad PLY header: " + element.name + " without a property");
  }

  // Where the records stand, as far as that is known before they are read.
  Records begin_records(const Ply_element& element)
  {
    Records records;
    records.order = m_header.order;
    records.properties = element.properties;
    if(m_header.order != Order::ASCII && !element.has_lists())
    {
      for(const Property& p : element.properties)
        records.stride += size_of(p.type);
      records.first = offset();
      records.count = element.count;
      if(records.stride * element.count > m_numbers.remaining())
        m_numbers.ended(element, m_numbers.remaining() / records.stride);
    }
    return records;
  }

  std::size_t offset() { return std::size_t(m_numbers.position() - m_file.text.data()); }

  // A column for every scalar property.
  static Columns scalar_columns(const Ply_element& element)
  {
    Columns columns;
    for(std::size_t p = 0; p < element.properties.size(); ++p)
      if(!element.properties[p].is_list)
        columns.push_back({element.properties[p].name, element.properties[p].type, {}, int(p)});
    return columns;
  }

  // Where all records have the same size.
  void read_evenly_spaced(const Records& records, Columns& columns)
  {
    read_columns(records, columns);
    m_numbers.advance(records.stride * records.count);
  }

  void read_columns(const Records& records, Columns& columns) const
  {
    std::vector<std::size_t> distances;
    for(Column& column : columns)
    {
      column.values.resize(records.count);
      std::size_t distance = 0;
      for(int p = 0; p < column.place; ++p)
        distance += distance_over(records.properties[std::size_t(p)], m_file.text.data() + records.first + distance,
                                  records.order);
      distances.push_back(distance);
    }
    for_each_block_of_records(records.count, [&](std::size_t begin, std::size_t end) {
      for(std::size_t c = 0; c < columns.size(); ++c)
      {
        const char* at = m_file.text.data() + records.first + begin * records.stride + distances[c];
        for(std::size_t i = begin; i < end; ++i, at += records.stride)
          columns[c].values[i] = binary_number(at, columns[c].type, records.order);
      }
    });
  }

  static std::size_t distance_over(const Property& property, const char* at, Order order)
  {
    if(!property.is_list)
      return size_of(property.type);
    return size_of(property.size_type)
           + size_of(property.type) * std::size_t(binary_number(at, property.size_type, order));
  }

  // Binary faces with one list, of the same length in all of them. Returns false, and has read nothing, where they are
  // not so, or where one has a vertex that does not exist.
  bool read_even_faces(const Ply_element& element, const Property& list)
  {
    if(m_header.order == Order::ASCII || element.count == 0
       || std::count_if(element.properties.begin(), element.properties.end(), [](const Property& p) {
            return p.is_list;
          }) != 1)
      return false;
    Records records = m_file.face_records;
    records.first = offset();
    records.count = element.count;
    std::size_t before = 0;
    for(const Property& p : element.properties)
    {
      before += &p < &list ? size_of(p.type) : 0;
      if(!p.is_list)
        records.stride += size_of(p.type);
    }
    records.stride += size_of(list.size_type);
    if(before + size_of(list.size_type) > m_numbers.remaining())
      return false;
    const double size = binary_number(m_file.text.data() + records.first + before, list.size_type, records.order);
    if(!(size >= 0 && size <= double(m_numbers.remaining())))
      return false;
    records.stride += std::size_t(size) * size_of(list.type);
    if(element.count > m_numbers.remaining() / records.stride
       || !read_even_corners(records, list, before, std::size_t(size)))
      return false;
    if(!m_file.face_columns.empty())
    {
      m_file.face_records = records;
      read_columns(records, m_file.face_columns);
    }
    m_numbers.advance(records.stride * records.count);
    return true;
  }

  bool read_even_corners(const Records& records, const Property& list, std::size_t before, std::size_t size)
  {
    Polygons polygons;
    polygons.corners.resize(size * records.count);
    polygons.first_corner.resize(records.count + 1);
    std::vector<char> are_good(records.count / records_of_block + 1, 1);
    for_each_block_of_records(records.count, [&](std::size_t begin, std::size_t end) {
      bool is_good = true;
      for(std::size_t i = begin; i < end; ++i)
      {
        const char* at = m_file.text.data() + records.offset(i) + before;
        is_good = is_good && binary_number(at, list.size_type, records.order) == double(size);
        at += size_of(list.size_type);
        for(std::size_t j = 0; j < size; ++j, at += size_of(list.type))
        {
          const double index = binary_number(at, list.type, records.order);
          is_good = is_good && is_vertex(index);
          polygons.corners[size * i + j] = is_good ? int(index) : 0;
        }
        polygons.first_corner[i + 1] = size * (i + 1);
      }
      are_good[begin / records_of_block] = is_good;
    });
    if(std::find(are_good.begin(), are_good.end(), 0) != are_good.end() || !m_file.polygons.empty())
      return false;
    std::swap(m_file.polygons, polygons);
    return true;
  }

  // Record by record; lists but one are read over.
  template <class List>
  void read_one_by_one(const Ply_element& element, Records* records, Columns& columns, const Property* wanted,
                       const List& list)
  {
    for(Column& column : columns)
      column.values.reserve(element.count);
    if(records)
      records->offsets.reserve(element.count);
    for(std::size_t i = 0; i < element.count; ++i)
    {
      if(records)
        records->offsets.push_back(offset());
      std::size_t next_column = 0;
      for(const Property& property : element.properties)
      {
        const std::size_t size = property.is_list ? m_numbers.list_size(property, element, i) : 1;
        Column* const column = !property.is_list && !columns.empty() ? &columns[next_column++] : nullptr;
        for(std::size_t j = 0; j < size; ++j)
        {
          const double x = m_numbers.next(property.type, element, i);
          if(column)
            column->values.push_back(x);
          else if(&property == wanted)
            list(x, i);
        }
        if(&property == wanted)
          m_file.polygons.close_polygon();
      }
    }
  }

  void note_lists(const Ply_element& element, const Property* used)
  {
    for(const Property& p : element.properties)
      if(p.is_list && &p != used)
        m_file.others.push_back("the list '" + p.name + "' of " + element.name);
  }

  void read_vertices(const Ply_element& element)
  {
    note_lists(element, nullptr);
    Columns columns = scalar_columns(element);
    Records& records = m_file.vertex_records = begin_records(element);
    if(records.stride > 0)
      read_evenly_spaced(records, columns);
    else
      read_one_by_one(element, &records, columns, nullptr, [](double, std::size_t) {});

    const Column *x = columns.find("x"), *y = columns.find("y"), *z = columns.find("z");
    if(!x || !y || !z)
      throw Failure(m_file.name, "the vertices have no coordinates x, y, z");
    m_file.coordinate_places = {{x->place, y->place, z->place}};
    m_file.coordinate_type = (std::max)({x->type, y->type, z->type});
    m_file.points.resize(element.count);
    for_each_block_of_records(element.count, [&](std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i < end; ++i)
        m_file.points[i] = Point(x->values[i], y->values[i], z->values[i]);
    });
    for(Column& column : columns)
      if(column.name != "x" && column.name != "y" && column.name != "z")
        m_file.vertex_columns.push_back(std::move(column));
  }

  const Property* indices(const Ply_element& element) const
  {
    const Property* list = element.find("vertex_indices", "vertex_index");
    if(!list || !list->is_list || !is_integer(list->type))
      throw Failure(m_file.name, "no list of integers 'vertex_indices' in " + element.name);
    return list;
  }

  bool is_vertex(double index) const
  {
    return index >= 0 && index < double(m_file.points.size()) && index == double(int(index));
  }

  int corner(double index, const Ply_element& element, std::size_t i) const
  {
    if(!is_vertex(index))
      throw Failure(m_file.name, element.name + " " + std::to_string(i) + " has a vertex that does not exist");
    return int(index);
  }

  void read_faces(const Ply_element& element)
  {
    const Property* const list = indices(element);
    note_lists(element, list);
    m_file.face_columns = scalar_columns(element);
    m_file.face_records = begin_records(element);
    if(read_even_faces(element, *list))
      return;
    m_file.polygons.first_corner.reserve(element.count + 1);
    m_file.polygons.corners.reserve((std::min)(3 * element.count, m_numbers.remaining()));
    const auto add = [&](double x, std::size_t i) { m_file.polygons.corners.push_back(corner(x, element, i)); };
    Records* const records = m_file.face_columns.empty() ? nullptr : &m_file.face_records;
    read_one_by_one(element, records, m_file.face_columns, list, add);
  }

  // Every other triangle of a strip is turned over; -1 begins a new one.
  void read_strips(const Ply_element& element)
  {
    const Property* const list = indices(element);
    Polygons& polygons = m_file.polygons;
    for(std::size_t i = 0; i < element.count; ++i)
    {
      int last[2] = {-1, -1};
      bool is_turned = false;
      for(const Property& property : element.properties)
        for(std::size_t n = property.is_list ? m_numbers.list_size(property, element, i) : 1; n > 0; --n)
        {
          const double x = m_numbers.next(property.type, element, i);
          if(&property != list)
            continue;
          if(x == -1)
          {
            last[0] = last[1] = -1;
            is_turned = false;
            continue;
          }
          const int v = corner(x, element, i);
          if(last[0] >= 0)
          {
            if(v != last[0] && v != last[1] && last[0] != last[1]) // strips are turned by empty triangles
            {
              polygons.corners.insert(polygons.corners.end(), {last[is_turned], last[!is_turned], v});
              polygons.close_polygon();
            }
            is_turned = !is_turned;
          }
          last[0] = last[1];
          last[1] = v;
        }
    }
  }

  void skip(const Ply_element& element)
  {
    if(element.properties.empty())
      return;
    m_file.others.push_back(counted(element.count, element.name + " element"));
    Columns none;
    read_one_by_one(element, nullptr, none, nullptr, [](double, std::size_t) {});
  }
};

} // namespace

void parse_ply(Mesh_file& file)
{
  Ply_parser(file).parse();
}
