// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_NESTED_DISSECTION_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_NESTED_DISSECTION_H

#include <CGAL/Gradient_domain_processing/internal/nested_dissection_leaf.h>
#include <CGAL/Gradient_domain_processing/internal/nested_dissection_separator.h>

#include <CGAL/tags.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <future>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

inline double tune(const char* name, double d) { const char* s = std::getenv(name); return s ? std::atof(s) : d; }

// The vertices along a Morton curve: neighbours in space become neighbours in memory.
inline std::vector<int> morton_order(const std::vector<Eigen::Vector3d>& points)
{
  constexpr int bits = 10;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : points) box.extend(p);
  const double extent = points.empty() ? 0. : box.sizes().maxCoeff();
  const double scale = extent > 0 ? ((1 << bits) - 1) / extent : 0.;

  auto spread = [](std::uint32_t x) {  // abc -> a00b00c
    x = (x | x << 16) & 0x030000FF;
    x = (x | x << 8) & 0x0300F00F;
    x = (x | x << 4) & 0x030C30C3;
    return (x | x << 2) & 0x09249249;
  };
  std::vector<std::uint32_t> keys(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d cell = (points[i] - box.min()) * scale;
    keys[i] = spread(std::uint32_t(cell.x())) | spread(std::uint32_t(cell.y())) << 1 | spread(std::uint32_t(cell.z())) << 2;
  }

  std::vector<int> order(points.size()), sorted(points.size());
  std::iota(order.begin(), order.end(), 0);
  constexpr std::uint32_t radix = 1 << bits;
  for (int shift = 0; shift < 3 * bits; shift += bits) {
    std::vector<int> position(radix + 1, 0);
    for (std::uint32_t key : keys) ++position[(key >> shift) % radix + 1];
    std::partial_sum(position.begin(), position.end(), position.begin());
    for (int i : order) sorted[position[(keys[i] >> shift) % radix]++] = i;
    order.swap(sorted);
  }
  return order;
}

class Nested_dissection
{
public:
  Nested_dissection(const std::vector<Eigen::Vector3d>& points, const std::vector<int>& offsets, const std::vector<int>& neighbors)
    : m_original(morton_order(points)),
      m_order(points.size()), m_domain(points.size(), 0), m_slab(points.size()), m_slot(points.size(), outside)
  {
    renumber(points, offsets, neighbors);
  }

  std::vector<int> compute(int fork_depth)
  {
    std::iota(m_order.begin(), m_order.end(), 0);
    Workspace workspace;
    dissect({ 0, int(m_order.size()) }, fork_depth, workspace);
    for (int& v : m_order) v = m_original[v];
    return std::move(m_order);
  }

private:
  struct Domain
  {
    int begin, end;
    int size() const { return end - begin; }
  };

  static constexpr int number_of_slabs = 256;

  struct Workspace
  {
    Minimum_vertex_separator separator;
    Leaf_elimination leaf;
    std::vector<int> band, buffer, right;
    std::array<int, number_of_slabs + 1> count, crossing;
  };

  struct Cut
  {
    Eigen::Vector3d direction;
    double cost;
    int slab;  // left: below this one
  };

  void renumber(const std::vector<Eigen::Vector3d>& points, const std::vector<int>& offsets, const std::vector<int>& neighbors)
  {
    const int n = int(points.size());
    std::vector<int> rank(n);
    for (int i = 0; i < n; ++i) rank[m_original[i]] = i;
    m_points.resize(n);
    m_offsets.resize(n + 1);
    m_neighbors.resize(neighbors.size());
    m_offsets[0] = 0;
    for (int i = 0; i < n; ++i) {
      const int v = m_original[i];
      m_points[i] = points[v];
      int out = m_offsets[i];
      for (int j = offsets[v]; j < offsets[v + 1]; ++j) m_neighbors[out++] = rank[neighbors[j]];
      m_offsets[i + 1] = out;
    }
  }

