// Copyright (c) 2026  The Gradient_domain_processing authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Gradient_domain_processing authors

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_ORDERING_NESTED_DISSECTION_SEPARATOR_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_ORDERING_NESTED_DISSECTION_SEPARATOR_H

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The fewest vertices of a small graph, the band, that part a source from a sink.
// By Menger's theorem they are as many as there are vertex-disjoint paths from one to the other. The paths are grown by
// depth-first search through the residual graph. A vertex has two states there, entered and left, and is on one path at
// most: storing the two neighbors along the path is storing the flow.
class Minimum_vertex_separator
{
public:
  enum class Side : char { source, separator, sink };

  // A band is filled vertex by vertex: the neighbors of one, then close_vertex().
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
    prefer_short_ways();
    m_previous.assign(size(), none);
    m_next.assign(size(), none);
    m_seen.assign(2 * std::size_t(size()), false);
    for(int v = 0; v < size(); ++v)
      if(m_touches_source[v] && !m_seen[entered(v)])
        grow_path(v);
  }

  // Of all smallest separators, compute() finds the one closest to the source.
  Side side(int v) const
  {
    if(m_seen[left(v)]) return Side::source;
    return m_seen[entered(v)] || m_touches_source[v] ? Side::separator : Side::sink;
  }

private:
  struct Step { int state, arc; };

  static constexpr int none = -1;
  static constexpr int terminal = -2;

  int size() const { return int(m_offsets.size()) - 1; }
  static int entered(int v) { return 2 * v; }
  static int left(int v) { return 2 * v + 1; }
  static int vertex(int state) { return state / 2; }
  static bool is_left(int state) { return state % 2 != 0; }

  // Sorts all neighbors by their distance from the sink, so that the search rarely goes astray.
  void prefer_short_ways()
  {
    m_distance.assign(size(), size());
    m_queue.clear();
    for(int v = 0; v < size(); ++v)
      if(m_touches_sink[v]) {
        m_distance[v] = 0;
        m_queue.push_back(v);
      }
    for(std::size_t head = 0; head < m_queue.size(); ++head) {
      const int v = m_queue[head];
      for(int i = m_offsets[v]; i < m_offsets[v + 1]; ++i) {
        const int w = m_neighbors[i];
        if(m_distance[w] < size()) continue;
        m_distance[w] = m_distance[v] + 1;
        m_queue.push_back(w);
      }
    }
    const auto is_closer = [this](int v, int w) { return m_distance[v] < m_distance[w]; };
    for(int v = 0; v < size(); ++v)
      std::sort(m_neighbors.begin() + m_offsets[v], m_neighbors.begin() + m_offsets[v + 1], is_closer);
  }

  // The next state to try after the last of the path, along an arc of the residual graph; `none` if there is no more.
  int advance(Step& last) const
  {
    const int v = vertex(last.state);
    if(!is_left(last.state)) return last.arc++ == 0 ? unseen(after_entering(v)) : none;
    const int degree = m_offsets[v + 1] - m_offsets[v];
    while(last.arc < degree) {
      const int w = m_neighbors[m_offsets[v] + last.arc++];
      if(w != m_next[v] && !m_seen[entered(w)]) return entered(w);
    }
    return last.arc++ == degree && is_on_path(v) ? unseen(entered(v)) : none;
  }

  bool is_on_path(int v) const { return m_next[v] != none; }
  int unseen(int state) const { return state != none && !m_seen[state] ? state : none; }

  // One who enters a vertex in use takes over the rest of its path; the vertex before must leave for elsewhere.
  int after_entering(int v) const
  {
    if(!is_on_path(v)) return left(v);
    return m_previous[v] != terminal ? left(m_previous[v]) : none;
  }

  // What a failed search has seen will never lead to the sink and stays marked; this is also what makes up the source's
  // side of the separator.
  void grow_path(int start)
  {
    m_path.clear();
    m_visited.clear();
    visit(entered(start));
    while(!m_path.empty()) {
      Step& last = m_path.back();
      if(is_left(last.state) && m_touches_sink[vertex(last.state)]) {
        augment();
        for(int state : m_visited) m_seen[state] = false;
        return;
      }
      const int next = advance(last);
      if(next != none) visit(next);
      else m_path.pop_back();
    }
  }

  void visit(int state)
  {
    m_seen[state] = true;
    m_visited.push_back(state);
    m_path.push_back({ state, 0 });
  }

  void augment()
  {
    m_previous[vertex(m_path.front().state)] = terminal;
    for(std::size_t i = 1; i < m_path.size(); ++i) {
      const int from = m_path[i - 1].state, to = m_path[i].state;
      const int v = vertex(from), w = vertex(to);
      if(!is_left(from)) continue;
      if(v == w) {
        m_previous[v] = m_next[v] = none;
      } else {
        m_next[v] = w;
        m_previous[w] = v;
      }
    }
    m_next[vertex(m_path.back().state)] = terminal;
  }

  std::vector<int> m_offsets, m_neighbors;
  std::vector<char> m_touches_source, m_touches_sink;

  std::vector<int> m_previous, m_next;  // along the path through a vertex
  std::vector<char> m_seen;             // by state
  std::vector<int> m_distance, m_queue, m_visited;
  std::vector<Step> m_path;
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_ORDERING_NESTED_DISSECTION_SEPARATOR_H
