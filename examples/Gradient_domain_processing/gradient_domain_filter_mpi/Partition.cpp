// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Partition.h"
#include "Halo.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace {

typedef Eigen::Vector3d Vec3;
typedef std::uint64_t Key;

constexpr int bits_per_axis = 21;

// The bits of x, two zeros before each.
Key spread_bits(Key x)
{
  x = (x | x << 32) & 0x001F00000000FFFFu;
  x = (x | x << 16) & 0x001F0000FF0000FFu;
  x = (x | x << 8) & 0x100F00F00F00F00Fu;
  x = (x | x << 4) & 0x10C30C30C30C30C3u;
  return (x | x << 2) & 0x1249249249249249u;
}

struct Placed_vertex
{
  Key key;
  Global file_vertex;
  double point[3];
};

// The part of the vertices that stands in the rank's slice of the file.
struct Slice
{
  Global begin = 0;
  std::vector<Vec3> points;
  std::vector<std::vector<double> > columns;
};

Slice read_slice(const Ranks& ranks, const Ply_slices& file, const std::vector<std::string>& properties)
{
  const Ply_slices::Element& vertices = file.vertices();
  Slice slice;
  slice.begin = vertices.slice_begin(ranks.rank(), ranks.size());
  const Global count = vertices.slice_begin(ranks.rank() + 1, ranks.size()) - slice.begin;
  const std::vector<char> bytes = file.read(vertices.first + slice.begin * vertices.stride, count * vertices.stride);
  ranks.together([&] {
    std::vector<Ply_slices::Place> places;
    for(const char* coordinate : {"x", "y", "z"})
      places.push_back(file.place(coordinate));
    for(const std::string& property : properties)
      places.push_back(file.place(property));
    slice.points.resize(std::size_t(count));
    slice.columns.assign(properties.size(), std::vector<double>(std::size_t(count)));
    for(std::size_t v = 0; v < slice.points.size(); ++v)
      for(std::size_t i = 0; i < places.size(); ++i)
      {
        const double x = binary_number(bytes.data() + Global(v) * vertices.stride + places[i].offset, places[i].type,
                                       file.order());
        (i < 3 ? slice.points[v][Eigen::Index(i)] : slice.columns[i - 3][v]) = x;
      }
  });
  return slice;
}

struct Bounds
{
  std::array<double, 3> low, high;
};

void find_box(const Ranks& ranks, const std::vector<Vec3>& points, Partition& partition)
{
  const double infinity = std::numeric_limits<double>::infinity();
  Vec3 low = Vec3::Constant(infinity), high = -low;
  for(const Vec3& p : points)
    if(p.allFinite())
    {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  for(const Bounds& b : ranks.gathered(Bounds{{{low[0], low[1], low[2]}}, {{high[0], high[1], high[2]}}}))
  {
    low = low.cwiseMin(Vec3(b.low.data()));
    high = high.cwiseMax(Vec3(b.high.data()));
  }
  partition.low = low;
  partition.extent = high - low;
}

Key key_of(const Vec3& p, const Partition& partition)
{
  const double extent = partition.extent.maxCoeff();
  if(!p.allFinite() || !(extent > 0))
    return 0;
  Key key = 0;
  for(int i = 0; i < 3; ++i)
  {
    const double cell = (p[i] - partition.low[i]) / extent * double((1 << bits_per_axis) - 1);
    key |= spread_bits(Key(cell)) << i;
  }
  return key;
}

// Keys between which there are about as many vertices for every rank, from a sample of them.
std::vector<Key> splitters(const Ranks& ranks, std::vector<Key> keys)
{
  constexpr int samples_per_rank = 1024;
  std::sort(keys.begin(), keys.end());
  std::vector<Key> mine(samples_per_rank, ~Key(0)); // of ranks without vertices: the last
  for(std::size_t i = 0; i < samples_per_rank && !keys.empty(); ++i)
    mine[i] = keys[(2 * i + 1) * keys.size() / (2 * samples_per_rank)];
  std::vector<Key> all(std::size_t(ranks.size()) * samples_per_rank);
  MPI_Allgather(mine.data(), samples_per_rank, MPI_UINT64_T, all.data(), samples_per_rank, MPI_UINT64_T, ranks.comm());
  all.erase(std::remove(all.begin(), all.end(), ~Key(0)), all.end());
  std::sort(all.begin(), all.end());
  std::vector<Key> result;
  for(std::size_t r = 1; r < std::size_t(ranks.size()); ++r)
    result.push_back(all.empty() ? 0 : all[r * all.size() / std::size_t(ranks.size())]);
  return result;
}

// Moves the vertices of all slices to their owners. What returns are the rows of the vertices in the own slice.
std::vector<Global> distribute(const Ranks& ranks, const Slice& slice, Partition& partition)
{
  std::vector<Placed_vertex> placed(slice.points.size());
  std::vector<Key> keys(placed.size());
  for(std::size_t v = 0; v < placed.size(); ++v)
  {
    const Vec3& p = slice.points[v];
    keys[v] = key_of(p, partition);
    placed[v] = {keys[v], slice.begin + Global(v), {p[0], p[1], p[2]}};
  }
  const std::vector<Key> split = splitters(ranks, keys);
  std::vector<int> targets(placed.size());
  for(std::size_t v = 0; v < placed.size(); ++v)
    targets[v] = int(std::upper_bound(split.begin(), split.end(), keys[v]) - split.begin());

  const Outbox<Placed_vertex> out(ranks, targets, placed);
  std::vector<int> counts;
  const std::vector<Placed_vertex> arrived = ranks.exchange(out.items, out.counts, &counts);
  std::vector<std::size_t> order(arrived.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::make_pair(arrived[a].key, arrived[a].file_vertex)
           < std::make_pair(arrived[b].key, arrived[b].file_vertex);
  });
  partition.first_row = ranks.first_of_ranks(Global(arrived.size()));
  std::vector<Global> rows(arrived.size());
  for(std::size_t i = 0; i < order.size(); ++i)
  {
    const Placed_vertex& v = arrived[order[i]];
    partition.points.emplace_back(v.point[0], v.point[1], v.point[2]);
    partition.file_vertices.push_back(v.file_vertex);
    rows[order[i]] = partition.first_row[std::size_t(ranks.rank())] + Global(i);
  }
  for(const std::vector<double>& column : slice.columns)
  {
    const std::vector<double> values = ranks.exchange(Outbox<double>(ranks, targets, column).items, out.counts);
    partition.columns.emplace_back();
    for(std::size_t i : order)
      partition.columns.back().push_back(values[i]);
  }
  const std::vector<Global> returned = ranks.exchange(rows, counts);
  std::vector<Global> row_of(placed.size());
  for(std::size_t i = 0; i < returned.size(); ++i)
    row_of[out.from[i]] = returned[i];
  return row_of;
}