  void dissect(Domain domain, int fork_depth, Workspace& workspace)
  {
    static const int leaf_size = int(tune("LEAF", 100));
    if (domain.size() <= leaf_size) {
      order_leaf(domain, workspace);
      return;
    }
    const auto [left, right] = split(domain, workspace);
    if (left.size() == domain.size() || right.size() == domain.size()) return;
    if (fork_depth > 0) {
      auto other = std::async(std::launch::async, [this, r = right, fork_depth] {
        Workspace own;
        dissect(r, fork_depth - 1, own);
      });
      dissect(left, fork_depth - 1, workspace);
      other.get();
    } else {
      dissect(left, 0, workspace);
      dissect(right, 0, workspace);
    }
  }

  std::pair<Domain, Domain> split(Domain domain, Workspace& workspace)
  {
    const Cut cut = best_cut(domain, workspace);
    collect_band(domain, cut, workspace);
    refine(domain, cut, workspace);
    return partition(domain, cut, workspace);
  }

  Cut best_cut(Domain domain, Workspace& workspace)
  {
    const Eigen::Vector3d origin = m_points[m_order[domain.begin]];
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d cov = Eigen::Matrix3d::Zero();
    for (int i = domain.begin; i < domain.end; ++i) {
      const Eigen::Vector3d d = m_points[m_order[i]] - origin;
      mean += d;
      cov.noalias() += d * d.transpose();
    }
    mean /= domain.size();
    cov = cov / domain.size() - mean * mean.transpose();
    mean += origin;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eig;
    eig.computeDirect(cov);
    const Eigen::Vector3d a = eig.eigenvectors().col(2), b = eig.eigenvectors().col(1), c = eig.eigenvectors().col(0);
    static const int nd = int(tune("NDIR", 1));
    static const int bign = int(tune("BIG", 0));
    const int k = domain.size() > bign ? nd : 1;
    std::vector<Eigen::Vector3d> dirs{ a };
    if (k > 1) dirs.push_back(b);
    if (k > 2) dirs.push_back((a + b).normalized()), dirs.push_back((a - b).normalized());
    if (k > 4) dirs.push_back(c);
    Cut best{ a, 1e300, 0 };
    for (const auto& d : dirs) {
      fill_slabs(domain, mean, d, std::sqrt(d.dot(cov * d)));
      const Cut cut = sweep(domain, d, workspace);
      if (cut.cost < best.cost) best = cut;
    }
    static const double bfs = tune("BFS", 1e9);
    if (best.cost == 1e300 || domain.size() > bfs) {
      rank_breadth_first(domain, workspace);
      const Cut cut = sweep(domain, Eigen::Vector3d::Zero(), workspace);
      if (cut.cost < best.cost) { return cut; }
      fill_slabs(domain, mean, best.direction, std::sqrt(best.direction.dot(cov * best.direction)));
    } else
    if (dirs.size() > 1 && best.direction != dirs.back()) fill_slabs(domain, mean, best.direction, std::sqrt(best.direction.dot(cov * best.direction)));
    return best;
  }

  void fill_slabs(Domain domain, const Eigen::Vector3d& mean, const Eigen::Vector3d& direction, double deviation)
  {
    static const double reach = tune("REACH", 1.4);
    const double scale = number_of_slabs / (2 * reach * deviation);
    for (int i = domain.begin; i < domain.end; ++i) {
      const int v = m_order[i];
      const double t = (m_points[v] - mean).dot(direction) * scale + number_of_slabs / 2;
      m_slab[v] = int(std::min(std::max(t, 0.), number_of_slabs - 1.));
    }
  }

