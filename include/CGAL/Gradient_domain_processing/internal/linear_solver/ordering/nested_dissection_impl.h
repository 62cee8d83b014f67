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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_ORDERING_NESTED_DISSECTION_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_ORDERING_NESTED_DISSECTION_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/linear_solver/ordering/nested_dissection.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/ordering/nested_dissection_leaf.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/ordering/nested_dissection_separator.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_blocks.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <thread>
#include <utility>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// A fill-reducing order: a few vertices, the separator, part a domain in two; they are eliminated after both halves,
// which are ordered in the same way. A plane, the best of a few, says where to cut; a maximum flow in a band around it
// says how. The graph may be any; the points only help to cut it well.
class Nested_dissection
{
public:
  Nested_dissection(const std::vector<Eigen::Vector3d>& points, const std::vector<int>& offsets,
                    const std::vector<int>& neighbors)
    : m_points(points), m_offsets(offsets), m_neighbors(neighbors), m_order(points.size()), m_domain(points.size(), 0),
      m_slab(points.size()), m_slot(points.size(), outside)
  {}

  // In parallel, both halves of a large domain are ordered at the same time. They share no edge, and all that is
  // written belongs to a vertex: the result does not depend on it. `go_on` is asked by the calling thread; where it
  // answers false, the order is empty.
  std::vector<int> compute(bool parallel, const std::function<bool()>& go_on)
  {
    m_parallel = parallel;
    m_ask = go_on ? &go_on : nullptr;
    m_caller = std::this_thread::get_id();
    std::iota(m_order.begin(), m_order.end(), 0);
    Workspace workspace;
    dissect(put_hubs_last(), workspace);
    if(m_is_cancelled) m_order.clear();
    return std::move(m_order);
  }

private:
  using Side = Minimum_vertex_separator::Side;

  // A range of m_order.
  struct Domain
  {
    int begin, end;
    int size() const { return end - begin; }
  };

  // Slabs are numbered along a direction; the left half are those below `slab`.
  struct Cut
  {
    double cost;
    int slab;
  };

  struct Scatter
  {
    Eigen::Vector3d mean;
    Eigen::Matrix3d covariance;
  };

  static constexpr int number_of_slabs = 256;
  static constexpr int outside = -1;
  static constexpr int separated = -1;

  struct Workspace
  {
    Minimum_vertex_separator separator;
    Leaf_elimination leaf;
    std::vector<int> queue, right, between;
    std::array<int, number_of_slabs + 1> population, crossing;
  };

  void dissect(Domain domain, Workspace& workspace)
  {
    if(domain.size() <= Leaf_elimination::max_number_of_interior_vertices) {
      if(goes_on(domain.size())) order_leaf(domain, workspace);
      return;
    }
    choose_sides(domain, workspace);
    if(m_is_cancelled) return;
    const std::pair<Domain, Domain> halves = partition(domain, workspace);
    // nearly complete: no order is better
    if((std::max)(halves.first.size(), halves.second.size()) == domain.size()) return;

    constexpr int worth_a_task = 5000;
    if(!m_parallel || domain.size() < worth_a_task) {
      dissect(halves.first, workspace);
      dissect(halves.second, workspace);
      return;
    }
    for_each_block(true, 2, 1, [&](std::size_t half, std::size_t) {
      Workspace own;
      dissect(half == 0 ? halves.first : halves.second, own);
    });
  }

  // To be asked before so many vertices are looked at; whether to go on with it.
  bool goes_on(int work)
  {
    constexpr int worth_a_question = 20000;
    if(m_is_cancelled) return false;
    if(!m_ask || m_caller != std::this_thread::get_id() || (m_work += work) < worth_a_question) return true;
    m_work = 0;
    if(!(*m_ask)()) m_is_cancelled = true;
    return !m_is_cancelled;
  }

  // body(v) for the vertices of a domain, or every `stride`-th, while it goes on.
  template <typename Body>
  void for_each_vertex(Domain domain, int stride, const Body& body)
  {
    constexpr int size_of_block = 10000;
    for(int i = domain.begin; i < domain.end && goes_on((std::min)(size_of_block, domain.end - i)); )
      for(int k = 0; k < size_of_block && i < domain.end; ++k, i += stride) body(m_order[i]);
  }

