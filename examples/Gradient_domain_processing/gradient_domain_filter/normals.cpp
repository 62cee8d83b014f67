// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "normals.h"
#include "files/Value_index.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace {

Vector normalized(const Vector& n)
{
  const double length = std::sqrt(n.squared_length());
  return length > 0 && std::isfinite(length) ? n / length : Vector(0, 0, 0);
}

// A power of two, so that equal differences stay equal.
double inverse_unit(const std::vector<Point>& points, const Polygons& polygons)
{
  double extent = 0;
  if(polygons.corners.empty())
    return 1;
  const Point& origin = points[std::size_t(polygons.corners[0])];
  for(int v : polygons.corners)
    for(int i = 0; i < 3; ++i)
      if(const double x = std::abs(points[std::size_t(v)][i] - origin[i]); std::isfinite(x))
        extent = (std::max)(extent, x);
  return extent > 0 ? std::ldexp(1., -std::ilogb(extent)) : 1;
}

// As long as twice the areas of the faces, in a unit in which nothing over- or underflows.
std::vector<Vector> face_normals(const std::vector<Point>& points, const Polygons& polygons, double factor)
{
  std::vector<Vector> normals(polygons.size(), Vector(0, 0, 0));
  for(std::size_t f = 0; f < polygons.size(); ++f)
  {
    const auto polygon = polygons[f];
    for(std::ptrdiff_t i = 2; i < std::ptrdiff_t(polygon.size()); ++i)
    {
      const Point &a = points[std::size_t(polygon[0])], &b = points[std::size_t(polygon[i - 1])],
                  &c = points[std::size_t(polygon[i])];
      normals[f] = normals[f] + CGAL::cross_product(factor * (b - a), factor * (c - a));
    }
  }
  return normals;
}

// The corners that have a normal in common: those of a vertex, or those of one vn of OBJ. Copies of a vertex at a seam
// that had the same normal go on having the same.
struct Shared_normals
{
  std::vector<int> of_corner; // -1: none
  std::vector<int> group;     // of a normal
};

Shared_normals share(const std::vector<Point>& points, const Polygons& polygons, const Columns& columns,
                     std::vector<int> of_corner)
{
  Shared_normals shared{std::move(of_corner), std::vector<int>(columns[0].values.size())};
  std::iota(shared.group.begin(), shared.group.end(), 0);
  const auto root = [&](int n) {
    while(shared.group[std::size_t(n)] != n)
      n = shared.group[std::size_t(n)] = shared.group[std::size_t(shared.group[std::size_t(n)])];
    return n;
  };
  const std::vector<double>* const n[3] = {&columns.find("nx")->values, &columns.find("ny")->values,
                                           &columns.find("nz")->values};
  Value_index<6> places(points.size());
  std::vector<int> first; // normal at a place
  for(std::size_t c = 0; c < polygons.corners.size(); ++c)
  {
    if(shared.of_corner[c] < 0)
      continue;
    const Point& p = points[std::size_t(polygons.corners[c])];
    const std::size_t i = std::size_t(shared.of_corner[c]);
    const std::size_t place =
      std::size_t(places.find_or_add({{p.x(), p.y(), p.z(), (*n[0])[i], (*n[1])[i], (*n[2])[i]}}));
    if(place == first.size())
      first.push_back(int(i));
    const int a = root(first[place]), b = root(int(i));
    shared.group[std::size_t((std::max)(a, b))] = (std::min)(a, b);
  }
  for(std::size_t i = 0; i < shared.group.size(); ++i)
    shared.group[i] = root(int(i));
  return shared;
}

std::vector<Vector> sums(const std::vector<Vector>& of_faces, const Polygons& polygons, const Shared_normals& shared)
{
  std::vector<Vector> sum(shared.group.size(), Vector(0, 0, 0));
  for(std::size_t f = 0; f < polygons.size(); ++f)
    for(std::size_t c = polygons.first_corner[f]; c < polygons.first_corner[f + 1]; ++c)
      if(const int n = shared.of_corner[c]; n >= 0)
      {
        Vector& at = sum[std::size_t(shared.group[std::size_t(n)])];
        at = at + of_faces[f];
      }
  return sum;
}

