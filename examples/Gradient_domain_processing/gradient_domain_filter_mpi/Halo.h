// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_MPI_HALO_H
#define GRADIENT_DOMAIN_FILTER_MPI_HALO_H

#include "Ranks.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

// Which rank owns a number, if every rank owns a range of them.
inline int owner(const std::vector<Global>& first_of_ranks, Global i)
{
  return int(std::upper_bound(first_of_ranks.begin(), first_of_ranks.end(), i) - first_of_ranks.begin()) - 1;
}

// Values that a rank owns and values of other ranks that it needs, its ghosts: locally the owned ones come first, then
// the ghosts by their global numbers.
class Halo
{
  const Ranks* m_ranks = nullptr;
  std::vector<Global> m_first_of_ranks;
  std::vector<Global> m_ghosts; // increasing
  std::vector<int> m_sent;      // which of the owned ones go to others, by rank
  std::vector<int> m_sent_counts, m_received_counts;

public:
  Halo() = default;
  Halo(const Ranks& ranks, std::vector<Global> first_of_ranks, std::vector<Global> ghosts)
    : m_ranks(&ranks), m_first_of_ranks(std::move(first_of_ranks)), m_ghosts(std::move(ghosts))
    , m_received_counts(std::size_t(ranks.size()), 0)
  {
    for(Global g : m_ghosts)
      ++m_received_counts[std::size_t(owner(m_first_of_ranks, g))];
    for(Global g : ranks.exchange(m_ghosts, m_received_counts, &m_sent_counts))
      m_sent.push_back(int(g - first_owned()));
  }

  Global first_owned() const { return m_first_of_ranks[std::size_t(m_ranks->rank())]; }
  Global global_size() const { return m_first_of_ranks.back(); }
  int owned() const { return int(m_first_of_ranks[std::size_t(m_ranks->rank()) + 1] - first_owned()); }
  int size() const { return owned() + int(m_ghosts.size()); }
  const std::vector<Global>& first_of_ranks() const { return m_first_of_ranks; }

  bool is_owned(Global i) const { return i >= first_owned() && i < first_owned() + owned(); }
  // -1 if it is neither owned nor a ghost.
  int local(Global i) const
  {
    if(is_owned(i))
      return int(i - first_owned());
    const auto at = std::lower_bound(m_ghosts.begin(), m_ghosts.end(), i);
    return at == m_ghosts.end() || *at != i ? -1 : owned() + int(at - m_ghosts.begin());
  }
  Global global(int local) const
  {
    return local < owned() ? first_owned() + local : m_ghosts[std::size_t(local - owned())];
  }

  // The ghosts get what their owners have: set(i, get(j)) for a ghost i that is j there.
  template <class T, class Get, class Set>
  void update(const Get& get, const Set& set) const
  {
    std::vector<T> outgoing;
    outgoing.reserve(m_sent.size());
    for(int i : m_sent)
      outgoing.push_back(get(i));
    const std::vector<T> incoming = m_ranks->exchange(outgoing, m_sent_counts);
    for(std::size_t k = 0; k < incoming.size(); ++k)
      set(owned() + int(k), incoming[k]);
  }
  template <class T>
  void update(std::vector<T>& values) const
  {
    update<T>([&](int i) { return values[std::size_t(i)]; }, [&](int i, const T& x) { values[std::size_t(i)] = x; });
  }
  void update(std::vector<Eigen::Vector3d>& vectors) const
  {
    typedef std::array<double, 3> Three;
    update<Three>(
      [&](int i) {
        const Eigen::Vector3d& p = vectors[std::size_t(i)];
        return Three{{p[0], p[1], p[2]}};
      },
      [&](int i, const Three& p) { vectors[std::size_t(i)] = Eigen::Vector3d(p.data()); });
  }
};

#endif // GRADIENT_DOMAIN_FILTER_MPI_HALO_H