  // A vertex with very many neighbors spoils every cut.
  Domain put_hubs_last()
  {
    const double many = 100 + 10 * std::sqrt(double(m_order.size()));
    const auto is_hub = [&](int v) { return m_offsets[v + 1] - m_offsets[v] > many; };
    const auto hubs = std::stable_partition(m_order.begin(), m_order.end(), [&](int v) { return !is_hub(v); });
    for(auto hub = hubs; hub != m_order.end(); ++hub) m_domain[*hub] = separated;
    return { 0, int(hubs - m_order.begin()) };
  }

  bool is_inside(int v, Domain domain) const { return m_domain[v] == domain.begin; }

  template <typename Visitor>
  void for_each_neighbor(int v, Domain domain, const Visitor& visit) const
  {
    for(int j = m_offsets[v]; j < m_offsets[v + 1]; ++j)
      if(is_inside(m_neighbors[j], domain)) visit(m_neighbors[j]);
  }

  void choose_sides(Domain domain, Workspace& workspace)
  {
    const Cut cut = find_cut(domain, workspace);
    if(!m_is_cancelled) collect_band(domain, cut, workspace);
    if(!m_is_cancelled) separate_band(domain, cut, workspace);
  }

  // Leaves the slabs of the best direction in m_slab.
  Cut find_cut(Domain domain, Workspace& workspace)
  {
    const Scatter scatter = compute_scatter(domain);
    const std::vector<Eigen::Vector3d> directions = candidate_directions(domain, scatter);
    Cut best = no_cut();
    std::size_t best_direction = 0;
    for(std::size_t k = 0; k < directions.size(); ++k) {
      assign_slabs(domain, scatter, directions[k]);
      const Cut cut = sweep(domain, workspace);
      if(cut.cost >= best.cost) continue;
      best = cut;
      best_direction = k;
    }
    if(m_is_cancelled) return best;
    if(best.cost > usual_cost(domain)) {  // the points say little about the graph
      assign_slabs_breadth_first(domain, workspace);
      const Cut cut = sweep(domain, workspace);
      if(cut.cost <= best.cost) return cut;
      assign_slabs(domain, scatter, directions[best_direction]);
    } else if(best_direction + 1 < directions.size()) {
      assign_slabs(domain, scatter, directions[best_direction]);
    }
    return best;
  }

  static double usual_cost(Domain domain) { return 6 * std::sqrt(double(domain.size())); }

  static Cut no_cut() { return { std::numeric_limits<double>::infinity(), number_of_slabs / 2 }; }

  Scatter compute_scatter(Domain domain)
  {
    // Sums relative to a point of the domain lose no digits.
    const Eigen::Vector3d origin = m_points[m_order[domain.begin]];
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for_each_vertex(domain, 1, [&](int v) {
      const Eigen::Vector3d d = m_points[v] - origin;
      mean += d;
      covariance.noalias() += d * d.transpose();
    });
    mean /= domain.size();
    covariance = covariance / domain.size() - mean * mean.transpose();
    return { mean + origin, covariance };
  }

