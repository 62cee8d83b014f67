// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The order in which degrees of freedom are eliminated: elimination tree, postorder and fill, against elimination by
// the book.

#include "test_shapes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/internal/linear_solver/ordering/elimination_order.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/ordering/nested_dissection_separator.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <set>
#include <string>
#include <thread>
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

// Columns of the Cholesky factor below the diagonal, without cancellation: eliminating a vertex connects all its later
// neighbors.
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

// A mesh as points and adjacency.
struct Points_and_graph
{
  std::vector<internal::Vec3> points;
  internal::Lists rings;
  Graph graph;

  explicit Points_and_graph(const Shape& shape)
    : points(shape.points.begin(), shape.points.end())
    , graph(shape.points.size())
  {
    for(const auto& t : shape.triangles)
      for(int i = 0; i < 3; ++i)
      {
        graph[t[i]].insert(t[(i + 1) % 3]);
        graph[t[(i + 1) % 3]].insert(t[i]);
      }
    rings.offsets.push_back(0);
    for(const std::set<int>& neighbors : graph)
    {
      rings.items.insert(rings.items.end(), neighbors.begin(), neighbors.end());
      rings.offsets.push_back(int(rings.items.size()));
    }
  }

  internal::Degrees_of_freedom order(bool parallel) const
  {
    return internal::elimination_order(points, rings, std::vector<char>(points.size(), 1), parallel);
  }
};

void test_numbering()
{
  const Points_and_graph mesh(sphere(24));
  std::vector<char> is_solved_for;
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
    is_solved_for.push_back(v % 7 != 0);
  const int number = int(std::count(is_solved_for.begin(), is_solved_for.end(), 1));
  const auto check = [&](const internal::Degrees_of_freedom& numbered) {
    GDP_CHECK(numbered.size() == number && numbered.of_vertex.size() == mesh.points.size());
    for(int v = 0; v < int(mesh.points.size()); ++v)
      GDP_CHECK(is_solved_for[v] ? numbered.vertex[numbered.of_vertex[v]] == v : numbered.of_vertex[v] == -1);
  };
  const internal::Degrees_of_freedom in_memory = internal::numbered_in_memory_order(is_solved_for);
  check(in_memory);
  GDP_CHECK(std::is_sorted(in_memory.vertex.begin(), in_memory.vertex.end()));
  for(bool parallel : {false, true})
  {
    const internal::Degrees_of_freedom ordered =
      internal::elimination_order(mesh.points, mesh.rings, is_solved_for, parallel);
    check(ordered);
    GDP_CHECK(is_postorder(tree_of(mesh.graph, ordered.vertex)));
    std::vector<int> visited;
    internal::for_each_degree_of_freedom(false, ordered, [&](int v, int i) {
      GDP_CHECK(ordered.vertex[i] == v);
      visited.push_back(v);
    });
    GDP_CHECK(visited == in_memory.vertex);
  }
}

// Teeth that are long and narrow: the points say little about the graph.
Shape comb(Shape shape)
{
  const auto is_gap = [&](const std::array<int, 3>& t) {
    const Vec center = (shape.points[t[0]] + shape.points[t[1]] + shape.points[t[2]]) / 3;
    return center[1] > 0.1 && int(center[0] * 20) % 2 == 1;
  };
  const auto end = std::remove_if(shape.triangles.begin(), shape.triangles.end(), is_gap);
  shape.triangles.erase(end, shape.triangles.end());
  return shape;
}

