// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_NESTED_DISSECTION_SEPARATOR_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_NESTED_DISSECTION_SEPARATOR_H

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The fewest vertices of a small graph, the band, that part a source from a sink.
// By Menger's theorem they are as many as there are vertex-disjoint paths from one to the other. The paths are grown as
// in Dinic's algorithm. A vertex has two states, entered and left, and is on one path at most: storing the two
// neighbours along the path is storing the flow.
class Minimum_vertex_separator
{
public:
  enum class Side : char { source, sink, separator };

  // The band is filled vertex by vertex: add_vertex, then its neighbours.
  void clear()
  {
    m_offsets.assign(1, 0);
    m_neighbors.clear();
    m_touches_source.clear();
    m_touches_sink.clear();
  }

  void add_neighbor(int v) { m_neighbors.push_back(v); }

  void close_vertex(bool touches_source, bool touches_sink)
  {
    m_offsets.push_back(int(m_neighbors.size()));
    m_touches_source.push_back(touches_source);
    m_touches_sink.push_back(touches_sink);
  }

  void compute()
  {
    m_previous.assign(size(), none);
    m_next.assign(size(), none);
    while (compute_levels())
      for (int v = 0; v < size(); ++v)
        if (m_touches_source[v] && m_level[entered(v)] == 0)
          grow_path(v);
  }

  // Of all smallest separators, compute() finds the one closest to the source.
  Side side(int v) const
  {
    if (m_level[left(v)] != none) return Side::source;
    return m_level[entered(v)] != none ? Side::separator : Side::sink;
  }

private:
  static constexpr int none = -1;
  static constexpr int terminal = -2;

  int size() const { return int(m_offsets.size()) - 1; }
  static int entered(int v) { return 2 * v; }
  static int left(int v) { return 2 * v + 1; }
  static int vertex(int state) { return state / 2; }
  static bool is_left(int state) { return state % 2 != 0; }

  bool is_on_path(int v) const { return m_next[v] != none; }

  // The i-th state that follows `state` in the residual graph; `none` for an arc that cannot be taken.
  int successor(int state, int i) const
  {
    const int v = vertex(state);
    if (!is_left(state)) {
      if (!is_on_path(v)) return left(v);
      return m_previous[v] >= 0 ? left(m_previous[v]) : none;  // push the old path back
    }
    const int begin = m_offsets[v];
    if (begin + i == m_offsets[v + 1]) return is_on_path(v) ? entered(v) : none;
    const int w = m_neighbors[begin + i];
    return m_next[v] != w ? entered(w) : none;
  }

  int number_of_successors(int state) const
  {
    const int v = vertex(state);
    return is_left(state) ? m_offsets[v + 1] - m_offsets[v] + 1 : 1;
  }

  // Breadth-first search over the residual graph. Says whether the sink was reached.
  bool compute_levels()
  {
    m_level.assign(2 * std::size_t(size()), none);
    m_queue.clear();
    for (int v = 0; v < size(); ++v)
      if (m_touches_source[v]) reach(entered(v), 0);

    int last_level = 2 * size();
    bool sink_reached = false;
    for (std::size_t head = 0; head < m_queue.size(); ++head) {
      const int state = m_queue[head];
      if (m_level[state] > last_level) break;
      if (is_left(state) && m_touches_sink[vertex(state)]) {
        last_level = m_level[state];
        sink_reached = true;
      }
      for (int i = 0, end = number_of_successors(state); i < end; ++i) {
        const int next = successor(state, i);
        if (next != none && m_level[next] == none) reach(next, m_level[state] + 1);
      }
    }
    return sink_reached;
  }

  void reach(int state, int level)
  {
    m_level[state] = level;
    m_queue.push_back(state);
  }

  // Depth-first search along increasing levels. A state carries one path at most, so each is visited once a phase.
  void grow_path(int start)
  {
    m_path.assign(1, { entered(start), 0, m_level[entered(start)] });
    m_level[entered(start)] = visited;
    while (!m_path.empty()) {
      Step& top = m_path.back();
      if (is_left(top.state) && m_touches_sink[vertex(top.state)]) {
        apply_path();
        return;
      }
      if (top.arc == number_of_successors(top.state)) {
        m_path.pop_back();
        continue;
      }
      const int next = successor(top.state, top.arc++);
      if (next == none || m_level[next] != top.level + 1) continue;
      m_level[next] = visited;
      m_path.push_back({ next, 0, top.level + 1 });
    }
  }

  void apply_path()
  {
    m_previous[vertex(m_path.front().state)] = terminal;
    for (std::size_t i = 1; i < m_path.size(); ++i) {
      const int from = m_path[i - 1].state, to = m_path[i].state;
      if (!is_left(from)) continue;
      if (vertex(from) == vertex(to)) {
        m_previous[vertex(to)] = m_next[vertex(to)] = none;
      } else {
        m_next[vertex(from)] = vertex(to);
        m_previous[vertex(to)] = vertex(from);
      }
    }
    m_next[vertex(m_path.back().state)] = terminal;
  }

  static constexpr int visited = -3;

  struct Step { int state, arc, level; };

  std::vector<int> m_offsets, m_neighbors;
  std::vector<char> m_touches_source, m_touches_sink;
  std::vector<int> m_previous, m_next;
  std::vector<int> m_level, m_queue;
  std::vector<Step> m_path;
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_NESTED_DISSECTION_SEPARATOR_H