// The rows of vertices of the file, whatever slices they stand in: the slices are a directory.
std::vector<Global> rows_of(const Ranks& ranks, const Ply_slices& file, const std::vector<Global>& vertices,
                            Global slice_begin, const std::vector<Global>& row_of)
{
  std::vector<int> counts(std::size_t(ranks.size()), 0), asked;
  for(Global v : vertices) // increasing
    ++counts[std::size_t(file.vertices().rank_of(v, ranks.size()))];
  std::vector<Global> questions = ranks.exchange(vertices, counts, &asked);
  for(Global& v : questions)
    v = row_of[std::size_t(v - slice_begin)];
  return ranks.exchange(questions, asked);
}

// Every triangle goes to all who own one of its rows.
std::vector<Row_triangle> send_to_owners(const Ranks& ranks, const std::vector<Row_triangle>& triangles,
                                         const std::vector<Global>& first_row)
{
  std::vector<Row_triangle> copies;
  std::vector<int> targets;
  for(const Row_triangle& t : triangles)
  {
    std::array<int, 3> owners;
    for(std::size_t i = 0; i < 3; ++i)
      owners[i] = owner(first_row, t.rows[i]);
    std::sort(owners.begin(), owners.end());
    for(std::size_t i = 0; i < 3; ++i)
      if(i == 0 || owners[i] != owners[i - 1])
      {
        copies.push_back(t);
        targets.push_back(owners[i]);
      }
  }
  const Outbox<Row_triangle> out(ranks, targets, copies);
  return ranks.exchange(out.items, out.counts);
}

// In parts, so that what is on its way takes little memory.
void read_triangles(const Ranks& ranks, const Ply_slices& file, Global slice_begin, const std::vector<Global>& row_of,
                    Partition& partition)
{
  constexpr Global part = 1 << 20;
  const Global begin = file.faces().slice_begin(ranks.rank(), ranks.size()),
               end = file.faces().slice_begin(ranks.rank() + 1, ranks.size());
  const Global parts = ranks.largest((end - begin + part - 1) / part);
  for(Global k = 0; k < parts; ++k)
  {
    const Global from = (std::min)(end, begin + k * part), to = (std::min)(end, from + part);
    const std::vector<std::array<Global, 3> > corners = file.read_faces(from, to);
    std::vector<Global> vertices;
    for(const auto& t : corners)
      vertices.insert(vertices.end(), t.begin(), t.end());
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    const std::vector<Global> rows = rows_of(ranks, file, vertices, slice_begin, row_of);
    std::vector<Row_triangle> triangles(corners.size());
    for(std::size_t f = 0; f < corners.size(); ++f)
    {
      triangles[f].face = from + Global(f);
      for(std::size_t i = 0; i < 3; ++i)
        triangles[f].rows[i] =
          rows[std::size_t(std::lower_bound(vertices.begin(), vertices.end(), corners[f][i]) - vertices.begin())];
    }
    const std::vector<Row_triangle> arrived = send_to_owners(ranks, triangles, partition.first_row);
    ranks.together(
      [&] { partition.triangles.insert(partition.triangles.end(), arrived.begin(), arrived.end()); });
  }
  std::sort(partition.triangles.begin(), partition.triangles.end(),
            [](const Row_triangle& a, const Row_triangle& b) { return a.face < b.face; });
}

} // namespace

Partition read_partition(const Ranks& ranks, const Ply_slices& file, const std::vector<std::string>& properties)
{
  Partition partition;
  Slice slice = read_slice(ranks, file, properties);
  find_box(ranks, slice.points, partition);
  const std::vector<Global> row_of = distribute(ranks, slice, partition);
  const Global slice_begin = slice.begin;
  slice = Slice();
  read_triangles(ranks, file, slice_begin, row_of, partition);
  return partition;
}
