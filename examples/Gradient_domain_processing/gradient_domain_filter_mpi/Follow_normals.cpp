// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Follow_normals.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

using CGAL::Gradient_domain_processing::internal::Signal;
using CGAL::Gradient_domain_processing::internal::Vec3;

namespace {

// Of every own row the lowest one of the same place and normal. They all belong to this rank.
std::vector<int> groups(const Mesh_piece& piece, const std::vector<Vec3>& places, const Signal& normals)
{
  std::vector<int> order(std::size_t(piece.rows.owned())), group(order.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](int row) {
    const Vec3& p = places[std::size_t(row)];
    return std::array<double, 6>{{p[0], p[1], p[2], normals(row, 0), normals(row, 1), normals(row, 2)}};
  };
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return std::make_pair(key(a), a) < std::make_pair(key(b), b); });
  for(std::size_t i = 0; i < order.size(); ++i)
    group[std::size_t(order[i])] =
      i > 0 && key(order[i]) == key(order[i - 1]) ? group[std::size_t(order[i - 1])] : order[i];
  return group;
}

std::vector<Vec3> sums(const Mesh_piece& piece, const std::vector<Vec3>& points, const std::vector<int>& group)
{
  std::vector<Vec3> sum(group.size(), Vec3::Zero());
  for(int f = 0; f < piece.mesh.number_of_triangles(); ++f)
    if(piece.is_near[std::size_t(f)])
      for(int row : piece.mesh.rows[std::size_t(f)])
        if(row < piece.rows.owned())
          sum[std::size_t(group[std::size_t(row)])] += piece.mesh.area_vector(f, points);
  return sum;
}

} // namespace

Signal followed_normals(const Ranks& ranks, const Mesh_piece& piece, const std::vector<Vec3>& before,
                        const std::vector<Eigen::Vector3d>& places, const Signal& normals)
{
  const std::vector<int> group = groups(piece, places, normals);
  const std::vector<Vec3> sum_before = sums(piece, before, group), sum_after = sums(piece, piece.mesh.points, group);
  Global agreeing = 0; // normals that look to the side from which faces are seen counter-clockwise, less the others
  for(std::size_t row = 0; row < group.size(); ++row)
  {
    const double product = sum_before[std::size_t(group[row])].dot(normals.row(Eigen::Index(row)).transpose());
    agreeing += product > 0 ? 1 : product < 0 ? -1 : 0;
  }
  const double sign = ranks.sum(agreeing) < 0 ? -1 : 1;
  Signal result = normals;
  for(std::size_t row = 0; row < group.size(); ++row)
  {
    const Vec3 &old_sum = sum_before[std::size_t(group[row])], &new_sum = sum_after[std::size_t(group[row])];
    const double length = new_sum.norm();
    if(old_sum != new_sum && length > 0 && !normals.row(Eigen::Index(row)).isZero(0))
      result.row(Eigen::Index(row)) = sign / length * new_sum.transpose();
  }
  return result;
}
