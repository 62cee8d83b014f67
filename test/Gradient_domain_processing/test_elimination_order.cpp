// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The order in which degrees of freedom are eliminated: elimination tree, postorder and fill, against elimination by the book.

#include "test_shapes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/internal/linear_solver/ordering/elimination_order.h>

#include <algorithm>
#include <iostream>
#include <set>
#include <vector>

using namespace gdp_test;
namespace internal = CGAL::Gradient_domain_processing::internal;

typedef std::vector<std::set<int> > Graph;

std::vector<int> places(const std::vector<int>& order, std::size_t number_of_vertices)
{
  std::vector<int> place(number_of_vertices, -1);
  for(std::size_t j = 0; j < order.size(); ++j)
    place[order[j]] = int(j);
  return place;
}

// Columns of the Cholesky factor below the diagonal, without cancellation: eliminating a vertex connects all its later neighbors.
Graph eliminated(const Graph& graph, const std::vector<int>& order)
{
  const int n = int(order.size());
  const std::vector<int> place = places(order, graph.size());
  Graph factor(n);
  for(int j = 0; j < n; ++j)
    for(int w : graph[order[j]])
      if(place[w] > j)
        factor[j].insert(place[w]);
  for(int j = 0; j < n; ++j)
    for(int i : factor[j])
      factor[*factor[j].begin()].insert(factor[j].upper_bound(i), factor[j].end());
  return factor;
}

std::size_t entries(const Graph& factor)
{
  std::size_t sum = 0;
  for(const auto& column : factor)
    sum += column.size();
  return sum;
}

std::vector<int> tree_of(const Graph& graph, const std::vector<int>& order)
{
  const std::vector<int> place = places(order, graph.size());
  return internal::elimination_tree(int(order.size()), [&](int j, const auto& visit) {
    for(int w : graph[order[j]])
      if(place[w] >= 0 && place[w] < j)
        visit(place[w]);
  });
}

// every node comes right after the nodes below it
bool is_postorder(const std::vector<int>& parent)
{
  std::vector<int> size(parent.size(), 1);
  for(int j = 0; j < int(parent.size()); ++j)
  {
    const int first = j - size[j] + 1; // where the nodes below j have to begin
    for(int k = first; k < j; ++k)
      if(parent[k] < 0 || parent[k] > j)
        return false;
    if(parent[j] >= 0)
      size[parent[j]] += size[j];
  }
  return true;
}

void test_random_graphs()
{
  Random random(7);
  for(int round = 0; round < 60; ++round)
  {
    const int n = 1 + random.below(40), edges = random.below(3 * n);
    Graph graph(n);
    for(int e = 0; e < edges; ++e)
    {
      const int v = random.below(n), w = random.below(n);
      if(v != w)
      {
        graph[v].insert(w);
        graph[w].insert(v);
      }
    }
    std::vector<int> order(n);
    for(int j = 0; j < n; ++j)
      order[j] = j;
    for(int j = n - 1; j > 0; --j)
      std::swap(order[j], order[random.below(j + 1)]);

    const Graph factor = eliminated(graph, order);
    const std::vector<int> parent = tree_of(graph, order);
    for(int j = 0; j < n; ++j)
      GDP_CHECK(parent[j] == (factor[j].empty() ? -1 : *factor[j].begin()));

    std::vector<int> better;
    for(int j : internal::postorder(parent))
      better.push_back(order[j]);
    GDP_CHECK(std::is_permutation(better.begin(), better.end(), order.begin(), order.end()));
    GDP_CHECK(entries(eliminated(graph, better)) == entries(factor));
    GDP_CHECK(is_postorder(tree_of(graph, better)));
  }
}

void test_mesh()
{
  const Mesh mesh = mesh_of(sphere(24));
  std::vector<internal::Vec3> points;
  internal::Lists rings;
  Graph graph(mesh.number_of_vertices());
  rings.offsets.push_back(0);
  for(Vertex v : mesh.vertices())
  {
    points.push_back(vec(mesh.point(v)));
    for(Vertex w : mesh.vertices_around_target(mesh.halfedge(v)))
    {
      rings.items.push_back(int(w));
      graph[v].insert(int(w));
    }
    rings.offsets.push_back(int(rings.items.size()));
  }
  std::vector<char> is_solved_for;
  for(std::size_t v = 0; v < points.size(); ++v)
    is_solved_for.push_back(v % 7 != 0);
  for(bool parallel : {false, true})
  {
    const internal::Degrees_of_freedom ordered = internal::elimination_order(points, rings, is_solved_for, parallel);
    int number = 0;
    for(Vertex v : mesh.vertices())
    {
      number += is_solved_for[v];
      GDP_CHECK(is_solved_for[v] ? ordered.vertex[ordered.of_vertex[v]] == int(v) : ordered.of_vertex[v] == -1);
    }
    GDP_CHECK(ordered.size() == number);
    GDP_CHECK(is_postorder(tree_of(graph, ordered.vertex)));
    std::vector<int> as_numbered = ordered.vertex;
    std::sort(as_numbered.begin(), as_numbered.end());
    const std::size_t fill = entries(eliminated(graph, ordered.vertex)), without = entries(eliminated(graph, as_numbered));
    std::cout << number << " degrees of freedom, " << fill << " entries of the factor; " << without << " in the order of the mesh" << std::endl;
    GDP_CHECK(2 * fill < without);
  }
}

int main()
{
  test_random_graphs();
  test_mesh();
  return GDP_TEST_RESULT();
}