  void rank_breadth_first(Domain domain, Workspace& w)
  {
    int start = m_order[domain.begin];
    for (int round = 0; round < 2; ++round) {
      w.band.clear();
      for (int i = domain.begin - 1; i < domain.end; ++i) {
        const int seed = i < domain.begin ? start : m_order[i];
        if (m_slot[seed] != outside) continue;
        m_slot[seed] = 0;
        std::size_t head = w.band.size();
        for (w.band.push_back(seed); head < w.band.size(); ++head) {
          const int v = w.band[head];
          for (int j = m_offsets[v]; j < m_offsets[v + 1]; ++j) {
            const int u = m_neighbors[j];
            if (is_inside(u, domain) && m_slot[u] == outside) {
              m_slot[u] = 0;
              w.band.push_back(u);
            }
          }
        }
      }
      start = w.band.back();
      for (int v : w.band) m_slot[v] = outside;
    }
    for (std::size_t k = 0; k < w.band.size(); ++k) m_slab[w.band[k]] = int(k * number_of_slabs / w.band.size());
  }

  Cut sweep(Domain domain, const Eigen::Vector3d& direction, Workspace& w)
  {
    w.count.fill(0);
    w.crossing.fill(0);
    static const double samp = tune("SAMP", 50);
    const int stride = std::max(1, int(std::sqrt(double(domain.size())) / samp));
    int sampled = 0;
    for (int i = domain.begin; i < domain.end; i += stride, ++sampled) {
      const int v = m_order[i], slab = m_slab[v];
      ++w.count[slab + 1];
      int highest = slab;
      for (int j = m_offsets[v]; j < m_offsets[v + 1]; ++j) {
        const int u = m_neighbors[j];
        if (is_inside(u, domain) && m_slab[u] > highest) highest = m_slab[u];
      }
      ++w.crossing[slab + 1];
      --w.crossing[highest + 1];
    }
    static const double pen = tune("PEN", 4), minb = tune("MINB", 0.3);
    Cut best{ direction, 1e300, number_of_slabs / 2 };
    int below = 0, crossing = 0;
    for (int s = 1; s < number_of_slabs; ++s) {
      below += w.count[s];
      crossing += w.crossing[s];
      const double p = double(below) / sampled;
      if (p < minb || p > 1 - minb) continue;
      const double cost = double(crossing) * (1 + pen * (p - 0.5) * (p - 0.5));
      if (cost < best.cost) best.cost = cost, best.slab = s;
    }
    return best;
  }

  bool is_inside(int v, Domain domain) const { return m_domain[v] == domain.begin; }

  void collect_band(Domain domain, const Cut& cut, Workspace& w)
  {
    w.band.clear();
    auto is_left = [&](int v) { return m_slab[v] < cut.slab; };
    for (int i = domain.begin; i < domain.end; ++i) {
      const int v = m_order[i];
      for (int j = m_offsets[v]; j < m_offsets[v + 1]; ++j) {
        const int u = m_neighbors[j];
        if (is_inside(u, domain) && is_left(u) != is_left(v)) {
          m_slot[v] = int(w.band.size());
          w.band.push_back(v);
          break;
        }
      }
    }
    static const double width = tune("WIDTH", 6), maxf = tune("MAXF", 0.5);
    int below = 0;
    for (int i = domain.begin; i < domain.end; ++i) below += is_left(m_order[i]);
    const double rows = width * std::sqrt(double(domain.size()));
    int room[2] = { int(std::min(rows, maxf * (domain.size() - below))), int(std::min(rows, maxf * below)) };
    for (int v : w.band) --room[is_left(v)];
    for (std::size_t k = 0; k < w.band.size(); ++k) {
      const int v = w.band[k];
      int& r = room[is_left(v)];
      for (int j = m_offsets[v]; r > 0 && j < m_offsets[v + 1]; ++j) {
        const int u = m_neighbors[j];
        if (is_inside(u, domain) && m_slot[u] == outside) {
          m_slot[u] = int(w.band.size());
          w.band.push_back(u);
          --r;
        }
      }
    }
  }