// Entries of the factor on meshes of several kinds against bounds that leave two per cent: without the maximum flow,
// without a choice of directions, or with leaves ordered as they come, they are exceeded.
void test_fill()
{
  const auto torus = [](double u, double v) {
    return Vec((3 + std::cos(2 * pi * v)) * std::cos(2 * pi * u), (3 + std::cos(2 * pi * v)) * std::sin(2 * pi * u),
               std::sin(2 * pi * v));
  };
  const auto check = [](const char* name, const Shape& shape, std::size_t bound) {
    const Points_and_graph mesh(shape);
    const internal::Degrees_of_freedom ordered = mesh.order(true);
    GDP_CHECK(ordered.vertex == mesh.order(false).vertex);
    const std::size_t fill = entries(eliminated(mesh.graph, ordered.vertex));
    std::cout << name << ": " << mesh.points.size() << " vertices, " << fill << " entries, " << bound << " allowed"
              << std::endl;
    GDP_CHECK(fill <= bound);
    return fill;
  };
  // Where no direction is as good as another, the numbers are known, and a change of them shall be meant.
  const auto knows = [&](const char* name, const Shape& shape, std::size_t known) {
    GDP_CHECK_NEAR(double(check(name, shape, known + known / 500)), double(known), double(known) / 500);
  };
  const Shape plate = jittered_square(70).mapped([](const Vec& p) { return Vec(p[0], 0.6 * p[1], 0); });
  knows("plate", plate, 100878);
  knows("plates", plate + jittered_square(30).moved(Vec(2, 0, 0)), 107227);
  knows("potato", ellipsoid(36, Vec(3, 2, 1)).noisy(0.2 / 36), 181204);
  knows("comb", comb(jittered_square(70)), 20737);
  check("square", square(80), 130000);
  check("jittered square", jittered_square(80), 127300);
  check("sphere", sphere(40), 209000);
  check("ellipsoid", ellipsoid(40, Vec(5, 1, 1)), 262500);
  check("torus", grid(120, 50, torus, true, true), 166300);
  check("disk", disk(100, 60), 190000);
}

// A smallest separator of a small graph by trying all sets of vertices.
std::size_t smallest_separator(const Graph& graph, const std::vector<char>& touches_source,
                               const std::vector<char>& touches_sink)
{
  const int n = int(graph.size());
  std::size_t smallest = graph.size();
  for(int set = 0; set < 1 << n; ++set)
  {
    std::vector<int> reached;
    std::vector<char> is_seen(n, 0);
    std::size_t size = 0;
    bool separates = true;
    for(int v = 0; v < n; ++v)
    {
      is_seen[v] = char(set >> v & 1);
      size += is_seen[v];
    }
    const auto reach = [&](int v) {
      if(!is_seen[v])
        reached.push_back(v);
      is_seen[v] = 1;
    };
    for(int v = 0; v < n; ++v)
      if(touches_source[v])
        reach(v);
    for(std::size_t head = 0; head < reached.size(); ++head)
    {
      separates = separates && !touches_sink[reached[head]];
      for(int w : graph[reached[head]])
        reach(w);
    }
    if(separates)
      smallest = (std::min)(smallest, size);
  }
  return smallest;
}

typedef internal::Minimum_vertex_separator Separator;

// Returns its size; what it leaves of the source's side touches neither the sink nor its side.
std::size_t separated(const Graph& graph, const std::vector<char>& touches_source,
                      const std::vector<char>& touches_sink)
{
  Separator separator;
  separator.clear();
  for(std::size_t v = 0; v < graph.size(); ++v)
  {
    for(int w : graph[v])
      separator.add_neighbor(w);
    separator.close_vertex(touches_source[v], touches_sink[v]);
  }
  separator.compute();
  std::size_t size = 0;
  for(int v = 0; v < int(graph.size()); ++v)
  {
    const Separator::Side side = separator.side(v);
    size += side == Separator::Side::separator;
    GDP_CHECK(side != Separator::Side::source || !touches_sink[v]);
    GDP_CHECK(side != Separator::Side::sink || !touches_source[v]);
    for(int w : graph[v])
      GDP_CHECK(side != Separator::Side::source || separator.side(w) != Separator::Side::sink);
  }
  return size;
}