  // The principal axis, and for domains large enough to repay it the second one and the two diagonals between them.
  static std::vector<Eigen::Vector3d> candidate_directions(Domain domain, const Scatter& scatter)
  {
    constexpr int worth_a_choice = 2000;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter.covariance);
    const Eigen::Vector3d first = solver.eigenvectors().col(2), second = solver.eigenvectors().col(1);
    if(domain.size() < worth_a_choice) return { first };
    return { (first + second).normalized(), (first - second).normalized(), second, first };
  }

  void assign_slabs(Domain domain, const Scatter& scatter, const Eigen::Vector3d& direction)
  {
    // In any distribution, all balanced cuts are this close to the mean.
    constexpr double reach = 1.4;
    const double deviation = std::sqrt((std::max)(0., direction.dot(scatter.covariance * direction)));
    const double scale = deviation > 0 ? number_of_slabs / (2 * reach * deviation) : 0.;
    for_each_vertex(domain, 1, [&](int v) {
      const double t = (m_points[v] - scatter.mean).dot(direction) * scale + number_of_slabs / 2;
      m_slab[v] = int((std::min)((std::max)(t, 0.), number_of_slabs - 1.));
    });
  }

  // Slabs of equal size in the order of a search that starts far from the middle.
  void assign_slabs_breadth_first(Domain domain, Workspace& workspace)
  {
    search_breadth_first(domain, m_order[domain.begin], workspace.queue);
    search_breadth_first(domain, workspace.queue.back(), workspace.queue);
    for(std::size_t k = 0; k < workspace.queue.size(); ++k)
      m_slab[workspace.queue[k]] = int(k * number_of_slabs / workspace.queue.size());
  }

  void search_breadth_first(Domain domain, int start, std::vector<int>& queue)
  {
    queue.clear();
    const auto reach = [&](int v) {
      if(m_slot[v] != outside) return;
      m_slot[v] = int(queue.size());
      queue.push_back(v);
    };
    std::size_t head = 0;
    const auto spread_from = [&](int seed) {
      for(reach(seed); head < queue.size() && (head % 10000 != 0 || goes_on(10000)); ++head)
        for_each_neighbor(queue[head], domain, reach);
    };
    spread_from(start);
    for(int i = domain.begin; i < domain.end; ++i) spread_from(m_order[i]);
    for(int v : queue) m_slot[v] = outside;
  }

  // Counts, for the cut below each slab, the vertices left of it with a neighbor right of it: all cuts in one pass.
  Cut sweep(Domain domain, Workspace& workspace)
  {
    auto& population = workspace.population;
    auto& crossing = workspace.crossing;
    population.fill(0);
    crossing.fill(0);
    const int stride = sweep_stride(domain);
    int total = 0;
    for_each_vertex(domain, stride, [&](int v) {
      int highest = m_slab[v];
      for_each_neighbor(v, domain, [&](int u) { highest = (std::max)(highest, m_slab[u]); });
      ++total;
      ++population[m_slab[v] + 1];
      ++crossing[m_slab[v] + 1];
      --crossing[highest + 1];
    });
    Cut cut = cheapest_cut(population, crossing, total);
    cut.cost *= stride;
    return cut;
  }

  // A sample is enough: of a separator of about sqrt(n) vertices it sees some fifty.
  static int sweep_stride(Domain domain) { return (std::max)(1, int(std::sqrt(double(domain.size())) / 50)); }

  template <typename Counts>
  static Cut cheapest_cut(const Counts& population, const Counts& crossing, int total)
  {
    constexpr double max_imbalance = 0.25;
    constexpr double price_of_imbalance = 4;
    Cut best = no_cut();
    int below = 0, separating = 0;
    for(int slab = 1; slab < number_of_slabs; ++slab) {
      below += population[slab];
      separating += crossing[slab];
      const double imbalance = double(below) / total - 0.5;
      if(std::abs(imbalance) > max_imbalance) continue;
      const double cost = separating * (1 + price_of_imbalance * imbalance * imbalance);
      if(cost < best.cost) best = { cost, slab };
    }
    return best;
  }

  // The band: all vertices with a neighbor across the cut, and as many layers around them as there is room for.
  void collect_band(Domain domain, Cut cut, Workspace& workspace)
  {
    std::vector<int>& band = workspace.queue;
    const auto is_left = [&](int v) { return m_slab[v] < cut.slab; };
    const auto add = [&](int v) {
      m_slot[v] = int(band.size());
      band.push_back(v);
    };
    band.clear();
    int number_of_left = 0;
    for_each_vertex(domain, 1, [&](int v) {
      number_of_left += is_left(v);
      bool crosses = false;
      for_each_neighbor(v, domain, [&](int u) { crosses |= is_left(u) != is_left(v); });
      if(crosses) add(v);
    });

    int room[2] = { room_in_band(domain, domain.size() - number_of_left), room_in_band(domain, number_of_left) };
    for(int v : band) --room[is_left(v)];
    for(std::size_t head = 0; head < band.size(); ++head)
      for_each_neighbor(band[head], domain, [&](int u) {
        if(m_slot[u] == outside && room[is_left(u)]-- > 0) add(u);
      });
  }

  // A wide band gives the separator freedom; it must leave most of the side alone, for balance and for speed.
  static int room_in_band(Domain domain, int size_of_side)
  {
    constexpr double layers = 10, part_of_side = 0.15;
    return int((std::min)(layers * std::sqrt(double(domain.size())), part_of_side * size_of_side));
  }

  // From here on, slabs tell the sides.
  void separate_band(Domain domain, Cut cut, Workspace& workspace)
  {
    Minimum_vertex_separator& separator = workspace.separator;
    separator.clear();
    for(int v : workspace.queue) {
      bool touches_left = false, touches_right = false;
      for_each_neighbor(v, domain, [&](int u) {
        if(m_slot[u] != outside) separator.add_neighbor(m_slot[u]);
        else (m_slab[u] < cut.slab ? touches_left : touches_right) = true;
      });
      separator.close_vertex(touches_left, touches_right);
    }
    separator.compute();

    for_each_vertex(domain, 1, [&](int v) {
      if(m_slot[v] != outside) m_slab[v] = int(separator.side(m_slot[v]));
      else m_slab[v] = int(m_slab[v] < cut.slab ? Side::source : Side::sink);
      m_slot[v] = outside;
    });
  }

  // Left, right, separator: each in the order it had, which keeps it local in memory.
  std::pair<Domain, Domain> partition(Domain domain, Workspace& workspace)
  {
    workspace.right.clear();
    workspace.between.clear();
    int end = domain.begin;
    for(int i = domain.begin; i < domain.end; ++i) {
      const int v = m_order[i];
      switch(Side(m_slab[v])) {
        case Side::source: m_order[end++] = v; break;
        case Side::sink: workspace.right.push_back(v); break;
        case Side::separator: workspace.between.push_back(v); break;
      }
    }
    const Domain left{ domain.begin, end }, right{ end, end + int(workspace.right.size()) };
    std::copy(workspace.right.begin(), workspace.right.end(), m_order.begin() + right.begin);
    std::copy(workspace.between.begin(), workspace.between.end(), m_order.begin() + right.end);
    for(int v : workspace.right) m_domain[v] = right.begin;
    for(int v : workspace.between) m_domain[v] = separated;
    return { left, right };
  }

  void order_leaf(Domain domain, Workspace& workspace)
  {
    std::vector<int>& interior = workspace.queue;
    std::vector<int>& boundary = workspace.between;
    interior.assign(m_order.begin() + domain.begin, m_order.begin() + domain.end);
    boundary.clear();
    for(int k = 0; k < domain.size(); ++k) m_slot[interior[k]] = k;

    const std::size_t room = std::size_t(Leaf_elimination::max_number_of_vertices - domain.size());
    workspace.leaf.reset(domain.size());
    for(int k = 0; k < domain.size(); ++k)
      for(int j = m_offsets[interior[k]]; j < m_offsets[interior[k] + 1]; ++j) {
        const int u = m_neighbors[j];
        if(is_inside(u, domain)) {
          workspace.leaf.connect(k, m_slot[u]);
          continue;
        }
        const std::size_t place = std::size_t(std::find(boundary.begin(), boundary.end(), u) - boundary.begin());
        if(place < room) {
          if(place == boundary.size()) boundary.push_back(u);
          workspace.leaf.connect(k, domain.size() + int(place));
        }
      }

    int end = domain.begin;
    for(int k : workspace.leaf.compute()) m_order[end++] = interior[k];
  }

  const std::vector<Eigen::Vector3d>& m_points;
  const std::vector<int>& m_offsets;
  const std::vector<int>& m_neighbors;

  std::vector<int> m_order;
  std::vector<int> m_domain;  // by vertex: where the range of its domain begins, or `separated`
  std::vector<int> m_slab;    // by vertex: place along the direction of the cut, then side
  std::vector<int> m_slot;    // by vertex: place in the band or leaf at work, or `outside`

  bool m_parallel = false;
  const std::function<bool()>* m_ask = nullptr;
  std::thread::id m_caller;
  int m_work = 0;  // of the caller since it last asked
  std::atomic<bool> m_is_cancelled{ false };
};

CGAL_GDP_INLINE std::vector<int> nested_dissection(const std::vector<Eigen::Vector3d>& points,
                                                   const std::vector<int>& offsets, const std::vector<int>& neighbors,
                                                   bool parallel, const std::function<bool()>& go_on)
{
  return Nested_dissection(points, offsets, neighbors).compute(parallel, go_on);
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_ORDERING_NESTED_DISSECTION_IMPL_H