  void refine(Domain domain, const Cut& cut, Workspace& w)
  {
    w.separator.clear();
    for (int v : w.band) {
      bool touches[2] = { false, false };
      for (int j = m_offsets[v]; j < m_offsets[v + 1]; ++j) {
        const int u = m_neighbors[j];
        if (!is_inside(u, domain)) continue;
        if (m_slot[u] != outside) w.separator.add_neighbor(m_slot[u]);
        else touches[m_slab[u] < cut.slab] = true;
      }
      w.separator.close_vertex(touches[1], touches[0]);
    }
    w.separator.compute();
  }

  std::pair<Domain, Domain> partition(Domain domain, const Cut& cut, Workspace& w)
  {
    using Side = Minimum_vertex_separator::Side;
    w.buffer.clear();
    w.right.clear();
    int out = domain.begin;
    for (int i = domain.begin; i < domain.end; ++i) {
      const int v = m_order[i];
      Side side = m_slab[v] < cut.slab ? Side::source : Side::sink;
      if (m_slot[v] != outside) {
        side = w.separator.side(m_slot[v]);
        m_slot[v] = outside;
      }
      if (side == Side::source) m_order[out++] = v;
      else if (side == Side::sink) w.right.push_back(v);
      else w.buffer.push_back(v);
    }
    const Domain left{ domain.begin, out }, right{ out, out + int(w.right.size()) };
    for (int v : w.right) { m_order[out++] = v; m_domain[v] = right.begin; }
    for (int v : w.buffer) { m_order[out++] = v; m_domain[v] = eliminated_later; }
    if (tune("DBG",1e9) < domain.size()) {
      int bad=0; for (int i=left.begin;i<left.end;++i) for (int j=m_offsets[m_order[i]];j<m_offsets[m_order[i]+1];++j) bad += m_domain[m_neighbors[j]]==right.begin;
      std::printf("m %d left %d right %d sep %zu band %zu cutcost %g slab %d bad %d\n",domain.size(),left.size(),right.size(),w.buffer.size(),w.band.size(),cut.cost,cut.slab,bad);
    }
    return { left, right };
  }

  void order_leaf(Domain domain, Workspace& w)
  {
    for (int i = domain.begin; i < domain.end; ++i) m_slot[m_order[i]] = i - domain.begin;
    w.leaf.reset(domain.size());
    w.band.clear();
    int boundary = domain.size();
    for (int i = domain.begin; i < domain.end; ++i) {
      const int v = m_order[i];
      for (int j = m_offsets[v]; j < m_offsets[v + 1]; ++j) {
        const int u = m_neighbors[j];
        int s;
        if (is_inside(u, domain)) s = m_slot[u];
        else {
          const auto it = std::find(w.band.begin(), w.band.end(), u);
          s = domain.size() + int(it - w.band.begin());
          if (it == w.band.end()) w.band.push_back(u);
        }
        if (s < Leaf_elimination::max_number_of_vertices) w.leaf.connect(i - domain.begin, s);
      }
    }
    (void)boundary;
    w.buffer.assign(m_order.begin() + domain.begin, m_order.begin() + domain.end);
    int out = domain.begin;
    for (int k : w.leaf.compute()) m_order[out++] = w.buffer[k];
  }

  static constexpr int outside = -1;
  static constexpr int eliminated_later = -1;

  std::vector<int> m_original;
  std::vector<Eigen::Vector3d> m_points;
  std::vector<int> m_offsets, m_neighbors;

  std::vector<int> m_order;   // a domain is a range of it
  std::vector<int> m_domain;  // by vertex: where the range of its domain begins
  std::vector<int> m_slab, m_slot;
};

template <typename Concurrency_tag = Sequential_tag>
std::vector<int> nested_dissection(const std::vector<Eigen::Vector3d>& points, const std::vector<int>& offsets, const std::vector<int>& neighbors)
{
  const int fork_depth = std::is_convertible<Concurrency_tag, Parallel_tag>::value ? 2 : 0;
  return Nested_dissection(points, offsets, neighbors).compute(fork_depth);
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_NESTED_DISSECTION_H
