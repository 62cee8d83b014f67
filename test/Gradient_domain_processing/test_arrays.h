// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_TEST_ARRAYS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_TEST_ARRAYS_H

#include "test_meshes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>
#include <CGAL/Gradient_domain_processing/internal/metric/Triangle_metrics.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <array>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

// Arrays as the functions below a verb take them, from soups.
namespace gdp_test {

namespace GDP = CGAL::Gradient_domain_processing;
typedef GDP::internal::Indexed_triangles Arrays;
typedef GDP::internal::Triangle_metrics Metrics;
typedef Eigen::SparseMatrix<double> Sparse;
typedef Eigen::Vector3d Vec;

inline Arrays arrays_of(const Soup& soup)
{
  Arrays arrays;
  for(const Coordinates& p : soup.points)
    arrays.points.emplace_back(p[0], p[1], p[2]);
  arrays.triangles.assign(soup.triangles.begin(), soup.triangles.end());
  arrays.index_corners();
  std::map<std::pair<int, int>, int> count;
  for(const auto& t : soup.triangles)
    for(int i = 0; i < 3; ++i)
      ++count[{(std::min)(t[i], t[(i + 1) % 3]), (std::max)(t[i], t[(i + 1) % 3])}];
  arrays.is_on_border.assign(soup.points.size(), 0);
  for(const auto& entry : count)
    if(entry.second == 1)
      arrays.is_on_border[entry.first.first] = arrays.is_on_border[entry.first.second] = 1;
  return arrays;
}

inline Soup read_off(const std::string& name)
{
  std::ifstream file("data/" + name + ".off");
  std::string word;
  std::size_t points = 0, triangles = 0, edges = 0;
  file >> word >> points >> triangles >> edges;
  Soup soup;
  soup.points.resize(points);
  soup.triangles.resize(triangles);
  for(Coordinates& p : soup.points)
    file >> p[0] >> p[1] >> p[2];
  for(auto& t : soup.triangles)
    file >> edges >> t[0] >> t[1] >> t[2];
  GDP_CHECK(bool(file) && points > 0);
  return soup;
}

// Values of a function of the points.
template <class Function>
Eigen::VectorXd sampled(const Arrays& arrays, const Function& function)
{
  Eigen::VectorXd values(arrays.number_of_vertices());
  for(int v = 0; v < arrays.number_of_vertices(); ++v)
    values[v] = function(arrays.points[v]);
  return values;
}

// The metric of a tensor in the plane z = 0, taken at the center of every triangle.
template <class Tensor>
Metrics planar_metrics(const Arrays& arrays, const Tensor& tensor)
{
  Metrics metrics;
  for(const auto& t : arrays.triangles)
  {
    const Vec center = (arrays.points[t[0]] + arrays.points[t[1]] + arrays.points[t[2]]) / 3;
    const Eigen::Matrix2d at_center = tensor(center);
    const Eigen::Vector2d t1 = (arrays.points[t[1]] - arrays.points[t[0]]).head<2>(),
                          t2 = (arrays.points[t[2]] - arrays.points[t[0]]).head<2>();
    metrics.given.push_back(
      GDP::Triangle_metric(t1.dot(at_center * t1), t1.dot(at_center * t2), t2.dot(at_center * t2)));
  }
  return metrics;
}

inline double largest(const Sparse& matrix)
{
  double result = 0;
  for(int j = 0; j < matrix.outerSize(); ++j)
    for(Sparse::InnerIterator it(matrix, j); it; ++it)
      result = (std::max)(result, std::isnan(it.value()) ? HUGE_VAL : std::abs(it.value()));
  return result;
}

inline double energy(const Sparse& matrix, const Eigen::VectorXd& values)
{
  return values.dot(matrix * values);
}

} // namespace gdp_test

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_TEST_ARRAYS_H