// Whether the normals of the file look to the side from which faces are seen counter-clockwise; -1 if to the other.
double side(const std::vector<Vector>& before, const Columns& columns)
{
  const std::vector<double>&x = columns.find("nx")->values, &y = columns.find("ny")->values,
        &z = columns.find("nz")->values;
  double sum = 0;
  for(std::size_t i = 0; i < before.size(); ++i)
    if(const double product = normalized(before[i]) * Vector(x[i], y[i], z[i]); std::isfinite(product))
      sum += product > 0 ? 1 : product < 0 ? -1 : 0;
  return sum < 0 ? -1 : 1;
}

std::size_t set_normals(const std::vector<Vector>& before, const std::vector<Vector>& after, Columns& columns)
{
  Column* const column[3] = {columns.find("nx"), columns.find("ny"), columns.find("nz")};
  const double sign = side(before, columns);
  std::size_t changed = 0;
  for(std::size_t i = 0; i < after.size(); ++i)
  {
    double* const n[3] = {&column[0]->values[i], &column[1]->values[i], &column[2]->values[i]};
    const Vector unit = normalized(after[i]);
    if(before[i] == after[i] || unit == Vector(0, 0, 0) || (*n[0] == 0 && *n[1] == 0 && *n[2] == 0))
      continue;
    for(int k = 0; k < 3; ++k)
      *n[k] = sign * unit[k];
    ++changed;
  }
  if(changed > 0)
    for(Column* c : column)
      c->is_changed = true;
  return changed;
}

std::size_t update_shared(const std::vector<Point>& before, const std::vector<Vector> (&faces)[2],
                          std::vector<int> of_corner, const Polygons& polygons, Columns& columns)
{
  const Shared_normals shared = share(before, polygons, columns, std::move(of_corner));
  std::vector<Vector> sum[2] = {sums(faces[0], polygons, shared), sums(faces[1], polygons, shared)};
  for(std::vector<Vector>& s : sum)
    for(std::size_t i = 0; i < s.size(); ++i)
      s[i] = s[std::size_t(shared.group[i])];
  return set_normals(sum[0], sum[1], columns);
}

} // namespace

std::vector<Vector> vertex_normals(const std::vector<Point>& points, const Polygons& polygons)
{
  const std::vector<Vector> of_faces = face_normals(points, polygons, inverse_unit(points, polygons));
  std::vector<Vector> normals(points.size(), Vector(0, 0, 0));
  for(std::size_t f = 0; f < polygons.size(); ++f)
    for(int v : polygons[f])
      normals[std::size_t(v)] = normals[std::size_t(v)] + of_faces[f];
  for(Vector& n : normals)
    n = normalized(n);
  return normals;
}

std::size_t update_normals(const std::vector<Point>& before, Mesh_file& file)
{
  const bool has_any = file.has_normals() || file.face_columns.has_normals();
  if(!has_any || before == file.points)
    return 0;
  const double factor = inverse_unit(before, file.polygons); // one for both, as equal normals shall be found
  const std::vector<Vector> faces[2] = {face_normals(before, file.polygons, factor),
                                        face_normals(file.points, file.polygons, factor)};
  std::size_t changed = 0;
  if(file.vertex_columns.has_normals())
    changed += update_shared(before, faces, file.polygons.corners, file.polygons, file.vertex_columns);
  if(file.normal_columns.has_normals())
  {
    std::vector<int> of_corner = file.corner_normals;
    of_corner.resize(file.polygons.corners.size(), -1);
    changed += update_shared(before, faces, std::move(of_corner), file.polygons, file.normal_columns);
  }
  if(file.face_columns.has_normals())
    changed += set_normals(faces[0], faces[1], file.face_columns);
  return changed;
}