void test_separators()
{
  Random random(11);
  for(int round = 0; round < 300; ++round)
  {
    const int n = 2 + int(random.below(8)), edges = int(random.below(3 * n));
    Graph graph(n);
    for(int e = 0; e < edges; ++e)
    {
      const int v = int(random.below(n)), w = int(random.below(n));
      if(v != w)
      {
        graph[v].insert(w);
        graph[w].insert(v);
      }
    }
    std::vector<char> touches_source(n), touches_sink(n);
    for(int v = 0; v < n; ++v)
    {
      touches_source[v] = random.below(3) == 0;
      touches_sink[v] = random.below(3) == 0;
    }
    GDP_CHECK(separated(graph, touches_source, touches_sink)
              == smallest_separator(graph, touches_source, touches_sink));
  }

  // a cylinder that is narrow in its middle
  const int columns = 31, rows = 20, narrow = 9;
  const auto at = [&](int column, int row) { return column * rows + row % rows; };
  Graph graph(columns * rows);
  std::vector<char> touches_source(graph.size(), 0), touches_sink(graph.size(), 0);
  for(int i = 0; i < columns; ++i)
    for(int j = 0; j < rows; ++j)
    {
      touches_source[at(i, j)] = i == 0;
      touches_sink[at(i, j)] = i == columns - 1;
      const auto connect = [&](int w) {
        graph[at(i, j)].insert(w);
        graph[w].insert(at(i, j));
      };
      connect(at(i, j + 1));
      if(i + 1 < columns && (i != columns / 2 || j < narrow))
        connect(at(i + 1, j));
    }
  GDP_CHECK(separated(graph, touches_source, touches_sink) == narrow);
}

// The number of threads of the process, or 0 where it is not known.
int number_of_threads()
{
  std::ifstream file("/proc/self/status");
  std::string word;
  while(file >> word)
    if(word == "Threads:" && file >> word)
      return std::atoi(word.c_str());
  return 0;
}

// Who asks for one thread gets no other, who cancels gets nothing, and nobody but the caller is asked.
void test_threads_and_cancelling()
{
  const Points_and_graph mesh(sphere(80));
  const int threads = number_of_threads();
  const auto caller = std::this_thread::get_id();
  const std::vector<char> all(mesh.points.size(), 1);
  std::vector<int> expected;
  int number_of_questions = 0;
  const auto count = [&] {
    ++number_of_questions;
    GDP_CHECK(number_of_threads() == threads);
    return true;
  };
  expected = internal::elimination_order(mesh.points, mesh.rings, all, false, count).vertex;
  GDP_CHECK(expected.size() == mesh.points.size());
  const int questions_of_one_thread = number_of_questions;
  GDP_CHECK(questions_of_one_thread > 50);
#ifdef CGAL_LINKED_WITH_TBB
  {
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    GDP_CHECK(internal::elimination_order(mesh.points, mesh.rings, all, true, count).vertex == expected);
  }
#endif
  for(bool parallel : {false, true})
    for(int last = 1; last <= questions_of_one_thread; last += last < 5 ? 1 : 17)
    {
      int questions = 0;
      bool has_answered_no = false;
      const internal::Degrees_of_freedom ordered =
        internal::elimination_order(mesh.points, mesh.rings, all, parallel, [&] {
          GDP_CHECK(std::this_thread::get_id() == caller && !has_answered_no);
          has_answered_no = has_answered_no || ++questions == last;
          return !has_answered_no;
        });
      GDP_CHECK(has_answered_no ? ordered.vertex.empty() : ordered.vertex == expected);
      GDP_CHECK(has_answered_no || parallel); // with help, the caller is asked less
      GDP_CHECK(ordered.of_vertex.size() == mesh.points.size());
    }
}

int main()
{
  test_threads_and_cancelling(); // first: no other threads are there yet
  test_separators();
  test_random_graphs();
  test_numbering();
  test_fill();
  return GDP_TEST_RESULT();
}
